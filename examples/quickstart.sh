#!/bin/sh
# The main job on made-up faces, with nothing to download but Debian packages: sh examples/quickstart.sh [FOLDER]
#   a template and a study of faces -> two models; a raw scan of a new person who grins -> the template
#   fitted to it -> the same face without the expression -> volumes, pictures, a table.
# Everything lands in FOLDER (default: build/quickstart).
set -eu
cd "$(dirname "$0")/.."
out=${1:-build/quickstart}
jobs=$(nproc 2>/dev/null || echo 2)

sh cmake/install-packages.sh build

# A build folder of its own: no tests, only the two programs that are needed.
cmake --preset joined -B build/quickstart-build -DMIEN_BUILD_TESTS=OFF >/dev/null
cmake --build build/quickstart-build --target mien_command mien-demo-data -j "$jobs"
mien=build/quickstart-build/bin/mien

step() { printf '\n== %s\n' "$1"; }

step "A template, a study of 30 people, a scan of somebody else"
build/quickstart-build/bin/mien-demo-data --out "$out/demo" --subjects 30

demo=$out/demo
step "Model of how a face may deform"
$mien model build --template "$demo/template.ply" --kernel geodesic-se --sigma 20 --modes 999 \
    --landmarks "$demo/landmarks.json" --zones "$demo/zones.json" --threads "$jobs" --out "$out/face.safetensors"

step "Model of identity and expression"
$mien train --data "$demo/train.safetensors" --method jpca --threads "$jobs" --out "$out/expressions.safetensors"

step "Fit the template to the scan of a grin"
$mien register --model "$out/face.safetensors" --scan "$demo/scan/scan_grin.ply" \
    --landmarks "$demo/scan/landmarks_grin.json" --threads "$jobs" --json "$out/register.json" --out "$out/fitted.ply"

step "Take the expression off"
$mien neutralize --model "$out/expressions.safetensors" --in "$out/fitted.ply" --weights "$out/register.json" \
    --threads "$jobs" --json "$out/neutralize.json" --out "$out/neutral.ply"

step "What the grin moved, zone by zone"
$mien measure volume --before "$out/neutral.ply" --after "$out/fitted.ply" --zones "$demo/zones.json" \
    --json "$out/volume.json"

# The generator knows the truth: how far off is each step?
error_of() { # MESH TRUTH ZONE: rms distance of corresponding vertices, mm
    $mien measure distance --before "$2" --after "$1" --zones "$demo/zones.json" |
        awk -v zone="$3" '$1 == zone { print $4 }'
}
volume_of() { # BEFORE AFTER ZONE: absolute volume, mL
    $mien measure volume --before "$1" --after "$2" --zones "$demo/zones.json" |
        awk -v zone="$3" '$1 == zone { print $5 }'
}
grin=$demo/scan/truth_grin.ply
neutral=$demo/scan/truth_neutral.ply

$mien render "$out/neutral.ply" --compare "$out/fitted.ply" --signed --label "mm outwards" --views front --size 420 \
    --beside "$demo/scan/scan_grin.ply" --beside "$out/fitted.ply" --beside "$out/neutral.ply" \
    --captions "raw scan,fitted,neutral,moved by the grin" --out "$out/quickstart.png" >/dev/null
$mien render "$out/fitted.ply" --compare "$grin" --max 3 --title "distance from the truth" --out "$out/registration.png" >/dev/null

step "Against the truth"
errors() { # LABEL MESH TRUTH
    printf '%-42s %8s %8s\n' "$1" "$(error_of "$2" "$3" face)" "$(error_of "$2" "$3" mouth)"
}
printf '%-42s %8s %8s\n' "distance of corresponding points, rms, mm" face mouth
errors "fitted face from the true grin" "$out/fitted.ply" "$grin"
errors "fitted face from the true neutral" "$out/fitted.ply" "$neutral"
errors "neutralized face from the true neutral" "$out/neutral.ply" "$neutral"
printf '%-42s %8s %8s\n' "volume between, mL (absolute)" "" mouth
printf '%-42s %8s %8s\n' "true neutral and fitted grin" "" "$(volume_of "$neutral" "$out/fitted.ply" mouth)"
printf '%-42s %8s %8s\n' "true neutral and neutralized face" "" "$(volume_of "$neutral" "$out/neutral.ply" mouth)"
printf '\nPictures: %s/quickstart.png %s/registration.png\n' "$out" "$out"
