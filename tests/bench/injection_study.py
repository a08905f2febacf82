#!/usr/bin/env python3
"""How well does the whole road measure a simulated injection into a cheek?

  injection_study.py --mien build/release/bin/mien --shared ../shared --model face.safetensors \\
                     --expressions expressions.safetensors --work /tmp/injection --subjects 20

Each simulated subject is scanned before, and after 1, 2 and 5 mL under the left cheek, neutral and with a
smile; every scan has its own noise, pose and landmarks. `mien report` registers and neutralizes the scans, aligns them on
forehead and nose and measures. Printed: the volume recovered in the cheek zone, whose rim cuts off some 5 %
of each injection ("true faces").
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

import numpy as np

SPREAD_MM = 14.0


def bump(vertices, triangles, centre, millilitres):
    """The face with a smooth hill along its normals, whose volume is what was asked for."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a)
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, triangles[:, k], area)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12
    away = np.linalg.norm(vertices - vertices[centre], axis=1)
    shape = np.exp(-0.5 * (away / SPREAD_MM) ** 2) * (away < 3 * SPREAD_MM)
    shape *= np.clip((normals @ normals[centre]), 0, 1)

    def volume(height):
        after = vertices + height * shape[:, None] * normals
        def signed(x):
            return np.einsum("ij,ij->i", x[triangles[:, 0]], np.cross(x[triangles[:, 1]], x[triangles[:, 2]])).sum() / 6
        return (signed(after) - signed(vertices)) / 1000

    low, high = 0.0, 30.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if volume(middle) < millilitres else (low, middle)
    return vertices + low * shape[:, None] * normals


def simulate(shared, out, subject, scan_seed, expression, millilitres, noise_mm):
    """One scan by the shared simulator, of a face that carries an injection."""
    if (out / "landmarks.json").exists():
        return
    sys.path.insert(0, str(shared / "tools"))
    import mien_data
    import simulate_scan
    zones = json.loads((shared / "data/ict/zones.json").read_text())["zones"]

    plain = mien_data.FaceModel

    class Treated(plain):
        def subject(self, *arguments):
            person = super().subject(*arguments)
            if millilitres:
                triangles = self.template_triangles
                neutral = person.neutral
                skin = neutral[: self.n_template]
                zone = np.asarray(zones["cheek_left"])
                centre = zone[np.argmin(np.linalg.norm(skin[zone] - skin[zone].mean(0), axis=1))]
                person.neutral = neutral.copy()
                person.neutral[: self.n_template] = bump(skin, triangles, centre, millilitres)
            return person

    simulate_scan.FaceModel = Treated
    old, sys.argv = sys.argv, ["simulate_scan.py", "--out", str(out), "--seed", "77", "--subject", str(subject),
                               "--scan-seed", str(scan_seed), "--expression", expression, "--noise-mm", str(noise_mm),
                               "--pose-deg", "15", "--pose-mm", "50"]
    try:
        simulate_scan.main()
    finally:
        simulate_scan.FaceModel, sys.argv = plain, old


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return done.stdout


def cheeks_ml(o, folder, scratch, *options):
    """Of every visit but the first: signed volume of the left cheek, its interval, below the limit."""
    run(o.mien, "report", "--visits", folder, "--zones", o.shared / "data/ict/zones.json", "--show", "cheek_left", "--json",
        scratch / "report.json", "--out", scratch / "report.html", "--threads", 2, *options)
    visits = json.loads((scratch / "report.json").read_text())["visits"]
    return [[v["zones"][0][k] for k in ("signed_ml", "low95_ml", "high95_ml", "below_limit_of_detection")] for v in visits[1:]]


def write_truth(o, folder, name):
    """The simulated face itself, in the scan's frame and the template's topology."""
    sys.path.insert(0, str(o.shared / "tools"))
    from mien_data import read_mesh, read_safetensors, write_ply
    tensors, _ = read_safetensors(folder / "truth.safetensors")
    write_ply(name, np.asarray(tensors["vertices"], float), read_mesh(o.shared / "data/ict/template.ply")[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--mien", required=True)
    parser.add_argument("--shared", type=Path, required=True)
    parser.add_argument("--model", required=True)
    parser.add_argument("--expressions", required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--subjects", type=int, default=20)
    parser.add_argument("--noise-mm", type=float, default=0.15)
    parser.add_argument("--smile", default="grin")
    o = parser.parse_args()

    cases = [("0before", "neutral", 0), ("1n1", "neutral", 1), ("2n2", "neutral", 2), ("3n5", "neutral", 5),
             ("4s1", o.smile, 1), ("5s2", o.smile, 2), ("6s5", o.smile, 5)]
    rows = {}
    for subject in range(o.subjects):
        base = o.work / f"{subject:02d}"
        (base / "true").mkdir(parents=True, exist_ok=True)
        for k, (name, expression, ml) in enumerate(cases):
            simulate(o.shared, base / "scans" / name, subject, 10 + k, expression, ml, o.noise_mm)
            if expression == "neutral":
                write_truth(o, base / "scans" / name, base / "true" / f"{name}.ply")
        results = {"true faces": cheeks_ml(o, base / "true", base, "--fitted"),
                   "fitted": cheeks_ml(o, base / "scans", base, "--model", o.model),
                   "neutralized": cheeks_ml(o, base / "scans", base, "--model", o.model, "--expressions", o.expressions)}
        for kind, values in results.items():
            for (name, expression, ml), got in zip(cases[1:], values):
                rows.setdefault((expression, ml, kind), []).append((ml, *got))
        print(f"subject {subject}", flush=True)
    print(f"{'after':8} {'mL':>3} {'measured on':12} {'median':>7} {'mean':>7} {'median |error|':>14} {'95 % covers':>11} {'below limit':>11}")
    for (expression, ml, kind), values in rows.items():
        v = np.array(values, float)
        covered = np.mean((v[:, 2] <= ml) & (v[:, 3] >= ml))
        print(f"{expression:8} {ml:3d} {kind:12} {np.median(v[:, 1]):7.2f} {v[:, 1].mean():7.2f} "
              f"{np.median(abs(v[:, 1] - ml)):14.2f} {covered:11.0%} {v[:, 4].mean():11.0%}")


if __name__ == "__main__":
    main()
