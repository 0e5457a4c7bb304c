#!/usr/bin/env bash
# libcxx.sh [--quick | VERSION]: the tests without windows, built by clang++ with LLVM's C++ library, the one that macOS
# has. Quick, as in .ci/run: one program, and the bits.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/portability/prepare.sh
quick=''; if [ "${1:-}" = --quick ]; then quick=1; shift; fi
version=${1:-$(apt-cache depends clang | sed -n 's/.*Depends: clang-\([0-9]*\)$/\1/p')}
need cmake ninja-build libeigen3-dev libcli11-dev doctest-dev "clang-$version" "libc++-$version-dev" "libc++abi-$version-dev"
wanted=all tests=(-LE long)
if [ -n "$quick" ]; then wanted="03_damping state_hashes" tests=(-R 'same bits'); fi
# The presets' clang flag, with which a test may trap, too.
build libcxx "$wanted" -DBOUNCE_APP=OFF -DCMAKE_CXX_COMPILER="clang++-$version" \
  -DCMAKE_CXX_FLAGS="-stdlib=libc++ -ffp-exception-behavior=maytrap"
ctest --test-dir build/libcxx "${tests[@]}" -j 2 --output-on-failure
