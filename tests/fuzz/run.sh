#!/bin/sh
# Fuzzes every reader, options and calls by libFuzzer under AddressSanitizer and UBSan: sh tests/fuzz/run.sh [SECONDS] [TARGET ...]
# SECONDS per target (60). Builds preset fuzz (clang). What it found stays in build/fuzz/found, what it learned in
# build/fuzz/corpus. Prints a line per target: how many inputs ran, and whether one was a fault.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-60}
[ $# = 0 ] || shift
cmake --preset fuzz >/dev/null
cmake --build build/fuzz --target fuzz_abi fuzz_files libfuzz_abi libfuzz_files -- -j "$(nproc)"
folder=$PWD/build/fuzz
mkdir -p "$folder/found" "$folder/links"
"$folder/tests/fuzz/fuzz_files" seeds "$folder/corpus/files"
"$folder/tests/fuzz/fuzz_abi" seeds "$folder/corpus/abi"
mkdir -p "$folder/corpus/abi/options" "$folder/corpus/abi/calls" "$folder/corpus/abi/sequences"

failed=0
for place in "$folder"/corpus/files/* "$folder"/corpus/abi/*; do
    target=$(basename "$place")
    case " ${*:-$target} " in *" $target "*) ;; *) continue ;; esac
    program=$folder/tests/fuzz/libfuzz_$(basename "$(dirname "$place")")
    ln -sf "$program" "$folder/links/libfuzz_$target"
    log=$folder/found/$target.txt
    state=ok
    ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=1 "$folder/links/libfuzz_$target" -max_total_time="$seconds" -timeout=25 \
        -rss_limit_mb=2048 -max_len=65536 -len_control=0 -print_final_stats=1 -artifact_prefix="$folder/found/$target-" "$place" >"$log" 2>&1 || {
        state=FAULT
        failed=$((failed + 1))
    }
    printf '%-40s %-6s %10s inputs\n' "$target" "$state" "$(sed -n 's/stat::number_of_executed_units: *//p' "$log")"
done
echo "$failed targets with faults"
[ "$failed" = 0 ]
