#!/usr/bin/env python3
"""clang-tidy with the project's .clang-tidy over the library and the C ABI; any finding fails.

  tidy.py PROJECT BUILD            all of src and abi (about 10 processor minutes)
  tidy.py PROJECT BUILD FILE ...   these files alone

BUILD is a configured folder of a preset that does not join files.
"""
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from commands import Commands


def main():
    project, build = Path(sys.argv[1]).resolve(), sys.argv[2]
    commands = Commands(project, build)
    wanted = {Path(name).resolve() for name in sys.argv[3:]}
    files = [p for p in commands.sources("src", "abi") if not wanted or p in wanted]
    missing = wanted - set(files)
    if missing:
        raise SystemExit(f"{sorted(missing)[0]} is no source of src or abi that {build} compiles")

    def tidy(path):
        return path, subprocess.run(["clang-tidy", "--quiet", "--warnings-as-errors=*", str(path), "--",
                                     "-fsized-deallocation", *commands.flags[path]], capture_output=True, text=True)

    failures = 0
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for path, run in pool.map(tidy, files):
            if run.returncode:
                failures += 1
                print(f"FAILED: {path.relative_to(project)}:\n{run.stdout[:6000]}{run.stderr[-500:] if not run.stdout else ''}")
    print(f"{len(files)} files tidied, {failures} with findings")
    return 1 if failures or not files else 0


if __name__ == "__main__":
    sys.exit(main())
