#!/bin/sh
# Other machines, proven on this one: builds the self-contained archives and runs programs against them.
#   sh tests/cross.sh [linux-x86_64] [linux-aarch64] [windows-x86_64]    (default: all three)
# 64-bit ARM runs through qemu-user, Windows through wine; what is missing is installed by apt. Each archive
# is unpacked into an empty folder and used as a stranger would: the first program in C does the main job on the project's
# own demo data, on this machine's kind also where there is nothing but the C library; a program of the first release runs,
# file names are UTF-8, the README's command makes a report, and every function is called with every wrong argument. The neutral face must agree with this
# machine's own build to 0.001 mm (abi/README.md, promises).
#   MIEN_NATIVE  a build of this machine with bin/mien and bin/mien-demo-data (default build/joined)
#   MIEN_WORK    keeps dependencies and objects for the next run (default build/cross)
set -eu
project=$(cd "$(dirname "$0")/.." && pwd)
native=${MIEN_NATIVE:-$project/build/joined}
work=${MIEN_WORK:-$project/build/cross}
mkdir -p "$work"
work=$(cd "$work" && pwd)
[ $# -gt 0 ] || set -- linux-x86_64 linux-aarch64 windows-x86_64

install() {
    missing=
    for package; do dpkg -s "$package" >/dev/null 2>&1 || missing="$missing $package"; done
    [ -z "$missing" ] && return
    as_root=
    [ "$(id -u)" = 0 ] || as_root=sudo
    # shellcheck disable=SC2086
    $as_root apt-get -q update && $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
}

# The models and the answer of this machine's own build.
demo=$work/demo
if [ ! -f "$demo/neutral.ply" ]; then
    mkdir -p "$demo"
    "$native/bin/mien-demo-data" --out "$demo" --subjects 4 --test-subjects 1 >"$demo/log"
    "$native/bin/mien" model build --template "$demo/template.ply" --kernel geodesic-se --sigma 20 --modes 99 \
        --landmarks "$demo/landmarks.json" --zones "$demo/zones.json" --out "$demo/face.safetensors" >>"$demo/log"
    "$native/bin/mien" train --data "$demo/train.safetensors" --method jpca --identity-modes 3 --expression-modes 5 \
        --out "$demo/expressions.safetensors" >>"$demo/log"
    "$native/bin/mien-first-program" "$demo/face.safetensors" "$demo/expressions.safetensors" "$demo/scan/scan_grin.ply" \
        "$demo/neutral.ply" >>"$demo/log"
fi

for machine; do
    echo "== $machine"
    sh "$project/cmake/package.sh" "$machine" "$work"
    root=$(echo "$work/$machine/unpacked"/*/)
    programs=$work/$machine/programs
    rm -rf "$programs"
    mkdir -p "$programs"
    warnings="-Wall -Wextra -Werror"
    case $machine in
    linux-x86_64)
        cross=; exe=; link="-L${root}lib -lmien -Wl,-rpath,${root}lib"
        run() { "$@"; }
        ;;
    linux-aarch64)
        install qemu-user
        cross=aarch64-linux-gnu-; exe=; link="-L${root}lib -lmien -Wl,-rpath,${root}lib"
        run() { qemu-aarch64 -L /usr/aarch64-linux-gnu "$@"; }
        ;;
    windows-x86_64)
        install wine64
        cross=x86_64-w64-mingw32-; exe=.exe; link="${root}lib/libmien.dll.a -static"
        export WINEPREFIX="$work/wine" WINEDEBUG=-all
        run() { "$(command -v wine64 || echo /usr/lib/wine/wine64)" "$@"; }
        cp "$root"bin/*.dll "$programs/"
        ;;
    *) echo "unknown machine $machine" >&2; exit 2 ;;
    esac
    posix=
    [ "$machine" = windows-x86_64 ] && posix=-posix
    # shellcheck disable=SC2086
    ${cross}gcc$posix -std=c99 $warnings -pedantic "$project/examples/c/first_program.c" -I"${root}include" $link -o "$programs/first$exe"
    # shellcheck disable=SC2086
    ${cross}gcc$posix -std=c99 $warnings "$project/tests/abi/previous_release.c" -I"$project/tests/golden/abi-0.1" $link -lm -o "$programs/previous$exe"
    # shellcheck disable=SC2086
    ${cross}gcc$posix -std=c99 $warnings "$project/tests/abi/utf8_paths.c" -I"${root}include" $link -o "$programs/utf8_paths$exe"
    python3 "$project/tests/abi/generate_abuse.py" "${root}include/mien" "$programs/abuse_tables.inc"
    # shellcheck disable=SC2086
    ${cross}g++$posix -std=c++17 -O1 "$project"/tests/abi/abuse/*.cpp -I"$programs" -I"${root}include" $link -o "$programs/abuse$exe"

    cd "$programs"
    run "./first$exe" "$demo/face.safetensors" "$demo/expressions.safetensors" "$demo/scan/scan_grin.ply" neutral.ply >first.log
    python3 "$project/tests/bindings/compare_ply.py" "$demo/neutral.ply" neutral.ply 0.001
    if [ "$machine" = "linux-$(uname -m)" ]; then
        sh "$project/tests/bindings/bare_root.sh" "${root%/}" "$demo" "$programs"
        # And with the old C library that the archive was compiled against.
        old=$(sh "$project/cmake/sysroot.sh" "$machine" "$work/dependencies" | head -1)
        sh "$project/tests/bindings/bare_root.sh" "${root%/}" "$demo" "$programs" "cc $old" "$work/dependencies/sysroot-$machine"
    fi
    # The one command of the archive's README, as it stands there, by the archive's own programs alone. On 64-bit ARM with the old C
    # library and no other: what qemu finds below the folder is all there is.
    report=$(sed -n 's/^bin\/mien report \(.*\) --out report\.html$/\1/p' "${root}README.md")
    [ -n "$report" ] || { echo "FAILED: the README names no command" >&2; exit 1; }
    bare() { run "$@"; }
    [ "$machine" != linux-aarch64 ] || bare() { env -i "$(command -v qemu-aarch64)" -L "$work/dependencies/sysroot-linux-aarch64" "$@"; }
    # shellcheck disable=SC2086
    (cd "$root" && bare "bin/mien$exe" report $report --out "$programs/report.html" >"$programs/report.log") ||
        { tail -5 "$programs/report.log" >&2; echo "FAILED: the README's command" >&2; exit 1; }
    grep -q 'left cheek' "$programs/report.html" || { echo "FAILED: the report does not speak of the left cheek" >&2; exit 1; }
    tail -1 "$programs/report.log"
    rm "$programs/report.html"
    run "./previous$exe"
    run "./utf8_paths$exe"
    run "./abuse$exe" - 20000
    cd "$work"
done
