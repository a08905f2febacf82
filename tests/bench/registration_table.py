#!/usr/bin/env python3
"""Registers the twelve simulated scans through the `mien` command and prints the table of their errors.

  registration_table.py MIEN SHARED_DATA [--mode kernel|pca|free|free-pca]... [--train FACES] [--work DIR]
                        [--model-options "--kernel ..."] [--register-options "..."] [--scans sim01,sim02] [--threads N]

kernel: the kernel alone; pca: with the modes of FACES (make_faces20.py --subjects 60 --seed 1); free, free-pca: the same
without landmarks. Errors in mm by the shared evaluator: mean and 95th percentile over the visible vertices of the zone
face, distance to the scan's surface, flipped visible triangles; processor seconds of the command; rank correlation of the
stated radius with the true error and the share of errors within it, over all vertices.
"""
import argparse
import json
import resource
import subprocess
import sys
from pathlib import Path

KERNEL = "--kernel surface-matern --sigma 40 --nu 1.2 --scale 4 --modes 1500 --mirror --mirror-correlation 0.9"
CLASSES = {"easy": range(1, 5), "medium": range(5, 9), "hard": range(9, 13)}


def run(command, report=None):
    """Output and processor seconds. A fit that is judged failed ends with status 1, but has written its report."""
    if report is not None:
        report.unlink(missing_ok=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0 and (report is None or not report.exists()):
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return done.stdout, after.ru_utime - before.ru_utime


def ranks(values):
    import numpy as np
    order = np.argsort(values, kind="stable")
    out = np.empty(len(order))
    out[order] = np.arange(len(order))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("mien")
    parser.add_argument("data", help="the folder with ict/ and scans/, beside tools/")
    parser.add_argument("--mode", action="append", choices=["kernel", "pca", "free", "free-pca"])
    parser.add_argument("--train")
    parser.add_argument("--work", default="registration_table")
    parser.add_argument("--model-options", default=KERNEL)
    parser.add_argument("--register-options", default="")
    parser.add_argument("--scans", default=",".join(f"sim{k:02d}" for k in range(1, 13)))
    parser.add_argument("--threads", default="2")
    given = parser.parse_args()
    data, work = Path(given.data), Path(given.work)
    tools = data.resolve().parent / "tools"
    sys.path.insert(0, str(tools))
    import numpy as np
    from mien_data import read_mesh, read_safetensors

    work.mkdir(parents=True, exist_ok=True)
    for mode in given.mode or ["kernel"]:
        trained = mode.endswith("pca")
        if trained and not given.train:
            sys.exit("the trained modes need --train FACES")
        model = work / ("pca.safetensors" if trained else "kernel.safetensors")
        command = [given.mien, "model", "build", "--template", data / "ict/template.ply", *given.model_options.split(),
                   "--landmarks", data / "ict/landmarks.json", "--zones", data / "ict/zones.json", "--threads",
                   given.threads, "--out", model]
        run(command + (["--pca", given.train] if trained else []))
        print(f"\n{mode}: {given.model_options} {given.register_options}\n")
        print("| scan | mean | p95 | surface | flipped | verdict | processor s | rank | within |")
        print("|---|---:|---:|---:|---:|---|---:|---:|---:|")
        rows, errors, radii = {}, [], []
        for name in given.scans.split(","):
            scan, out, report = data / "scans" / name, work / f"{mode}_{name}.ply", work / f"{mode}_{name}.json"
            command = [given.mien, "register", "--model", model, "--scan", scan / "scan.ply", "--out", out, "--json",
                       report, "--threads", given.threads, *given.register_options.split()]
            if not mode.startswith("free"):
                command += ["--landmarks", scan / "landmarks.json"]
            _, seconds = run(command, report)
            text, _ = run([sys.executable, tools / "eval_registration.py", "--truth", scan / "truth.safetensors",
                           "--fit", out, "--scan", scan / "scan.ply"])
            result, verdict = json.loads(text), json.load(open(report))
            truth = read_safetensors(scan / "truth.safetensors")[0]["vertices"]
            error = np.linalg.norm(read_mesh(out)[0] - truth, axis=1)
            radius = np.array(verdict["radius95_mm"])
            errors.append(error)
            radii.append(radius)
            rank = np.corrcoef(ranks(error), ranks(radius))[0, 1]
            face = result["vertex"]["face"]
            rows[name] = [face["mean"], face["p95"], result["scan"]["face"]["mean"], result["flipped"]["visible"]]
            print("| {} | {:.3f} | {:.3f} | {:.3f} | {} | {} | {:.2f} | {:.2f} | {:.3f} |".format(
                name, *rows[name], verdict["quality"], seconds, rank, (error <= radius).mean()), flush=True)
        for label, numbers in CLASSES.items():
            part = [rows[f"sim{k:02d}"] for k in numbers if f"sim{k:02d}" in rows]
            if part:
                mean = np.mean(part, axis=0)
                print(f"| **{label}** | {mean[0]:.3f} | {mean[1]:.3f} | {mean[2]:.3f} | {sum(r[3] for r in part)} | | | | |")
        error, radius = np.concatenate(errors), np.concatenate(radii)
        print(f"\nall vertices of all scans: rank correlation {np.corrcoef(ranks(error), ranks(radius))[0, 1]:.3f}, "
              f"within the 95 % radius {(error <= radius).mean():.3f}")


if __name__ == "__main__":
    main()
