#!/usr/bin/env python3
"""The converter on a made-up folder in ICT-FaceKit's layout: a dome with 68 marked vertices."""
import json
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

SCRIPT = Path(__file__).resolve().parents[2] / "examples" / "python" / "convert_ict_facekit.py"
sys.path.insert(0, str(SCRIPT.parent))
import convert_ict_facekit as converter  # noqa: E402

# Where the 68 landmarks lie on the dome, millimetres, front view (x of the left half, mirrored).
EYE = [(18, 33), (26, 39), (37, 39), (45, 34), (37, 31), (26, 31)]
JAW = [(0, -76), (15, -74), (31, -69), (43, -62), (56, -46), (64, -24), (68, -5), (71, 15), (72, 37)]


def marked_points():
    left = lambda points: [(-x, y) for x, y in points]
    jaw = left(JAW[:0:-1]) + JAW
    brow = [(12, 58), (24, 62), (38, 63), (49, 60), (58, 53)]
    mouth = [(-25, -35), (-17, -29), (-7, -25), (0, -26), (7, -25), (17, -29), (25, -35), (18, -41), (10, -43),
             (0, -44), (-10, -43), (-18, -41)]
    inner = [(-22, -35), (-10, -33), (0, -33.5), (10, -33), (22, -35), (11, -34.5), (0, -34.8), (-11, -34.5)]
    right_eye = [EYE[k] for k in (3, 2, 1, 0, 5, 4)]
    return (jaw + left(brow[::-1]) + brow + [(0, 37), (0, 26), (0, 16), (0, 4)] +
            [(-13, -11), (-6, -11.5), (0, -12), (6, -11.5), (13, -11)] + left(right_eye) + EYE + mouth + inner)


class Miniature:
    """Dome z(x, y) on a 33 x 41 grid of quads, then the landmarks, then three socket vertices."""

    def __init__(self, folder, more_units=()):
        self.model = Path(folder) / "FaceXModel"
        self.model.mkdir()
        xs, ys = np.meshgrid(np.linspace(-80, 80, 33), np.linspace(-80, 120, 41))
        grid = np.c_[xs.ravel(), ys.ravel()]
        points = np.r_[grid, marked_points()]
        z = 110 - 0.009 * points[:, 0] ** 2 - 0.004 * points[:, 1] ** 2
        self.mean = np.c_[points, z]
        self.grid, self.skin = len(grid), len(points)
        self.marks = list(range(self.grid, self.skin))
        quads = [[r * 33 + c + 1, r * 33 + c + 2, (r + 1) * 33 + c + 2, (r + 1) * 33 + c + 1]
                 for r in range(40) for c in range(32)]
        self.faces = [" ".join(f"{i}/{i}/{i}" for i in q) for q in quads]
        self.faces.append(f"{self.skin + 1} {self.skin + 2} {self.skin + 3}")     # a socket
        self.identity = [np.array([0.03, 0, 0]) * self.mean, np.array([0, 0.04, 0]) * self.mean]
        units = sorted({u for e in converter.EXPRESSIONS.values() for u in e} | set(more_units))
        rng = np.random.default_rng(5)
        self.shapes = {u: rng.standard_normal(3) * np.exp(-(self.mean[:, 1:2] + 35) ** 2 / 900) for u in units}
        (self.model / "vertex_indices.json").write_text(json.dumps({"expressions": units + ["eyeLookUp_L"]}))
        self.write("generic_neutral_mesh", self.mean)
        for k, d in enumerate(self.identity):
            self.write(f"identity{k:03d}", self.mean + d)
        for unit, d in self.shapes.items():
            self.write(unit, self.mean + d)

    def write(self, name, vertices):
        rows = np.r_[vertices, [[0, 0, 50], [1, 0, 50], [0, 1, 50]]] / 10        # centimetres
        text = "mtllib x.mtl\n" + "".join("v %.9f %.9f %.9f\n" % tuple(r) for r in rows)
        (self.model / f"{name}.obj").write_text(text + "".join(f"f {f}\n" for f in self.faces))

    def convert(self, out, **options):
        return converter.convert(self.model.parent, out, skin=self.skin, face=self.skin, marks=self.marks,
                                 **options)


def read_safetensors(path):
    raw = Path(path).read_bytes()
    size = struct.unpack("<Q", raw[:8])[0]
    header = json.loads(raw[8:8 + size])
    kinds = {"F32": "<f4", "I32": "<i4", "U32": "<u4"}
    arrays = {}
    for name, entry in header.items():
        if name != "__metadata__":
            a, b = entry["data_offsets"]
            arrays[name] = np.frombuffer(raw[8 + size + a:8 + size + b], kinds[entry["dtype"]]).reshape(entry["shape"])
    return arrays, header["__metadata__"], 8 + size


class ConvertTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        cls.source = Miniature(cls.folder)
        cls.out = cls.folder / "out"
        cls.counts = cls.source.convert(cls.out, subjects=4, seed=3)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_template_is_in_millimetres_and_holds_the_skin_alone(self):
        raw = (self.out / "template.ply").read_bytes()
        header, _, body = raw.partition(b"end_header\n")
        self.assertIn(f"element vertex {self.source.skin}\n".encode(), header)
        self.assertIn(f"element face {2 * 40 * 32}\n".encode(), header)      # quads split, socket gone
        vertices = np.frombuffer(body[:12 * self.source.skin], "<f4").reshape(-1, 3)
        np.testing.assert_allclose(vertices, self.source.mean, atol=1e-4)

    def test_landmarks_name_68_vertices(self):
        marks = json.loads((self.out / "landmarks.json").read_text())["vertices"]
        self.assertEqual(len(marks), 68)
        self.assertEqual(sorted(marks.values()), self.source.marks)
        left, right = self.source.mean[marks["eye_left_3"]], self.source.mean[marks["eye_right_0"]]
        self.assertGreater(left[0], 0)
        self.assertLess(right[0], 0)
        self.assertGreater(self.source.mean[marks["mouth_outer_03"]][1], self.source.mean[marks["mouth_outer_09"]][1])

    def test_zones_are_disjoint_parts_of_the_face_and_hold_their_landmarks(self):
        zones = {k: set(v) for k, v in json.loads((self.out / "zones.json").read_text())["zones"].items()}
        parts = [k for k in zones if k != "face"]
        self.assertEqual(len(parts), 10)
        for k, a in enumerate(parts):
            self.assertTrue(zones[a], a)
            self.assertLessEqual(zones[a], zones["face"])
            for b in parts[k + 1:]:
                self.assertFalse(zones[a] & zones[b], (a, b))
        marks = json.loads((self.out / "landmarks.json").read_text())["vertices"]
        for name, zone in (("eye_left_1", "eye_left"), ("eye_right_1", "eye_right"), ("nose_bridge_2", "nose"),
                           ("mouth_outer_03", "mouth"), ("mouth_outer_09", "mouth")):
            self.assertIn(marks[name], zones[zone], name)
        x = self.source.mean[:, 0]
        self.assertTrue(all(x[v] >= 0 for v in zones["cheek_left"]))
        self.assertTrue(all(x[v] < 0 for v in zones["cheek_right"]))

    def test_training_set_holds_subjects_times_20_expressions(self):
        arrays, metadata, start = read_safetensors(self.out / "train.safetensors")
        self.assertEqual(start % 64, 0)
        self.assertEqual(arrays["vertices"].shape, (80, self.source.skin, 3))
        self.assertEqual(json.loads(metadata["expression_names"])[0], "neutral")
        self.assertEqual(metadata["units"], "millimetres")
        self.assertEqual(arrays["expression"].tolist(), list(range(20)) * 4)
        self.assertEqual(arrays["subject"].tolist(), [s for s in range(4) for _ in range(20)])
        self.assertEqual(arrays["triangles"].shape, (2 * 40 * 32, 3))

    def test_neutral_faces_lie_in_the_identity_span_and_expressions_do_not(self):
        arrays, _, _ = read_safetensors(self.out / "train.safetensors")
        basis = np.array([d.ravel() for d in self.source.identity]).T
        for row in (0, 20, 21, 40):
            off = (arrays["vertices"][row] - self.source.mean).ravel()
            rest = off - basis @ np.linalg.lstsq(basis, off, rcond=None)[0]
            if row % 20 == 0:
                self.assertLess(np.abs(rest).max(), 1e-3)
            else:
                self.assertGreater(np.abs(rest).max(), 0.05)

    def test_same_seed_gives_the_same_bytes_another_seed_others(self):
        for name, seed in (("again", 3), ("other", 4)):
            self.source.convert(self.folder / name, subjects=4, seed=seed)
        first = (self.out / "train.safetensors").read_bytes()
        self.assertEqual(first, (self.folder / "again" / "train.safetensors").read_bytes())
        self.assertNotEqual(first, (self.folder / "other" / "train.safetensors").read_bytes())

    def test_52_shapes_for_face_trackers_are_those_of_the_model(self):
        shapes = converter.face_tracking_shapes()
        self.assertEqual(len(shapes), 52)
        with tempfile.TemporaryDirectory() as folder:
            source = Miniature(folder, {unit for units in shapes.values() for unit in units})
            source.convert(Path(folder) / "out", subjects=0, face_tracking=True)
            self.assertEqual({p.stem for p in (Path(folder) / "out/shapes").iterdir()}, set(shapes))

            def moved(name):
                _, _, body = (Path(folder) / "out/shapes" / f"{name}.ply").read_bytes().partition(b"end_header\n")
                return np.frombuffer(body[:12 * source.skin], "<f4").reshape(-1, 3) - source.mean
            np.testing.assert_allclose(moved("eyeBlinkLeft"), source.shapes["eyeBlink_L"], atol=1e-4)
            np.testing.assert_allclose(moved("browInnerUp"), source.shapes["browInnerUp_L"] + source.shapes["browInnerUp_R"], atol=1e-4)
            np.testing.assert_allclose(moved("tongueOut"), 0, atol=1e-4)

    def test_a_folder_without_the_model_says_what_to_give(self):
        run = subprocess.run([sys.executable, str(SCRIPT), str(self.folder / "nothing"), "--out",
                              str(self.folder / "x")], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn("FaceXModel", run.stderr)
        self.assertNotIn("Traceback", run.stderr)

    def test_too_few_vertices_are_named(self):
        with self.assertRaisesRegex(converter.Problem, "generic_neutral_mesh.obj: .* vertices where 11248"):
            converter.convert(self.folder, self.folder / "y")

    def test_a_missing_expression_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Miniature(folder)
            (source.model / "jawOpen.obj").unlink()
            with self.assertRaisesRegex(converter.Problem, "jawOpen.obj"):
                source.convert(Path(folder) / "out", subjects=1, seed=1)


if __name__ == "__main__":
    unittest.main()
