#!/usr/bin/env bash
# windows.sh: the eight programs with their windows, bits and tests for Windows, by mingw-w64, under wine.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/portability/prepare.sh
tests/portability/windows_libraries.sh
headers
need g++-mingw-w64-x86-64-posix wine64 wine
export WINEDEBUG=-all WINEPREFIX=$PWD/build/wine SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
wineboot >/dev/null 2>&1 || true # makes that folder, once
build windows all --preset windows
ctest --test-dir build/windows -LE long -j 2 --output-on-failure
