#!/usr/bin/env python3
"""Checks that every function of the public headers is documented whole and listed in symbols.txt.

  check_headers.py INCLUDE_DIR SYMBOLS_TXT

A function needs a comment with a purpose, one @param per parameter, and @errors @owner @thread
@cancel @cost @since. Exit status 1 and one line per fault otherwise.
"""
import re
import sys
from pathlib import Path

FIELDS = ("errors", "owner", "thread", "cancel", "cost", "since")
FUNCTION = re.compile(r"(/\*\*(?:(?!\*/).)*\*/)?\s*MIEN_API\s+([^;{]*?)MIEN_CALL\s+(mien_\w+)\s*\(([^;]*?)\)\s*;", re.S)


def parameter_names(text):
    """Names of the parameters of a C declaration without function-pointer parameters."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S).strip()
    if text in ("", "void"):
        return []
    return [re.search(r"(\w+)\s*(\[\w*\])?$", part.strip()).group(1) for part in text.split(",")]


def main():
    include, symbols_file = Path(sys.argv[1]), Path(sys.argv[2])
    faults, declared = [], set()
    for header in sorted(include.glob("*.h")):
        for comment, _, name, parameters in FUNCTION.findall(header.read_text()):
            declared.add(name)
            where = f"{header.name}: {name}"
            if not comment:
                faults.append(f"{where}: no documentation")
                continue
            body = re.sub(r"^\s*/?\*+/?", "", comment, flags=re.M).strip()
            if body.startswith("@"):
                faults.append(f"{where}: no purpose")
            for parameter in parameter_names(parameters):
                if not re.search(rf"@param\s+{parameter}\s+\[(in|out|in,out)\]", body):
                    faults.append(f"{where}: parameter {parameter} is not documented with [in] or [out]")
            for documented in re.findall(r"@param\s+(\w+)", body):
                if documented not in parameter_names(parameters):
                    faults.append(f"{where}: documents {documented}, which is no parameter")
            for field in FIELDS:
                if not re.search(rf"@{field}\s+\S", body):
                    faults.append(f"{where}: @{field} is missing")
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
