#!/usr/bin/env python3
"""What does the whole road say of a person who did not change?

  unchanged_person.py --mien build/release/bin/mien --demo build/release/bin/mien-demo-data --shared ../shared \\
                      --model face.safetensors --expressions expressions.safetensors --work /tmp/unchanged --people 5

Two populations: people of the shared simulator, scanned neutral, smiling and with the mouth wide open (hair, three holes,
noise, pose, landmarks), and people of the project's own demo generator (neutral, grin, mouth_stretch), whose models are made
from other demo people. `mien register` fits the scans, `mien report` studies the three visits of each; the truth is no change in
any zone. Printed per population and measure, over zones and the two later visits: how often the interval holds 0,
median and largest error, median deviation, how often a change is called detected. Fits and scans are kept in --work: run again with
another --mien to compare two programs on the same fits.
"""
import argparse
import json
import math
import statistics
import subprocess
import sys
from pathlib import Path

MEASURES = ("signed_ml", "gained_ml", "lost_ml", "absolute_ml", "area_change_mm2", "mean_distance_mm")


def run(*command, leaves=None):
    """leaves: a file that a command writes even where it calls its result failed."""
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode and not (leaves and leaves.exists()):
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stderr}{done.stdout}")


def register(o, model, scan, landmarks, out):
    if not out.with_suffix(".json").exists():
        run(o.mien, "register", "--model", model, "--scan", scan, "--landmarks", landmarks, "--out", out.with_suffix(".ply"),
            "--json", out.with_suffix(".json"), leaves=out.with_suffix(".json"))


def simulated(o):
    """Fits of people of the shared simulator; one folder each."""
    model = o.model
    for subject in range(o.people):
        base = o.work / f"simulated{subject:02d}"
        (base / "fits").mkdir(parents=True, exist_ok=True)
        for k, expression in enumerate(("neutral", "smile", "mouth_stretch")):
            scan = base / "scans" / expression
            if not (scan / "landmarks.json").exists():
                run(sys.executable, o.shared / "tools/simulate_scan.py", "--out", scan, "--seed", o.seed, "--subject", subject,
                    "--scan-seed", 10 + k, "--expression", expression, "--hair", "--holes", 3, "--pose-deg", 15, "--pose-mm", 50)
            register(o, model, scan / "scan.ply", scan / "landmarks.json", base / "fits" / f"{k}{expression}")
        yield base, o.expressions, o.shared / "data/ict/zones.json"


def demo(o):
    """Fits of people of the demo generator, with models of other demo people."""
    made = o.work / "demo_models"
    face, expressions = made / "face.safetensors", made / "expressions.safetensors"
    if not expressions.exists():
        run(o.demo, "--out", made, "--subjects", 40, "--test-subjects", 0, "--seed", 1)
        run(o.mien, "model", "build", "--template", made / "template.ply", "--kernel", "surface-matern", "--sigma", 40, "--nu", 1.2,
            "--scale", 4, "--modes", 600, "--mirror", "--landmarks", made / "landmarks.json", "--zones", made / "zones.json",
            "--pca", made / "train.safetensors", "--out", face)
        run(o.mien, "train", "--data", made / "train.safetensors", "--method", "qojpca", "--out", expressions)
    for person in range(o.people):
        base = o.work / f"demo{person:02d}"
        (base / "fits").mkdir(parents=True, exist_ok=True)
        if not (base / "scan/landmarks.json").exists():
            run(o.demo, "--out", base, "--subjects", 1, "--test-subjects", 0, "--seed", o.seed + person)
        for k, expression in enumerate(("neutral", "grin", "mouth_stretch")):
            register(o, face, base / f"scan/scan_{expression}.ply", base / f"scan/landmarks_{expression}.json",
                     base / "fits" / f"{k}{expression}")
        yield base, expressions, made / "zones.json"


def zones_of(o, base, expressions, zones):
    """(expression, zone) -> what the report says of it."""
    report = base / "report.json"
    run(o.mien, "report", "--fitted", "--visits", base / "fits", "--zones", zones, "--expressions", expressions, "--json", report,
        "--out", base / "report.html", *(("--correlation", o.correlation) if o.correlation else ()))
    for visit in json.loads(report.read_text())["visits"][1:]:
        for zone in visit["zones"]:
            yield visit["name"][1:], zone


def values_of(zone, measure):
    """(value, sd, low, high), or None where the program does not tell or does not know."""
    if measure == "signed_ml":
        got = [zone[key] for key in ("signed_ml", "sd_ml", "low95_ml", "high95_ml")]
    else:
        more = zone.get("more", {}).get(measure)
        got = [more[key] for key in ("value", "sd", "low95", "high95")] if more else [None]
    return None if any(v is None or math.isnan(v) for v in got) else got


def table(name, rows):
    print(f"{name}: {len(rows)} zones of visits")
    for measure in MEASURES:
        got = [v for v in (values_of(zone, measure) for _, zone in rows) if v]
        if not got:
            continue
        errors = [abs(v[0]) for v in got]
        print(f"  {measure:18} {len(got):4d} known  holds 0: {sum(v[2] <= 0 <= v[3] for v in got) / len(got):6.1%}  median error "
              f"{statistics.median(errors):7.3f}  largest {max(errors):7.3f}  median sd {statistics.median(v[1] for v in got):7.3f}")
    detected = [zone["below_limit_of_detection"] is False for _, zone in rows if zone["below_limit_of_detection"] is not None]
    print(f"  called detected: {sum(detected)} of {len(detected)}", flush=True)
    for _, zone in sorted(((abs(z["signed_ml"] or 0), (e, z)) for e, z in rows), key=lambda r: -r[0])[:3]:
        low, high = zone[1]["low95_ml"], zone[1]["high95_ml"]
        if low is not None:
            print(f"    farthest: {zone[0]} {zone[1]['name']} {zone[1]['signed_ml']:.2f} mL [{low:.2f}, {high:.2f}]")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--mien", required=True)
    parser.add_argument("--demo", required=True)
    parser.add_argument("--shared", type=Path, required=True)
    parser.add_argument("--model", required=True)
    parser.add_argument("--expressions", required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--people", type=int, default=5, help="of each population")
    parser.add_argument("--seed", type=int, default=91, help="of the people")
    parser.add_argument("--correlation", type=float, default=0, help="mm; 0: the program's own")
    parser.add_argument("--only", choices=("simulated", "demo"), help="one population alone")
    o = parser.parse_args()
    together = []
    for name, people in (("simulated", simulated), ("demo", demo)):
        if o.only in (None, name):
            rows = [row for person in people(o) for row in zones_of(o, *person)]
            table(name, rows)
            together += rows
    if o.only is None:
        table("together", together)


if __name__ == "__main__":
    main()
