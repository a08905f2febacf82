#!/usr/bin/env python3
"""Figures 2.13 and 2.14 of jousse-2022: weights by skin colour from texture images, and what a fit makes of them.

  skin_figures.py --mien M --model MODEL --template template.ply --zones zones.json --textured FOLDER --out FOLDER SCAN_FOLDER ...

FOLDER of --textured holds NAME_jpeg.obj of each scan, as bench_textured_fits writes them into its work folder. A scan folder has
scan.ply, landmarks.json and truth.safetensors (simulate_scan.py, make_mh.py). The thesis shows one scan and no numbers. Here, for each
scan, without and with `--weights skin`: mean distance of the fitted from the true vertices, over the visible vertices of the zone
"face", over the visible ones outside it (ears, neck), and over all vertices higher than the face (the scalp, under the hair), mm, and the
share of the visible vertices inside and outside the face whose say in the fit skin colours lowered to less than half. Pictures: NAME_map.png (2.13: the scan, and how much of its say
counts with skin weights on the fitted template) and NAME_fit_none.png, NAME_fit_skin.png (2.14: the scan and the distance from the true face).
"""
import argparse
import json
import struct
import subprocess
from pathlib import Path

import numpy as np

RANGE_MM = 5.0  # of the colours of the distance
HALF = 0.5


def tensor(path, name):
    raw = Path(path).read_bytes()
    length = struct.unpack_from("<Q", raw)[0]
    entry = json.loads(raw[8:8 + length])[name]
    first, last = (8 + length + o for o in entry["data_offsets"])
    return np.frombuffer(raw[first:last], {"F32": np.float32, "U8": np.uint8}[entry["dtype"]]).reshape(entry["shape"])


def write_off(path, places, triangles):
    lines = ["OFF", f"{len(places)} {len(triangles)} 0", *("%.6f %.6f %.6f" % tuple(p) for p in places),
             *("3 %d %d %d" % tuple(t) for t in triangles)]
    path.write_text("\n".join(lines) + "\n")


def read_off(path):
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    count, faces = map(int, lines[1].split()[:2])
    places = np.array([line.split()[:3] for line in lines[2:2 + count]], float)
    return places, np.array([line.split()[1:4] for line in lines[2 + count:2 + count + faces]], int)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("--mien", "--model", "--template", "--zones", "--textured", "--out"):
        parser.add_argument(name, required=True)
    parser.add_argument("scans", nargs="+")
    a = parser.parse_args()
    out = Path(a.out)
    out.mkdir(parents=True, exist_ok=True)

    def mien(*arguments):
        subprocess.run([a.mien, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    mien("mesh", "convert", a.template, out / "template.off")
    height = read_off(out / "template.off")[0][:, 1]
    face = json.loads(Path(a.zones).read_text())["zones"]["face"]
    print("| scan | face, no weights, mm | by skin | outside, no weights, mm | by skin | scalp, no weights, mm | by skin | say below half: face | outside |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|---:|", flush=True)
    for folder in map(Path, a.scans):
        name, errors, weight = folder.name, {}, {}
        truth, seen = tensor(folder / "truth.safetensors", "vertices"), tensor(folder / "truth.safetensors", "visible") != 0
        for kind in ("none", "skin"):
            fit = out / f"{name}_{kind}.off"
            mien("register", "--model", a.model, "--scan", Path(a.textured) / f"{name}_jpeg.obj", "--landmarks",
                 folder / "landmarks.json", "--weights", kind, "--out", fit, "--json", out / "fit.json")
            weight[kind] = np.array(json.loads((out / "fit.json").read_text())["weight"], float)
            places, triangles = read_off(fit)
            errors[kind] = np.linalg.norm(places - truth, axis=1)
        inside = np.zeros(len(truth), bool)
        inside[face] = True
        lowered = weight["skin"] < HALF * weight["none"]
        parts = [seen & inside, seen & ~inside, height > height[face].max()]
        numbers = [errors[kind][part].mean() for part in parts for kind in ("none", "skin")]
        shares = [100 * lowered[part & (weight["none"] > 0)].mean() for part in parts[:2]]
        print(f"| {name} | " + " | ".join(f"{x:.3f}" for x in numbers) + " | " + " | ".join(f"{x:.0f} %" for x in shares) + " |", flush=True)
        write_off(out / "truth.off", truth, triangles)
        (out / "weight.json").write_text(json.dumps(weight["skin"].tolist()))
        common = ["--beside", folder / "scan.ply", "--views", "front,left45", "--size", "360"]
        mien("render", out / f"{name}_skin.off", "--scalar", out / "weight.json", "--min", "0", "--max", "1", *common, "--label",
             "say in the fit", "--captions", "scan,weights by skin", "--out", out / f"{name}_map.png")
        for kind, words in (("none", "no weights"), ("skin", "weights by skin")):
            mien("render", out / f"{name}_{kind}.off", "--compare", out / "truth.off", "--min", "0", "--max", RANGE_MM, *common,
                 "--label", "from the true face mm", "--captions", f"scan,{words}", "--out", out / f"{name}_fit_{kind}.png")


if __name__ == "__main__":
    main()
