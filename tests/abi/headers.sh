#!/bin/sh
# Every public header alone, twice, and all together, in every language version that is promised.
#   headers.sh INCLUDE_DIR [compiler ...]     (default: gcc clang, whichever are installed)
set -u
include=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
checked=0

c_headers=$(cd "$include" && ls mien/*.h)
cpp_headers=$(cd "$include" && ls mien/*.hpp mien/detail/*.hpp)

# A source that includes its headers twice, and declares something so that it is not empty.
source_of() {
    for pass in 1 2; do
        for header in $1; do printf '#include <%s>\n' "$header"; done
    done
    printf 'typedef int mien_not_empty;\n'
}

check() { # compiler flags... file
    checked=$((checked + 1))
    if ! "$@" -fsyntax-only -I"$include" >"$folder/log" 2>&1; then
        echo "FAILED: $*"
        head -5 "$folder/log"
        failed=$((failed + 1))
    fi
}

number=0
for headers in $c_headers "$c_headers"; do
    number=$((number + 1))
    source_of "$headers" >"$folder/$number.c"
    source_of "$headers" >"$folder/$number.cc"
done
c_sources=$(ls "$folder"/*.c)
cc_sources=$(ls "$folder"/*.cc)
number=0
for headers in $cpp_headers "mien/mien.h $cpp_headers"; do
    number=$((number + 1))
    source_of "$headers" >"$folder/face$number.cpp"
done
face_sources=$(ls "$folder"/*.cpp)
all_faces=$folder/face$number.cpp

warnings="-Wall -Wextra -Wundef -Wshadow -Werror -pedantic -pedantic-errors"
if [ $# -eq 0 ]; then
    for compiler in gcc clang; do
        if command -v $compiler >/dev/null 2>&1; then set -- "$@" $compiler; else echo "skipped: no $compiler"; fi
    done
fi
for compiler in "$@"; do
    case $compiler in
    *clang*) cpp=$(echo "$compiler" | sed 's/clang/clang++/') ;;
    *) cpp=$(echo "$compiler" | sed 's/gcc/g++/') ;;
    esac
    for standard in c89 c99 c11 c17; do
        check "$compiler" -std=$standard $warnings -Wstrict-prototypes -Wmissing-prototypes $c_sources
    done
    for standard in c++11 c++17 c++20; do
        check "$cpp" -std=$standard $warnings -Wold-style-cast $cc_sources
    done
    check "$cpp" -std=c++17 $warnings -Wno-missing-field-initializers $face_sources
    # Those that stand alone in C++17 do in C++20: together they are enough.
    check "$cpp" -std=c++20 $warnings -Wno-missing-field-initializers "$all_faces"
    check "$compiler" -std=c99 -fshort-enums -DMIEN_STATIC $warnings $c_sources
done

# Machines that no compiler here has a C library for: the headers need none.
if command -v clang >/dev/null 2>&1; then
    for machine in armv7-none-eabi i386-linux-gnu x86_64-pc-windows-msvc arm64-apple-macos riscv64-linux-gnu; do
        check clang --target=$machine -ffreestanding -std=c99 -fshort-enums $warnings $c_sources
    done
fi

# What no compiler minds: more than two standard headers, types whose size differs between machines.
for header in $c_headers; do
    if [ "$header" != mien/mien.h ] && ! grep -q "#include \"${header#mien/}\"" "$include/mien/mien.h"; then
        echo "FAILED: mien.h does not include $header"
        failed=$((failed + 1))
    fi
    if grep -n '#include <' "$include/$header" | grep -v '<stddef.h>\|<stdint.h>'; then
        echo "FAILED: $header includes more than stddef.h and stdint.h"
        failed=$((failed + 1))
    fi
    if sed -e 's|/\*.*\*/||' -e '/^ *\/\*/d' -e '/^ \*/d' "$include/$header" | grep -nE '\b(bool|long|wchar_t|va_list|enum +[a-z]\w*)\b'; then
        echo "FAILED: $header uses a type whose size differs between machines"
        failed=$((failed + 1))
    fi
done

echo "$checked compiler runs over $(echo $c_headers | wc -w) C and $(echo $cpp_headers | wc -w) C++ headers, $failed failed"
[ $failed -eq 0 ]
