#!/bin/sh
# The unpacked archive on a machine that has the C library and nothing else: no compiler, no headers, no libstdc++,
# no shell, no /proc, no /etc. The first program in C does the main job there, and the command runs.
#   bare_root.sh UNPACKED_ARCHIVE DEMO_FOLDER WORK_DIR [CC [ROOT]]
# DEMO_FOLDER holds face.safetensors, expressions.safetensors, scan/scan_grin.ply. Needs root, or user namespaces.
# ROOT is a folder with another C library (cmake/sysroot.sh), whose loader and libraries are taken then; CC compiles against it.
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd)
archive=$1
demo=$2
bare=$3/bare
cc=${4:-cc}
root=${5:-}
rm -rf "$bare"
mkdir -p "$bare/mien" "$bare/job"
cp -R "$archive/." "$bare/mien"
cp "$demo/face.safetensors" "$demo/expressions.safetensors" "$demo/scan/scan_grin.ply" "$bare/job"
$cc -std=c99 "$project/examples/c/first_program.c" -I"$archive/include" -L"$archive/lib" -lmien -Wl,-rpath,/mien/lib -o "$bare/job/first"

# The loader and the C library of this machine; `ldd` names what else it would take, which is left out on purpose.
loader=$(readelf -lW "$bare/job/first" | sed -n 's/.*interpreter: \(.*\)\]/\1/p')
for library in "$loader" $(ldd "$archive/bin/mien" | grep -oE '/[^ ]*/lib(c|m|pthread|dl)\.so\.[0-9]+'); do
    mkdir -p "$bare$(dirname "$library")"
    cp -L "$root$library" "$bare$library"
done

there() { # VARIABLE=VALUE ... -- COMMAND ...: runs it with that environment alone
    settings=
    while [ "$1" != -- ]; do settings="$settings $1"; shift; done
    shift
    if [ "$(id -u)" = 0 ]; then
        # shellcheck disable=SC2086
        env -i $settings "$(command -v chroot)" "$bare" "$@"
    else
        # shellcheck disable=SC2086
        env -i $settings "$(command -v unshare)" --user --map-root-user "$(command -v chroot)" "$bare" "$@"
    fi
}

# What `ldd -r` asks, by the loader of the bare machine: every library and every name of both files.
for file in /mien/lib/libmien.so.0 /mien/bin/mien; do
    names=$(there LD_LIBRARY_PATH=/mien/lib -- "$loader" --list "$file" 2>&1) || { echo "FAILED: $names" >&2; exit 1; }
    bound=$(there LD_LIBRARY_PATH=/mien/lib LD_TRACE_LOADED_OBJECTS=1 LD_WARN=yes LD_BIND_NOW=yes -- "$loader" "$file" 2>&1) || true
    if echo "$names $bound" | grep -E 'undefined|not found'; then
        echo "FAILED: $file has unresolved names where there is only the C library" >&2
        exit 1
    fi
    echo "$file needs:" $(echo "$names" | sed 's/ (0x.*//; s/.*=> //')
done
there -- /job/first /job/face.safetensors /job/expressions.safetensors /job/scan_grin.ply /job/neutral.ply >"$bare/job/first.log"
there LD_LIBRARY_PATH=/mien/lib -- /mien/bin/mien --version
# The one command of the archive's README, as it stands there, seen from the archive's folder.
readme=$(grep '^bin/mien report ' "$archive/README.md" | sed 's| share/| /mien/share/|g; s|^bin/|/mien/bin/|; s| report.html| /job/report.html|')
[ -n "$readme" ] || { echo "FAILED: the README names no command" >&2; exit 1; }
# shellcheck disable=SC2086
there LD_LIBRARY_PATH=/mien/lib -- $readme >"$bare/job/report.log" || { echo "FAILED: $readme" >&2; exit 1; }
grep -q 'cheek left\|left cheek' "$bare/job/report.html" || { echo "FAILED: the report does not speak of the left cheek" >&2; exit 1; }
tail -1 "$bare/job/report.log"
there LD_LIBRARY_PATH=/mien/lib -- /mien/bin/mien-demo-data --out /job/more --subjects 2 --test-subjects 0 >/dev/null
cmp "$bare/job/neutral.ply" "$3/neutral.ply" || { echo "FAILED: the bare machine gives another face" >&2; exit 1; }
echo "bare machine, $(strings "$bare"/lib/*/libc.so.6 | grep -m1 'GNU C Library' || true): $(cd "$bare" && find lib* usr -type f 2>/dev/null | tr '\n' ' ')and the archive do the main job"
