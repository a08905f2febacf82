#!/usr/bin/env python3
"""Runs the tests of the C ABI and says which public functions none of them called: reached.py SYMBOLS PROGRAM ...

The programs are linked to bind names when they are first called, and glibc tells each binding (LD_DEBUG=bindings). So a
function counts when a test really called it, by itself or through the C++ face, and not when its name stands somewhere.
The abuse test calls everything and does not count. Exits as the first program that fails does; 1 for a function missed.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

BINDING = re.compile(r"binding file \S+ \[\d+\] to \S*libmien\S* \[\d+\]: normal symbol `(mien_\w+)'")


def called_by(program):
    """Exit code of the program and the functions of libmien that it called."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {k: v for k, v in os.environ.items() if k != "LD_BIND_NOW"}
        environment.update(LD_DEBUG="bindings", LD_DEBUG_OUTPUT=str(Path(folder) / "bindings"))
        code = subprocess.run([program], env=environment, check=False).returncode
        texts = [path.read_text(errors="replace") for path in Path(folder).glob("bindings.*")]
    return code, {name for text in texts for name in BINDING.findall(text)}


def main():
    listed = set(Path(sys.argv[1]).read_text().split())
    reached, failed = set(), 0
    for program in sys.argv[2:]:
        code, names = called_by(program)
        failed = failed or code
        reached |= names
    missed = sorted(listed - reached)
    for name in missed:
        print(f"{name}: no test of the C ABI calls it: add one of its result to tests/abi")
    print(f"{len(listed & reached)} of {len(listed)} public functions are called by tests of their results")
    if not reached:
        print("no binding was seen: is the program linked with -z lazy, and the C library glibc?")
    return failed or (1 if missed else 0)


if __name__ == "__main__":
    sys.exit(main())
