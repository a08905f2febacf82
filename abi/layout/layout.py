#!/usr/bin/env python3
"""Size, alignment and offsets of every public struct and the value of every constant, per machine.

  layout.py print INCLUDE_DIR COMPILER [FLAG ...]            the layout, one line per fact
  layout.py compare SNAPSHOT INCLUDE_DIR COMPILER [FLAG ...] exit 1 and say what broke
  layout.py update INCLUDE_DIR                               rewrite the snapshots beside this file

The structs come from the headers, so a new one is measured without being listed anywhere. The
compiler only has to compile: the facts are read from its assembly, so that one machine can speak
for all. Growth is allowed where callers tell their size (a struct that opens with struct_size and
is no part of another one): old fields must keep their places, new ones must follow them.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from read_headers import read_interface

CLANG = ["clang", "-ffreestanding"]
MACHINES = {
    "x86_64": CLANG + ["--target=x86_64-linux-gnu"],
    "aarch64": CLANG + ["--target=aarch64-linux-gnu"],
    "x86_64-windows": CLANG + ["--target=x86_64-w64-windows-gnu", "-DMIEN_STATIC"],
}


def questions(interface):
    """(key, C expression) of every fact."""
    for struct in interface.structs:
        yield f"struct {struct.name} size", f"sizeof({struct.name})"
        yield f"struct {struct.name} align", f"offsetof(struct {{ char c; {struct.name} s; }}, s)"
        for field in struct.fields:
            yield f"field {struct.name}.{field.name} offset", f"offsetof({struct.name}, {field.name})"
            yield f"field {struct.name}.{field.name} size", f"sizeof((({struct.name} *)0)->{field.name})"
    for name in interface.enumerators:
        yield f"constant {name}", name
    yield "constant MIEN_ABI_VERSION", "MIEN_ABI_VERSION"


def measure(include, compiler):
    facts = list(questions(read_interface(include, strict=False)[0]))
    source = "#include <stddef.h>\n#include <mien/mien.h>\nconst long long mien_layout[] = {\n"
    source += ",\n".join(f"    (long long)({expression})" for _, expression in facts)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "layout.c"
        path.write_text(source + "\n};\n")
        assembly = subprocess.run([*compiler, "-std=c99", "-S", "-o", "-", f"-I{Path(include).parent}", str(path)],
                                  check=True, capture_output=True, text=True).stdout
    values = []
    for word, number in re.findall(r"^\s*\.(quad|xword|zero)\s+(-?\d+)", assembly, re.M):
        values += [0] * (int(number) // 8) if word == "zero" else [int(number)]
    values = [v - 2**64 if v >= 2**63 else v for v in values]
    if len(values) != len(facts):
        raise SystemExit(f"{len(facts)} facts asked for, {len(values)} found in the assembly")
    return {key: value for (key, _), value in zip(facts, values)}


def text(layout):
    return "".join(f"{key} {value}\n" for key, value in layout.items())


def read(path):
    lines = (line.rsplit(" ", 1) for line in Path(path).read_text().splitlines() if line)
    return {key: int(value) for key, value in lines}


def growable(interface):
    """Structs that may grow: they open with struct_size and stand in no other struct by value."""
    held = {field.type.split("[")[0] for struct in interface.structs for field in struct.fields}
    return {s.name for s in interface.structs
            if s.fields and s.fields[0].name == "struct_size" and s.name not in held}


def compare(old, new, may_grow):
    """(faults, additions) in words."""
    faults, additions = [], []
    for key, value in old.items():
        if key not in new:
            faults.append(f"{key} is gone (was {value})")
        elif new[key] != value:
            struct = key.split()[1]
            grown = key.endswith(" size") and key.startswith("struct ") and struct in may_grow
            if grown and new[key] > value:
                additions.append(f"{key}: {value} -> {new[key]}")
            else:
                faults.append(f"{key}: {value} -> {new[key]}")
    for key in new.keys() - old.keys():
        match = re.fullmatch(r"field (\w+)\.(\w+) offset", key)
        if not match or f"struct {match.group(1)} size" not in old:
            continue
        struct = match.group(1)
        # Inside the old size lay padding or reserved fields, whose content old callers did not set.
        if struct not in may_grow or new[key] < old[f"struct {struct} size"]:
            faults.append(f"{struct}.{match.group(2)} was inserted at byte {new[key]}; append it instead")
        else:
            additions.append(f"{struct}.{match.group(2)} at byte {new[key]}")
    return faults, additions


def main():
    command, *arguments = sys.argv[1:]
    if command == "print":
        print(text(measure(arguments[0], arguments[1:])), end="")
    elif command == "update":
        for machine, compiler in MACHINES.items():
            (Path(__file__).parent / f"{machine}.txt").write_text(text(measure(arguments[0], compiler)))
    elif command == "compare":
        snapshot, include, compiler = arguments[0], arguments[1], arguments[2:]
        old, new = read(snapshot), measure(include, compiler)
        faults, additions = compare(old, new, growable(read_interface(include, strict=False)[0]))
        unknown = sum(key not in old for key in new)
        print(f"{len(old)} facts kept, {unknown} new" if not faults else "\n".join(faults))
        if additions or unknown:
            print("record additions with: python3 abi/layout/layout.py update include/mien")
        return 1 if faults else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
