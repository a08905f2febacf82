#!/usr/bin/env python3
"""Checks that every function of the public headers is documented whole, in words that the bindings'
generator understands (documentation.py), and listed in symbols.txt.

  check_headers.py INCLUDE_DIR SYMBOLS_TXT

Exit status 1 and one line per fault: where, what, and what to write instead.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from read_headers import HeaderError, read_interface


def main():
    include, symbols_file = Path(sys.argv[1]), Path(sys.argv[2])
    try:
        interface, faults = read_interface(include, strict=False)
    except HeaderError as problem:
        print(problem)
        return 1
    declared = {f.name for f in interface.functions}
    reached = {f.name for f in interface.functions}.union({"mien.h", "mien.hpp"}, (f.header for f in interface.functions))
    faults += [f"{header.name}: mien.h does not include it" for header in sorted(include.glob("*.h"))
               if header.name not in reached and "MIEN_API mien" in header.read_text()]
    lines = symbols_file.read_text().split()
    if lines != sorted(set(lines)):
        faults.append(f"{symbols_file.name}: not sorted or not unique")
    for name in sorted(declared - set(lines)):
        faults.append(f"{name}: declared but not in {symbols_file.name}")
    for name in sorted(set(lines) - declared):
        faults.append(f"{name}: in {symbols_file.name} but declared nowhere")
    print("\n".join(faults) if faults else f"{len(declared)} functions documented and listed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
