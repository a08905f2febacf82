#!/bin/sh
# The C library that the Linux archives are compiled against: Debian 11's (glibc 2.31), so that what is compiled here asks for
# no newer one. Prints the compiler flags for C, a line further those for C++; none for Windows.
#   sysroot.sh linux-x86_64|linux-aarch64|windows-x86_64 WORK_DIR
# The compiler and its C++ library stay this machine's. Only the unwinder comes from there too: today's asks the C library for a
# function of glibc 2.35 (_dl_find_object). WORK_DIR/sysroot-MACHINE holds it; nothing is fetched twice.
set -e
machine=$1
work=$2
case $machine in
linux-x86_64) architecture=amd64; triple=x86_64-linux-gnu; compiler=g++ ;;
linux-aarch64) architecture=arm64; triple=aarch64-linux-gnu; compiler=aarch64-linux-gnu-g++ ;;
windows-*) exit 0 ;;
*) echo "sysroot.sh: no C library for $machine" >&2; exit 2 ;;
esac
mkdir -p "$work"
work=$(cd "$work" && pwd)
root=$work/sysroot-$machine
libraries=$root/usr/lib/$triple

if [ ! -f "$libraries/libgcc_eh.a" ]; then
    rm -rf "$root" "$root.apt"
    mkdir -p "$root" "$root.apt/lists/partial" "$root.apt/cache/archives/partial" "$root.apt/files"
    # Lists of our own, so that the machine's apt configuration stays as it is. An old release moves to the archive one day.
    for home in http://deb.debian.org/debian http://archive.debian.org/debian; do
        echo "deb [arch=$architecture signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $home bullseye main" >"$root.apt/sources.list"
        apt="apt-get -q -o Dir::Etc::sourcelist=$root.apt/sources.list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$root.apt/lists
            -o Dir::State::status=/dev/null -o Dir::Cache=$root.apt/cache -o APT::Sandbox::User=root -o APT::Architectures::=$architecture
            -o Acquire::Check-Valid-Until=false"
        # shellcheck disable=SC2086
        if $apt update >"$root.apt/log" 2>&1 && (cd "$root.apt/files" && $apt download "libc6:$architecture" "libc6-dev:$architecture" \
            "linux-libc-dev:$architecture" "libgcc-10-dev:$architecture" >>"$root.apt/log" 2>&1); then
            break
        fi
    done
    [ "$(ls "$root.apt/files" | wc -l)" = 4 ] || { tail -5 "$root.apt/log" >&2; echo "FAILED: no C library of Debian 11 for $machine" >&2; exit 1; }
    for file in "$root.apt/files"/*.deb; do dpkg-deb -x "$file" "$root"; done
    # Links with a full path would lead to this machine's own files.
    find "$root" -lname '/*' | while read -r link; do ln -sfr "$root$(readlink "$link")" "$link"; done
    cp "$root/usr/lib/gcc/$triple/10/libgcc_eh.a" "$libraries/"
    rm -rf "$root/usr/lib/gcc" "$root.apt"
fi

# The folders of the compiler itself, then those of the old C library: a cross compiler looks for its own C library first.
own=$($compiler -x c++ -E -v - </dev/null 2>&1 | sed -n '/^#include </,/^End/s/^ //p' | while read -r folder; do realpath "$folder"; done)
of_c="-isystem $(echo "$own" | grep '/gcc[^/]*/.*/include$' | head -1)"
of_cxx=$(echo "$own" | grep '/c++/' | sed 's/^/-isystem /' | tr '\n' ' ')
system="-isystem $root/usr/include/$triple -isystem $root/usr/include"
find_libraries="--sysroot=$root -B$libraries/"
echo "$find_libraries -nostdinc $of_c $system"
echo "$find_libraries -nostdinc -nostdinc++ $of_cxx$of_c $system"
