#!/usr/bin/env python3
"""Writes the public C headers as one file without comments: what programs of this release were built with.

  freeze_headers.py INCLUDE_DIR > tests/golden/abi-VERSION/mien-VERSION.h

Run once per release and never again for it: tests/abi/previous_release.c is compiled against the frozen
file and run with the present library.
"""
import re
import sys
from pathlib import Path

done = []


def flatten(path):
    if path in done:
        return ""
    done.append(path)
    text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)
    text = re.sub(r'^#include "(\w+\.h)"\n', lambda m: flatten(path.parent / m.group(1)), text, flags=re.M)
    return text


text = flatten(Path(sys.argv[1]) / "mien.h")
text = re.sub(r"[ \t]+$", "", text, flags=re.M)
print("/* Frozen by abi/baseline/freeze_headers.py; comments are in the headers of that release. */")
print(re.sub(r"\n{2,}", "\n", text).strip())
