#!/bin/sh
# Builds what the self-contained packages need, as static libraries, from Debian's source packages.
#   dependencies.sh linux-x86_64|linux-aarch64|windows-x86_64 WORK_DIR
# The result is WORK_DIR/MACHINE: OpenMesh, zlib, libpng, libjpeg, and the header-only libraries of this
# machine's packages (libeigen3-dev nlohmann-json3-dev libcli11-dev), with their
# licence files in share/licenses. Nothing is built twice.
set -e
machine=$1
work=$2
project=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$work/source" "$work/apt/lists/partial"
work=$(cd "$work" && pwd)
prefix=$work/$machine
jobs=${MIEN_JOBS:-$(nproc)}
launcher=
command -v ccache >/dev/null && launcher="-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache"

toolchain=
case $machine in
linux-x86_64) ;;
linux-aarch64 | windows-x86_64) toolchain=-DCMAKE_TOOLCHAIN_FILE=$project/cmake/$machine.cmake ;;
*) echo "unknown machine $machine" >&2; exit 2 ;;
esac
# For Linux compiled against an older C library, as Mien itself is (package.sh).
flags=$(sh "$project/cmake/sysroot.sh" "$machine" "$work")
c_flags=$(echo "$flags" | head -1)
cxx_flags=$(echo "$flags" | tail -1)

# Sources through lists of our own, so that the machine's apt configuration stays as it is.
. /etc/os-release
keys=/usr/share/keyrings/debian-archive-keyring.gpg
for suite in "$VERSION_CODENAME" "$VERSION_CODENAME-updates"; do
    echo "deb-src [signed-by=$keys] http://deb.debian.org/debian $suite main"
done >"$work/apt/sources.list"
apt="apt-get -q -o Dir::Etc::sourcelist=$work/apt/sources.list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$work/apt/lists -o APT::Sandbox::User=root"
fetch() { # package: unpacks its source, with Debian's patches, into source/package
    [ -d "$work/source/$1" ] && return
    [ -f "$work/apt/updated" ] || { $apt update >/dev/null && touch "$work/apt/updated"; }
    mkdir -p "$work/source/$1.tmp"
    (cd "$work/source/$1.tmp" && $apt source "$1" >/dev/null 2>&1)
    mv "$work/source/$1.tmp"/*/ "$work/source/$1"
    rm -rf "$work/source/$1.tmp"
}

# zlib always builds its shared library too, whose Windows part is not in Debian's source: its static
# library is a dozen files.
build_zlib() {
    [ -f "$prefix/share/licenses/zlib/copyright" ] && return
    fetch zlib
    case $machine in
    linux-x86_64) cross= ;;
    linux-aarch64) cross=aarch64-linux-gnu- ;;
    windows-x86_64) cross=x86_64-w64-mingw32- ;;
    esac
    objects=$work/build/$machine-zlib
    mkdir -p "$objects" "$prefix/lib" "$prefix/include" "$prefix/share/licenses/zlib"
    unistd=-DHAVE_UNISTD_H
    [ "$machine" = windows-x86_64 ] && unistd=
    (cd "$objects" && ${cross}gcc $c_flags -O2 -fPIC -fvisibility=hidden -ffunction-sections $unistd -c "$work"/source/zlib/*.c)
    ${cross}ar rcs "$prefix/lib/libz.a" "$objects"/*.o
    cp "$work/source/zlib/zlib.h" "$prefix/include/"
    cp "$work/source/zlib"/zconf.h.in "$prefix/include/zconf.h"
    cp "$work/source/zlib/debian/copyright" "$prefix/share/licenses/zlib/copyright"
    rm -rf "$objects"
}

build() { # package, its library, cmake options...
    package=$1
    library=$2
    shift 2
    [ -f "$prefix/share/licenses/$package/copyright" ] && return
    fetch "$package"
    rm -rf "$work/build/$machine-$package"
    if ! { cmake -S "$work/source/$package" -B "$work/build/$machine-$package" -G Ninja $toolchain $launcher \
        -DMIEN_DEPENDENCIES="$prefix" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR:STRING=lib \
        -DCMAKE_C_FLAGS="$c_flags" -DCMAKE_CXX_FLAGS="$cxx_flags" -DCMAKE_BUILD_TYPE=Release -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCMAKE_POLICY_DEFAULT_CMP0063=NEW \
        -DCMAKE_C_VISIBILITY_PRESET=hidden -DCMAKE_CXX_VISIBILITY_PRESET=hidden -DCMAKE_VISIBILITY_INLINES_HIDDEN=ON \
        -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG -ffunction-sections -fdata-sections -ffp-contract=off" "$@" &&
        cmake --build "$work/build/$machine-$package" -j "$jobs" && cmake --install "$work/build/$machine-$package"; } \
        >"$work/$machine-$package.log" 2>&1; then
        tail -20 "$work/$machine-$package.log" >&2
        exit 1
    fi
    rm -rf "$work/build/$machine-$package"
    [ -f "$prefix/lib/$library" ] || { echo "FAILED: $package installs no lib/$library ($work/$machine-$package.log)" >&2; exit 1; }
    mkdir -p "$prefix/share/licenses/$package"
    cp "$work/source/$package/debian/copyright" "$prefix/share/licenses/$package/copyright"
}

# Only the parts of a package that are headers; their CMake files find them by their own place.
borrow() { # package, paths below /usr ...
    package=$1
    shift
    for path; do
        mkdir -p "$prefix/$(dirname "$path")"
        cp -rp "/usr/$path" "$prefix/$(dirname "$path")/"  # with their times: nothing is compiled anew
    done
    mkdir -p "$prefix/share/licenses/$package"
    cp "/usr/share/doc/$package/copyright" "$prefix/share/licenses/$package/copyright"
}

borrow libeigen3-dev include/eigen3 share/eigen3
borrow nlohmann-json3-dev include/nlohmann share/cmake/nlohmann_json
borrow libcli11-dev include/CLI share/cmake/CLI11
# Debian's OpenMesh builds shared libraries only, and a package that needs nothing links it statically.
fetch openmesh
sed -i 's/\(vci_add_library *(OpenMesh[A-Za-z]* *\)SHARED /\1STATIC /' \
    "$work"/source/openmesh/src/OpenMesh/Core/CMakeLists.txt "$work"/source/openmesh/src/OpenMesh/Tools/CMakeLists.txt
build openmesh libOpenMeshCore.a -DBUILD_APPS=OFF -DOPENMESH_DOCS=OFF -DOPENMESH_BUILD_SHARED=OFF
build_zlib
build libpng1.6 libpng.a -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF
# Its assembly needs nasm and gives the same bits; a texture is decoded once a scan.
build libjpeg-turbo libjpeg.a -DENABLE_SHARED=OFF -DWITH_TURBOJPEG=OFF -DWITH_SIMD=OFF
echo "$prefix"
