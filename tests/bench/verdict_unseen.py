#!/usr/bin/env python3
"""Kinds of trouble that the verdict's table was not learned from: how it judges what nobody thought of.

  verdict_unseen.py fit MIEN SHARED_DATA MODELS ROWS.jsonl --seeds 17001,17002 [--scans 14] [--per-scan 3]
  verdict_fits.py judge ROWS.jsonl

As verdict_fits.py, with the kinds below in place of those of verdict_cases.py and three people in ten bent by a random field.
None of these kinds may enter the table; new ones belong here, not there.
"""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree

import verdict_cases
import verdict_fits
from verdict_cases import cut, line_distance, smooth


class Face:
    """Of a case (head frame, frontal): its landmarks, and what way is outwards."""

    def __init__(self, case, population):
        self.case, self.data = case, population.data
        self.points, self.truth = case["points"], case["truth"]
        self.marks = dict(zip(population.mark_names, self.truth[population.mark_index]))
        self.nose = self.marks["nose_bridge_3"]
        self.mouth = np.mean([self.marks[f"mouth_outer_{k:02d}"] for k in range(12)], 0)
        self.eyes = [np.mean([self.marks[f"eye_{side}_{k}"] for k in range(6)], 0) for side in ("right", "left")]
        self.middle_y = self.points[:, 1].mean()
        # Of each scan vertex on the template.
        self.coord = population.mean[cKDTree(self.truth).query(self.points)[1]]
        self.at = dict(zip(population.mark_names, population.mean[population.mark_index]))

    def outward(self, p):
        away = (p - [0, self.middle_y, 0]) * [1, 0, 1]
        return away / (np.linalg.norm(away, axis=1)[:, None] + 1e-9)

    def lift(self, height):
        self.case["points"] = self.points + self.outward(self.points) * height[:, None]

    def both(self, change):
        """The person, not the scan."""
        self.case.update(points=change(self.points), truth=change(self.truth))

    def paint(self, share, color):
        share = share[:, None]
        self.case["rgb"] = self.case["rgb"] * (1 - share) + share * np.array(color, float)

    def add(self, points, faces, color):
        count = len(self.case["points"])
        self.case.update(points=np.vstack([self.case["points"], points]), faces=np.vstack([self.case["faces"], faces + count]),
                         rgb=np.vstack([self.case["rgb"], np.broadcast_to(np.array(color, float), points.shape)]))

    def turn(self, rng, least, most):
        return self.data.rotation(rng.standard_normal(3), rng.uniform(least, most))


def grid_faces(rows, columns):
    k = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (x.ravel() for x in (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1]))
    return np.vstack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def bandage(face, rng):
    names = ("jaw_04", "jaw_12", "nose_bridge_2", "jaw_08", "brow_left_2", "mouth_outer_00")
    centre = face.marks[str(rng.choice(names))] + [0, 5, 0]
    cover = smooth((rng.uniform(16, 30) - np.linalg.norm((face.points - centre) * [1, 1, .5], axis=1)) / 4)
    face.lift(cover * rng.uniform(2, 5))
    face.paint(cover, [238, 232, 225])


def beard(face, rng):
    jaw = np.array([face.at[f"jaw_{k:02d}"] for k in range(3, 14)])
    hair = smooth((30 - line_distance(face.coord, jaw)) / 12) * (face.coord[:, 1] < face.at["nose_bridge_3"][1] - 10)
    face.lift(hair * (rng.uniform(4, 14) + rng.normal(0, 1.5, len(hair))))
    face.paint(np.where(hair > .2, 1., 0.), [70, 50, 40])


def cheese(face, rng):
    """Holes of all sizes."""
    waves = sum(np.cos(face.points @ rng.normal(0, 1 / rng.uniform(5, 14), 3) + rng.uniform(0, 6)) for _ in range(5))
    cut(face.case, waves < np.quantile(waves, rng.uniform(.4, .75)))


def clipped_nose(face, rng):
    points = face.points.copy()
    points[:, 2] = np.minimum(points[:, 2], face.truth[:, 2].max() - rng.uniform(4, 14))
    face.case["points"] = points


def coarse(face, rng):
    """Vertices merged in cells of some millimetres."""
    cells = np.floor(face.points / rng.uniform(3, 7)).astype(int)
    _, first, place = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    faces = place.ravel()[face.case["faces"]]
    faces = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 0] != faces[:, 2])]
    face.case.update(points=face.points[first], faces=faces, rgb=face.case["rgb"][first])


def face_paint(face, rng):
    face.paint(smooth(rng.choice([-1, 1]) * (face.points[:, 0] - face.nose[0]) / 6 + .5), [180, 30, 30])
    for _ in range(6):
        centre = face.points[rng.integers(len(face.points))]
        color = ([250, 250, 250], [20, 20, 20], [30, 60, 180])[rng.integers(3)]
        face.paint(smooth((rng.uniform(6, 18) - np.linalg.norm(face.points - centre, axis=1)) / 2), color)


def hood(face, rng):
    top, wide = face.marks["brow_left_2"][1] + rng.uniform(5, 25), rng.uniform(45, 65)
    cloth = np.maximum(smooth((face.points[:, 1] - top) / 6), smooth((abs(face.points[:, 0] - face.nose[0]) - wide) / 6))
    face.lift(cloth * rng.uniform(5, 20))
    face.paint(np.where(cloth > .3, 1., 0.), [60, 60, 120])


def lens(face, rng):
    """Barrel or pincushion, uncorrected."""
    bend = rng.choice([-1, 1]) * rng.uniform(.03, .1) / 80**2

    def seen(p):
        d = p - face.nose
        return face.nose + d * np.stack([1 + bend * (d[:, :2] ** 2).sum(1)] * 2 + [np.ones(len(d))], 1)
    face.both(seen)


def painted_lines(face, rng):
    for _ in range(8):
        ends = face.coord[rng.integers(len(face.coord), size=2)]
        face.paint(smooth((2.5 - line_distance(face.coord, ends)) / 1.5), [20, 20, 40])


def phone(face, rng):
    """A telephone held before the face."""
    centre = face.mouth + [rng.uniform(-50, 50), rng.uniform(-30, 40), 0]
    wide, high, z = rng.uniform(15, 28), rng.uniform(35, 60), face.nose[2] + rng.uniform(3, 20)
    away = abs(face.points[:, :2] - centre[:2])
    cut(face.case, ~((away[:, 0] < wide + 4) & (away[:, 1] < high + 4)))
    x, y = np.meshgrid(np.arange(-wide, wide, 1.5), np.arange(-high, high, 1.5))
    face.add(np.column_stack([centre[0] + x.ravel(), centre[1] + y.ravel(), np.full(x.size, z)]), grid_faces(*x.shape), [30] * 3)


def relief(face, rng):
    """Flatter than the person is."""
    depth = rng.uniform(.65, .88)
    face.both(lambda p: face.nose + (p - face.nose) * [1, 1, depth])


def ripple(face, rng):
    """The stripes that a projector leaves."""
    along = face.points @ face.turn(rng, 0, 180)[0]
    face.case["points"] = face.points + np.array([0, 0, 1]) * (
        rng.uniform(.4, 2) * np.sin(2 * np.pi * along / rng.uniform(5, 25)))[:, None]


def rounded(face, rng):
    step = rng.uniform(.8, 3)
    face.case["points"] = np.round(face.points / step) * step


def scarf(face, rng):
    top = face.mouth[1] - rng.uniform(-8, 25)
    cloth = smooth((top - face.points[:, 1]) / 6)
    folds = 2 * np.sin(face.points[:, 1] / rng.uniform(2, 5)) + 1.5 * np.sin(face.points[:, 0] / 6)
    face.lift(cloth * (rng.uniform(5, 18) + folds))
    face.paint(cloth, rng.uniform(20, 230, 3))


def shell(face, rng):
    """A printed mask: an inner surface as well."""
    inner = face.points - face.outward(face.points) * rng.uniform(1.5, 5)
    face.add(inner, face.case["faces"][:, ::-1], [200] * 3)


def shifted_image(face, rng):
    shift = rng.normal(0, 1, 3) * [1, 1, 0]
    shift *= rng.uniform(3, 9) / np.linalg.norm(shift)
    face.case["rgb"] = face.case["rgb"][cKDTree(face.points).query(face.points + shift)[1]]


def smoothed(face, rng):
    corner, count = face.case["faces"], len(face.points)
    row, column = corner[:, [0, 1, 2, 1, 2, 0]].T.ravel(), corner[:, [1, 2, 0, 0, 1, 2]].T.ravel()
    neighbours = coo_matrix((np.ones(len(row)), (row, column)), (count, count)).tocsr()
    neighbours.data[:] = 1
    number = np.asarray(neighbours.sum(1)).ravel()
    points = face.points
    for _ in range(rng.integers(10, 80)):
        points = neighbours @ points / np.maximum(number, 1)[:, None]
    points[number == 0] = face.points[number == 0]
    face.case["points"] = points


def stairs(face, rng):
    step = rng.uniform(1, 4)
    face.case["points"] = np.column_stack([face.points[:, :2], np.round(face.points[:, 2] / step) * step])


def stick(face, rng):
    """Something in the mouth."""
    around, along = np.meshgrid(np.linspace(0, 2 * np.pi, 16), np.linspace(0, 60, 30))
    rod = np.stack([4 * np.cos(around), 4 * np.sin(around), along], -1).reshape(-1, 3)
    face.add(rod @ face.turn(rng, 0, 40).T + face.mouth, grid_faces(*around.shape), [240, 240, 230])


def stretched(face, rng):
    """The scale drifts from top to bottom."""
    drift = rng.choice([-1, 1]) * rng.uniform(.03, .1) / 80
    face.both(lambda p: face.nose + (p - face.nose) * (1 + np.array([0, drift, 0]) * (p - face.nose)[:, 1:2]))


def sunglasses(face, rng):
    points, front = face.points.copy(), max(eye[2] for eye in face.eyes) + rng.uniform(6, 14)
    for eye in face.eyes:
        away = np.linalg.norm((face.points - eye)[:, :2] / [1.1, .8], axis=1)
        glass = smooth((26 - away) / 3) * (face.points[:, 2] > eye[2] - 25)
        points[:, 2] += glass * (np.maximum(front, points[:, 2]) - points[:, 2])
        face.paint(glass, [15, 15, 18])
    face.case["points"] = points


def swollen(face, rng):
    names = ("jaw_03", "jaw_13", "mouth_outer_03", "brow_left_2", "nose_bridge_3", "jaw_08")
    centre, height, wide = face.marks[str(rng.choice(names))], rng.uniform(6, 18), rng.uniform(12, 25)
    face.both(lambda p: p + face.outward(p) * (height * np.exp(-((p - centre) ** 2).sum(1) / (2 * wide**2)))[:, None])


def twist(face, rng):
    """The person moved sideways while the scanner came down."""
    size, phase, length = rng.uniform(2, 6), rng.uniform(0, 6), rng.uniform(90, 250)
    face.both(lambda p: p + np.array([1, 0, 0]) * (size * np.sin(2 * np.pi * p[:, 1] / length + phase))[:, None])


def two_frames(face, rng):
    """Two scans of a face that moved between them, laid over each other."""
    turned = (face.points - face.nose) @ face.data.rotation(np.array([0, 1., 0]), rng.uniform(1, 4)).T + face.nose
    second = turned + rng.normal(0, 1, 3) * rng.uniform(1, 3)
    count = len(second)
    face.case.update(points=np.vstack([face.points, second]), faces=np.vstack([face.case["faces"], face.case["faces"] + count]),
                     rgb=np.vstack([face.case["rgb"]] * 2))


KINDS = (bandage, beard, cheese, clipped_nose, coarse, face_paint, hood, lens, painted_lines, phone, relief, ripple, rounded,
         scarf, shell, shifted_image, smoothed, stairs, stick, stretched, sunglasses, swollen, twist, two_frames)


def marks_of(kind, population, truth, rng, right=verdict_cases.given_marks):
    """Right ones of verdict_cases.py, or all of them shifted, turned about the nose, or given to the next name of their line."""
    if not kind.startswith("68 "):
        return right(kind, population, truth, rng)
    marks = {name: np.array(place) for name, place in right("68", population, truth, rng).items()}
    if kind == "68 shifted":
        shift = rng.normal(0, 1, 3)
        shift *= rng.uniform(4, 12) / np.linalg.norm(shift)
        marks = {name: place + shift for name, place in marks.items()}
    elif kind == "68 turned":
        centre = np.mean([place for name, place in marks.items() if name.startswith("nose")], 0)
        turn = population.data.rotation(rng.standard_normal(3), rng.uniform(5, 15))
        marks = {name: turn @ (place - centre) + centre for name, place in marks.items()}
    else:
        part = str(rng.choice(["mouth_outer", "jaw", "brow_left", "nose_bridge"]))
        line = [name for name in marks if name.startswith(part)]
        marks.update({name: marks[after] for name, after in zip(line, line[1:] + line[:1])})
    return {name: list(place) for name, place in marks.items()}


def trouble(case, kind, population, rng):
    {k.__name__: k for k in KINDS}[kind](Face(case, population), rng)
    return case


if __name__ == "__main__":
    verdict_cases.TROUBLES = tuple(k.__name__ for k in KINDS)
    verdict_cases.MARKS = ("68", "12", "none", "none", "68 shifted", "68 turned", "68 next name")
    verdict_cases.UNLIKE, verdict_cases.NO_FACES = .3, ()
    verdict_cases.trouble, verdict_cases.given_marks = trouble, marks_of
    verdict_fits.main()
