#!/bin/sh
# The hosts in C under valgrind: sh tests/valgrind.sh BUILD_FOLDER
# first_program and visits (examples/c) do the main job on demo data, test_previous_release what release 0.1 did: no
# invalid read or write, no use of what was never set, no block lost. Some minutes. No suppressions.
set -eu
build=$(cd "${1:?usage: valgrind.sh BUILD_FOLDER}" && pwd)
work=$build/valgrind
mien=$build/bin/mien
rm -rf "$work" && mkdir -p "$work" && cd "$work"
# A small model and a coarse scan: valgrind is fifty times slower.
"$build/bin/mien-demo-data" --out demo --subjects 4 --test-subjects 1 >demo.log
"$mien" model build --template demo/template.ply --kernel geodesic-se --sigma 20 --modes 60 --landmarks demo/landmarks.json \
    --zones demo/zones.json --out face.safetensors >>demo.log
"$mien" train --data demo/train.safetensors --method jpca --identity-modes 3 --expression-modes 5 \
    --out expressions.safetensors >>demo.log
"$mien" mesh decimate demo/scan/scan_grin.ply scan.ply --vertices 6000 >>demo.log
failed=0
look() {
    name=$1
    shift
    if valgrind -q --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite,indirect,possible \
        --log-file="$name.txt" "$@" >"$name.out" 2>&1; then
        state=clean
    else
        state=FAULTS
        failed=$((failed + 1))
    fi
    printf '%-24s %s\n' "$name" "$state"
}
look first_program "$build/bin/mien-first-program" face.safetensors expressions.safetensors scan.ply neutral.ply
look visits "$build/bin/mien-visits" face.safetensors expressions.safetensors scan.ply scan.ply scan.ply
look previous_release "$build/tests/abi/test_previous_release"
echo "$failed of 3 programs with faults"
[ "$failed" = 0 ]
