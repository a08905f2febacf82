#!/usr/bin/env python3
"""The largest distance between the vertices of two binary PLY files: compare_ply.py A B TOLERANCE_MM."""
import math
import re
import struct
import sys


def vertices(path):
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode()
    block = header.split("element vertex")[1].split("element")[0]
    properties = re.findall(r"property (\w+) (\w+)", block)
    assert "binary_little_endian" in header and [p for _, p in properties[:3]] == ["x", "y", "z"], header
    sizes = {"float": 4, "float32": 4, "uchar": 1, "uint8": 1, "int": 4, "double": 8}
    row = sum(sizes[kind] for kind, _ in properties)
    count = int(re.match(r"\s*(\d+)", block).group(1))
    form = "<3d" if properties[0][0] == "double" else "<3f"
    return [struct.unpack_from(form, data, end + i * row) for i in range(count)]


first, second = vertices(sys.argv[1]), vertices(sys.argv[2])
tolerance = float(sys.argv[3])
if len(first) != len(second):
    sys.exit(f"FAILED: {len(first)} and {len(second)} vertices")
worst = max(math.dist(a, b) for a, b in zip(first, second))
print(f"{len(first)} vertices, at most {worst:.3g} mm apart")
if not worst <= tolerance:
    sys.exit(f"FAILED: more than {tolerance} mm")
