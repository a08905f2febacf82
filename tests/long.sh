#!/bin/sh
# The long forms: sh tests/long.sh BUILD_FOLDER [MINUTES per fuzz mode]. Prints a line for each, and how many failed.
#   MIEN_LONG=valgrind,tsan,libfuzzer adds what needs builds or tools of its own (cmake/install-packages.sh long).
#   MIEN_CORPUS=FOLDER puts every mesh file below it through the library.
set -u
build=${1:?usage: long.sh BUILD_FOLDER [MINUTES]}
minutes=${2:-1}
build=$(cd "$build" && pwd)
source=$(cd "$(dirname "$0")/.." && pwd)
failed=0
run() {
    name=$1
    shift
    if "$@" >"$build/long-$name.txt" 2>&1; then state=ok; else state=FAILED; failed=$((failed + 1)); fi
    printf '%-24s %-7s %s\n' "$name" "$state" "$(tail -n 1 "$build/long-$name.txt")"
}
# Seeds one after the other until the time is over.
fuzz_for() {
    name=$1 end=$(($(date +%s) + 60 * minutes)) seed=1
    shift
    : >"$build/long-$name.txt"
    state=ok
    while [ "$(date +%s)" -lt "$end" ] && [ "$state" = ok ]; do
        "$@" "$seed" >>"$build/long-$name.txt" 2>&1 || { state=FAILED; failed=$((failed + 1)); }
        seed=$((seed + 1))
    done
    printf '%-24s %-7s %d runs, the last: %s\n' "$name" "$state" $((seed - 1)) "$(tail -n 1 "$build/long-$name.txt")"
}

run oom-all "$build/tests/oom/oom_abi_functions" sweep all
run budget "$build/tests/oom/oom_abi_functions" budget
run budget-long-calls "$build/tests/oom/oom_abi_long_budget" all
run flips "$build/tests/endurance/endurance" flips 100000
run truncations "$build/tests/endurance/endurance" truncations 50000
run kills "$build/tests/endurance/endurance" kills 400
run cancels "$build/tests/endurance/endurance" cancels 5000
run latency "$build/tests/endurance/endurance" latency 20
run crafted "$build/tests/endurance/endurance" crafted 1
run disk "$build/tests/endurance/endurance" disk 5000
run static-library sh "$source/tests/bindings/static_library.sh" "$source" "$build/long-static"
[ -z "${MIEN_CORPUS:-}" ] || run corpus "$build/tests/endurance/endurance" corpus "$MIEN_CORPUS"
run soak "$build/tests/endurance/endurance" soak 500
fuzz_for fuzz-meshes "$build/tests/fuzz/fuzz_files" 200000
for mode in files options calls sequences; do
    fuzz_for "fuzz-$mode" "$build/tests/fuzz/fuzz_abi" "$mode" 20000
done
case ",${MIEN_LONG:-}," in *,valgrind,*) run valgrind sh "$source/tests/valgrind.sh" "$build" ;; esac
case ",${MIEN_LONG:-}," in *,tsan,*) run tsan sh "$source/tests/tsan.sh" ;; esac
case ",${MIEN_LONG:-}," in *,libfuzzer,*) run libfuzzer sh "$source/tests/fuzz/run.sh" $((60 * minutes)) ;; esac
echo "$failed failed"
[ "$failed" = 0 ]
