#!/bin/sh
# The demo of the prebuilt archives, made by the project's own generator: make-demo.sh MIEN MIEN_DEMO_DATA OUT_DIR
# OUT_DIR gets a small model of faces, a small model of expressions, and two visits of one made-up person.
set -eu
mien=$1
generator=$2
out=$3
rm -rf "$out" "$out.tmp"
mkdir -p "$out.tmp" "$out"
"$generator" --out "$out.tmp" --subjects 12 --test-subjects 1 >/dev/null
"$mien" model build --template "$out.tmp/template.ply" --kernel geodesic-se --sigma 20 --modes 300 --landmarks "$out.tmp/landmarks.json" \
    --zones "$out.tmp/zones.json" --out "$out/face.safetensors" >/dev/null
"$mien" train --data "$out.tmp/train.safetensors" --method jpca --identity-modes 10 --expression-modes 15 \
    --out "$out/expressions.safetensors" >/dev/null
visit() { # FOLDER EXPRESSION
    mkdir -p "$out/visits/$1"
    cp "$out.tmp/scan/scan_$2.ply" "$out/visits/$1/scan.ply"
    cp "$out.tmp/scan/landmarks_$2.json" "$out/visits/$1/landmarks.json"
}
visit "2026-01-12 before" neutral
visit "2026-03-09 after" grin
printf '{"name": "Made Up", "id": "demo-1", "note": "a face of the generator, no person"}\n' >"$out/visits/patient.json"
rm -rf "$out.tmp"
