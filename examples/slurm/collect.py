#!/usr/bin/env python3
"""Puts the fitted faces of a study into one data set (safetensors). Standard library only.

  collect.py --study study.tsv --fitted FOLDER --out study.safetensors

The table has lines subject<TAB>expression<TAB>scan<TAB>landmarks; the face of a line is
FOLDER/<subject>_<expression>.ply as `mien register` writes it (binary, float32). Missing ones are named
and left out.
"""
import argparse
import json
import struct
import sys
from array import array
from pathlib import Path


def read_ply(path):
    """Vertices (bytes of float32 x y z) and triangles (bytes of uint32) of a PLY file of mien."""
    raw = path.read_bytes()
    end = raw.index(b"end_header\n") + len(b"end_header\n")
    head = raw[:end].decode("ascii").split("\n")
    if "format binary_little_endian 1.0" not in head:
        sys.exit(f"{path}: not a binary little endian PLY file")
    vertices = triangles = 0
    width, element = 0, None
    sizes = {"float": 4, "float32": 4, "uchar": 1, "uint8": 1, "double": 8, "int": 4, "uint": 4}
    for line in head:
        words = line.split()
        if words[:1] == ["element"]:
            element = words[1]
            if element == "vertex":
                vertices = int(words[2])
            elif element == "face":
                triangles = int(words[2])
        elif words[:1] == ["property"] and element == "vertex":
            width += sizes[words[1]]
    positions = b"".join(raw[end + k * width:end + k * width + 12] for k in range(vertices))
    start = end + vertices * width
    corners = b"".join(raw[start + 13 * k + 1:start + 13 * k + 13] for k in range(triangles))
    return positions, corners


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    for name in ("study", "fitted", "out"):
        parser.add_argument("--" + name, required=True)
    options = parser.parse_args()
    rows, subjects, names = [], {}, ["neutral"]
    for line in Path(options.study).read_text().splitlines():
        if not line.strip():
            continue
        subject, expression = line.split("\t")[:2]
        path = Path(options.fitted) / f"{subject}_{expression}.ply"
        if not path.exists():
            print(f"{path}: missing, left out", file=sys.stderr)
            continue
        subjects.setdefault(subject, len(subjects))
        if expression not in names:
            names.append(expression)
        rows.append((path, subjects[subject], names.index(expression)))
    if not rows:
        sys.exit("no fitted face at all")
    _, triangles = read_ply(rows[0][0])
    count = len(read_ply(rows[0][0])[0]) // 12
    shapes = {"vertices": ("F32", [len(rows), count, 3], 12 * count * len(rows)),
              "subject": ("I32", [len(rows)], 4 * len(rows)),
              "expression": ("I32", [len(rows)], 4 * len(rows)),
              "triangles": ("U32", [len(triangles) // 12, 3], len(triangles))}
    header, offset = {"__metadata__": {"units": "millimetres", "expression_names": json.dumps(names)}}, 0
    for name, (dtype, shape, size) in shapes.items():
        header[name] = {"dtype": dtype, "shape": shape, "data_offsets": [offset, offset + size]}
        offset += size
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % 64)
    part = Path(options.out + ".part")
    with part.open("wb") as out:
        out.write(struct.pack("<Q", len(text)) + text)
        for path, _, _ in rows:
            positions, own = read_ply(path)
            if len(positions) != 12 * count or own != triangles:
                sys.exit(f"{path}: another topology than {rows[0][0]}")
            out.write(positions)
        for column in (1, 2):
            values = array("i", [row[column] for row in rows])
            if sys.byteorder == "big":
                values.byteswap()
            out.write(values.tobytes())
        out.write(triangles)
    part.rename(options.out)
    print(f"{options.out}: {len(rows)} faces, {len(subjects)} subjects, {len(names)} expressions")


if __name__ == "__main__":
    main()
