#!/bin/sh
# Installs what is missing, builds everything and runs all tests: sh tests/run.sh
# MIEN_TEST_SANITIZE=1 adds a second build with AddressSanitizer and UBSan.
set -eu
cd "$(dirname "$0")/.."

sh cmake/install-packages.sh build test

cmake --preset release -DMIEN_WERROR=ON
cmake --build --preset release
ctest --preset release -j 2 --timeout 900

if [ "${MIEN_TEST_SANITIZE:-0}" = 1 ]; then
    # Whatever reads hostile input, once more under AddressSanitizer and UBSan.
    cmake --preset asan -DMIEN_BUILD_CLI=OFF -DMIEN_BUILD_EXAMPLES=OFF
    cmake --build --preset asan --target test_base test_mesh test_abi
    ctest --preset asan -R '^(unit_base|unit_mesh|abi)$' --timeout 900
fi
