"""The table behind the verdict's expected error: learned from rows of verdict_fits.py, and held against others."""
import json
import textwrap
from pathlib import Path

import numpy as np
from scipy.optimize import nnls

ZONE = ("unseen", "residual_mm", "open_mm", "turn", "deviation_mm", "stretch", "landmark_mm", "open_most_mm", "asymmetry_mm",
        "shape_deviation", "slid_mm", "pin_far_mm", "pin_misfit_mm", "color_doubt")
WHOLE = ("search_miss", "landmark_misfit", "landmarks_out", "color_miss", "trained_deviation", "kernel_deviation", "size", "folds",
         "is_free", "no_colors", "lips_miss", "brows_miss", "worst_open_mm", "worst_unseen")
LOWERS = ("is_trained", "color_hold")          # more of it makes the error smaller
ZONE_WHOLE = ("search_miss", "color_miss", "trained_deviation", "kernel_deviation", "kernel_mm", "size")
LEAST_MM, MOST_MM, NO_FACE_MM = .3, 30., 30.
QUANTILES = (.1, .5, .97)
RIDGE, LEAST_RISE, HUBER = 1., .02, .35
FOLDS = 10
WRONG_MM, RIGHT_MM = 3., 1.5


def load(paths):
    rows = [json.loads(line) for path in paths for line in Path(path).read_text().splitlines()]
    return [r for r in rows if "measures" in r]


def samples(rows, whole):
    """(features as {name: value}, truth mm, row, zone) of the whole faces, or of the zones."""
    out = []
    for r in rows:
        for zone, measures in r["zones"].items():
            if (zone == "face") != whole:
                continue
            truth = NO_FACE_MM if r["truth"] is None else r["truth"].get(zone)
            if truth is None or r["truth"] is None and not whole:
                continue
            out.append(({**measures, **r["measures"]}, truth, r, zone))
    return out


def knots_of(values):
    at = np.unique(np.round(np.quantile(values, QUANTILES), 6))
    return at if len(at) > 1 else None


class Table:
    """log error = constant + sum of curves."""

    def __init__(self, features, truth, names):
        y = np.log(np.clip(truth, LEAST_MM, MOST_MM))
        columns, self.owner, self.knots = [], [], {}
        for name in names:
            x = np.array([f[name] for f in features])
            at = knots_of(x)
            if at is None:
                continue
            self.knots[name] = at
            for b in self.basis(name, x):
                columns.append(b * (-1 if name in LOWERS else 1))
                self.owner.append(name)
        a = np.stack(columns, 1)
        w = np.ones(len(y))
        for _ in range(8):                         # Huber's weights: a few lost fits do not bend the curves
            mean, middle = np.average(a, axis=0, weights=w), np.average(y, weights=w)
            s = np.sqrt(w)[:, None]
            design = np.concatenate([(a - mean) * s, np.sqrt(RIDGE * len(y) / 100) * np.eye(a.shape[1])])
            self.rise = nnls(design, np.r_[(y - middle) * s[:, 0], np.zeros(a.shape[1])])[0]
            self.constant = middle - mean @ self.rise
            left = y - self.constant - a @ self.rise
            w = np.minimum(1, HUBER / np.maximum(np.abs(left), 1e-9))
        right = truth < RIGHT_MM
        self.right = {n: float(np.median([f[n] for f, r in zip(features, right) if r])) for n in self.knots}

    def basis(self, name, x):
        at = self.knots[name]
        return [np.clip((x - at[k - 1]) / (at[k] - at[k - 1]), 0, 1) for k in range(1, len(at))]

    def log_error(self, features):
        out, k = np.full(len(features), self.constant), 0
        for name in self.knots:
            for b in self.basis(name, np.array([f[name] for f in features])):
                out += self.rise[k] * b * (-1 if name in LOWERS else 1)
                k += 1
        return out

    def curves(self):
        for name in self.knots:
            rise = np.array([r for r, o in zip(self.rise, self.owner) if o == name])
            value = np.r_[0, np.cumsum(rise)] * (-1 if name in LOWERS else 1) + 0.
            if np.abs(value).max() >= LEAST_RISE:
                yield name, self.right[name], self.knots[name], value


def person(row):
    return "-".join(row["key"].split("-")[:3])


def across_people(data, names):
    """Log error of each sample by a table that did not see its person."""
    people = sorted({person(r) for _, _, r, _ in data})
    fold = {p: k % FOLDS for k, p in enumerate(np.random.default_rng(5).permutation(people))}
    fold = np.array([fold[person(r)] for _, _, r, _ in data])
    out = np.empty(len(data))
    for k in range(FOLDS):
        train = [d for d, f in zip(data, fold) if f != k]
        table = Table([d[0] for d in train], np.array([d[1] for d in train]), names)
        out[fold == k] = table.log_error([d[0] for d, f in zip(data, fold) if f == k])
    return out


def ranges(expected, truth):
    left = np.log(np.clip(truth, LEAST_MM, MOST_MM)) - np.log(expected)
    edges = np.quantile(expected, (0, .25, .5, .75, .92, 1))
    rows = [(float(np.median(expected[m])), *np.quantile(left[m], (.1, .9)))
            for lo, hi in zip(edges[:-1], edges[1:]) if (m := (expected >= lo) & (expected <= hi)).sum() > 5]
    return [(a, min(b, 0.), max(c, 0.)) for a, b, c in rows]


def limits(expected, truth):
    """Doubtful: just below the expectation under which a hundredth of the wrong would be called good."""
    wrong = np.sort(expected[truth > WRONG_MM])
    doubtful = .99 * float(wrong[int(.01 * len(wrong))]) if len(wrong) else WRONG_MM
    return doubtful, float(max(2.2 * doubtful, 5.))


def describe(label, expected, truth, low=None, high=None, doubtful=None):
    rank = lambda v: np.argsort(np.argsort(v))
    clipped = np.clip(truth, LEAST_MM, MOST_MM)
    factor = np.exp(np.abs(np.log(expected / clipped)))
    text = f"{label}: {len(truth)}, rank correlation {np.corrcoef(rank(expected), rank(truth))[0, 1]:.3f}, " \
           f"within a factor of 1.5 {(factor < 1.5).mean():.3f}"
    if doubtful is not None:
        good, wrong, right = expected <= doubtful, truth > WRONG_MM, truth < RIGHT_MM
        text += f"; beyond {WRONG_MM} mm and good {good[wrong].sum()} of {wrong.sum()}; below {RIGHT_MM} mm and good " \
                f"{good[right].mean():.3f} of {right.sum()}"
    if low is not None:
        text += f"; in the range {((clipped >= low) & (clipped <= high)).mean():.3f}"
    print(text, flush=True)


def learn(a):
    rows = load(a.rows)
    faces, zones = samples(rows, True), samples(rows, False)
    truth = np.array([d[1] for d in faces])
    names = tuple(n for n in ZONE if n != "landmark_mm") + WHOLE + LOWERS  # of the face: landmark_misfit tells the same
    face_held = np.exp(across_people(faces, names))
    face_limits = limits(face_held, truth)
    describe("face, people left out", face_held, truth, doubtful=face_limits[0])
    face = Table([d[0] for d in faces], truth, names)
    expected = {id(d[2]): e for d, e in zip(faces, face_held)}
    for d in zones:
        d[0]["face_mm"] = expected[id(d[2])]
    zone_truth = np.array([d[1] for d in zones])
    zone_names = ("face_mm",) + ZONE + ("is_free",) + ZONE_WHOLE + LOWERS
    zone_held = np.exp(across_people(zones, zone_names))
    zone_limits = limits(zone_held, zone_truth)
    describe("zones, people left out", zone_held, zone_truth, doubtful=zone_limits[0])
    for name in sorted({d[3] for d in zones}):
        m = np.array([d[3] == name for d in zones])
        describe("  " + name, zone_held[m], zone_truth[m], doubtful=zone_limits[0])
    zone = Table([d[0] for d in zones], zone_truth, zone_names)
    face_spread, zone_spread = ranges(face_held, truth), ranges(zone_held, zone_truth)
    if a.out:
        write(a.out, rows, (face, face_spread, face_limits), (zone, zone_spread, zone_limits))
    if a.against:
        hold_against(a.against, (face, face_spread, face_limits), (zone, zone_spread, zone_limits))


def hold_against(path, face, zone):
    """The tables on fits of people that they were not learned from: what the command will say of them."""
    rows = load(path)
    expected = {}
    for label, whole, (table, spread, (doubtful, _)) in (("face", True, face), ("zones", False, zone)):
        data = samples(rows, whole)
        if not whole:
            data = [({**f, "face_mm": expected[id(r)]}, t, r, z) for f, t, r, z in data]
        e, truth = np.exp(table.log_error([d[0] for d in data])), np.array([d[1] for d in data])
        if whole:
            expected = {id(d[2]): x for d, x in zip(data, e)}
        at, low, high = (np.array(v) for v in zip(*spread))
        bound = lambda v: e * np.exp(np.interp(e, at, v))
        describe(f"{label}, other people", e, truth, bound(low), bound(high), doubtful)
        if not whole:
            for name in sorted({d[3] for d in data}):
                m = np.array([d[3] == name for d in data])
                describe("  " + name, e[m], truth[m], doubtful=doubtful)
        else:
            for key in ("population", "model", "marks", "trouble"):
                for value in sorted({d[2][key] for d in data}):
                    m = np.array([d[2][key] == value for d in data])
                    print(f"  {key} {value}: {m.sum()}, truth {np.median(truth[m]):.2f} expected {np.median(e[m]):.2f} mm in the "
                          f"middle, good {(e[m] <= doubtful).sum()}, beyond {WRONG_MM} mm {(truth[m] > WRONG_MM).sum()}, of these "
                          f"good {((e <= doubtful) & m & (truth > WRONG_MM)).sum()}")


def numbers(values):
    return ", ".join(f"{v:.6g}" for v in values)


def write(path, rows, face, zone):
    people = {person(r) for r in rows}
    seeds = sorted({p.rsplit("-", 1)[0] for p in people})
    comment = textwrap.fill(
        f"Written by tests/bench/verdict_fits.py learn; do not edit. {len(rows)} fits of {len(people)} people, seeds "
        f"{', '.join(seeds)} of verdict_cases.py, by kernel and trained models of two populations.", 97)
    lines = ["// " + line for line in comment.splitlines()]
    lines += ['#include "registration/expected_error.hpp"', "", "namespace mien {", "namespace {", ""]
    for label, (table, spread, _) in (("face", face), ("zone", zone)):
        lines += [f"ErrorTable {label}_table() {{", "    using M = FitMeasure;", "    ErrorTable table;",
                  f"    table.constant = {table.constant:.6g};", "    table.curves = {"]
        lines += [f"{{M::{name}, {right:.6g}, {{{numbers(at)}}}, {{{numbers(value)}}}}},"
                  for name, right, at, value in table.curves()]
        at, low, high = zip(*spread)
        lines += ["    };", f"    table.at_mm = {{{numbers(at)}}};", f"    table.low = {{{numbers(low)}}};",
                  f"    table.high = {{{numbers(high)}}};", "    return table;", "}", ""]
    lines += ["}  // namespace", "", "const ErrorTables& learned_error_tables() {",
              "static const ErrorTables tables{face_table(), zone_table(), "
              f"{numbers(face[2])}, {numbers(zone[2])}}};", "    return tables;", "}", "", "}  // namespace mien"]
    Path(path).write_text("\n".join(lines) + "\n")


def judge(a):
    """What the command itself said of its fits, against the truth."""
    rows = [r for r in load(a.rows) if "expected_error" in r]
    for whole in (True, False):
        data = samples(rows, whole)
        get = lambda d, k: d[2]["expected_error"][d[3]][k]
        truth, expected = np.array([d[1] for d in data]), np.array([get(d, "expected_mm") for d in data])
        low, high = np.array([get(d, "low_mm") for d in data]), np.array([get(d, "high_mm") for d in data])
        word = np.array([d[2]["quality"] if whole else get(d, "quality") for d in data])
        describe("face" if whole else "zones", expected, truth, low, high)
        groups = [("all", np.ones(len(data), bool))]
        for key in ("trouble", "marks", "model") if whole else ():
            groups += [(f"{key} {v}", np.array([d[2][key] == v for d in data])) for v in sorted({d[2][key] for d in data})]
        if not whole:
            groups += [(z, np.array([d[3] == z for d in data])) for z in sorted({d[3] for d in data})]
        for label, m in groups:
            wrong, right, good = m & (truth > WRONG_MM), m & (truth < RIGHT_MM), word == "good"
            print(f"  {label:24s} {m.sum():4d}  truth {np.median(truth[m]):6.2f}  good {(good & m).sum():4d}  doubtful "
                  f"{((word == 'doubtful') & m).sum():4d}  failed {((word == 'failed') & m).sum():4d}  wrong and good "
                  f"{(good & wrong).sum()} of {wrong.sum()}  right and good {(good & right).sum()} of {right.sum()}")
    inside = {}
    for r in rows:
        for zone, share in r.get("within", {}).items():
            inside.setdefault(zone, []).append(share)
    print("within radius95: " + ", ".join(f"{z} {np.mean(v):.3f}" for z, v in sorted(inside.items())))
