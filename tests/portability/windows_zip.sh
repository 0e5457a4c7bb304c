#!/usr/bin/env bash
# windows_zip.sh: build/bounce-windows.zip, for who has Windows and no compiler: the programs, and the lessons as pages.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/portability/prepare.sh
tests/portability/windows_libraries.sh
headers
programs=$(cd stages && printf '%s ' [0-9][0-9]_*)
build windows "$programs" --preset windows
./course site
folder=build/windows_zip/bounce
rm -rf build/windows_zip build/bounce-windows.zip
mkdir -p "$folder/licences"
for one in $programs; do x86_64-w64-mingw32-strip -o "$folder/$one.exe" "build/windows/bin/$one.exe"; done
cp -r build/site "$folder/lessons"
cp LICENSE "$folder/licences/bounce.txt"
for one in libsdl2 imgui libpng1.6 zlib; do cp "build/windows_sources/$one/debian/copyright" "$folder/licences/$one.txt"; done
for one in libeigen3-dev libcli11-dev mingw-w64-x86-64-dev; do cp "/usr/share/doc/$one/copyright" "$folder/licences/$one.txt"; done
cat >"$folder/README.txt" <<'TEXT'
The stages are the programs 01_free_fall.exe to 08_racket_game.exe: a double click opens one, F1 shows its keys.
The lessons are in lessons\index.html. Their figures move only where a web server shows them.
TEXT
sed -i 's/$/\r/' "$folder/README.txt"
(cd build/windows_zip && cmake -E tar cf ../bounce-windows.zip --format=zip bounce)
echo "written: build/bounce-windows.zip"
