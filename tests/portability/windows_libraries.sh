#!/usr/bin/env bash
# windows_libraries.sh: SDL2, Dear ImGui, libpng and zlib for Windows, of Debian's sources, as archives in
# build/windows_libraries, where the preset `windows` looks. Nothing is done twice.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/portability/prepare.sh
need cmake ninja-build dpkg-dev ca-certificates g++-mingw-w64-x86-64-posix
prefix=$PWD/build/windows_libraries sources=$PWD/build/windows_sources tool=x86_64-w64-mingw32
[ ! -f "$prefix/done" ] || exit 0
rm -rf "$prefix" "$sources"
mkdir -p "$prefix/lib" "$prefix/include/imgui" "$sources/lists/partial"

# Their sources are where the packages come from. (Not the archive of security updates: it drops its older files.)
apt-get indextargets --format 'deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
  sort -u | grep 'debian\|ubuntu' | grep -v security >"$sources/list"
apt=(apt-get -qq -o Dir::Etc::SourceList="$sources/list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$sources/lists")
"${apt[@]}" update
(cd "$sources" && "${apt[@]}" source --download-only libsdl2 imgui libpng1.6 zlib 2>/dev/null &&
  for one in *.dsc; do dpkg-source --no-check -x "$one" "${one%%_*}" >/dev/null; done)

archive() { # archive NAME COMPILER FILE...: lib/libNAME.a of these
  local name=$1 compiler=$2 objects; shift 2
  objects=$sources/$name.objects
  mkdir "$objects"
  printf '%s\0' "$@" | (cd "$objects" && xargs -0 -n 4 -P 2 "$tool-$compiler-posix" -O2 -w -c -I"$prefix/include")
  "$tool-ar" rcs "$prefix/lib/lib$name.a" "$objects"/*.o
}
cp "$sources"/zlib/{zlib,zconf}.h "$prefix/include"
archive z gcc "$sources"/zlib/*.c
rm "$sources/libpng1.6/pngtest.c"
cp "$sources/libpng1.6/scripts/pnglibconf.h.prebuilt" "$sources/libpng1.6/pnglibconf.h"
cp "$sources"/libpng1.6/{png,pngconf,pnglibconf}.h "$prefix/include"
archive png gcc "$sources"/libpng1.6/png*.c
cp "$sources"/imgui/*.h "$prefix/include/imgui"
archive imgui g++ "$sources"/imgui/*.cpp
build windows_sdl install -S "$sources/libsdl2" -DCMAKE_TOOLCHAIN_FILE="$PWD/tests/portability/windows.cmake" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" -DSDL_SHARED=OFF -DSDL_TEST=OFF
touch "$prefix/done"
