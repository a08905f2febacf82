#!/usr/bin/env python3
"""The whole road of neutralization: simulated scans, registered, neutralized; registration's and neutralization's errors apart.

  expression_road.py --mien build/release/bin/mien --shared ../shared --faces test.safetensors --model face.safetensors \\
                     --expressions expressions.safetensors --work /tmp/road --subjects 20 [--only-scans]

FACES is the data set of make_faces20.py that holds the true faces (its --seed is --scan-seed here). Distances are means
over the face zone and the mouth zone, mm, against the true expression and the true neutral face in the scan's frame.
Needs numpy.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

import numpy as np


def main():
    ap = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    for name in ("mien", "shared", "faces", "model", "expressions", "work"):
        ap.add_argument("--" + name, required=name in ("shared", "faces", "work"))
    ap.add_argument("--subjects", type=int, default=20)
    ap.add_argument("--scan-seed", type=int, default=2)
    ap.add_argument("--expression", action="append", help="default: grin and mouth_stretch")
    ap.add_argument("--only-scans", action="store_true")
    o = ap.parse_args()
    sys.path.insert(0, str(Path(o.shared) / "tools"))
    from mien_data import read_mesh, read_safetensors
    from mien_geometry import rigid_align
    tensors, meta = read_safetensors(o.faces)
    names = json.loads(meta["expression_names"])
    zones = json.loads((Path(o.shared) / "data/ict/zones.json").read_text())["zones"]
    row_of = {(int(s), names[e]): i for i, (s, e) in enumerate(zip(tensors["subject"], tensors["expression"]))}
    count = tensors["vertices"].shape[1]
    zone = {k: np.array([i for i in zones[k] if i < count]) for k in ("face", "mouth")}
    subjects = sorted({s for s, _ in row_of})[:o.subjects]

    for expression in o.expression or ["grin", "mouth_stretch"]:
        rows, worse, silent, warned = [], 0, 0, 0
        for subject in subjects:
            out = Path(o.work) / f"{expression}_{subject:03d}"
            if not (out / "landmarks.json").exists():
                subprocess.run([sys.executable, str(Path(o.shared) / "tools/simulate_scan.py"), "--out", str(out),
                                "--seed", str(o.scan_seed), "--subject", str(subject), "--expression", expression,
                                "--noise-mm", "0.2", "--holes", "3", "--hair", "--pose-deg", "20", "--pose-mm", "100",
                                "--step", "1.1"], check=True, stdout=subprocess.DEVNULL)
            if o.only_scans:
                continue
            run = lambda *arguments: subprocess.run([o.mien, *map(str, arguments)], check=True, capture_output=True)
            run("register", "--model", o.model, "--scan", out / "scan.ply", "--landmarks", out / "landmarks.json",
                "--out", out / "fitted.ply", "--json", out / "register.json")
            run("neutralize", "--model", o.expressions, "--in", out / "fitted.ply", "--weights", out / "register.json",
                "--out", out / "neutral.ply", "--json", out / "neutralize.json")
            truth = read_safetensors(out / "truth.safetensors")[0]["vertices"][:count].astype(float)
            own = tensors["vertices"][row_of[subject, expression]].astype(float)
            turn, shift = rigid_align(own, truth)
            if np.abs(own @ turn.T + shift - truth).max() > 0.01:
                sys.exit(f"{out}: the scan is not of subject {subject} of {o.faces}")
            neutral = tensors["vertices"][row_of[subject, "neutral"]].astype(float) @ turn.T + shift
            fitted, result = (read_mesh(out / name)[0][:count] for name in ("fitted.ply", "neutral.ply"))
            far = lambda a, b: [np.linalg.norm(a[zone[k]] - b[zone[k]], axis=1).mean() for k in ("face", "mouth")]
            rows.append([far(fitted, truth), far(truth, neutral), far(fitted, neutral), far(result, neutral),
                         far(result - fitted, neutral - truth)])
            warnings = json.loads((out / "neutralize.json").read_text())["warnings"]
            quality = json.loads((out / "register.json").read_text()).get("quality", "")
            bad = rows[-1][3][0] > rows[-1][2][0]
            worse += bad
            warned += bool(warnings)
            silent += bad and not warnings and quality == "good"
        if o.only_scans:
            continue
        print(f"{expression}, {len(rows)} scans, mean distance in mm, face zone / mouth zone")
        for label, pair in zip(("registration: fitted from the true expression", "the expression itself",
                                "fitted from the true neutral", "neutralized from the true neutral",
                                "neutralization: displacement from the true one"), np.mean(rows, axis=0)):
            print(f"  {label:50s} {pair[0]:6.3f} / {pair[1]:6.3f}")
        print(f"  worse than before: {worse} of {len(rows)}, of them without a word {silent}; with a warning {warned}")


if __name__ == "__main__":
    main()
