#!/usr/bin/env python3
"""How well does the whole road measure a simulated injection into a cheek?

  injection_study.py --mien build/release/bin/mien --shared ../shared --model face.safetensors \\
                     --expressions expressions.safetensors --work /tmp/injection --subjects 20

Each simulated subject is scanned before, and after 1, 2 and 5 mL under the left cheek, neutral and with an
expression; every scan has its own noise, pose and landmarks. `mien register` fits the scans, `mien report` takes the
expressions off all visits together, the treated cheek being no witness, aligns and measures. Printed, against what was
injected and against what of it lies in the zone by the simulated faces themselves (the rim cuts off some 5 % of
the wide hill and 0.2 % of the one that ends inside): median, median error, mean stated deviation, how often the 95 % interval holds the truth, and how often the change
is called below the limit of detection. 0 mL: the other cheek. "as fitted": with the expression left on.
"and around": the cheek zone with the margin of `mien report` around it.
"""
import argparse
import copy
import json
import subprocess
import sys
from pathlib import Path

import numpy as np

SPREAD_MM = 14.0  # of the hill, a Gaussian at its top
FADE_MM = 12.0


def hill_inside(vertices, zone, away):
    """The wide hill brought down smoothly to nothing over the last FADE_MM before the zone's rim."""
    inside = np.zeros(len(vertices), bool)
    inside[zone] = True
    outside = vertices[~inside & (away < away[zone].max() + 2 * FADE_MM)]
    shape = np.zeros(len(vertices))
    for v in zone:
        t = min(np.linalg.norm(outside - vertices[v], axis=1).min() / FADE_MM, 1.0)
        shape[v] = np.exp(-0.5 * (away[v] / SPREAD_MM) ** 2) * t * t * (3 - 2 * t)
    return shape


def bump(vertices, triangles, zone, millilitres, wide):
    """The face with a smooth hill along its normals, whose volume is what was asked for.

    wide: a Gaussian that does not stop at the zone's rim.
    """
    centre = zone[np.argmin(np.linalg.norm(vertices[zone] - vertices[zone].mean(0), axis=1))]
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a)
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, triangles[:, k], area)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12
    away = np.linalg.norm(vertices - vertices[centre], axis=1)
    if wide:
        shape = np.exp(-0.5 * (away / SPREAD_MM) ** 2) * (away < 3 * SPREAD_MM)
    else:
        shape = hill_inside(vertices, zone, away)
    shape *= np.clip((normals @ normals[centre]), 0, 1)

    def signed_ml(x):
        return np.einsum("ij,ij->i", x[triangles[:, 0]], np.cross(x[triangles[:, 1]], x[triangles[:, 2]])).sum() / 6000

    base, height, slope = signed_ml(vertices), 0.0, None
    for _ in range(20):  # secant steps; the volume is a cubic of the height
        grown = signed_ml(vertices + height * shape[:, None] * normals) - base
        if abs(grown - millilitres) < 1e-9:
            break
        slope = grown / height if height else signed_ml(vertices + shape[:, None] * normals) - base
        height += (millilitres - grown) / slope
    return vertices + height * shape[:, None] * normals


class Simulator:
    """The shared simulator, of faces that carry an injection; the face model is loaded once."""

    def __init__(self, shared, wide):
        sys.path.insert(0, str(shared / "tools"))
        import mien_data
        import simulate_scan
        self.tool, self.millilitres, self.people = simulate_scan, 0.0, {}
        model = mien_data.FaceModel(None, with_sockets=True)
        untreated, skin_count = model.subject, model.n_template
        zone = np.asarray(json.loads((shared / "data/ict/zones.json").read_text())["zones"]["cheek_left"])

        def treated(*key):
            person = copy.copy(self.people.setdefault(key, None) or untreated(*key))
            self.people = {key: copy.copy(person)}
            if self.millilitres:
                skin = person.neutral[:skin_count]
                person.neutral = person.neutral.copy()
                person.neutral[:skin_count] = bump(skin, model.template_triangles, zone, self.millilitres, wide)
            return person

        model.subject = treated
        simulate_scan.FaceModel = lambda *a, **k: model

    def scan(self, out, seed, subject, scan_seed, expression, millilitres, noise_mm):
        if (out / "landmarks.json").exists():
            return
        self.millilitres = millilitres
        old, sys.argv = sys.argv, ["simulate_scan.py", "--out", str(out), "--seed", str(seed), "--subject", str(subject),
                                   "--scan-seed", str(scan_seed), "--expression", expression, "--noise-mm",
                                   str(noise_mm), "--pose-deg", "15", "--pose-mm", "50", "--step", "1"]
        try:
            self.tool.main()
        finally:
            sys.argv = old


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return done.stdout


def register(o, scan, out):
    """The fitted face with what is known of it beside it, as `mien report --fitted` reads it."""
    if not out.with_suffix(".json").exists():
        run(o.mien, "register", "--model", o.model, "--scan", scan / "scan.ply", "--landmarks", scan / "landmarks.json", "--out",
            out.with_suffix(".ply"), "--json", out.with_suffix(".json"))


def write_truth(o, scan, out):
    """The simulated face itself, in the scan's frame and the template's topology."""
    from mien_data import read_mesh, read_safetensors, write_ply
    if not out.exists():
        tensors, _ = read_safetensors(scan / "truth.safetensors")
        write_ply(out, np.asarray(tensors["vertices"], float), read_mesh(o.shared / "data/ict/template.ply")[1])


def cheeks(o, folder, scratch, *options):
    """Of every visit but the first: the cheeks as `mien report` tells them, the treated one first and, with its
    margin, last."""
    run(o.mien, "report", "--fitted", "--visits", folder, "--zones", o.shared / "data/ict/zones.json", "--show",
        "cheek_left,cheek_right", "--treated", "cheek_left", "--json", scratch / "report.json", "--out", scratch / "report.html", *options)
    return {v["name"]: v["zones"] for v in json.loads((scratch / "report.json").read_text())["visits"][1:]}


def hill_height_mm(o, base, millilitres):
    """Of the hill on the simulated face; the bump does not ask in which frame the face lies."""
    from mien_data import read_mesh
    vertices, triangles = read_mesh(base / "true/0before.ply")[:2]
    zone = np.asarray(json.loads((o.shared / "data/ict/zones.json").read_text())["zones"]["cheek_left"])
    return np.linalg.norm(bump(vertices, triangles, zone, millilitres, o.hill == "wide") - vertices, axis=1).max()


def measure_patient(o, base, cases, rows):
    for folder in ("fits", "true"):
        (base / folder).mkdir(parents=True, exist_ok=True)
    for name, expression, ml in cases:
        register(o, base / "scans" / name, base / "fits" / name)
        if expression == "neutral":
            write_truth(o, base / "scans" / name, base / "true" / f"{name}.ply")
    truth = cheeks(o, base / "true", base)
    kinds = {"as fitted": cheeks(o, base / "fits", base),
             "neutralized": cheeks(o, base / "fits", base, "--expressions", o.expressions)}
    held = {ml: truth[name] for name, expression, ml in cases[1:] if expression == "neutral"}
    for kind, visits in kinds.items():
        for name, expression, ml in cases[1:]:
            left, right, around = visits[name]
            rows.setdefault((kind, expression, ml), []).append((ml, held[ml][0]["signed_ml"], left))
            rows.setdefault((kind + " and around", expression, ml), []).append((ml, held[ml][2]["signed_ml"], around))
            rows.setdefault((kind, expression, 0), []).append((0, 0, right))  # the other cheek: nothing was injected


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--mien", required=True)
    parser.add_argument("--shared", type=Path, required=True)
    parser.add_argument("--model", required=True)
    parser.add_argument("--expressions", required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--subjects", type=int, default=20)
    parser.add_argument("--seed", type=int, default=78, help="of the people; 77 served to choose the settings")
    parser.add_argument("--noise-mm", type=float, default=0.15)
    parser.add_argument("--hill", choices=("inside", "wide"), default="inside",
                        help="inside: ends at the zone's rim; wide: a Gaussian that leaves the zone")
    parser.add_argument("--after", default="neutral,smile", help="expressions after the injection")
    o = parser.parse_args()

    cases = [("0before", "neutral", 0)]
    for expression in o.after.split(","):
        for ml in (1, 2, 5):
            cases.append((f"{len(cases)}{expression[0]}{ml}", expression, ml))
    simulator, rows = Simulator(o.shared, o.hill == "wide"), {}
    for subject in range(o.subjects):
        base = o.work / f"{subject:02d}"
        for k, (name, expression, ml) in enumerate(cases):
            simulator.scan(base / "scans" / name, o.seed, subject, 10 + k, expression, ml, o.noise_mm)
        measure_patient(o, base, cases, rows)
        print(f"subject {subject}", flush=True)
    print("height of the hill (median, mm):", ", ".join(
        f"{ml} mL {np.median([hill_height_mm(o, o.work / f'{s:02d}', ml) for s in range(o.subjects)]):.2f}" for ml in (1, 2, 5)))
    print(f"{'measured':22} {'after':8} {'mL':>3} {'in zone':>7} {'median':>7} {'|error|':>7} {'of zone':>7} {'mean sd':>7} "
          f"{'95 % holds':>10} {'of zone':>7} {'below limit':>11}")
    for (kind, expression, ml), values in sorted(rows.items(), key=str):
        injected, zone = (np.array([v[k] for v in values], float) for k in (0, 1))
        got, low, high, sd, below = (np.array([float(v[2][k]) for v in values]) for k in (
            "signed_ml", "low95_ml", "high95_ml", "sd_ml", "below_limit_of_detection"))
        print(f"{kind:22} {expression:8} {ml:3d} {np.median(zone):7.2f} {np.median(got):7.2f} {np.median(abs(got - injected)):7.2f} "
              f"{np.median(abs(got - zone)):7.2f} {sd.mean():7.2f} {np.mean((low <= injected) & (high >= injected)):10.0%} "
              f"{np.mean((low <= zone) & (high >= zone)):7.0%} {below.mean():11.0%}")


if __name__ == "__main__":
    main()
