#!/bin/sh
# What the sources promise beside working: sh tests/style/run.sh [BUILD_FOLDER]
# Formatting, arrows and lengths, sources and headers on their own, clang-tidy. Needs no build: a folder is configured
# for the compilers' flags. MIEN_TEST_STYLE=long: every file on its own with GCC and Clang, clang-tidy over all files, and
# a plain and a debug build of everything; otherwise clang-tidy sees the files listed in tidy_short.txt.
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/style}

# What a release recorded stays as it was written.
git ls-files '*.cpp' '*.hpp' '*.inc' '*.c' '*.h' | grep -v '^tests/golden/abi-' | xargs clang-format --dry-run -Werror
python3 tests/style/check_style.py .
python3 tests/style/planted_faults_test.py

cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug >/dev/null
# The short form: the public headers and one room, by Clang.
if [ "${MIEN_TEST_STYLE:-short}" = long ]; then
    python3 tests/style/compile_alone.py . "$build" g++
    python3 tests/style/compile_alone.py . "$build" clang++
    python3 tests/style/tidy.py . "$build"
    cmake -S . -B build/plain >/dev/null
    cmake --build build/plain -j "$(nproc)"
    cmake --preset debug >/dev/null
    cmake --build --preset debug
else
    python3 tests/style/compile_alone.py . "$build" clang++ src/spatial include
    xargs python3 tests/style/tidy.py . "$build" <tests/style/tidy_short.txt
fi
