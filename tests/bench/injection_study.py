#!/usr/bin/env python3
"""How well does the whole road measure a simulated injection, into a cheek or where else clinics treat?

  injection_study.py --mien build/release/bin/mien --shared ../shared --model face.safetensors \\
                     --expressions expressions.safetensors --work /tmp/injection --subjects 20

Each simulated subject is scanned before, and after 1, 2 and 5 mL under the left cheek, neutral and with an
expression; every scan has its own noise, pose and landmarks. `mien register` fits the scans, `mien report` takes the
expressions off all visits together, the treated cheek being no witness, aligns and measures. Printed, against what was
injected and against what of it lies in the zone by the simulated faces themselves (the rim cuts off some 5 % of
the wide hill and 0.2 % of the one that ends inside): median, median error, mean stated deviation, how often the 95 % interval holds the truth, and how often the change
is called below the limit of detection. 0 mL: the other cheek. "as fitted": with the expression left on.
"and around": the treated zone with the margin of `mien report` around it.
--population mh: MakeHuman people, with a model and expressions of that template.
Other places: --treat lips=0:0.5,nose=0:0.4,tear_trough_left=0:0.25,chin=0:1; each place is measured on visits of its own.
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
TROUGH_REACH_MM = 12.0  # of the made zone under an eye, about a point 8 mm under the inner half of the lower lid


def all_zones(template):
    """The shared zones, the lips, and a tear trough, which the shared data has no zone for."""
    from mien_data import read_mesh
    listed = json.loads((template / "zones.json").read_text())
    zones = dict(listed["zones"], lips=listed["lips"])
    places = json.loads((template / "landmarks.json").read_text())["vertices"]
    vertices = read_mesh(template / "template.ply")[0]
    corner, lid = vertices[places["eye_left_0"]], vertices[places["eye_left_5"]]
    place = 0.5 * (corner + lid) - np.array([0.0, 8.0, 0.0])
    near = np.linalg.norm(vertices - place, axis=1) < TROUGH_REACH_MM
    skin = set(zones["face"]) - set(zones["nose"])
    zones["tear_trough_left"] = [int(v) for v in np.flatnonzero(near & (vertices[:, 1] < min(corner[1], lid[1]) - 2.0)) if int(v) in skin]
    return zones


def injected_zones(template):
    """Where hills stand: the open skin of each zone of the template at rest."""
    from mien_data import read_mesh
    vertices, triangles = read_mesh(template / "template.ply")[:2]
    return {name: open_skin(vertices, triangles, zone) for name, zone in all_zones(template).items() if name != "face"}


def open_skin(vertices, triangles, zone):
    """The zone without the walls in nostrils, mouth and lids: a ray along the normal leaves the face."""
    zone = np.asarray(zone)
    normals = vertex_normals(vertices, triangles)[zone]
    corner = vertices[triangles[:, 0]]
    edge1, edge2 = vertices[triangles[:, 1]] - corner, vertices[triangles[:, 2]] - corner
    seen = []
    for v, normal in zip(zone, normals):
        p = np.cross(normal, edge2)
        det = np.einsum("ij,ij->i", edge1, p)
        det[abs(det) < 1e-12] = np.inf
        to = vertices[v] + 0.05 * normal - corner
        q = np.cross(to, edge1)
        a, b, t = np.einsum("ij,ij->i", to, p) / det, q @ normal / det, np.einsum("ij,ij->i", edge2, q) / det
        seen.append(not ((a >= 0) & (b >= 0) & (a + b <= 1) & (t > 0.05)).any())
    return zone[seen]


def vertex_normals(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a)
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, triangles[:, k], area)
    return normals / (np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12)


def hill_inside(vertices, zone, away):
    """The wide hill brought down smoothly to nothing over the last FADE_MM before the zone's rim; a smaller zone's narrower hill over
    all of the way."""
    inside = np.zeros(len(vertices), bool)
    inside[zone] = True
    outside = vertices[~inside & (away < away[zone].max() + 2 * FADE_MM)]
    inwards = np.array([np.linalg.norm(outside - vertices[v], axis=1).min() for v in zone])
    fade = min(FADE_MM, inwards.max())
    t = np.minimum(inwards / fade, 1.0)
    shape = np.zeros(len(vertices))
    shape[zone] = np.exp(-0.5 * (away[zone] / SPREAD_MM) ** 2) * t * t * (3 - 2 * t)
    return shape


def bump(vertices, triangles, zone, millilitres, wide):
    """The face with a smooth hill along its normals, whose volume is what was asked for.

    wide: a Gaussian that does not stop at the zone's rim.
    """
    centre = zone[np.argmin(np.linalg.norm(vertices[zone] - vertices[zone].mean(0), axis=1))]
    normals = vertex_normals(vertices, triangles)
    away = np.linalg.norm(vertices - vertices[centre], axis=1)
    if wide:
        shape = np.exp(-0.5 * (away / SPREAD_MM) ** 2) * (away < 3 * SPREAD_MM)
    else:
        shape = hill_inside(vertices, zone, away)
    facing = normals[zone].sum(0)
    shape *= np.clip(normals @ (facing / np.linalg.norm(facing)), 0, 1)

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
    """One of the shared simulators, of faces that carry an injection; the face model is loaded once."""

    def __init__(self, template, population, wide):
        self.millilitres, self.zone, self.people = 0.0, None, {}
        self.treatable, self.wide = injected_zones(template), wide
        {"ict": self.use_ict, "mh": self.use_mh}[population]()

    def use_ict(self):
        import mien_data
        import simulate_scan
        model = mien_data.FaceModel(None, with_sockets=True)
        untreated, self.skin_count, self.triangles = model.subject, model.n_template, model.template_triangles
        model.subject = lambda *key: self.treated(key, untreated)
        simulate_scan.FaceModel = lambda *a, **k: model
        self.main, self.command = simulate_scan.main, ["simulate_scan.py", "--step", "1"]

    def use_mh(self):
        import make_mh
        model, person = make_mh.MhModel(with_inside=True), make_mh.MhSubject
        self.skin_count, self.triangles = model.n_template, model.triangles
        make_mh.MhModel = lambda *a, **k: model
        make_mh.MhSubject = lambda model, *key: self.treated(key, lambda *k: person(model, *k))
        self.main, self.command = make_mh.main, ["make_mh.py", "scan", "--level", "easy"]

    def treated(self, key, untreated):
        if key not in self.people:
            self.people = {key: untreated(*key)}
        person = copy.copy(self.people[key])
        if self.millilitres:
            skin = person.neutral[:self.skin_count]
            person.neutral = person.neutral.copy()
            person.neutral[:self.skin_count] = bump(skin, self.triangles, self.treatable[self.zone], self.millilitres, self.wide)
        return person

    def scan(self, out, seed, subject, scan_seed, case, noise_mm):
        _, expression, self.zone, self.millilitres = case
        if (out / "landmarks.json").exists():
            return
        old, sys.argv = sys.argv, self.command + ["--out", str(out), "--seed", str(seed), "--subject", str(subject),
                                                  "--scan-seed", str(scan_seed), "--expression", expression, "--noise-mm",
                                                  str(noise_mm), "--pose-deg", "15", "--pose-mm", "50"]
        try:
            self.main()
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
        write_ply(out, np.asarray(tensors["vertices"], float), read_mesh(o.template / "template.ply")[1])


def zone_changes(o, folder, zone, scratch, *options):
    """Of every visit but the first: the zones as `mien report` tells them, the treated one first, the other cheek, if there
    is one, second, and the treated one with its margin last."""
    shown = zone + ",cheek_right" if zone == "cheek_left" else zone
    run(o.mien, "report", "--fitted", "--visits", folder, "--zones", o.work / "zones.json", "--show", shown, "--treated", zone,
        "--json", scratch / "report.json", "--out", scratch / "report.html", *options)
    return {v["name"]: v["zones"] for v in json.loads((scratch / "report.json").read_text())["visits"][1:]}


def hill_height_mm(o, base, zone, millilitres):
    """Of the hill on the simulated face; the bump does not ask in which frame the face lies."""
    from mien_data import read_mesh
    vertices, triangles = read_mesh(base / "true/0before.ply")[:2]
    return np.linalg.norm(bump(vertices, triangles, zone, millilitres, o.hill == "wide") - vertices, axis=1).max()


def visits_of(base, kind, zone, cases):
    """A folder of links to the first visit and those in which this zone was treated, or nothing was."""
    folder = base / f"{kind}-{zone}"
    folder.mkdir(parents=True, exist_ok=True)
    for name, expression, treated, _ in cases:
        if treated in (None, zone) and (kind == "fits" or expression == "neutral"):
            for file in (base / kind).glob(f"{name}.*"):
                if not (folder / file.name).exists():
                    (folder / file.name).symlink_to(file.resolve())
    return folder


def measure_patient(o, base, cases, rows):
    for folder in ("fits", "true"):
        (base / folder).mkdir(parents=True, exist_ok=True)
    for name, expression, _, _ in cases:
        register(o, base / "scans" / name, base / "fits" / name)
        if expression == "neutral":
            write_truth(o, base / "scans" / name, base / "true" / f"{name}.ply")
    for zone in dict(o.treat):
        truth = zone_changes(o, visits_of(base, "true", zone, cases), zone, base)
        fits = visits_of(base, "fits", zone, cases)
        kinds = {"as fitted": zone_changes(o, fits, zone, base),
                 "neutralized": zone_changes(o, fits, zone, base, "--expressions", o.expressions)}
        mine = [case for case in cases[1:] if case[2] in (None, zone)]
        held = {ml: truth[name] for name, expression, _, ml in mine if expression == "neutral"}
        for kind, visits in kinds.items():
            for name, expression, _, ml in mine:
                told = visits[name]
                rows.setdefault((zone, kind, expression, ml), []).append((ml, held[ml][0]["signed_ml"], told[0]))
                rows.setdefault((zone, kind + " and around", expression, ml), []).append((ml, held[ml][-1]["signed_ml"], told[-1]))
                if zone == "cheek_left":
                    rows.setdefault(("cheek_right", kind, expression, 0), []).append((0, 0, told[1]))  # nothing was injected


def cases_of(o):
    """Of (name, expression, zone, mL): the first visit, untreated ones if 0 mL is asked for, and one for each place and amount."""
    cases = [("0before", "neutral", None, 0.0)]
    for expression in o.after.split(","):
        if any(0 in amounts for _, amounts in o.treat):
            cases.append((f"{len(cases)}{expression[0]}", expression, None, 0.0))
        for zone, amounts in o.treat:
            for ml in amounts:
                if ml:
                    cases.append((f"{len(cases)}{expression[0]}{ml:g}".replace(".", "-"), expression, zone, ml))
    return cases


def treatments(text):
    """NAME=ML:ML:...,NAME=... -> [(name, [mL])]"""
    return [(name, [float(ml) for ml in amounts.split(":")]) for name, amounts in (part.split("=") for part in text.split(","))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--mien", required=True)
    parser.add_argument("--shared", type=Path, required=True)
    parser.add_argument("--model", required=True)
    parser.add_argument("--expressions", required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--subjects", type=int, default=20)
    parser.add_argument("--seed", type=int, default=78, help="of the people; 77 served to choose the settings")
    parser.add_argument("--population", choices=("ict", "mh"), default="ict")
    parser.add_argument("--noise-mm", type=float, default=0.15)
    parser.add_argument("--hill", choices=("inside", "wide"), default="inside",
                        help="inside: ends at the zone's rim; wide: a Gaussian that leaves the zone")
    parser.add_argument("--treat", type=treatments, default="cheek_left=1:2:5", help="places and mL: NAME=ML:ML,NAME=ML")
    parser.add_argument("--after", default="neutral,smile", help="expressions after the injection")
    o = parser.parse_args()

    sys.path.insert(0, str(o.shared / "tools"))
    o.template = o.shared / "data" / o.population
    cases = cases_of(o)
    simulator, rows = Simulator(o.template, o.population, o.hill == "wide"), {}
    o.work.mkdir(parents=True, exist_ok=True)
    (o.work / "zones.json").write_text(json.dumps({"zones": all_zones(o.template)}))
    for subject in range(o.subjects):
        base = o.work / f"{subject:02d}"
        for k, case in enumerate(cases):
            simulator.scan(base / "scans" / case[0], o.seed, subject, 10 + k, case, o.noise_mm)
        measure_patient(o, base, cases, rows)
        print(f"subject {subject}", flush=True)
    print("height of the hill (median, mm):", ", ".join(
        f"{zone} {ml:g} mL {np.median([hill_height_mm(o, o.work / f'{s:02d}', simulator.treatable[zone], ml) for s in range(o.subjects)]):.2f}"
        for zone, amounts in o.treat for ml in amounts if ml))
    print_rows(rows)


def print_rows(rows):
    print(f"{'zone':17} {'measured':22} {'after':8} {'mL':>4} {'in zone':>7} {'median':>7} {'|error|':>7} {'of zone':>7} {'mean sd':>7} "
          f"{'95 % holds':>10} {'of zone':>7} {'limit':>6} {'below limit':>11} {'told':>5}")
    for (place, kind, expression, ml), values in sorted(rows.items(), key=str):
        injected, zone = (np.array([v[k] for v in values], float) for k in (0, 1))
        got, low, high, sd, limit, below = (np.array([float(v[2][k]) for v in values]) for k in (
            "signed_ml", "low95_ml", "high95_ml", "sd_ml", "limit_of_detection_ml", "below_limit_of_detection"))
        told = (low > 0) | (high < 0)
        print(f"{place:17} {kind:22} {expression:8} {ml:4g} {np.median(zone):7.2f} {np.median(got):7.2f} "
              f"{np.median(abs(got - injected)):7.2f} {np.median(abs(got - zone)):7.2f} {sd.mean():7.2f} "
              f"{np.mean((low <= injected) & (high >= injected)):10.0%} {np.mean((low <= zone) & (high >= zone)):7.0%} "
              f"{np.median(limit):6.2f} {below.mean():11.0%} {told.mean():5.0%}")


if __name__ == "__main__":
    main()
