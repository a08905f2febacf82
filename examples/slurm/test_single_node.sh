#!/bin/sh
# Starts a Slurm of one node for this machine alone and runs a small study with it: submit.sh with the scans of two
# people (registration, collection, shard, merge), then three shards of a larger set against a single run.
# Touches nothing outside WORK and a temporary folder. Exit status 77: skipped, with the reason.
#
#   test_single_node.sh MIEN MIEN_DEMO_DATA WORK
set -eu
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 77; }
[ $# -eq 3 ] || { echo "usage: test_single_node.sh MIEN MIEN_DEMO_DATA WORK" >&2; exit 2; }
MIEN=$1 demo_data=$2 work=$3
for tool in slurmctld slurmd sbatch munged; do
    command -v "$tool" >/dev/null || skip "$tool is not installed (apt-get install slurm-wlm)"
done
[ "$(id -u)" -eq 0 ] || skip "slurmd needs root"
[ "$(nproc)" -ge 2 ] || skip "the jobs ask for two processors"
rm -rf "$work" && mkdir -p "$work/slurm/state" "$work/slurm/spool" && work=$(cd "$work" && pwd)
short=$(mktemp -d) # a socket's path must be short

started=""
stop() {
    for process in $started; do kill "$process" 2>/dev/null || true; done
    for process in $started; do wait "$process" 2>/dev/null || true; done
    rm -rf "$short"
}
trap stop EXIT
trap 'exit 1' INT TERM

# Patience in tries of a second.
wait_for() {
    tries=$1
    shift
    until "$@" >/dev/null 2>&1; do
        tries=$((tries - 1))
        [ "$tries" -gt 0 ] || return 1
        sleep 1
    done
}

(umask 077 && dd if=/dev/urandom of="$short/munge.key" bs=64 count=1 2>/dev/null)
munged --foreground --force --socket="$short/munge.socket" --key-file="$short/munge.key" \
    --pid-file="$short/munged.pid" --log-file="$work/slurm/munge.txt" --seed-file="$short/munge.seed" \
    >"$work/slurm/out-munge.txt" 2>&1 &
started="$started $!"
wait_for 20 munge -n --socket="$short/munge.socket" ||
    skip "munged does not start: $(tail -n 1 "$work/slurm/out-munge.txt")"

node=$(hostname -s)
cat >"$work/slurm/slurm.conf" <<CONF
ClusterName=mien
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=26817
SlurmdPort=26818
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$short/munge.socket
CredType=cred/munge
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
idle() { sinfo -h -o %t | grep -q idle; }
wait_for 60 idle || skip "the node does not come up: $(tail -n 1 "$work/slurm/out-slurmd.txt")"

fail() {
    echo "failed: $1" >&2
    tail -n 3 "$work"/*/log/*.txt >&2 || true
    exit 1
}
empty_queue() { [ -z "$(squeue -h)" ]; }

# The whole chain. Two people with three scans each; one shard, because a shard needs two subjects.
for seed in 1 2; do
    "$demo_data" --out "$work/demo$seed" --subjects $((14 - 6 * seed)) --test-subjects 0 --seed "$seed" >/dev/null
done
"$MIEN" model build --template "$work/demo1/template.ply" --landmarks "$work/demo1/landmarks.json" --kernel geodesic-se \
    --sigma 20 --modes 300 --out "$work/face.safetensors"
mkdir -p "$work/chain"
for seed in 1 2; do
    for expression in neutral grin mouth_stretch; do
        printf 'person%s\t%s\t%s\t%s\n' "$seed" "$expression" "$work/demo$seed/scan/scan_$expression.ply" \
            "$work/demo$seed/scan/landmarks_$expression.json"
    done
done >"$work/study.tsv"
MIEN="$MIEN" MODEL="$work/face.safetensors" STUDY="$work/study.tsv" WORK="$work/chain" PARTS=1 IDENTITY_MODES=1 \
    EXPRESSION_MODES=2 sh "$here/submit.sh"
wait_for 600 empty_queue || fail "the chain of jobs does not end: $(squeue)"
[ "$(find "$work/chain/fitted" -name '*.ply' | wc -l)" -eq 6 ] || fail "not every scan was registered"
[ -f "$work/chain/expressions.safetensors" ] || fail "no model came out of the chain"
# The dataset holds what the array job fitted: every face within 3 mm of the true one, as the registration test asks.
python3 - "$work" <<'PY'
import json, struct, sys
from pathlib import Path
work = Path(sys.argv[1])
def vertices(path):
    raw = path.read_bytes()
    head, body = raw.split(b"end_header\n", 1)
    count = next(int(line.split()[2]) for line in head.decode().splitlines() if line.startswith("element vertex"))
    width = 12 + 3 * (b"property uchar red" in head)
    return [struct.unpack_from("<3f", body, k * width) for k in range(count)]
zone = json.loads((work / "demo1/zones.json").read_text())["zones"]["face"]
for person in (1, 2):
    for expression in ("neutral", "grin", "mouth_stretch"):
        fitted = vertices(work / f"chain/fitted/person{person}_{expression}.ply")
        truth = vertices(work / f"demo{person}/scan/truth_{expression}.ply")
        error = sum(sum((a - b) ** 2 for a, b in zip(fitted[i], truth[i])) ** 0.5 for i in zone) / len(zone)
        print(f"person {person}, {expression}: {error:.2f} mm from the truth")
        if error > 3.0:
            sys.exit("a fitted face is far from the true one")
PY

# Shards and merge against a single run.
mkdir -p "$work/parts/shards" "$work/parts/log"
cp "$work/demo1/train.safetensors" "$work/parts/study.safetensors"
export MIEN WORK="$work/parts" PARTS=3 IDENTITY_MODES=5 EXPRESSION_MODES=8
shards=$(sbatch --parsable --array=1-3 --output="$WORK/log/shard-%a.txt" "$here/shard.sbatch")
sbatch --wait --dependency="afterok:$shards" --output="$WORK/log/merge.txt" "$here/merge.sbatch" || fail "the merge failed"
"$MIEN" train --data "$WORK/study.safetensors" --identity-modes 5 --expression-modes 8 --out "$WORK/single.safetensors"
grin="$work/demo2/scan/truth_grin.ply"
"$MIEN" neutralize --model "$WORK/single.safetensors" --in "$grin" --out "$WORK/a.ply"
"$MIEN" neutralize --model "$WORK/expressions.safetensors" --in "$grin" --out "$WORK/b.ply"
"$MIEN" measure distance --before "$WORK/a.ply" --after "$WORK/b.ply" --json "$WORK/distance.json"
python3 - "$WORK/distance.json" <<'PY'
import json, sys
worst = json.load(open(sys.argv[1]))["distance"]["whole"]["max_length_mm"]
print(f"merged against single run: {worst:.2e} mm")
sys.exit(worst > 1e-4)
PY
