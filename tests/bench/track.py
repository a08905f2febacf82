#!/usr/bin/env python3
"""Figures of this commit as a file, and which of them moved since another one.

  track.py run COMMANDS.json OUT.json [--bin FOLDER] [--repeat 5] [--against FOLDER] [--callgrind]
           [--place NAME=FOLDER ...]
  track.py compare BEFORE.json AFTER.json [--allow 0.05]

COMMANDS.json: {"name": ["mien", "register", "--model", "{models}/kernel.safetensors", ...], ...}. A first word without a
slash is a program of --bin; {NAME} is taken from --place NAME=FOLDER; {tmp} is an empty folder. speed_commands.json beside this
file wants the places models (kernel.safetensors, trained60.safetensors), scan (scan.ply, landmarks.json), template (template.ply).

run measures each command as a process, after one run that is not counted: processor seconds (user and system), peak memory
and, where `perf` counts them, instructions, which other work on the machine does not change; --callgrind counts them by
valgrind instead, in one more run that takes fifty times as long. With --against another
build's folder, its runs take turns with ours, so that both see the same machine; OUT.json then holds both. OUT.json names
commit, machine, command, and of each figure the median and the spread (least and most).

compare says of each figure the ratio of the medians, and "moved" where it is beyond --allow and, for seconds, the runs of
one do not reach into those of the other. Exit code 1 when something became worse. `compare OUT.json` alone compares the two
builds of an --against run.
"""
import argparse
import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

FIGURES = ("seconds", "instructions", "peak_mb")


def counts_instructions():
    if shutil.which("perf") is None:
        return False
    done = subprocess.run(["perf", "stat", "-x", ",", "-e", "instructions:u", "true"], capture_output=True, text=True)
    return done.returncode == 0 and "not supported" not in done.stderr and "not counted" not in done.stderr


def measure(command, with_instructions):
    """One run: {"seconds", "peak_mb", "instructions"}; ends the program when it fails."""
    with tempfile.NamedTemporaryFile("r") as counted, tempfile.TemporaryFile() as said:
        full = ["perf", "stat", "-x", ",", "-o", counted.name, "-e", "instructions:u", "--", *command] if with_instructions else command
        process = subprocess.Popen(full, stdout=said, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            said.seek(0)
            sys.exit(f"{' '.join(command)} ended with {process.returncode}:\n{said.read().decode(errors='replace')[-2000:]}")
        figures = {"seconds": usage.ru_utime + usage.ru_stime, "peak_mb": usage.ru_maxrss / 1024}
        if with_instructions:
            for line in counted.read().splitlines():
                cells = line.split(",")
                if len(cells) > 2 and cells[2].startswith("instructions") and cells[0].isdigit():
                    figures["instructions"] = int(cells[0])
        return figures


def instructions_by_callgrind(command):
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command], capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or found is None:
        sys.exit(f"{' '.join(command)} under valgrind ended with {done.returncode}:\n{done.stderr[-2000:]}")
    return {"instructions": int(found.group(1))}


def filled(words, folder, places):
    try:
        command = [word.format(**places) for word in words]
    except KeyError as name:
        sys.exit(f"{' '.join(words)} wants --place {name.args[0]}=FOLDER")
    if "/" not in command[0]:
        command[0] = str(Path(folder) / command[0])
    return command


def summary(runs):
    row = {}
    for figure in FIGURES:
        values = [run[figure] for run in runs if figure in run]
        if values:
            row[figure] = {"median": statistics.median(values), "least": min(values), "most": max(values)}
    return row


def commit_of(folder):
    done = subprocess.run(["git", "-C", str(folder), "describe", "--always", "--dirty", "--abbrev=12"], capture_output=True, text=True)
    return done.stdout.strip() or "unknown"


def processor():
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or "unknown"


def run(options):
    plan = json.loads(Path(options.commands).read_text())
    places = dict(place.split("=", 1) for place in options.place)
    folders = {"after": options.bin} | ({"before": options.against} if options.against else {})
    instructions = not options.callgrind and counts_instructions()
    result = {"machine": f"{platform.node()}, {processor()}, {os.cpu_count()} processors", "runs": options.repeat,
              "commits": {side: commit_of(folder) for side, folder in folders.items()}, "figures": {side: {} for side in folders}}
    for name, words in plan.items():
        runs = {side: [] for side in folders}
        for turn in range(options.repeat + 1):
            for side, folder in folders.items():
                with tempfile.TemporaryDirectory() as temporary:
                    figures = measure(filled(words, folder, places | {"tmp": temporary}), instructions)
                if turn > 0:
                    runs[side].append(figures)
        for side, folder in folders.items() if options.callgrind else ():
            with tempfile.TemporaryDirectory() as temporary:
                runs[side].append(instructions_by_callgrind(filled(words, folder, places | {"tmp": temporary})))
        for side in folders:
            result["figures"][side][name] = {"command": " ".join(words)} | summary(runs[side])
        print(name, " ".join(f"{figure} {row['median']:.4g}" for figure, row in summary(runs["after"]).items()), flush=True)
    Path(options.out).write_text(json.dumps(result, indent=1) + "\n")


def moved(before, after, figure, allow):
    ratio = after["median"] / before["median"] if before["median"] > 0 else 1.0
    apart = after["least"] > before["most"] or after["most"] < before["least"]
    beyond = ratio > 1 + allow or ratio < 1 / (1 + allow)
    return ratio, beyond and (apart or figure == "instructions")


def compare(options):
    files = [json.loads(Path(path).read_text()) for path in options.files]
    if len(files) == 1:
        if "before" not in files[0]["figures"]:
            sys.exit(f"{options.files[0]} holds one build: give two files, or run with --against")
        before, after = files[0]["figures"]["before"], files[0]["figures"]["after"]
    else:
        before, after = files[0]["figures"]["after"], files[1]["figures"]["after"]
        if files[0]["machine"] != files[1]["machine"]:
            print("note: measured on different machines; seconds do not compare")
    worse = 0
    for name in sorted(before.keys() | after.keys()):
        if name not in before or name not in after:
            print(f"{name}: only {'after' if name in after else 'before'}")
            continue
        for figure in FIGURES:
            if figure not in before[name] or figure not in after[name]:
                continue
            ratio, is_moved = moved(before[name][figure], after[name][figure], figure, options.allow)
            word = "" if not is_moved else "  moved: worse" if ratio > 1 else "  moved: better"
            worse += is_moved and ratio > 1
            print(f"{name:32s} {figure:13s} {before[name][figure]['median']:12.5g} {after[name][figure]['median']:12.5g}"
                  f" {ratio:7.3f}{word}")
    return 1 if worse else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    tasks = parser.add_subparsers(dest="task", required=True)
    task = tasks.add_parser("run")
    task.add_argument("commands")
    task.add_argument("out")
    task.add_argument("--bin", default="build/release/bin")
    task.add_argument("--against")
    task.add_argument("--repeat", type=int, default=5)
    task.add_argument("--callgrind", action="store_true")
    task.add_argument("--place", action="append", default=[])
    task = tasks.add_parser("compare")
    task.add_argument("files", nargs="+")
    task.add_argument("--allow", type=float, default=0.05)
    options = parser.parse_args()
    if options.task == "compare":
        if len(options.files) > 2:
            sys.exit("compare takes one file or two")
        return compare(options)
    return run(options)


if __name__ == "__main__":
    sys.exit(main())
