#!/usr/bin/env python3
"""The C library that built files need: the highest GLIBC_ version of each, and the names that ask for more than the wanted one.

  glibc_needs.py AT_MOST WANTED FILE...            e.g. 2.36 2.28 lib/libmien.so.0 bin/mien

Fails when a file needs more than AT_MOST, which is what the README of the archive may promise at the worst. OBJDUMP names another
objdump, for files of another machine.
"""
import os
import re
import subprocess
import sys


def number(version):
    return tuple(int(part) for part in version.split("."))


def needs(file):
    """{name: version} of the names that the C library must have."""
    table = subprocess.run([os.environ.get("OBJDUMP", "objdump"), "-T", file], capture_output=True, text=True, check=True).stdout
    return {name: version for version, name in re.findall(r"\*UND\*.*\(?GLIBC_([0-9.]+)\)?\s+(\S+)$", table, re.M)}


def main():
    at_most, wanted, *files = sys.argv[1:]
    failed = False
    for file in files:
        found = needs(file)
        if not found:
            print(f"FAILED: {file} names no symbol of the C library")
            failed = True
            continue
        highest = max(found.values(), key=number)
        above = sorted((number(version), name) for name, version in found.items() if number(version) > number(wanted))
        print(f"{os.path.basename(file)}: glibc {highest}; above {wanted}: "
              + (", ".join(f"{name} ({'.'.join(map(str, version))})" for version, name in above) or "none"))
        if number(highest) > number(at_most):
            print(f"FAILED: {file} needs glibc {highest}, more than {at_most}")
            failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main())
