#!/usr/bin/env bash
# windows.sh [--quick]: the eight programs, bits and tests for Windows, by mingw-w64, under wine. Quick, as in .ci/run:
# no windows, and of the tests the bits and the checks of the course's own stages.
# Not here:
# - progress_test: it makes a terminal, and sends Ctrl-C.
# - hostile_command_lines: it ends runs by a signal. fuzz_*: libFuzzer comes with clang++. Traps on NaNs: glibc alone has them.
# - lammps_round_trip_long_test: there is no LAMMPS.
# - tests marked skip(on_windows): they need /dev/full, /proc, a limit, a shell's words, or the last digits of this C library.
# - ./course and what is tested by scripts: bash and awk. course.cmd has a test of its own.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/portability/prepare.sh
headers
need g++-mingw-w64-x86-64-posix wine64 wine
export WINEDEBUG=-all WINEPREFIX=$PWD/build/wine SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
wineboot >/dev/null 2>&1 || true # makes that folder, once
if [ "${1:-}" = --quick ]; then
  stages=$(cd stages && printf '%s ' [0-9][0-9]_*)
  build windows_quick "$stages ${stages// /_course } state_hashes stage_checks" --preset windows -DBOUNCE_APP=OFF
  ctest --test-dir build/windows_quick -R 'same bits|checks of [0-9]' -j 2 --output-on-failure
  exit
fi
tests/portability/windows_libraries.sh
build windows all --preset windows
ctest --test-dir build/windows -LE long -j 2 --output-on-failure
tests/portability/course_cmd.sh
