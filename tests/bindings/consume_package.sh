#!/bin/sh
# Installs into an empty folder, moves it, and builds a program in plain C and one in C++ against it,
# through CMake, pkg-config and the bare files: without the build tree.
#   consume_package.sh PROJECT_DIR BUILD_DIR WORK_DIR
set -e
project=$1
build=$2
work=$3
rm -rf "$work"
mkdir -p "$work/elsewhere"
cmake --install "$build" --prefix "$work/first" >"$work/install.log"
mv "$work/first" "$work/elsewhere/mien"
prefix=$work/elsewhere/mien
libdir=$(dirname "$(find "$prefix" -name 'libmien.so' | head -1)")
cp "$project/conan/test_package/test_package.c" "$project/conan/test_package/CMakeLists.txt" "$work/"

if grep -rlF -e "$build" -e "$project" "$libdir/cmake" "$libdir/pkgconfig"; then
    echo "FAILED: the installed files name the build machine's folders"
    exit 1
fi

cmake -S "$work" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$prefix" >"$work/cmake.log"
cmake --build "$work/cmake" >>"$work/cmake.log"
echo "CMake:      $("$work/cmake/test_package")"

export PKG_CONFIG_PATH="$libdir/pkgconfig"
if command -v pkg-config >/dev/null; then
    cc -std=c99 -Wall -Werror "$work/test_package.c" $(pkg-config --cflags --libs mien) -o "$work/by_pkg_config"
    echo "pkg-config: $(LD_LIBRARY_PATH="$libdir" "$work/by_pkg_config"), version $(pkg-config --modversion mien)"
else
    echo "skipped: no pkg-config"
fi

cc -std=c99 "$work/test_package.c" -I"$prefix/include" -L"$libdir" -lmien -o "$work/by_hand"
echo "by hand:    $(LD_LIBRARY_PATH="$libdir" "$work/by_hand")"
c++ -std=c++17 -x c++ - -fsyntax-only -I"$prefix/include" <<'END'
#include <mien/mien.hpp>
int main() { return mien::Session().get() == nullptr; }
END
if [ -x "$prefix/bin/mien" ]; then "$prefix/bin/mien" --version >/dev/null; fi
