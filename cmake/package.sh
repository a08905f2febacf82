#!/bin/sh
# Builds a prebuilt, self-contained archive of Mien, and proves that it needs nothing.
#   sh cmake/package.sh linux-x86_64|linux-aarch64|windows-x86_64 [WORK_DIR]
# WORK_DIR (default build/package) keeps dependencies and objects for the next run; the archive, its
# hash, and the names and lines for debuggers in an archive of their own (-debug) come into WORK_DIR. MIEN_PACKAGE_OPTIONS are more options for CMake, MIEN_JOBS the number of
# compilers at a time. Debian's compilers and sources are installed and fetched as needed.
set -e
machine=$1
project=$(cd "$(dirname "$0")/.." && pwd)
work=${2:-$project/build/package}
mkdir -p "$work"
work=$(cd "$work" && pwd)

packages="cmake ninja-build dpkg-dev libeigen3-dev nlohmann-json3-dev libcli11-dev"
toolchain=-DCMAKE_TOOLCHAIN_FILE=$project/cmake/$machine.cmake
case $machine in
linux-x86_64) packages="$packages g++"; toolchain=; tools= ;;
linux-aarch64) packages="$packages g++-aarch64-linux-gnu"; tools=aarch64-linux-gnu- ;;
windows-x86_64) packages="$packages g++-mingw-w64-x86-64-posix"; tools=x86_64-w64-mingw32- ;;
*) echo "usage: package.sh linux-x86_64|linux-aarch64|windows-x86_64 [WORK_DIR]" >&2; exit 2 ;;
esac
for package in $packages; do
    dpkg -s "$package" >/dev/null 2>&1 || missing="$missing $package"
done
if [ -n "$missing" ]; then
    as_root=
    [ "$(id -u)" = 0 ] || as_root=sudo
    $as_root apt-get -q update && $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
fi

sh "$project/cmake/dependencies.sh" "$machine" "$work/dependencies"
prefix=$work/dependencies/$machine
# The oldest C library that the archive runs with: it is compiled against that of Debian 11 (2.31), and takes what changed since 2.28 in
# the older form (cmake/glibc_2_28.c).
oldest_glibc=2.28
flags=$(sh "$project/cmake/sysroot.sh" "$machine" "$work/dependencies")
c_flags=$(echo "$flags" | head -1)
cxx_flags=$(echo "$flags" | tail -1)
cmake -S "$project" -B "$work/$machine" -G Ninja $toolchain -DCMAKE_BUILD_TYPE=Release -DMIEN_SELF_CONTAINED=ON \
    -DCMAKE_C_FLAGS="$c_flags" -DCMAKE_CXX_FLAGS="$cxx_flags" \
    -DMIEN_DEPENDENCIES="$prefix" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_IGNORE_PATH=/usr/lib/x86_64-linux-gnu/cmake/OpenMesh \
    -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_STRIP="$(command -v "${tools}strip")" -DPNG_PNG_INCLUDE_DIR="$prefix/include" \
    -DPNG_LIBRARY="$prefix/lib/libpng.a" -DJPEG_INCLUDE_DIR="$prefix/include" -DJPEG_LIBRARY="$prefix/lib/libjpeg.a" -DZLIB_INCLUDE_DIR="$prefix/include" -DZLIB_LIBRARY="$prefix/lib/libz.a" \
    -DMIEN_BUILD_TESTS=OFF -DMIEN_BUILD_EXAMPLES=OFF -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 \
    -DCMAKE_C_FLAGS_RELEASE="-O3 -DNDEBUG -g1" -DCMAKE_CXX_FLAGS_RELEASE="-O3 -DNDEBUG -g1" ${MIEN_PACKAGE_OPTIONS:-} >"$work/$machine.log"
cmake --build "$work/$machine" -j "${MIEN_JOBS:-$(nproc)}" >>"$work/$machine.log" || { tail -30 "$work/$machine.log" >&2; exit 1; }

# Names and lines for debuggers, which the archive's files are stripped of, and the link to them (gdb looks beside the file).
debug=$work/$machine/debug
rm -rf "$debug" && mkdir -p "$debug"
for file in "$work/$machine"/bin/mien "$work/$machine"/bin/mien.exe "$work/$machine"/bin/mien-demo-data "$work/$machine"/bin/mien-demo-data.exe "$work/$machine"/abi/mien-0.dll \
    "$work/$machine"/abi/libmien.so.*.*.*; do
    [ -f "$file" ] || continue
    name=$(basename "$file")
    "${tools}objcopy" --only-keep-debug "$file" "$debug/$name.debug"
    "${tools}objcopy" --remove-section=.gnu_debuglink "$file"
    (cd "$debug" && "${tools}objcopy" --add-gnu-debuglink="$name.debug" "$file")
done
[ "$(ls "$debug" | wc -l)" -ge 2 ] || { echo "FAILED: no library and command to take debug information from" >&2; exit 1; }

# What the archive tells of itself: its README with the C library that it needs, what is inside, and a demo that this machine's
# own programs make. For another machine the demo is made by MIEN_NATIVE, a build of this machine, or by the programs through qemu or wine.
archive_parts=$work/$machine/archive
mkdir -p "$archive_parts"
bin=$work/$machine/bin
exe=
case $machine in
linux-*)
    OBJDUMP=${tools}objdump python3 "$project/tests/bindings/glibc_needs.py" "$oldest_glibc" "$oldest_glibc" "$bin/mien" "$bin/mien-demo-data" \
        "$work/$machine"/abi/libmien.so.*.*.*
    needs="glibc $oldest_glibc or later"
    more=
    ;;
windows-x86_64)
    needs="Windows 10 or later, 64 bits"
    more="; \`mien-0.dll\`, the library"
    exe=.exe
    ;;
esac
version=$(sed -n 's/^project(mien VERSION \([0-9.]*\).*/\1/p' "$project/CMakeLists.txt")
sed -e "s|@VERSION@|$version|; s|@MINOR@|${version%.*}|; s|@MACHINE@|$machine|; s|@NEEDS@|$needs|; s|@BIN_MORE@|$more|" \
    "$project/cmake/archive-README.md" >"$archive_parts/README.md"
python3 "$project/cmake/sbom.py" "$work/$machine" "$archive_parts/sbom"
if [ ! -f "$archive_parts/demo/face.safetensors" ]; then
    programs=$bin
    if [ "$machine" != "linux-$(uname -m)" ]; then
        programs=${MIEN_NATIVE:+$MIEN_NATIVE/bin}
        [ -n "$programs" ] || programs=$work/linux-$(uname -m)/bin
        [ -x "$programs/mien-demo-data" ] || { echo "FAILED: no programs of this machine to make the demo with: package linux-$(uname -m) first, or set MIEN_NATIVE" >&2; exit 1; }
    fi
    sh "$project/cmake/make-demo.sh" "$programs/mien" "$programs/mien-demo-data" "$archive_parts/demo"
fi

(cd "$work/$machine" && cpack -B "$work/$machine/packed" >>"$work/$machine.log")
cp "$work/$machine"/packed/mien-*.tar.gz* "$work/$machine"/packed/mien-*.zip* "$work" 2>/dev/null || true


# What the archive promises, looked at from outside.
archive=$(ls "$work/$machine"/packed/mien-*.tar.gz "$work/$machine"/packed/mien-*.zip 2>/dev/null | head -1)
look=$work/$machine/unpacked
rm -rf "$look" && mkdir "$look"
case $archive in
*.zip) (cd "$look" && cmake -E tar xf "$archive") ;;
*) tar -C "$look" -xzf "$archive" ;;
esac
root=$(echo "$look"/*/)
(cd "$root" && sha256sum --quiet -c MANIFEST.txt)
if [ "$machine" = windows-x86_64 ]; then
    library=$root/bin/mien-0.dll
    command=$root/bin/mien.exe
    needed_by() { "${tools}objdump" -p "$1" | sed -n 's/.*DLL Name: //p' | sort | tr '\n' ' '; }
    allowed='KERNEL32.dll|msvcrt.dll|USER32.dll|ADVAPI32.dll|bcrypt.dll'
    own=mien-0.dll
else
    library=$(ls "$root"/lib/libmien.so.0.*)
    command=$root/bin/mien
    needed_by() { "${tools}readelf" -dW "$1" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | tr '\n' ' '; }
    allowed='lib(c|m).so.6|libpthread.so.0|libdl.so.2|ld-linux-.*'
    own=libmien.so.0
fi
# Names that the loader would not find, where this machine can load it.
if [ "$machine" = "linux-$(uname -m)" ] && { ldd -r "$library"; ldd -r "$command"; } | grep -E 'undefined|not found'; then
    echo "FAILED: the library or the command has unresolved names" >&2
    exit 1
fi
stem=$(basename "$archive" | sed 's/\.tar\.gz$//; s/\.zip$//')
tar -C "$debug" -czf "$work/$stem-debug.tar.gz" .
# The guards that SECURITY.md promises, and names and lines for debuggers, in what was unpacked.
if [ "$machine" = windows-x86_64 ]; then
    for file in "$library" "$command"; do
        [ -f "$debug/$(basename "$file").debug" ] || { echo "FAILED: no debug file for $(basename "$file")" >&2; exit 1; }
    done
else
    sh "$project/tests/bindings/guards.sh" -t "$tools" -d "$debug" "$library" "$command"
fi

size=$(wc -c <"$library")
echo "$archive: $(wc -c <"$archive") bytes, $(wc -l <"$root/MANIFEST.txt") files"
echo "$(basename "$library"): $size bytes, needs $(needed_by "$library")"
echo "$(basename "$command"): $(wc -c <"$command") bytes, needs $(needed_by "$command")"
for name in $(needed_by "$library"); do
    echo "$name" | grep -qE "^($allowed)$" || { echo "FAILED: the library needs $name" >&2; exit 1; }
done
for name in README.md LICENSE share/doc/mien/CHANGELOG.md share/doc/mien/SECURITY.md share/sbom/mien.spdx.json share/sbom/mien.cdx.json \
    share/licenses/mien/dependencies share/mien/examples/python/mien/runtime.py share/mien/examples/java/mien_jni.c \
    share/mien/examples/csharp/Runtime.cs share/mien/examples/c/first_program.c share/mien/demo/visits/patient.json "bin/mien-demo-data$exe"; do
    [ -e "$root/$name" ] || { echo "FAILED: the archive has no $name" >&2; exit 1; }
done
for name in $(needed_by "$command"); do
    echo "$name" | grep -qE "^($allowed|$own)$" || { echo "FAILED: the command needs $name" >&2; exit 1; }
done
# A guard against what is linked by mistake: the C++ library and the decoders, 1.3 MB, are inside.
[ "$size" -lt 7500000 ] || { echo "FAILED: the library is larger than 7.5 MB" >&2; exit 1; }
