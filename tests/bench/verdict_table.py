"""The table behind the verdict's expected error: learned from rows of verdict_fits.py, and held against others."""
import json
import textwrap
from pathlib import Path

import numpy as np

ZONE = ("unseen", "residual_mm", "open_mm", "turn", "deviation_mm", "stretch", "landmark_mm", "open_most_mm", "asymmetry_mm",
        "shape_deviation", "slid_mm", "pin_far_mm", "pin_misfit_mm", "color_hold", "color_doubt")
WHOLE = ("search_miss", "landmark_misfit", "landmarks_out", "color_miss", "trained_deviation", "kernel_deviation", "kernel_mm",
         "size", "folds", "is_free", "is_trained", "no_colors", "lips_miss", "brows_miss", "worst_open_mm", "worst_unseen")
LOWERS = ("is_trained", "color_hold")          # more of it makes the error smaller
EITHER = ("kernel_mm", "pin_far_mm", "is_free", "no_colors")  # what it means hangs on the others
ZONE_NAMES = ZONE + WHOLE
# What its zones are expected to be off, in the mean, tells most of a face; of its landmarks landmark_misfit does.
FACE_NAMES = ("zones_mm",) + tuple(n for n in ZONE if n != "landmark_mm") + WHOLE
LEAST_MM, MOST_MM, NO_FACE_MM = .3, 30., 30.
TREES = {True: 60, False: 120}                 # of the face, of the zones
DEPTH, RATE, LEAST_LEAF, RIDGE, BINS = 4, .1, {True: 15, False: 60}, 1., 48
LEAF_STEPS = 1e4                               # per unit of the logarithm
FOLDS = 10
OF_DEVIATION = (.1, .2, .3, .4, .5, .6, .7, .8, .9, .95, .99, 1)  # quantiles of distance over stated deviation in a row
OF_SIGMA, OF_EXPECTED, FACTORS = 2.7955, (1., 1.03, 1.06, 1.1), (.6, 30.)   # radius.hpp
WRONG_MM, RIGHT_MM = 3., 1.5
WRONG_SHARE = .005                             # of the wrong, called good


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


class Table:
    """log error = constant + sum of trees: boosted, each measure bounded to one direction where it has one."""

    def __init__(self, features, truth, names, whole):
        from sklearn.ensemble import HistGradientBoostingRegressor  # nothing else here needs Debian's python3-sklearn
        y = np.log(np.clip(truth, LEAST_MM, MOST_MM))
        x = np.array([[f[n] for n in names] for f in features])
        direction = [-1 if n in LOWERS else 0 if n in EITHER else 1 for n in names]
        model = HistGradientBoostingRegressor(
            learning_rate=RATE, max_iter=TREES[whole], max_depth=DEPTH, max_leaf_nodes=2 ** DEPTH, l2_regularization=RIDGE,
            min_samples_leaf=LEAST_LEAF[whole], max_bins=BINS, early_stopping=False, monotonic_cst=direction).fit(x, y)
        self.names, self.constant = names, round(float(model._baseline_prediction.ravel()[0]), 6)
        nodes = [trees[0].nodes for trees in model._predictors]
        # Thresholds as they are written; a split names its measure and the place of its threshold.
        inner = [(n["feature_idx"], rounded(n["num_threshold"])) for t in nodes for n in t if not n["is_leaf"]]
        self.limits = [sorted({limit for feature, limit in inner if feature == k}) for k in range(len(names))]
        self.trees = [self.complete(t) for t in nodes]
        right = truth < RIGHT_MM
        self.right = [float(np.median(x[right, k])) for k in range(len(names))]

    def complete(self, nodes):
        """Splits (measure, limit) and leaves of the full tree of that depth; a leaf above its floor is repeated."""
        splits, leaves = [(0, 0)] * (2 ** DEPTH - 1), [0] * 2 ** DEPTH

        def fill(at, place, level):
            node = nodes[at]
            if level == DEPTH:
                leaves[place - (2 ** DEPTH - 1)] = int(round(float(node["value"]) * LEAF_STEPS))
                return
            if node["is_leaf"]:
                left = right = at
            else:
                k = int(node["feature_idx"])
                splits[place] = (k, self.limits[k].index(rounded(node["num_threshold"])))
                left, right = int(node["left"]), int(node["right"])
            fill(left, 2 * place + 1, level + 1)
            fill(right, 2 * place + 2, level + 1)

        fill(0, 0, 0)
        return splits, leaves

    def log_error(self, features):
        x = np.array([[f[n] for n in self.names] for f in features])
        out = np.full(len(x), self.constant)
        for splits, leaves in self.trees:
            at = np.zeros(len(x), int)
            measure = np.array([k for k, _ in splits])
            limit = np.array([self.limits[k][j] if self.limits[k] else 0. for k, j in splits])
            for _ in range(DEPTH):
                at = 2 * at + 1 + (x[np.arange(len(x)), measure[at]] > limit[at])
            out += np.array(leaves)[at - len(splits)] / LEAF_STEPS
        return out


def rounded(value):
    return float(f"{float(value):.6g}")


def person(row):
    return "-".join(row["key"].split("-")[:3])


def across_people(data, names, whole):
    """Log error of each sample by a table that did not see its person."""
    people = sorted({person(r) for _, _, r, _ in data})
    fold = {p: k % FOLDS for k, p in enumerate(np.random.default_rng(5).permutation(people))}
    fold = np.array([fold[person(r)] for _, _, r, _ in data])
    out = np.empty(len(data))
    for k in range(FOLDS):
        train = [d for d, f in zip(data, fold) if f != k]
        table = Table([d[0] for d in train], np.array([d[1] for d in train]), names, whole)
        out[fold == k] = table.log_error([d[0] for d, f in zip(data, fold) if f == k])
    return out


def ranges(expected, truth):
    left = np.log(np.clip(truth, LEAST_MM, MOST_MM)) - np.log(expected)
    edges = np.quantile(expected, (0, .25, .5, .75, .92, 1))
    rows = [(float(np.median(expected[m])), *np.quantile(left[m], (.1, .9)))
            for lo, hi in zip(edges[:-1], edges[1:]) if (m := (expected >= lo) & (expected <= hi)).sum() > 5]
    return [(a, min(b, 0.), max(c, 0.)) for a, b, c in rows]


def radii(rows, expected, failed_mm):
    """What radii of the size of a zone's expectation (radius.hpp) would have held, of fits that did not fail.

    expected: {(id of a row, zone): mm}, of people left out."""
    levels = np.r_[0., OF_DEVIATION]
    data = [(r, z, np.r_[0., q]) for r in rows for z, q in r.get("of_deviation", {}).items()
            if z != "face" and z in r["zones"] and expected[id(r), "face"] <= failed_mm]
    for scale in OF_EXPECTED:
        held = []
        for r, z, quantiles in data:
            factor = np.clip(scale * expected[id(r), z] / r["zones"][z]["deviation_mm"], *FACTORS)
            held.append(np.interp(OF_SIGMA * factor, quantiles, levels))
        held = np.array(held)
        text = f"radii of {scale:g} times the expected error: {len(held)} zones, held {held.mean():.3f}"
        for key in (lambda r, z: z, lambda r, z: r["trouble"], lambda r, z: r["marks"], lambda r, z: r["model"]):
            of = np.array([key(r, z) for r, z, _ in data])
            text += "\n   " + ", ".join(f"{v} {held[of == v].mean():.3f}" for v in sorted(set(of)))
        print(text, flush=True)


def limits(expected, truth):
    """Doubtful: just below the expectation under which WRONG_SHARE of the wrong would be called good."""
    wrong = np.sort(expected[truth > WRONG_MM])
    doubtful = .99 * float(wrong[int(WRONG_SHARE * len(wrong))]) if len(wrong) else WRONG_MM
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


def give_zones_mm(faces, expectation):
    """Adds zones_mm to the faces' measures: mean of expectation(row, zone), mm, over the zones."""
    for features, _, row, _ in faces:
        values = [expectation(row, z) for z in row["zones"] if z != "face"]
        features["zones_mm"] = float(np.mean(values or [expectation(row, "face")]))


def expectation_of(table):
    return lambda row, zone: float(np.exp(table.log_error([{**row["zones"][zone], **row["measures"]}])[0]))


def learn(a):
    rows = load(a.rows)
    zones, faces = samples(rows, False), samples(rows, True)
    zone_truth, truth = np.array([d[1] for d in zones]), np.array([d[1] for d in faces])
    zone_held = np.exp(across_people(zones, ZONE_NAMES, False))
    zone_limits = limits(zone_held, zone_truth)
    describe("zones, people left out", zone_held, zone_truth, doubtful=zone_limits[0])
    for name in sorted({d[3] for d in zones}):
        m = np.array([d[3] == name for d in zones])
        describe("  " + name, zone_held[m], zone_truth[m], doubtful=zone_limits[0])
    zone = Table([d[0] for d in zones], zone_truth, ZONE_NAMES, False)
    held, of_all = {(id(d[2]), d[3]): e for d, e in zip(zones, zone_held)}, expectation_of(zone)
    # Zones of things that are no face have no truth: no table saw them.
    give_zones_mm(faces, lambda r, z: held[id(r), z] if (id(r), z) in held else of_all(r, z))
    face_held = np.exp(across_people(faces, FACE_NAMES, True))
    face_limits = limits(face_held, truth)
    describe("face, people left out", face_held, truth, doubtful=face_limits[0])
    face = Table([d[0] for d in faces], truth, FACE_NAMES, True)
    held.update({(id(d[2]), "face"): e for d, e in zip(faces, face_held)})
    if any("of_deviation" in r for r in rows):
        radii(rows, held, face_limits[1])
    face_spread, zone_spread = ranges(face_held, truth), ranges(zone_held, zone_truth)
    if a.out:
        write(a.out, rows, (face, face_spread, face_limits), (zone, zone_spread, zone_limits))
    if a.against:
        hold_against(a.against, (face, face_spread, face_limits), (zone, zone_spread, zone_limits))


def hold_against(path, face, zone):
    """The tables on fits of people that they were not learned from: what the command will say of them."""
    rows = load(path)
    for label, whole, (table, spread, (doubtful, _)) in (("zones", False, zone), ("face", True, face)):
        data = samples(rows, whole)
        if whole:
            give_zones_mm(data, expectation_of(zone[0]))
        e, truth = np.exp(table.log_error([d[0] for d in data])), np.array([d[1] for d in data])
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
                          f"middle, good {(e[m] <= doubtful).sum()}, beyond {WRONG_MM} mm {(truth[m] > WRONG_MM).sum()}, of "
                          f"these good {((e <= doubtful) & m & (truth > WRONG_MM)).sum()}")


def numbers(values):
    return ", ".join(f"{v:.6g}" for v in values)


def write(path, rows, face, zone):
    people = {person(r) for r in rows}
    seeds = sorted({p.rsplit("-", 1)[0] for p in people})
    comment = textwrap.fill(
        f"Written by tests/bench/verdict_fits.py learn; do not edit. {len(rows)} fits of {len(people)} people, seeds "
        f"{', '.join(seeds)} of verdict_cases.py, by kernel and trained models of two populations.", 97)
    lines = ["// " + line for line in comment.splitlines()]
    lines += ['#include "registration/expected_error.hpp"', "", "#include <iterator>", "", "namespace mien {", "namespace {", "",
              "using M = FitMeasure;", "", "struct Input {", "    FitMeasure measure;", "    double right;",
              "    int num_limits;", "};", ""]
    for label, (table, _, _) in (("Face", face), ("Zone", zone)):
        lines += [f"// {len(table.trees)} trees.", f"constexpr Input k{label}Inputs[] = {{"]
        lines += [f"{{M::{name}, {right:.6g}, {len(limits)}}},"
                  for name, right, limits in zip(table.names, table.right, table.limits)]
        lines += ["};", f"constexpr double k{label}Limits[] = {{"]
        lines += [numbers(limits) + "," for limits in table.limits if limits]
        lines += ["};", f"constexpr std::uint8_t k{label}Splits[] = {{"]
        lines += [", ".join(f"{k}, {j}" for k, j in splits) + "," for splits, _ in table.trees]
        lines += ["};", f"constexpr std::int16_t k{label}Leaves[] = {{"]
        lines += [", ".join(map(str, leaves)) + "," for _, leaves in table.trees]
        lines += ["};", ""]
    lines += ["template <std::size_t I, std::size_t S, std::size_t L>",
              "ErrorTable table_of(double constant, const Input (&inputs)[I], const double* limits,",
              "                    const std::uint8_t (&splits)[S], const std::int16_t (&leaves)[L]) {",
              "    ErrorTable table{};", "    table.constant = constant;", f"    table.depth = {DEPTH};",
              f"    table.leaf_unit = {1 / LEAF_STEPS:g};", "    for (const Input& input : inputs) {",
              "        table.inputs.push_back({input.measure, input.right, {limits, limits + input.num_limits}});",
              "        limits += input.num_limits;", "    }",
              "    table.splits.assign(std::begin(splits), std::end(splits));",
              "    table.leaves.assign(std::begin(leaves), std::end(leaves));", "    return table;", "}", "",
              "ErrorTables learned() {", "    ErrorTables tables{};"]
    for label, (table, spread, bounds) in (("face", face), ("zone", zone)):
        at, low, high = zip(*spread)
        name = label.capitalize()
        lines += [f"    tables.{label} = table_of({table.constant:.6g}, k{name}Inputs, k{name}Limits, k{name}Splits, "
                  f"k{name}Leaves);", f"    tables.{label}.at_mm = {{{numbers(at)}}};",
                  f"    tables.{label}.low = {{{numbers(low)}}};", f"    tables.{label}.high = {{{numbers(high)}}};",
                  f"    tables.{label}_doubtful_mm = {bounds[0]:.6g};", f"    tables.{label}_failed_mm = {bounds[1]:.6g};"]
    lines += ["    return tables;", "}", "", "}  // namespace", "", "const ErrorTables& learned_error_tables() {",
              "    static const ErrorTables tables = learned();", "    return tables;", "}", "", "}  // namespace mien"]
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
