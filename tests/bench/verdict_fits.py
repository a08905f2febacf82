#!/usr/bin/env python3
"""Many fits with known truth: what the verdict's expected error is learned from, and held against.

  verdict_fits.py fit MIEN SHARED_DATA MODELS ROWS.jsonl --seeds 3001,3002 [--scans 40] [--per-scan 4] [--population ict]
  verdict_fits.py learn ROWS.jsonl [ROWS.jsonl ...] --out src/registration/expected_error_table.cpp [--against OTHERS.jsonl ...]
  verdict_fits.py judge ROWS.jsonl [ROWS.jsonl ...]

fit: cases of verdict_cases.py (people of the seeds; every kind of trouble; with and without landmarks), fitted by models of
MODELS: ict_kernel, ict_trained, ict_other, mh_kernel, mh_trained (.safetensors). Each row is flushed; a run that was cut off
goes on where it stopped. The truth of a zone is the mean distance of those of its vertices that the untroubled scan shows;
of an ICT template on a MakeHuman face, whose vertices do not correspond, that of the landmarks of nose, eyes and mouth.
Half of the people are bent by a random field; a row's "unlike" is its deviation in mm.
learn: boosted trees of log error, most measures held to one direction (expected_error.hpp); ranges and limits by people left
out, a tenth of them at a time. judge: how a table does on rows that it was not learned from.
"""
import argparse
import json
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import verdict_table
from verdict_cases import Population, cases_of

MODELS = {"ict": ("ict_kernel", "ict_trained", "ict_other"), "mh": ("mh_kernel", "mh_trained", "ict_kernel", "ict_trained")}
MARKED = {"nose": "nose_", "eye_right": "eye_right_", "eye_left": "eye_left_", "mouth": "mouth_"}


def true_errors(population, other, case, fitted):
    """{zone: mm}, "face" the whole; None for no face. `other`: the fit's template when it is not the population's."""
    if case["truth"] is None:
        return None
    if other is None:
        d, seen = np.linalg.norm(fitted - case["truth"], axis=1), case["visible"]
        return {z: float(d[v[seen[v]]].mean()) for z, v in population.zones.items() if seen[v].sum() >= 10}
    d = np.linalg.norm(fitted[other.mark_index] - case["truth"][population.mark_index], axis=1)
    part = lambda start: float(np.mean([x for n, x in zip(population.mark_names, d) if n.startswith(start)]))
    errors = {z: part(start) for z, start in MARKED.items()}
    errors["face"] = float(np.mean([x for n, x in zip(population.mark_names, d) if n.startswith(("nose", "eye", "mouth"))]))
    return errors


def fit_all(a):
    rows = Path(a.rows)
    done = {json.loads(line)["key"] for line in rows.read_text().splitlines()} if rows.exists() else set()
    populations = {name: Population(name, a.shared) for name in ("ict", "mh")}
    out = open(rows, "a")
    work = Path(tempfile.mkdtemp())
    jobs = [(int(seed), n, name) for n in range(a.scans) for seed in a.seeds.split(",") for name in ("ict", "mh")
            if a.population in (None, name)]
    for seed, number, name in jobs:
        population = populations[name]
        key = f"{name}-{seed}-{number}"
        if f"{key}-end" in done:
            continue
        for label, kind, marks, case in cases_of(population, seed, number, work, a.per_scan):
            rng = np.random.default_rng([seed, number, zlib.crc32(label.encode())])
            model = MODELS[name][rng.integers(len(MODELS[name]))]
            if f"{key}-{label}" in done:
                continue
            row = fit_one(a, population, populations, case, model, marks, work)
            row.update(key=f"{key}-{label}", population=name, trouble=kind, marks=marks, model=model,
                       expression=case.get("expression"), level=case.get("level"), unlike=case.get("unlike"))
            print(json.dumps(row), file=out, flush=True)
        print(json.dumps({"key": f"{key}-end"}), file=out, flush=True)


def fit_one(a, population, populations, case, model, marks, work):
    data = population.data
    data.write_ply(work / "scan.ply", case["points"], case["faces"], None if case["rgb"] is None else case["rgb"].astype(np.uint8))
    command = [a.mien, "register", "--model", f"{a.models}/{model}.safetensors", "--scan", work / "scan.ply", "--out",
               work / "fit.ply", "--json", work / "fit.json", *a.options.split()]
    if case.get("marks"):
        (work / "marks.json").write_text(json.dumps({"points": case["marks"]}))
        command += ["--landmarks", work / "marks.json"]
    for name in ("fit.ply", "fit.json"):
        (work / name).unlink(missing_ok=True)
    run = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if not (work / "fit.json").exists():
        return {"error": run.stderr.strip()[:200]}
    report = json.loads((work / "fit.json").read_text())
    own = model.startswith(population.name)
    fitted = data.read_mesh(work / "fit.ply")[0]
    keep = ("quality", "reasons", "measures", "zones", "coverage", "inlier_share", "mean_residual_mm", "search_score",
            "landmark_rms_mm", "color_agreement", "expected_error")
    row = {k: report[k] for k in keep if k in report}
    row["truth"] = true_errors(population, None if own else populations["ict"], case, fitted)
    if own and case["truth"] is not None:
        d = np.linalg.norm(fitted - case["truth"], axis=1)
        radius, deviation = np.array(report["radius95_mm"]), np.array(report["standard_deviation_mm"])
        use = {z: v[case["visible"][v]] for z, v in population.zones.items()}
        use = {z: v for z, v in use.items() if len(v) >= 10}
        row["within"] = {z: float((d[v] <= radius[v]).mean()) for z, v in use.items()}
        # Quantiles of distance over stated deviation: what any radius would have held.
        share = d / np.maximum(deviation, 1e-9)
        row["of_deviation"] = {z: [round(float(q), 4) for q in np.quantile(share[v], verdict_table.OF_DEVIATION)]
                               for z, v in use.items()}
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    sub = parser.add_subparsers(dest="command", required=True)
    p = sub.add_parser("fit")
    p.add_argument("mien"), p.add_argument("shared"), p.add_argument("models"), p.add_argument("rows")
    p.add_argument("--seeds", required=True)
    p.add_argument("--scans", type=int, default=40)
    p.add_argument("--per-scan", type=int, default=4)
    p.add_argument("--population", choices=["ict", "mh"])
    p.add_argument("--options", default="", help="more options of mien register")
    p.set_defaults(run=fit_all)
    for name in ("learn", "judge"):
        p = sub.add_parser(name)
        p.add_argument("rows", nargs="+")
        p.add_argument("--out")
        p.add_argument("--against", nargs="+", help="learn: rows of other people, to hold the table against")
        p.set_defaults(run={"learn": verdict_table.learn, "judge": verdict_table.judge}[name])
    a = parser.parse_args()
    a.run(a)


if __name__ == "__main__":
    main()
