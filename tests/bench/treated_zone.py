#!/usr/bin/env python3
"""Filler on neutral faces, neutralized with the zone as a witness of expression and without.

  treated_zone.py --mien build/release/bin/mien --shared ../shared --faces test.safetensors --expressions expr.safetensors
                  --work /tmp/treated [--subjects 20]

FACES is a data set of make_faces20.py (--region face), EXPRESSIONS a model of other people. Each neutral face receives a hill about
the middle of the zone that ends at its rim, along the normals: 0.5 mL in the lips, 0.4 in the nose, 1 in the chin, 0.25 at an eye. The truth is that nothing is to be taken off. Printed per zone: how often the likeliest expression is
another than neutral, and what is taken off inside the zone, mL, median and largest, both ways. Needs numpy.
"""
import argparse
import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

import numpy as np

TREATMENTS = {"lips": 0.5, "nose": 0.4, "chin": 1.0, "eye_left": 0.25}


def area_vectors(vertices, triangles):
    corners = vertices[triangles]
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 6
    total = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(total, triangles[:, k], vectors)
    return total


def treated(vertices, triangles, zone, volume_ml):
    """The face with a hill about the middle of the zone that ends at its rim."""
    areas = area_vectors(vertices, triangles)
    normals = areas / np.linalg.norm(areas, axis=1, keepdims=True)
    place = vertices[zone]
    distance = np.linalg.norm(place - np.median(place, axis=0), axis=1)
    reach = np.percentile(distance, 90)
    height = np.where(distance < reach, np.cos(0.5 * np.pi * np.minimum(distance / reach, 1)) ** 2, 0)
    scale = 1000 * volume_ml / (height * np.linalg.norm(areas[zone], axis=1)).sum()
    face = vertices.copy()
    face[zone] += (scale * height)[:, None] * normals[zone]
    return face


def main():
    ap = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    for name in ("mien", "shared", "faces", "expressions", "work"):
        ap.add_argument("--" + name, required=True)
    ap.add_argument("--subjects", type=int, default=20)
    o = ap.parse_args()
    sys.path.insert(0, str(Path(o.shared) / "tools"))
    from mien_data import read_safetensors, write_ply
    work = Path(o.work)
    work.mkdir(parents=True, exist_ok=True)
    tensors, meta = read_safetensors(o.faces)
    neutral = json.loads(meta["expression_names"]).index("neutral")
    rows = [i for i, e in enumerate(tensors["expression"]) if e == neutral][:o.subjects]
    zone_file = Path(o.shared) / "data/ict/zones.json"
    listed = json.loads(zone_file.read_text())
    zones = dict(listed["zones"], lips=listed["lips"])
    triangles = tensors["triangles"].astype(np.int64)
    count = tensors["vertices"].shape[1]
    print(f"{'zone':10}{'mL':>6}   {'as a witness: another':>22}{'median':>8}{'largest':>8}   {'no witness: another':>20}{'median':>8}"
          f"{'largest':>8}   seen as")
    for name, volume in TREATMENTS.items():
        zone = np.array([v for v in zones[name] if v < count])
        (work / f"{name}.json").write_text(json.dumps({"zones": {name: zone.tolist()}}))
        readings = {"as_expression": [], "treated": []}
        for row in rows:
            write_ply(work / "face.ply", treated(tensors["vertices"][row].astype(float), triangles, zone, volume), triangles)
            done = subprocess.run([o.mien, "neutralize", "--model", o.expressions, "--in", str(work / "face.ply"), "--out",
                                   str(work / "neutral.ply"), "--zones", str(work / f"{name}.json"), "--treated", name, "--json",
                                   str(work / "out.json")], capture_output=True, text=True)
            if done.returncode:
                raise SystemExit(done.stderr)
            report = json.loads((work / "out.json").read_text())["treated_zone"]
            for key in readings:
                readings[key].append(report[key])
        parts = []
        for key in ("as_expression", "treated"):
            removed = np.abs([reading["removed_ml"] for reading in readings[key]])
            other = sum(reading["expression"] != "neutral" for reading in readings[key])
            parts += [f"{other:6d} of {len(removed):3d}", f"{np.median(removed):8.3f}{removed.max():8.3f}"]
        seen = Counter(reading["expression"] for reading in readings["as_expression"] if reading["expression"] != "neutral")
        print(f"{name:10}{volume:6.2f}   {parts[0]:>22}{parts[1]}   {parts[2]:>20}{parts[3]}   "
              + ", ".join(f"{k} {n}" for k, n in seen.most_common()))


if __name__ == "__main__":
    main()
