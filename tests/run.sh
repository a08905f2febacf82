#!/bin/sh
# Installs what is missing, builds everything and runs all tests: sh tests/run.sh
# What reads hostile input runs once more in a second build with AddressSanitizer and UBSan: MIEN_TEST_SANITIZE=0
# leaves that out, MIEN_TEST_SANITIZE=long adds every function with every wrong argument (some minutes more).
# MIEN_TEST_TRAINING=0 leaves out libtorch, the trainer (mien-train) and its short tests.
# MIEN_TEST_STYLE=0 leaves out what looks at the sources alone, =long adds GCC on each
# file alone, clang-tidy over all files and two more builds.
set -eu
cd "$(dirname "$0")/.."

sh cmake/install-packages.sh build test

[ "${MIEN_TEST_STYLE:-short}" = 0 ] || sh tests/style/run.sh

cmake --preset joined -DMIEN_WERROR=ON -DMIEN_TRAINING=OFF
cmake --build --preset joined
ctest --preset joined -j 2 --timeout 900

if [ "${MIEN_TEST_TRAINING:-1}" != 0 ]; then
    sh cmake/install-packages.sh training
    cmake --preset joined -DMIEN_WERROR=ON -DMIEN_TRAINING=ON
    cmake --build --preset joined --target mien-train test_training
    ctest --preset joined -R '^training' --timeout 1800
fi

sanitize=${MIEN_TEST_SANITIZE:-short}
if [ "$sanitize" != 0 ]; then
    cmake --preset asan -DMIEN_BUILD_CLI=OFF -DMIEN_BUILD_EXAMPLES=OFF
    cmake --build --preset asan --target test_base test_mesh test_abi test_abi_abuse fuzz_files fuzz_networks
    ctest --preset asan -R '^(unit_base|unit_mesh|abi_half_[01]|fuzz_files|fuzz_networks)$' -j 2 --timeout 1800
    [ "$sanitize" != long ] || build/asan/tests/abi/test_abi_abuse - 60000
fi
