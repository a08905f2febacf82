#!/usr/bin/env python3
"""Tables 4.1 to 4.4 and A.1 to A.4 of jousse-2022 on our faces, with the thesis' own numbers beside ours.

  thesis_tables.py TABLE --mien build/release/bin/mien --data test.safetensors --zones zones.json
                   --jpca jpca.safetensors --qojpca qojpca.safetensors --work /tmp/tables [--sweeps 3] [--default model.safetensors]

TABLE: 4.1 4.2 4.3 4.4 A.1 A.2 A.3 A.4, or order (why the two methods change places, below), or all. The two models are
`mien train --method jpca|qojpca` of other people. J-PCA and QOJPCA are fitted by the thesis' block relaxation with --sweeps
sweeps; "default" is what `mien train` and `mien neutralize` do without options, with the model of --default. FaceScape (the thesis') and simulated faces are other people in other
expressions: what can be compared is the order of the methods, not the numbers.

order: both methods over the number of sweeps, from 1 to 200. The subspaces of J-PCA are oblique; block relaxation of
oblique subspaces converges slowly, by the square of the cosine of the angle between them a sweep; what is left of the
identity in the expression's coordinates, and the other way round, is not taken off. QOJPCA pays for its nearly right
angles with modes that explain less, but arrives in a few sweeps.
"""
import argparse
import json
import subprocess
from pathlib import Path

# Expression: mean error in mm (deviation) of baseline, J-PCA, QOJPCA; table 4.2.
TABLE_42 = {
    "mouth_stretch": (2.16, 2.00, 0.71), "cheek_blowing": (1.41, 1.08, 0.75), "lip_puckerer": (1.02, 0.85, 0.69),
    "lip_funneler": (1.26, 0.89, 0.70), "grin": (2.24, 1.52, 1.13), "smile": (1.15, 0.74, 0.59), "dimpler": (2.08, 1.69, 1.40),
    "chin_raiser": (1.49, 1.28, 1.16), "lip_roll": (1.47, 1.21, 1.10), "brow_lower": (1.67, 1.60, 1.54),
    "mouth_left": (1.27, 0.67, 0.67), "mouth_right": (1.26, 0.66, 0.67), "sadness": (1.40, 1.09, 1.11),
    "jaw_left": (1.11, 0.76, 0.78), "anger": (1.21, 1.05, 1.11), "jaw_right": (0.93, 0.65, 0.68), "jaw_forward": (0.78, 0.70, 0.74),
    "eye_closed": (0.75, 0.57, 0.70), "brow_raiser": (0.66, 0.55, 0.65), "neutral": (0.00, 0.19, 0.47)}

# Mean absolute volume in mL of baseline, J-PCA, QOJPCA; tables 4.3 (face), A.1 (mouth), A.2 (nasolabial folds), A.3 (chin), A.4 (cheeks).
VOLUMES = {
    "4.3": {
        "mouth_stretch": (149.2, 145.3, 59.5), "grin": (91.2, 78.4, 55.1), "cheek_blowing": (85.1, 71.3, 65.3),
        "lip_funneler": (70.8, 65.2, 53.9), "lip_puckerer": (69.6, 67.7, 54.5), "chin_raiser": (67.2, 64.1, 57.6),
        "dimpler": (60.2, 62.8, 50.7), "sadness": (57.1, 52.5, 48.0), "lip_roll": (56.4, 51.4, 51.2), "mouth_right": (57.7, 49.8, 54.0),
        "jaw_forward": (67.8, 63.2, 64.2), "jaw_left": (65.1, 52.9, 58.9), "smile": (46.8, 52.8, 44.3), "brow_lower": (54.8, 48.1, 52.8),
        "jaw_right": (55.9, 47.2, 55.4), "mouth_left": (53.2, 48.7, 53.4), "anger": (51.3, 46.6, 52.7), "brow_raiser": (48.6, 44.1, 53.0),
        "eye_closed": (36.0, 36.4, 44.3), "neutral": (0.0, 13.2, 33.0)},
    "A.1": {
        "mouth_stretch": (15.1, 8.5, 3.8), "lip_funneler": (11.6, 10.4, 4.0), "lip_puckerer": (12.9, 9.6, 4.3), "grin": (9.9, 8.9, 3.6),
        "dimpler": (8.4, 9.4, 3.2), "cheek_blowing": (10.6, 10.7, 4.0), "chin_raiser": (8.1, 5.9, 4.2), "jaw_forward": (7.7, 5.3, 4.2),
        "smile": (6.3, 7.6, 3.0), "mouth_right": (5.6, 4.8, 3.3), "lip_roll": (5.6, 5.2, 3.5), "mouth_left": (5.3, 4.1, 3.3),
        "jaw_right": (4.8, 3.6, 3.5), "jaw_left": (5.0, 3.6, 3.5), "sadness": (4.0, 3.4, 3.3), "brow_lower": (3.0, 3.3, 2.9),
        "anger": (3.0, 3.0, 3.7), "brow_raiser": (3.0, 3.0, 3.4), "eye_closed": (2.3, 2.5, 2.7), "neutral": (0.0, 1.2, 2.9)},
    "A.2": {
        "cheek_blowing": (11.0, 5.9, 4.1), "mouth_stretch": (5.9, 6.1, 2.8), "grin": (5.8, 5.3, 3.0), "lip_funneler": (4.8, 4.9, 2.7),
        "lip_puckerer": (4.7, 4.7, 2.8), "dimpler": (4.4, 5.0, 2.6), "jaw_right": (3.8, 2.6, 2.8), "mouth_right": (3.7, 2.8, 2.8),
        "mouth_left": (3.6, 2.6, 2.7), "chin_raiser": (3.5, 3.1, 2.7), "smile": (3.1, 4.3, 2.4), "jaw_left": (4.2, 2.8, 2.9),
        "lip_roll": (3.0, 3.1, 2.6), "jaw_forward": (3.1, 3.0, 2.8), "brow_raiser": (2.4, 2.1, 2.3), "brow_lower": (2.2, 2.2, 2.3),
        "sadness": (2.2, 2.2, 2.4), "anger": (2.0, 2.2, 2.6), "eye_closed": (1.7, 1.6, 2.2), "neutral": (0.0, 0.8, 1.9)},
    "A.3": {
        "mouth_stretch": (24.1, 21.9, 6.9), "lip_roll": (10.3, 6.3, 6.1), "lip_funneler": (9.4, 6.7, 5.7), "jaw_right": (7.4, 5.6, 5.7),
        "grin": (7.5, 6.5, 5.7), "chin_raiser": (9.1, 7.9, 7.4), "jaw_left": (7.5, 5.4, 6.1), "jaw_forward": (12.2, 10.1, 11.1),
        "mouth_right": (5.7, 5.5, 5.3), "mouth_left": (5.8, 5.4, 5.4), "cheek_blowing": (5.8, 6.8, 5.5), "lip_puckerer": (6.2, 6.1, 5.9),
        "sadness": (5.1, 5.1, 5.0), "smile": (3.7, 5.3, 3.8), "anger": (4.8, 4.6, 5.5), "eye_closed": (3.2, 3.5, 3.8),
        "brow_raiser": (3.8, 4.0, 4.3), "dimpler": (5.9, 7.5, 6.7), "brow_lower": (4.9, 4.4, 5.5), "neutral": (0.0, 1.8, 3.0)},
    "A.4": {
        "grin": (32.7, 25.2, 18.3), "mouth_stretch": (32.4, 40.7, 18.6), "cheek_blowing": (39.3, 22.3, 27.6), "dimpler": (23.8, 21.9, 16.7),
        "mouth_left": (22.0, 17.2, 17.1), "mouth_right": (21.5, 16.8, 17.7), "lip_funneler": (20.4, 18.6, 16.4),
        "jaw_forward": (23.9, 24.0, 20.2), "chin_raiser": (21.6, 21.0, 17.7), "jaw_right": (20.2, 16.4, 18.2),
        "lip_puckerer": (19.4, 17.8, 17.6), "jaw_left": (22.3, 17.6, 19.1), "smile": (15.7, 17.1, 13.9), "lip_roll": (17.5, 16.8, 16.5),
        "brow_raiser": (12.3, 12.1, 13.7), "sadness": (13.4, 13.9, 15.0), "brow_lower": (15.7, 13.3, 18.2), "anger": (14.6, 13.1, 17.5),
        "eye_closed": (9.5, 10.1, 13.0), "neutral": (0.0, 4.6, 10.2)}}
ZONES = {"4.3": ["face"], "A.1": ["mouth"], "A.2": ["nasolabial_left", "nasolabial_right"], "A.3": ["chin"],
         "A.4": ["cheek_left", "cheek_right"]}

# Median absolute volume in mL on the face, cheeks, chin, mouth and nasolabial folds; table 4.1. Of a pair of zones ours is the sum
# of both medians.
TABLE_41 = {
    "mouth_stretch": (144.43, 30.72, 23.11, 14.61, 5.64),
    "grin": (86.39, 31.19, 6.57, 9.70, 5.35), "cheek_blowing": (79.60, 37.71, 5.15, 10.16, 10.55), "lip_puckerer": (65.89, 18.08, 5.16, 12.40, 4.36),
    "lip_funneler": (65.38, 18.88, 8.13, 11.42, 4.33), "jaw_forward": (63.96, 22.62, 12.11, 7.11, 2.80),
    "chin_raiser": (62.90, 19.57, 7.94, 7.76, 3.01), "jaw_left": (57.01, 20.13, 6.95, 4.61, 3.73), "dimpler": (55.84, 22.98, 5.42, 8.16, 4.08),
    "jaw_right": (53.61, 19.56, 6.80, 4.62, 3.39), "sadness": (52.57, 11.56, 4.50, 3.34, 1.95), "lip_roll": (52.17, 15.92, 9.72, 5.37, 2.80),
    "mouth_right": (52.12, 20.29, 5.17, 5.35, 3.41), "brow_lower": (50.83, 13.70, 4.37, 2.51, 1.82), "anger": (48.90, 13.26, 4.13, 2.47, 1.79),
    "mouth_left": (48.26, 20.48, 5.07, 4.96, 3.51), "brow_raiser": (43.02, 10.17, 3.24, 2.34, 1.94), "smile": (41.63, 13.86, 3.47, 5.98, 2.80),
    "eye_closed": (30.77, 8.03, 2.74, 1.90, 1.37), "neutral": (0, 0, 0, 0, 0)}

SAME = {"eyes_closed": "eye_closed", "eye_closed": "eye_closed"}


class Runs:
    """Evaluations, each run once."""

    def __init__(self, options):
        self.options, self.work = options, Path(options.work)
        self.work.mkdir(parents=True, exist_ok=True)

    def of(self, model, fit, sweeps=200, volumes=True):
        path = self.work / f"{model}_{fit}_{sweeps}{'' if volumes else '_mm'}.json"
        if not path.exists():
            command = [self.options.mien, "evaluate", "neutralization", "--model", getattr(self.options, model), "--data",
                       self.options.data, "--fit", fit, "--sweeps", str(sweeps), "--json", str(path)]
            done = subprocess.run(command + (["--zones", self.options.zones] if volumes else []), capture_output=True, text=True)
            if done.returncode:
                raise SystemExit(done.stderr)
        report = json.loads(path.read_text())
        return {SAME.get(row["expression"], row["expression"]): row for row in report["expressions"] + [report["all"]]}


def volume(row, zones, which, key="mean_ml"):
    return sum(entry[which][key] for entry in row["volumes"] if entry["zone"] in zones)


def print_rows(title, thesis, ours, columns):
    print(f"\n{title}\n{'':16}" + "".join(f"{c:>12}" for c in columns))
    for name, numbers in sorted(ours.items(), key=lambda item: -item[1][0]):
        theirs = thesis.get(name, (float("nan"),) * (len(columns) - len(numbers)))
        print(f"{name:16}" + "".join(f"{x:12.2f}" if x == x else f"{'-':>12}" for x in tuple(numbers) + tuple(theirs)))


def table_of(runs, number, sweeps):
    j, q = runs.of("jpca", "alternating", sweeps), runs.of("qojpca", "alternating", sweeps)
    own = runs.of("default", "mixture") if runs.options.default else None
    default = ["default"] if own else []
    if number == "4.1":
        names = ["face", "cheeks", "chin", "mouth", "nasolabial"]
        parts = [["face"], ["cheek_left", "cheek_right"], ["chin"], ["mouth"], ["nasolabial_left", "nasolabial_right"]]
        ours = {name: [volume(row, part, "baseline", "median_ml") for part in parts] for name, row in j.items() if name != "all"}
        print_rows("Table 4.1: median absolute volume that an expression makes, mL", TABLE_41,
                   ours, names + [f"th. {name[:6]}" for name in names])
    elif number == "4.2":
        ours = {name: [row["baseline"]["mean_mm"], row["result"]["mean_mm"], q[name]["result"]["mean_mm"]]
                + ([own[name]["result"]["mean_mm"]] if own else []) for name, row in j.items()}
        print_rows(f"Table 4.2: mean vertex error, mm; {sweeps} sweeps", TABLE_42, ours,
                   ["untouched", "J-PCA", "QOJPCA"] + default + ["th. base", "th. J-PCA", "th. QOJPCA"])
    elif number == "4.4":
        print(f"\nTable 4.4: over all but the neutral faces, mm; {sweeps} sweeps\n{'':16}{'mean':>10}{'maximum':>10}{'thesis':>10}{'maximum':>10}")
        for name, row, thesis in (("untouched", j["all"]["baseline"], (2.75, 8.83)), ("J-PCA", j["all"]["result"], (2.53, 6.46)),
                                  ("QOJPCA", q["all"]["result"], (2.08, 5.34))) + (
                                      (("default", own["all"]["result"], None),) if own else ()):
            print(f"{name:16}{row['mean_mm']:10.2f}{row['max_vertex_mm']:10.2f}" + (f"{thesis[0]:10.2f}{thesis[1]:10.2f}" if thesis else ""))
    else:
        zones = ZONES[number]
        ours = {name: [volume(row, zones, "baseline"), volume(row, zones, "result"), volume(q[name], zones, "result")]
                + ([volume(own[name], zones, "result")] if own else []) for name, row in j.items()}
        print_rows(f"Table {number}: mean absolute volume on {' + '.join(zones)}, mL; {sweeps} sweeps", VOLUMES[number], ours,
                   ["untouched", "J-PCA", "QOJPCA"] + default + ["th. base", "th. J-PCA", "th. QOJPCA"])


def order(runs):
    print("\nWhy the order changes: mean vertex error over the sweeps of block relaxation, mm\n"
          f"{'sweeps':>8}{'J-PCA':>10}{'QOJPCA':>10}   mouth_stretch:{'J-PCA':>8}{'QOJPCA':>10}   neutral:{'J-PCA':>8}{'QOJPCA':>10}")
    for sweeps in (1, 3, 10, 50, 200):
        pair = [runs.of(model, "alternating", sweeps, volumes=False) for model in ("jpca", "qojpca")]
        numbers = [[row[name]["result"]["mean_mm"] for row in pair] for name in ("all", "mouth_stretch", "neutral")]
        print(f"{sweeps:8d}{numbers[0][0]:10.2f}{numbers[0][1]:10.2f}{'':17}{numbers[1][0]:8.2f}{numbers[1][1]:10.2f}{'':11}"
              f"{numbers[2][0]:8.2f}{numbers[2][1]:10.2f}")
    print("thesis, table 4.2: mouth_stretch 2.00 by J-PCA (2.16 untouched), 0.71 by QOJPCA: as a J-PCA that has not converged.")


def main():
    ap = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    ap.add_argument("table", choices=["4.1", "4.2", "4.3", "4.4", "A.1", "A.2", "A.3", "A.4", "order", "all"])
    for name in ("mien", "data", "zones", "jpca", "qojpca", "work"):
        ap.add_argument("--" + name, required=True)
    ap.add_argument("--sweeps", type=int, default=3)
    ap.add_argument("--default", help="a model of `mien train` without options: one more column, by the default fit")
    options = ap.parse_args()
    runs = Runs(options)
    for number in (["4.1", "4.2", "4.3", "4.4", "A.1", "A.2", "A.3", "A.4"] if options.table == "all" else [options.table]):
        if number != "order":
            table_of(runs, number, options.sweeps)
    if options.table in ("order", "all"):
        order(runs)


if __name__ == "__main__":
    main()
