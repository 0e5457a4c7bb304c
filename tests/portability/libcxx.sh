#!/usr/bin/env bash
# libcxx.sh [VERSION]: the tests without windows, built by clang++ with LLVM's C++ library, the one that macOS has.
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
source tests/portability/prepare.sh
version=${1:-$(apt-cache depends clang | sed -n 's/.*Depends: clang-\([0-9]*\)$/\1/p')}
need cmake ninja-build libeigen3-dev libcli11-dev doctest-dev "clang-$version" "libc++-$version-dev" "libc++abi-$version-dev"
# The presets' clang flag, with which a test may trap, too.
build libcxx all -DBOUNCE_APP=OFF -DCMAKE_CXX_COMPILER="clang++-$version" \
  -DCMAKE_CXX_FLAGS="-stdlib=libc++ -ffp-exception-behavior=maytrap"
ctest --test-dir build/libcxx -LE long -j 2 --output-on-failure
