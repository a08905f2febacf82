"""mien measure and mien score on surfaces whose numbers are known."""
import json
import math
import random
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

mien, shared, work = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])


def run(*arguments):
    return subprocess.run([mien, *map(str, arguments)], capture_output=True, text=True)


def write_obj(path, vertices, triangles):
    lines = ["v " + " ".join(repr(float(x)) for x in v) for v in vertices]
    path.write_text("\n".join(lines + ["f " + " ".join(str(i + 1) for i in t) for t in triangles]) + "\n")
    return path


def sheet(height, size=60, cells=30):
    """A square of size mm: z = height(x, y)."""
    side = cells + 1
    vertices = [(size * i / cells, size * j / cells, height(size * i / cells, size * j / cells))
                for j in range(side) for i in range(side)]
    triangles = []
    for j in range(cells):
        for i in range(cells):
            a = j * side + i
            triangles += [(a, a + 1, a + side + 1), (a, a + side + 1, a + side)]
    return vertices, triangles


def read_tensors(path):
    raw = path.read_bytes()
    size = struct.unpack("<Q", raw[:8])[0]
    header = json.loads(raw[8:8 + size])
    return {name: (entry["shape"], raw[8 + size + entry["data_offsets"][0]:8 + size + entry["data_offsets"][1]], entry["dtype"])
            for name, entry in header.items() if name != "__metadata__"}


def write_faces(path, faces, triangles):
    """A dataset of one neutral face per person."""
    tensors = {"vertices": ("F32", [len(faces), len(faces[0]), 3], "f", [x for face in faces for v in face for x in v]),
               "triangles": ("U32", [len(triangles), 3], "I", [i for t in triangles for i in t]),
               "subject": ("I32", [len(faces)], "i", range(len(faces))),
               "expression": ("I32", [len(faces)], "i", [0] * len(faces))}
    header, body = {"__metadata__": {"expression_names": json.dumps(["neutral"]), "units": "millimetres"}}, b""
    for name, (kind, shape, code, values) in tensors.items():
        values = list(values)
        data = struct.pack(f"<{len(values)}{code}", *values)
        header[name] = {"dtype": kind, "shape": shape, "data_offsets": [len(body), len(body) + len(data)]}
        body += data
    text = json.dumps(header).encode()
    path.write_bytes(struct.pack("<Q", len(text)) + text + body)
    return path


class Measure(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)

    def measured(self, *arguments):
        done = run("measure", *arguments, "--json", work / "out.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((work / "out.json").read_text())

    def test_volume_between_surfaces_that_no_template_joins(self):
        flat = write_obj(work / "flat.obj", *sheet(lambda x, y: 0.0))
        hill = write_obj(work / "hill.obj", *sheet(lambda x, y: 2 * math.sin(math.pi * x / 60) * math.sin(math.pi * y / 60), cells=47))
        truth = 2 * (2 * 60 / math.pi) ** 2 / 1000
        got = self.measured("volume", "--before", flat, "--after", hill, "--surfaces", "direction", "--direction", 0, 0, 1)
        self.assertAlmostEqual(got["volume"]["whole"]["signed_ml"], truth, delta=0.01 * truth)
        self.assertAlmostEqual(got["coverage"], 1, places=6)
        # Two scans apart: aligned on a zone that has not changed, whose rim the hill does not reach.
        low = write_obj(work / "low.obj", *sheet(lambda x, y: 0.02 * x * x / 60 + 0.03 * y * y / 60))
        bump = lambda x, y: 3 * math.exp(-((x - 42) ** 2 + (y - 42) ** 2) / 60)
        after, triangles = sheet(lambda x, y: 0.02 * x * x / 60 + 0.03 * y * y / 60 + bump(x, y), cells=41)
        moved = write_obj(work / "moved.obj", [(x + 0.2, y - 0.1, z + 0.8) for x, y, z in after], triangles)
        side = 31
        zones = {"zones": {"still": [v for v in range(side * side) if v % side < 14 or v // side < 14],
                           "hill": [v for v in range(side * side) if v % side >= 14 and v // side >= 14]}}
        (work / "zones.json").write_text(json.dumps(zones))
        got = self.measured("volume", "--before", low, "--after", moved, "--surfaces", "normal", "--zones", work / "zones.json",
                            "--stable", "still")
        self.assertAlmostEqual(got["volume"]["zones"][[z["name"] for z in got["volume"]["zones"]].index("hill")]["signed_ml"],
                               3 * math.pi * 60 / 1000, delta=0.02)
        done = run("measure", "volume", "--before", flat, "--after", hill, "--surfaces", "direction")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--direction", done.stderr)

    def test_curvature_of_a_cylinder_and_its_field(self):
        coat = write_obj(work / "coat.obj", *sheet(lambda x, y: math.sqrt(80 ** 2 - (x - 30) ** 2)))
        got = self.measured("curvature", coat, "--field", work / "k.txt", "--what", "maximal")["curvature"]["whole"]
        self.assertAlmostEqual(got["mean_maximal_per_mm"], 1 / 80, delta=0.04 / 80)  # fits at the rim see one side only
        self.assertAlmostEqual(got["mean_gaussian_per_mm2"], 0, delta=1e-6)
        self.assertEqual(len((work / "k.txt").read_text().split()), 31 * 31)

    def test_lengths_between_landmarks(self):
        arc = write_obj(work / "arc.obj", *sheet(lambda x, y: math.sqrt(40 ** 2 - (x - 30) ** 2), cells=60))
        (work / "marks.json").write_text(json.dumps({"vertices": {"left": 30 * 61, "right": 30 * 61 + 60}}))
        got = self.measured("length", arc, "--landmarks", work / "marks.json", "--between", "left,right")["lengths"][0]
        self.assertAlmostEqual(got["straight_mm"], 60, places=5)
        self.assertAlmostEqual(got["geodesic_mm"], 80 * math.asin(30 / 40), delta=0.01 * 80 * math.asin(30 / 40))
        done = run("measure", "length", arc, "--landmarks", work / "marks.json", "--between", "left,nowhere")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nowhere", done.stderr)

    def test_anthropometry_with_norms_and_reasons(self):
        people = [sheet(lambda x, y: 0.01 * x * y, size=60 + k, cells=10) for k in range(12)]
        data = write_faces(work / "norm_people.safetensors", [vertices for vertices, _ in people], people[0][1])
        marks = work / "anatomy.json"
        marks.write_text(json.dumps({"vertices": {"ch_right": 0, "Left-Cheilion": 10, "sn": 60, "gnathion": 5}}))
        done = run("measure", "norms", "--data", data, "--landmarks", marks, "--out", work / "norms.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        norm = json.loads((work / "norms.json").read_text())["norms"]["ch-ch"]
        self.assertEqual(norm["people"], 12)
        face = write_obj(work / "norm_face.obj", *sheet(lambda x, y: 0.01 * x * y, size=75, cells=10))
        got = self.measured("anthropometry", face, "--landmarks", marks, "--norms", work / "norms.json", "--sd", 0.2)["anthropometry"]
        by_name = {one["name"]: one for one in got["measurements"]}
        self.assertGreaterEqual(len(by_name), 40)
        width = by_name["ch-ch"]
        self.assertAlmostEqual(width["value"], 75, delta=1e-4)
        self.assertAlmostEqual(width["z"], (75 - norm["mean"]) / norm["sd"], delta=1e-3)
        self.assertGreater(width["sd"], 0.1)
        self.assertIn("zygion_left", by_name["zy-zy"]["reason"])
        self.assertIsNone(by_name["zy-zy"]["value"])
        self.assertEqual(got["landmarks"]["cheilion_left"], "Left-Cheilion")
        self.assertIn("no deviation", run("measure", "anthropometry", face, "--landmarks", marks).stdout)
        self.assertIn("landmarks", run("measure", "anthropometry", face).stderr)

    def test_asymmetry_of_a_hill_on_one_side(self):
        def half(height):
            return lambda x, y: 0.01 * (x - 30) ** 2 + height * math.exp(-((x - 45) ** 2 + (y - 30) ** 2) / 40)

        def centred(height):
            vertices, triangles = sheet(half(height))
            return [(x - 30, y, z) for x, y, z in vertices], triangles

        template = write_obj(work / "sides.obj", *centred(0))
        face = write_obj(work / "face_sides.obj", *centred(3))
        done = run("model", "build", "--template", template, "--kernel", "euclidean-se", "--sigma", 30, "--modes", 5,
                   "--accept-faults", "--out", work / "sides.safetensors")
        self.assertEqual(done.returncode, 0, done.stderr)
        side = 31
        (work / "sides.json").write_text(json.dumps({"zones": {
            "cheek_left": [v for v in range(side * side) if v % side > 16], "cheek_right": [v for v in range(side * side) if v % side < 14]}}))
        got = self.measured("asymmetry", face, "--model", work / "sides.safetensors", "--zones", work / "sides.json", "--sd", 0.1,
                            "--field", work / "sides.txt", "--picture", work / "sides.png")
        self.assertEqual([zone["name"] for zone in got["volume"]["zones"]], ["cheek"])
        cheek = got["volume"]["zones"][0]
        truth = 3 * math.pi * 40 / 1000
        self.assertAlmostEqual(cheek["signed_ml"], truth, delta=0.05 * truth)
        self.assertLess(cheek["low95_ml"], truth)
        self.assertGreater(cheek["high95_ml"], truth)
        self.assertGreater(got["asymmetry"]["plane"]["normal"][0], 0.999)
        field = [float(x) for x in (work / "sides.txt").read_text().split()]
        self.assertAlmostEqual(max(field), -min(field), delta=0.2)
        self.assertEqual((work / "sides.png").read_bytes()[:4], b"\x89PNG")

    def test_bland_altman_of_the_published_peak_flows(self):
        wright = [494, 395, 516, 434, 476, 557, 413, 442, 650, 433, 417, 656, 267, 478, 178, 423, 427]
        mini = [512, 430, 520, 428, 500, 600, 364, 380, 658, 445, 432, 626, 260, 477, 259, 350, 451]
        (work / "flows.json").write_text(json.dumps({"first": wright, "second": mini}))
        done = run("score", "bland-altman", "--values", work / "flows.json", "--json", work / "ba.json", "--picture", work / "ba.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        got = json.loads((work / "ba.json").read_text())
        self.assertAlmostEqual(got["bias"], -2.1, delta=0.05)
        self.assertAlmostEqual(got["bias"] - 2 * got["sd"], -79.7, delta=0.1)
        self.assertEqual((work / "ba.png").read_bytes()[:4], b"\x89PNG")

    def test_a_score_finds_where_it_moves_the_face(self):
        chance = random.Random(3)
        hill = lambda x, y: math.exp(-((x - 40) ** 2 + (y - 15) ** 2) / 60)
        waves = [(chance.gauss(0, 0.08), chance.gauss(0, 0.08), chance.uniform(0, 6)) for _ in range(8)]
        faces, grades = [], []
        for _ in range(60):
            grade, amounts = chance.uniform(0, 4), [chance.gauss(0, 1.5) for _ in waves]
            vertices, triangles = sheet(lambda x, y: 0.02 * (x - 30) ** 2 + grade * hill(x, y) + sum(
                a * math.sin(u * x + v * y + w) for a, (u, v, w) in zip(amounts, waves)), cells=18)
            faces.append(vertices)
            grades.append(grade + chance.gauss(0, 0.3))
        data = write_faces(work / "people.safetensors", faces, triangles)
        (work / "grades.json").write_text(json.dumps({"grades": grades}))

        def train(*options):
            done = run("score", "train", "--data", data, "--grades", work / "grades.json", "--curvature", 0, "--json",
                       work / "score.json", "--out", work / "score.safetensors", *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads((work / "score.json").read_text())

        self.assertEqual(train("--uniform")["focus_places"], 0)
        report = train()
        self.assertGreater(report["focus_places"], 0)
        self.assertGreater(report["q2"], 0.8)
        ends = []
        for target in (0, 4):
            done = run("score", "simulate", "--model", work / "score.safetensors", "--target", target, "--out", work / "end.obj")
            self.assertEqual(done.returncode, 0, done.stderr)
            ends.append([tuple(map(float, line.split()[1:4])) for line in (work / "end.obj").read_text().splitlines()
                         if line.startswith("v ")])
        moved = [math.dist(a, b) for a, b in zip(*ends)]
        x, y, _ = ends[0][moved.index(max(moved))]
        self.assertLess(math.hypot(x - 40, y - 15), 8)

    def test_the_closed_head(self):
        model, sockets = shared / "data/ict/model.safetensors", shared / "data/ict/sockets.safetensors"
        if not model.exists():
            self.skipTest("needs the shared data")
        vertices, triangles = [], []
        for path in (model, sockets):
            tensors = read_tensors(path)
            shape, raw, kind = tensors["mean"]
            self.assertEqual(kind, "F32")
            flat = struct.unpack(f"<{shape[0] * 3}f", raw)
            vertices += [flat[k:k + 3] for k in range(0, len(flat), 3)]
            shape, raw, kind = tensors["triangles"]
            self.assertEqual(kind, "U32")
            flat = struct.unpack(f"<{shape[0] * 3}I", raw)
            triangles += [flat[k:k + 3] for k in range(0, len(flat), 3)]
        head = write_obj(work / "head.obj", vertices, triangles)
        got = self.measured("area", head, "--close-rims")
        print("closed head:", got["closed_volume_ml"] / 1000, "L")
        self.assertAlmostEqual(got["closed_volume_ml"], 5119.7, delta=0.0001 * 5119.7)
        self.assertIn("open", run("measure", "area", head, "--closed").stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
