#!/bin/sh
# Starts a Slurm of one node for this machine alone, registers and trains a small study with it, and
# compares the merged model with a single run. Exit status 77: skipped, with the reason.
#
#   test_single_node.sh MIEN DEMO_DATA WORK
set -eu
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 77; }
[ $# -eq 3 ] || { echo "usage: test_single_node.sh MIEN DEMO_DATA WORK" >&2; exit 2; }
MIEN=$1 demo=$2 work=$3
for tool in slurmctld slurmd sbatch munged; do
    command -v "$tool" >/dev/null || skip "$tool is not installed (apt-get install slurm-wlm)"
done
[ "$(id -u)" -eq 0 ] || skip "slurmd needs root"
rm -rf "$work" && mkdir -p "$work/slurm/state" "$work/slurm/spool" && work=$(cd "$work" && pwd)

started=""
stop() { for process in $started; do kill "$process" 2>/dev/null || true; done; }
trap stop EXIT INT TERM

mkdir -p /run/munge && chown munge: /run/munge 2>/dev/null || true
[ -f /etc/munge/munge.key ] || mungekey >/dev/null 2>&1 || skip "no munge key can be made"
if ! munge -n >/dev/null 2>&1; then
    setpriv --reuid munge --regid munge --clear-groups munged --foreground --force >"$work/slurm/munge.txt" 2>&1 &
    started="$started $!"
    sleep 2
    munge -n >/dev/null 2>&1 || skip "munged does not start: $(tail -n 1 "$work/slurm/munge.txt")"
fi
node=$(hostname -s)
cat >"$work/slurm/slurm.conf" <<CONF
ClusterName=mien
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=26817
SlurmdPort=26818
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
StateSaveLocation=$work/slurm/state
SlurmdSpoolDir=$work/slurm/spool
SlurmctldPidFile=$work/slurm/slurmctld.pid
SlurmdPidFile=$work/slurm/slurmd.pid
SlurmctldLogFile=$work/slurm/slurmctld.txt
SlurmdLogFile=$work/slurm/slurmd.txt
SchedulerParameters=sched_interval=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$work/slurm/slurm.conf"
slurmctld -D >"$work/slurm/out-ctld.txt" 2>&1 &
started="$started $!"
slurmd -D >"$work/slurm/out-slurmd.txt" 2>&1 &
started="$started $!"
tries=0
until sinfo -h -o %t 2>/dev/null | grep -q idle; do
    tries=$((tries + 1))
    [ "$tries" -lt 30 ] || skip "the node does not come up: $(tail -n 1 "$work/slurm/out-slurmd.txt")"
    sleep 1
done

# Shards and merge on the demo's training set.
mkdir -p "$work/shards" "$work/log"
cp "$demo/train.safetensors" "$work/study.safetensors"
export MIEN WORK="$work" PARTS=3 IDENTITY_MODES=8 EXPRESSION_MODES=8
shards=$(sbatch --parsable --mem=0 --cpus-per-task=1 --array=1-3 --output="$work/log/shard-%a.txt" "$here/shard.sbatch")
sbatch --wait --mem=0 --cpus-per-task=1 --dependency="afterok:$shards" --output="$work/log/merge.txt" "$here/merge.sbatch"
"$MIEN" train --data "$work/study.safetensors" --identity-modes 8 --expression-modes 8 --out "$work/single.safetensors"
"$MIEN" neutralize --model "$work/single.safetensors" --in "$demo/scan/truth_grin.ply" --out "$work/a.ply"
"$MIEN" neutralize --model "$work/expressions.safetensors" --in "$demo/scan/truth_grin.ply" --out "$work/b.ply"
"$MIEN" measure distance --before "$work/a.ply" --after "$work/b.ply" --json "$work/distance.json"
python3 - "$work/distance.json" <<'PY'
import json, sys
worst = json.load(open(sys.argv[1]))["distance"]["whole"]["max_length_mm"]
print(f"merged against single run: {worst:.2e} mm")
sys.exit(worst > 1e-4)
PY
