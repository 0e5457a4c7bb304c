#!/usr/bin/env bash
# Read by the other scripts of this folder, which run on Debian, install what they need with apt-get, and build
# in build/.
set -euo pipefail

need() { # need PACKAGE...
  local package missing=()
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  local root=(); [ "$(id -u)" = 0 ] || root=(sudo)
  "${root[@]}" apt-get -o DPkg::Lock::Timeout=300 -qq update
  DEBIAN_FRONTEND=noninteractive "${root[@]}" apt-get -o DPkg::Lock::Timeout=300 -qq install -y \
    --no-install-recommends "${missing[@]}" >/dev/null
}

headers() { # Eigen, CLI11 and doctest are headers alone: they go, with what CMake knows of them, into a folder
  # where a compiler for another machine finds nothing else of this one
  local prefix=$PWD/build/headers
  need cmake ninja-build libeigen3-dev libcli11-dev doctest-dev
  mkdir -p "$prefix"
  (cd /usr && dpkg -L libeigen3-dev libcli11-dev doctest-dev |
    sed -n 's:^/usr/\(\(include\|lib/cmake\|share/cmake\|share/eigen3\)/.*\):\1:p' | tar --no-recursion -cf - -T -) |
    tar -xf - -C "$prefix"
  grep -rlZ '"/usr"' "$prefix" --include='*.cmake' | xargs -0r sed -i "s|\"/usr\"|\"$prefix\"|"
}

build() { # build FOLDER "TARGET..." CMAKE_WORD...
  local folder=build/$1 targets; read -ra targets <<<"$2"; shift 2
  mkdir -p "$folder"
  { cmake -S . -B "$folder" -G Ninja -DBOUNCE_WERROR="${CI:+ON}" -Wno-dev "$@" &&
    cmake --build "$folder" -j 2 --target "${targets[@]}"; } >"$folder/build.log" 2>&1 || { cat "$folder/build.log"; exit 1; }
}
