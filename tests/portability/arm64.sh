#!/usr/bin/env bash
# arm64.sh: bits, and tests of physics, stages and many balls, for 64-bit ARM (as in Apple's machines), under qemu.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/portability/prepare.sh
headers
need g++-aarch64-linux-gnu qemu-user
tests=(physics_tests allocation_tests many_balls_tests)
programs=$(cd stages && printf '%s ' [0-9][0-9]_*)
build arm64 "state_hashes ${tests[*]} $programs" \
  -DCMAKE_TOOLCHAIN_FILE=tests/portability/arm64.cmake -DBOUNCE_APP=OFF
export BOUNCE_EMULATOR=qemu-aarch64
$BOUNCE_EMULATOR build/arm64/bin/state_hashes --check tests/hard_cases/state_hashes.txt
for one in "${tests[@]}"; do # not by ctest, whose time limits are for the processor itself
  $BOUNCE_EMULATOR "build/arm64/bin/$one"
done
