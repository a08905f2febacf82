"""Scans of people that nobody has seen, with all that goes wrong in a clinic, and their truth: what verdict_fits.py fits.

A case is a dict: the scan (points, faces, colours or None), the landmarks given with the fit, and the true places of the
template's vertices in the scan's frame. Everything follows from (population, seed, number): the same case on every machine.
"""
import json
import sys
from argparse import Namespace
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

EXPRESSIONS = ("neutral", "neutral", "neutral", "smile", "grin", "mouth_stretch", "eyes_closed", "cheek_blowing", "brow_raiser",
               "lip_puckerer", "jaw_left", "lip_funneler", "anger", "sadness")
TROUBLES = ("none", "none", "none", "none", "turned", "noisy", "wide", "crop", "half", "no lower", "no upper", "mask", "glasses",
            "hand", "brows drawn", "make-up", "side light", "grey", "no colours")
MARKS = ("68", "68", "68 noisy", "68 mouth off", "12", "8 noisy", "4", "none", "none", "none", "none", "none")
UNLIKE = .5                                    # share of people whom no linear model holds
NO_FACES = ("ball", "egg", "nape", "wall", "hand-like")


class Population:
    """ICT-FaceKit ("ict") or MakeHuman ("mh") by the shared tools, loaded once."""

    def __init__(self, name, shared):
        sys.path.insert(0, str(Path(shared).resolve().parent / "tools"))
        import make_mh
        import mien_data
        import simulate_scan
        self.name, self.folder = name, Path(shared) / name
        self.sim, self.mh, self.data = simulate_scan, make_mh, mien_data
        self.zones = {k: np.array(v) for k, v in json.loads((self.folder / "zones.json").read_text())["zones"].items()}
        marks = json.loads((self.folder / "landmarks.json").read_text())
        self.mark_names, self.mark_index = list(marks["vertices"]), np.array(list(marks["vertices"].values()))
        self.alignment = marks["alignment4"]
        self.model = mien_data.FaceModel(self.folder, with_sockets=True) if name == "ict" \
            else make_mh.MhModel(self.folder, with_inside=True)
        self.mean = self.model.mean[:self.model.n_template]
        # The simulators load the model anew with each scan; this one is the same.
        if name == "ict":
            simulate_scan.FaceModel = lambda *a, **k: self.model

    def scan(self, seed, subject, expression, level, work):
        """Points, faces, colours, truth, visible."""
        numbers = dict(self.mh.LEVELS[level])
        o = Namespace(out=str(work), seed=seed, subject=subject, expression=expression, jitter=.2, scan_seed=0, model=None,
                      pick_mm=0., min_fragment=25, level=level, ages="child,adult,old", sex=None, asymmetry=1., beard=None,
                      makeup=False, no_colors=False, **numbers)
        rng = np.random.default_rng([seed, subject, 77])
        if self.name == "ict":
            o.step = 1. if o.view == "cylindrical" else .75
            model, truth, layers = self.sim.build_layers(o, rng)
        else:
            person = self.mh.MhSubject(self.model, seed, subject, tuple(o.ages.split(",")), 1., None)
            look = self.mh.appearance(np.random.default_rng([seed, subject, 63]), person)
            truth, layers = self.mh.build_layers(o, rng, self.model, person, look)
        clean, ray, faces, kind, rgb = self.sim.scan(o, layers, rng)
        d, hit = self.sim.closest_on_mesh(truth, clean, faces)
        triangles = self.model.template_triangles if self.name == "ict" else self.model.triangles
        facing = (self.sim.vertex_normals(truth, triangles) * self.sim.face_normals(clean, faces)[hit]).sum(1) > 0
        noise = o.noise_mm * rng.standard_normal(len(clean))
        noise[(kind == self.sim.EYE) | (kind == self.sim.SOCKET)] *= 3
        spike = rng.random(len(clean)) < o.outliers
        noise[spike] += rng.choice([-1, 1], spike.sum()) * rng.uniform(3, 25, spike.sum())
        rgb = np.clip(rgb + 2.5 * rng.standard_normal((len(rgb), 1)), 0, 255)
        return clean + ray * noise[:, None], faces, rgb, truth, (d < .5) & facing


def unlike(case, rng):
    """Another person: the head (frontal, mm) bent by a smooth random field, as real people differ from what a linear model spans.
    Returns the field's deviation in mm."""
    deviation, length = rng.uniform(.5, 3.5), rng.uniform(22, 70)
    waves, phase = rng.normal(0, 1 / length, (200, 3)), rng.uniform(0, 2 * np.pi, 200)
    weight = rng.normal(0, deviation / 10, (200, 3))         # 200 cosines of mean square 1/2
    lopsided = rng.choice([0, .3, 1], p=[.4, .4, .2])
    middle = case["truth"].mean(0)

    def field(p):
        return np.cos((p - middle) @ waves.T + phase) @ weight

    def bend(p):
        flip = np.array([-1., 1, 1])
        even = .5 * (field(p) + flip * field(middle + flip * (p - middle)))
        return p + np.sqrt(2 - lopsided) * even + lopsided * (field(p) - even)

    case.update(points=bend(case["points"]), truth=bend(case["truth"]))
    return deviation


def smooth(x):
    x = np.clip(x, 0, 1)
    return x * x * (3 - 2 * x)


def cut(case, keep):
    """Only the vertices of `keep` and the triangles among them."""
    faces = case["faces"][keep[case["faces"]].all(1)]
    used = np.unique(faces)
    number = np.zeros(len(keep), int)
    number[used] = np.arange(len(used))
    case.update(points=case["points"][used], faces=number[faces],
                rgb=None if case["rgb"] is None else case["rgb"][used])
    return case


def line_distance(points, line):
    t = np.linspace(0, len(line) - 1, 60)
    dense = np.stack([np.interp(t, range(len(line)), line[:, k]) for k in range(3)], 1)
    return cKDTree(dense).query(points)[0]


def trouble(case, kind, population, rng):
    """Does to a case (head frame, frontal) what its kind says."""
    p, truth = case["points"], case["truth"]
    coord = population.mean[cKDTree(truth).query(p)[1]]      # of each scan vertex on the template
    marks = dict(zip(population.mark_names, truth[population.mark_index]))
    at = dict(zip(population.mark_names, population.mean[population.mark_index]))
    nose, mouth = marks["nose_bridge_3"], np.mean([marks[f"mouth_outer_{k:02d}"] for k in range(12)], 0)
    if kind == "noisy":
        case["points"] = p + rng.normal(0, rng.uniform(.5, 1.5), p.shape)
    elif kind == "wide":
        factor = np.array([rng.uniform(1.12, 1.28), 1, 1])
        case.update(points=p * factor, truth=truth * factor)
    elif kind == "crop":
        cut(case, np.linalg.norm(p - nose, axis=1) < rng.uniform(45, 95))
    elif kind == "half":
        cut(case, rng.choice([-1, 1]) * (p[:, 0] - nose[0]) > rng.uniform(-25, 5))
    elif kind == "no lower":
        cut(case, p[:, 1] > nose[1] - rng.uniform(0, 25))
    elif kind == "no upper":
        cut(case, p[:, 1] < nose[1] + rng.uniform(15, 50))
    elif kind in ("mask", "hand"):
        centre = mouth + [0, -8, 0] if kind == "mask" else marks["jaw_04"] * .5 + mouth * .5 + [0, 8, 0]
        size = np.array([58, 40, 70.]) if kind == "mask" else np.array([26, 34, 60.])
        inside = smooth((1.25 - np.linalg.norm((p - centre) / size, axis=1)) / .5)
        away = (p - [0, p[:, 1].mean(), 0]) * [1, 0, 1]
        away /= np.linalg.norm(away, axis=1)[:, None] + 1e-9
        case["points"] = p + away * (inside * rng.uniform(4, 16))[:, None]
        if case["rgb"] is not None:
            cloth = np.array([[150, 190, 215], [235, 235, 235], [40, 40, 45], [196, 150, 122]][rng.integers(4)], float)
            w = (inside > .25)[:, None]
            case["rgb"] = np.where(w, cloth, case["rgb"])
    elif kind == "glasses":
        for side in ("right", "left"):
            eye = np.mean([marks[f"eye_{side}_{k}"] for k in range(6)], 0)
            r = np.linalg.norm((p - eye)[:, :2] / [1.15, 1], axis=1)
            rim = np.exp(-((r - 24) / 2.5) ** 2) * (p[:, 2] > eye[2] - 25)
            case["points"] = case["points"] + [0, 0, 1] * (rim * rng.uniform(4, 9))[:, None]
            if case["rgb"] is not None:
                case["rgb"] = case["rgb"] * (1 - rim[:, None]) + rim[:, None] * 30
    elif case["rgb"] is not None:
        paint(case, kind, coord, at, rng)
    return case


def paint(case, kind, coord, at, rng):
    """Colours that lie."""
    rgb = case["rgb"].astype(float)
    skin = np.median(rgb[(coord[:, 2] > 50) & (coord[:, 1] > 0)], 0)
    if kind == "brows drawn":
        lift = np.array([0, rng.choice([-1, 1, 1]) * rng.uniform(6, 12), 0])
        for side in ("right", "left"):
            line = np.array([at[f"brow_{side}_{k}"] for k in range(5)])
            old = smooth((11 - line_distance(coord, line)) / 3)[:, None]
            rgb = rgb * (1 - old) + old * skin
            new = .85 * smooth((4.5 - line_distance(coord, line + lift)) / 2)[:, None]
            rgb = rgb * (1 - new) + new * skin * .25
    elif kind == "make-up":
        ring = np.array([at[f"mouth_outer_{k:02d}"] for k in range(12)] + [at["mouth_outer_00"]])
        middle = ring.mean(0)
        wide = middle + (ring - middle) * rng.uniform(1.1, 1.6) + [0, rng.uniform(-5, 5), 0]
        w = smooth((rng.uniform(3, 7) - line_distance(coord, wide)) / 2)[:, None]
        rgb = rgb * (1 - w) + w * np.array([[170, 24, 40], [98, 22, 44], [206, 128, 112]][rng.integers(3)], float)
        for name in ("jaw_03", "jaw_13"):
            w = .6 * np.exp(-((coord - (.5 * at[name] + .5 * middle)) ** 2).sum(1) / 450)[:, None]
            rgb = rgb * (1 - w) + w * [206., 84., 90.]
    elif kind == "side light":
        angle = np.radians(rng.choice([-1, 1]) * rng.uniform(40, 85))
        away = case["points"] - case["points"].mean(0) + [0, 0, 60]
        away /= np.linalg.norm(away, axis=1)[:, None]
        rgb = rgb * (.12 + .95 * np.clip(away @ [np.sin(angle), .2, np.cos(angle)], 0, 1))[:, None]
    elif kind == "grey":
        rgb = np.full_like(rgb, rng.uniform(90, 200)) + rng.normal(0, 1, (len(rgb), 1))
    case["rgb"] = np.clip(rgb, 0, 255)
    if kind == "no colours":
        case["rgb"] = None


def given_marks(kind, population, truth, rng):
    """Landmarks picked on the true face, as {name: place}; empty without."""
    names = list(population.mark_names)
    places = truth[population.mark_index] + rng.normal(0, 1.5, (len(names), 3))
    if kind == "none":
        return {}
    if kind == "68 noisy":
        places += rng.normal(0, rng.uniform(2, 6), places.shape)
    elif kind == "68 mouth off":
        shift = rng.normal(0, 1, 3)
        shift *= rng.uniform(4, 12) / np.linalg.norm(shift)
        part = rng.choice(["mouth", "eye_right", "brow", "nose"])
        places += np.array([n.startswith(part) for n in names])[:, None] * shift
    keep = set(names)
    if kind == "12":
        keep = set(rng.choice(names, 12, replace=False))
    elif kind == "8 noisy":
        places += rng.normal(0, 3, places.shape)
        keep = set(rng.choice(names[17:], 8, replace=False))
    elif kind == "4":
        places = truth[population.mark_index]
        keep = set(population.alignment)
    return {n: list(map(float, p)) for n, p in zip(names, places) if n in keep}


def no_face(kind, population, rng):
    """A thing that is no face, about as large as one."""
    u, v = np.meshgrid(np.linspace(0, np.pi, 90), np.linspace(0, 2 * np.pi, 140))
    unit = np.stack([np.sin(u) * np.cos(v), np.cos(u), np.sin(u) * np.sin(v)], -1).reshape(-1, 3)
    g = np.arange(u.size).reshape(u.shape)
    a, b, c, d = (k.ravel() for k in (g[:-1, :-1], g[1:, :-1], g[1:, 1:], g[:-1, 1:]))
    faces = np.concatenate([np.stack([a, c, b], 1), np.stack([a, d, c], 1)])
    size = {"ball": [95, 95, 95], "egg": [75, 105, 88], "wall": [150, 150, 8], "hand-like": [45, 90, 20]}.get(kind)
    if size is not None:
        points = unit * np.array(size, float) * rng.uniform(.8, 1.2)
        if kind == "hand-like":
            points[:, 0] += 12 * np.sin(points[:, 1] / 9)
        points = points + rng.normal(0, .3, points.shape)
    else:
        person = population.model.subject(int(rng.integers(1000, 2000)), 0)
        points, faces = person.neutral[:population.model.n_template], population.model.template_triangles
        faces = faces[(points[faces][:, :, 2] < 0).all(1)]
        used = np.unique(faces)
        number = np.zeros(len(points), int)
        number[used] = np.arange(len(used))
        points, faces = points[used], number[faces]
    rgb = np.clip(np.array([200., 150, 130]) + rng.normal(0, 6, (len(points), 1)), 0, 255)
    return {"points": points, "faces": faces, "rgb": rgb if rng.random() < .5 else None, "truth": None, "visible": None}


def move(case, population, kind, rng):
    """Somewhere in space; turned by any angle when the trouble is that."""
    degrees = rng.uniform(40, 180) if kind == "turned" else rng.uniform(0, 25)
    r = population.data.rotation(rng.standard_normal(3), degrees)
    t = rng.normal(0, 60, 3)
    case["points"] = case["points"] @ r.T + t
    if case["truth"] is not None:
        case["truth"] = case["truth"] @ r.T + t
    return case


def cases_of(population, seed, number, work, per_scan):
    """Yields (name, trouble, marks, case) of one person's scan."""
    rng = np.random.default_rng([seed, number, 501])
    if number % 12 == 3:
        for k, kind in enumerate(NO_FACES):
            if kind == "nape" and population.name != "ict":
                continue
            yield f"no{k}", kind, "none", move(no_face(kind, population, rng), population, kind, rng)
        return
    expression = EXPRESSIONS[rng.integers(len(EXPRESSIONS))]
    level = ("easy", "medium", "hard")[rng.integers(3)]
    points, faces, rgb, truth, visible = population.scan(seed, number, expression, level, work)
    for k in range(per_scan):
        kind = TROUBLES[rng.integers(len(TROUBLES))]
        marks = MARKS[rng.integers(len(MARKS))]
        case = {"points": points.copy(), "faces": faces, "rgb": rgb.copy(), "truth": truth.copy(), "visible": visible}
        away = unlike(case, rng) if rng.random() < UNLIKE else 0.
        case = move(trouble(case, kind, population, rng), population, kind, rng)
        case.update(expression=expression, level=level, unlike=away, marks=given_marks(marks, population, case["truth"], rng))
        yield f"c{k}", kind, marks, case
