#!/bin/sh
# The static library: built, installed, and a program in C linked with it by CMake and by pkg-config --static, which runs without
# libmien.so. A long form: it compiles the library once more.
#   static_library.sh PROJECT_DIR WORK_DIR
set -e
project=$1
work=$2
mkdir -p "$work"
work=$(cd "$work" && pwd)
cmake -S "$project" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DMIEN_BUILD_CLI=OFF \
    -DMIEN_BUILD_TESTS=OFF -DMIEN_BUILD_EXAMPLES=OFF -DMIEN_INSTALL=ON >"$work/build.log"
cmake --build "$work/build" -j "${MIEN_JOBS:-2}" >>"$work/build.log"
rm -rf "$work/prefix"
cmake --install "$work/build" --prefix "$work/prefix" >>"$work/build.log"
libdir=$(dirname "$(find "$work/prefix" -name libmien.a)")
cp "$project/conan/test_package/test_package.c" "$project/conan/test_package/CMakeLists.txt" "$work/"
cmake -S "$work" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/cmake.log"
cmake --build "$work/cmake" >>"$work/cmake.log"
echo "CMake: $("$work/cmake/test_package")"
# shellcheck disable=SC2046
cc -std=c99 -Wall -Werror "$work/test_package.c" $(PKG_CONFIG_PATH="$libdir/pkgconfig" pkg-config --static --cflags --libs mien) \
    -o "$work/by_pkg_config"
if readelf -d "$work/by_pkg_config" | grep -q libmien; then echo "FAILED: the program still needs libmien.so"; exit 1; fi
echo "pkg-config --static: $("$work/by_pkg_config")"
