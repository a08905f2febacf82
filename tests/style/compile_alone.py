#!/usr/bin/env python3
"""Every source and every header compiles on its own, without a precompiled header and without its neighbours.

  compile_alone.py PROJECT BUILD COMPILER [folder ...]

BUILD is a configured (not necessarily built) folder of a preset that does not join files. Nothing is written;
warnings count as errors. Folders default to src, abi and include. A header that some source includes before anything
else is on its own there already, and not compiled once more.
"""
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from commands import Commands

STRICT = ["-fsyntax-only", "-Wall", "-Wextra", "-Wshadow", "-Werror"]
# What the build leaves out as well, and turns on (cmake/MienCompile.cmake).
LEFT_OUT = {"gcc": ["-Wno-psabi", "-Wno-maybe-uninitialized"], "clang": ["-Wno-unknown-warning-option", "-fsized-deallocation"]}


def included_first(sources, folders):
    """The headers that come first in a source: it would not compile if they needed anything before them."""
    headers = set()
    for path in sources:
        found = re.search(r'^[ \t]*#[ \t]*include[ \t]+(["<])([^">]+)[">]', path.read_text(), re.M)
        if found:
            headers.update((folder / found.group(2)).resolve() for folder in [path.parent, *folders])
    return headers


def main():
    project, build, compiler = Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
    folders = sys.argv[4:] or ["src", "abi", "include"]
    commands = Commands(project, build)
    extra = LEFT_OUT["clang" if "clang" in compiler else "gcc"]
    work = [(path, commands.flags[path], None) for path in commands.sources(*folders)]
    covered = included_first([path for path, _, _ in work], [project / "src", project / "include"])
    for folder in folders:
        for header in sorted((project / folder).rglob("*.h*")):
            if "training" in header.parts and not any("training" in p.parts for p in commands.flags):
                continue  # the optional trainer is not configured here
            if header.suffix in (".h", ".hpp") and header.resolve() not in covered:
                own = [f"-I{project / 'include'}", f"-I{header.parent}"]
                work.append((header, commands.of_header(header) + own, f'#include "{header}"\n'))

    def compile_one(job):
        path, flags, text = job
        target = [str(path)] if text is None else ["-x", "c++", "-"]
        return path, subprocess.run([compiler, *flags, *STRICT, *extra, *target], input=text, capture_output=True,
                                    text=True)

    failures = 0
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for path, run in pool.map(compile_one, work):
            if run.returncode:
                failures += 1
                print(f"FAILED: {path.relative_to(project)} does not compile on its own with {compiler}:\n{run.stderr[:3000]}")
    print(f"{len(work)} sources and headers on their own with {compiler}: {failures} failures")
    return 1 if failures or not work else 0


if __name__ == "__main__":
    sys.exit(main())
