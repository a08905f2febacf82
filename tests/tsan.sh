#!/bin/sh
# Shared models, meshes, networks and sessions used by 8 threads under ThreadSanitizer: sh tests/tsan.sh
# Builds preset tsan (the library, and the tests of the C ABI alone). No suppressions.
set -eu
cd "$(dirname "$0")/.."
cmake --preset tsan -DMIEN_BUILD_CLI=OFF -DMIEN_BUILD_EXAMPLES=OFF >/dev/null
cmake --build build/tsan --target test_abi test_base -- -j "$(nproc)" >build/tsan/build.log || { tail -30 build/tsan/build.log; exit 1; }
TSAN_OPTIONS="halt_on_error=0:exitcode=66:second_deadlock_stack=1" build/tsan/tests/abi/test_abi --gtest_filter='Sharing.*:Session.*'
TSAN_OPTIONS="exitcode=66" build/tsan/tests/test_base --gtest_filter='ThreadPool.*:Context.*:MemoryBudget.*:AtomicFile.*:Parallel*'
