#!/usr/bin/env python3
"""Does a score learned from raters find a hidden sagging of the jawline?

  score_study.py --mien build/release/bin/mien --shared ../shared --work /tmp/score --seeds 1,2,3,4,5

Each study: 120 faces of the face model, a hidden sagging of 0 to 4 (jowls beside the chin sink and come forward,
2 mm a grade where they sink most), and three raters with a bias, a noise and whole grades of their own. `mien score train`
learns from all grades, cross-validated by subject. Printed per study: how often the raters agree with each other, how often the
held-out prediction, rounded, agrees with their majority, and the correlation of the simulated direction, `mien score
simulate` from grade 0 to grade 4, with the hidden mode over all vertices.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

import numpy as np


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stderr}")


def sagging(mean, triangles, landmarks, millimetres):
    """The hidden mode, mm per grade: jowls on both sides of the chin."""
    mode = np.zeros_like(mean)
    for names in (("jaw_04", "jaw_05", "jaw_06"), ("jaw_10", "jaw_11", "jaw_12")):
        centre = mean[[landmarks[n] for n in names]].mean(0)
        away = np.linalg.norm((mean - centre) / [18.0, 16.0, 22.0], axis=1)
        mode += np.exp(-0.5 * away ** 2)[:, None] * [0.25 * np.sign(centre[0]), -1.0, 0.2]
    return mode * (millimetres / np.linalg.norm(mode, axis=1).max())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--mien", required=True)
    parser.add_argument("--shared", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--seeds", default="1,2,3,4,5")
    parser.add_argument("--faces", type=int, default=120)
    parser.add_argument("--millimetres", type=float, default=2.0)
    parser.add_argument("--options", default="", help="more options of mien score train")
    o = parser.parse_args()
    sys.path.insert(0, str(o.shared / "tools"))
    from mien_data import N_FACE, read_mesh, read_safetensors, write_safetensors

    o.work.mkdir(parents=True, exist_ok=True)
    tensors, _ = read_safetensors(o.shared / "data/ict/model.safetensors")
    mean, modes = tensors["mean"][:N_FACE].astype(float), tensors["identity_modes"][:, :N_FACE].astype(float)
    triangles = tensors["triangles"][(tensors["triangles"] < N_FACE).all(1)]
    landmarks = json.loads((o.shared / "data/ict/landmarks.json").read_text())["vertices"]
    hidden = sagging(mean, triangles, landmarks, o.millimetres)

    print(f"{'study':>5} {'components':>10} {'raters agree':>12} {'prediction agrees':>17} {'held-out R2':>11} {'direction':>9}")
    for seed in map(int, o.seeds.split(",")):
        rng = np.random.default_rng([seed, 606])
        truth = rng.uniform(0, 4, o.faces)
        faces = (mean + np.tensordot(rng.standard_normal((o.faces, len(modes))), modes, 1)
                 + truth[:, None, None] * hidden)
        bias, noise = rng.uniform(-0.3, 0.3, 3), rng.uniform(0.4, 0.7, 3)
        grades = np.clip(np.rint(truth[:, None] + bias + noise * rng.standard_normal((o.faces, 3))), 0, 4).astype(int)
        data, table = o.work / "faces.safetensors", o.work / "grades.json"
        write_safetensors(data, {"vertices": faces.astype(np.float32), "subject": np.arange(o.faces, dtype=np.int32),
                                 "expression": np.zeros(o.faces, np.int32), "triangles": triangles.astype(np.uint32)},
                          {"expression_names": json.dumps(["neutral"]), "units": "millimetres"})
        table.write_text(json.dumps({"grades": grades.tolist()}))
        run(o.mien, "score", "train", "--data", data, "--grades", table, "--range", 0, 4, "--json", o.work / "report.json",
            "--out", o.work / "score.safetensors", *o.options.split())
        run(o.mien, "score", "agreement", "--grades", table, "--json", o.work / "agreement.json")
        for target in (0, 4):
            run(o.mien, "score", "simulate", "--model", o.work / "score.safetensors", "--target", target, "--out",
                o.work / f"grade{target}.ply")
        report = json.loads((o.work / "report.json").read_text())
        agreement = json.loads((o.work / "agreement.json").read_text())
        raters = np.mean([pair["percent_agreement"] for pair in agreement["pairs"]])
        predicted = np.clip(np.rint(report["held_out_predictions"]), 0, 4)
        agrees = np.mean(predicted == np.array(agreement["majority"]))
        direction = read_mesh(o.work / "grade4.ply")[0] - read_mesh(o.work / "grade0.ply")[0]
        correlation = (direction * hidden).sum() / np.linalg.norm(direction) / np.linalg.norm(hidden)
        print(f"{seed:5d} {report['components']:10d} {raters:12.1%} {agrees:17.1%} {report['q2']:11.3f} {correlation:9.3f}", flush=True)


if __name__ == "__main__":
    main()
