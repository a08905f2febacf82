#!/bin/sh
# What the sources promise beside working: sh tests/style/run.sh [BUILD_FOLDER]
# Formatting, arrows and lengths, every source and header on its own with Clang, clang-tidy over the files listed in
# tidy_short.txt. Needs no build: a folder is configured for the compilers' flags. MIEN_TEST_STYLE=long: on its own with
# GCC as well, which compiles everything joined otherwise; clang-tidy over all files; a plain and a debug build.
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/style}

# What a release recorded stays as it was written.
git ls-files '*.cpp' '*.hpp' '*.inc' '*.c' '*.h' | grep -v '^tests/golden/abi-' | xargs clang-format --dry-run -Werror
python3 tests/style/check_style.py .
python3 tests/style/planted_faults_test.py

cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug >/dev/null
python3 tests/style/compile_alone.py . "$build" clang++
if [ "${MIEN_TEST_STYLE:-short}" = long ]; then
    python3 tests/style/compile_alone.py . "$build" g++
    python3 tests/style/tidy.py . "$build"
    cmake -S . -B build/plain >/dev/null
    cmake --build build/plain -j "$(nproc)"
    cmake --preset debug >/dev/null
    cmake --build --preset debug
else
    xargs python3 tests/style/tidy.py . "$build" <tests/style/tidy_short.txt
fi
