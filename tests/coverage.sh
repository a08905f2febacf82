#!/bin/sh
# Which lines of src and abi the tests reach: sh tests/coverage.sh [LEAST_PERCENT (90)]
# Builds preset coverage, runs the tests of rooms, interface, command and failing memory, and prints gcovr's table; the lines
# that nobody reached stand in build/coverage/uncovered.txt. Fails under LEAST_PERCENT of lines.
set -eu
cd "$(dirname "$0")/.."
least=${1:-90}
sh cmake/install-packages.sh build test long
cmake --preset coverage >/dev/null
cmake --build build/coverage -- -j "$(nproc)"
find build/coverage -name '*.gcda' -delete
ctest --test-dir build/coverage -j "$(nproc)" --timeout 1800 -R '^(unit_|abi|cli|oom|golden|fuzz_|render)' || echo "some tests failed: see above"
# Not counted: what the compiler adds for exceptions, and the command, which is a program on top of the library.
gcovr -r . build/coverage --filter 'src/' --filter 'abi/' --exclude 'src/cli/' --exclude-throw-branches \
    --txt build/coverage/uncovered.txt --print-summary --fail-under-line "$least"
