#!/bin/sh
# Submits a study: registration (array), collection and shards (array), merge. Settings by environment:
# MIEN (command), MODEL (deformation model), STUDY (table of scans), WORK (shared folder), PARTS (shards).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
: "${MIEN:=mien}" "${MODEL:?}" "${STUDY:?}" "${WORK:?}" "${PARTS:=4}"
export MIEN MODEL STUDY WORK PARTS
mkdir -p "$WORK/fitted" "$WORK/shards" "$WORK/log"
scans=$(grep -c . "$STUDY")
register=$(sbatch --parsable --array="1-$scans" --output="$WORK/log/register-%a.txt" "$here/register.sbatch")
collect=$(sbatch --parsable --dependency="afterany:$register" --output="$WORK/log/collect.txt" \
    --wrap="python3 '$here/collect.py' --study '$STUDY' --fitted '$WORK/fitted' --out '$WORK/study.safetensors'")
shards=$(sbatch --parsable --dependency="afterok:$collect" --array="1-$PARTS" \
    --output="$WORK/log/shard-%a.txt" "$here/shard.sbatch")
merge=$(sbatch --parsable --dependency="afterok:$shards" --output="$WORK/log/merge.txt" "$here/merge.sbatch")
echo "register $register, collect $collect, shards $shards, merge $merge"
