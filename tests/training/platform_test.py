"""mien-train as one command: 20 configurations into one table, interrupted and gone on with.

  platform_test.py MIEN_TRAIN CONFIGS WORK_FOLDER
"""
import hashlib
import json
import math
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest
from pathlib import Path

TRAIN, CONFIGS, WORK = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
SIDE, PEOPLE = 25, 20  # 625 vertices


def face(person, side=SIDE, grin=0):
    """A bump of side x side vertices with a few amplitudes of the person's own, mm; with an expression of its own."""
    a, b, c = (math.sin(1.7 * person + k) for k in range(3))
    points = []
    for j in range(side):
        for i in range(side):
            x, y = 160 * i / (side - 1) - 80, 160 * j / (side - 1) - 80
            z = 50 * math.exp(-(x * x + y * y) / 4000) + 4 * a * math.cos(0.04 * x) + 3 * b * math.sin(0.03 * y + a)
            z += grin * (5 + a) * math.exp(-(x * x + (y + 30) ** 2) / 800)
            points.append((x + 2 * c * math.sin(0.02 * y), y + b * math.cos(0.05 * x), z))
    return points


def write_faces(path, side=SIDE, expressions=("neutral",)):
    triangles = []
    for j in range(side - 1):
        for i in range(side - 1):
            a = j * side + i
            triangles += [a, a + 1, a + side + 1, a, a + side + 1, a + side]
    faces = [(p, e) for p in range(PEOPLE) for e in range(len(expressions))]
    tensors = {"vertices": ("F32", [len(faces), side * side, 3], "f",
                            [x for p, e in faces for v in face(p, side, e) for x in v]),
               "triangles": ("U32", [len(triangles) // 3, 3], "I", triangles),
               "subject": ("I32", [len(faces)], "i", [p for p, _ in faces]),
               "expression": ("I32", [len(faces)], "i", [e for _, e in faces])}
    header, body = {"__metadata__": {"expression_names": json.dumps(expressions), "units": "millimetres"}}, b""
    for name, (kind, shape, code, values) in tensors.items():
        data = struct.pack(f"<{len(values)}{code}", *values)
        header[name] = {"dtype": kind, "shape": shape, "data_offsets": [len(body), len(body) + len(data)]}
        body += data
    text = json.dumps(header).encode()
    path.write_bytes(struct.pack("<Q", len(text)) + text + body)


def arguments(out, epochs, *more, plan="table", faces="faces"):
    settings = [f"data.faces={WORK / (faces + '.safetensors')}", f"data.split={WORK / 'split.json'}", f"out={out}",
                f"experiment.epochs={epochs}", "experiment.batch=8", "experiment.checkpoint_every=1",
                "model.latent=8", "model.widths=[8,16]", "model.mesh_widths=[8,16,16]", "model.bases=8", *more]
    return [TRAIN, str(CONFIGS / (plan + ".json")), *(word for s in settings for word in ("--set", s))]


def run(*words):
    return subprocess.run([*map(str, words)], capture_output=True, text=True, timeout=1500)


def weights(path):
    raw = path.read_bytes()
    size = struct.unpack("<Q", raw[:8])[0]
    return hashlib.sha256(raw[8 + size:]).hexdigest()


class Platform(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        WORK.mkdir(parents=True)
        write_faces(WORK / "faces.safetensors")
        write_faces(WORK / "expressions.safetensors", 13, ("neutral", "grin"))
        done = run(TRAIN, "split", "--data", WORK / "faces.safetensors", "--out", WORK / "split.json")
        assert done.returncode == 0, done.stderr

    def test_twenty_configurations_fill_one_table(self):
        done = run(*arguments(WORK / "table", 2))
        self.assertEqual(done.returncode, 0, done.stderr)
        table = json.loads((WORK / "table" / "table.json").read_text())
        self.assertEqual(len(table["rows"]), 21)
        self.assertEqual(len({row["name"] for row in table["rows"]}), 21)
        for row in table["rows"]:
            for part in ("training", "test", "test_best"):
                for metric in ("l1_mm", "l2_mm", "dame", "fmpd"):
                    self.assertTrue(math.isfinite(row[part][metric]), (row["name"], part, metric))
            self.assertEqual(row["test"]["faces"], 2)
            self.assertTrue((WORK / "table" / row["name"] / "network.safetensors").exists())
        # After two epochs the linear model is far ahead, and the table says so.
        self.assertTrue(table["findings"][0].startswith("PCA wins"), table["findings"])
        self.assertTrue(table["findings"][1].startswith("a smooth function of PCA's own numbers brings its L1 from"), table["findings"])
        self.assertIn("(d)", done.stdout)
        self.assertTrue((WORK / "table" / "table.png").read_bytes().startswith(b"\x89PNG"))
        # A second run has nothing left to do.
        before = {row["name"]: weights(WORK / "table" / row["name"] / "network.safetensors") for row in table["rows"]}
        again = run(*arguments(WORK / "table", 2))
        self.assertEqual(again.stdout, done.stdout)
        for name, mark in before.items():
            self.assertEqual(weights(WORK / "table" / name / "network.safetensors"), mark)

    def test_two_bands_stand_beside_single_networks(self):
        done = run(*arguments(WORK / "bands", 2, "representation.band_limit=20", plan="bands", faces="expressions"))
        self.assertEqual(done.returncode, 0, done.stderr)
        table = json.loads((WORK / "bands" / "table.json").read_text())
        rows = {row["name"]: row for row in table["rows"]}
        self.assertEqual(len(rows), 8)
        for name in ("mesh-autoencoder-bands", "mesh-autoencoder-bands_gamma04", "mesh-autoencoder-bands_plain"):
            self.assertTrue(math.isfinite(rows[name]["test"]["dame"]))
            self.assertGreater(rows[name]["bands"]["low_edit_moves_low_mm"], 0)
            self.assertEqual(len(rows[name]["run"]["losses"][0]), 4, "of both bands, training and validation")
        self.assertIn("mesh-autoencoder-bands: two bands are", done.stdout)

    def test_a_table_of_expressions_has_its_rivals(self):
        (WORK / "oracle.json").write_text('{"expressions_l1_mm": {"grin": 0.125}}')
        more = ["data.expression=grin", f"data.oracle={WORK / 'oracle.json'}", "representation.band_limit=20"]
        done = run(*arguments(WORK / "grin", 3, *more, plan="blendshapes", faces="expressions"))
        self.assertEqual(done.returncode, 0, done.stderr)
        table = json.loads((WORK / "grin" / "table.json").read_text())
        rows = {row["name"]: row for row in table["rows"]}
        self.assertEqual(len(rows), 10, list(rows))
        for model in ("mean-displacement", "deformation-transfer", "pca", "ridge", "banded-regression"):
            self.assertTrue(math.isfinite(rows[model + "-grin"]["test"]["l1_mm"]))
        # The expression is a function of the person that is nearly linear.
        self.assertLess(rows["ridge-grin"]["test"]["l1_mm"], rows["mean-displacement-grin"]["test"]["l1_mm"])
        search = rows["mesh-autoencoder-bands-grin"]["run"]["search"]
        self.assertEqual([c["k"] for c in search], [0, 10, 20, "all"])
        self.assertEqual(sum(c["chosen"] for c in search), 1)
        self.assertIn("L1 0.1250 mm", done.stdout)
        self.assertIn("mesh-autoencoder-bands-grin against ridge: L1 ", done.stdout)
        # The autoencoder of the two steps was trained, and is no row of this table.
        self.assertTrue((WORK / "grin" / "mesh-autoencoder-euclidean_standardised" / "network.safetensors").exists())

    def test_a_killed_run_goes_on_to_the_same_bits(self):
        one = ['models=[{"operator":"mesh-autoencoder"}]', 'representations=[{"kind":"euclidean_standardised"}]']
        name = "mesh-autoencoder-euclidean_standardised"
        whole = run(*arguments(WORK / "whole", 60, *one))
        self.assertEqual(whole.returncode, 0, whole.stderr)
        state = WORK / "killed" / name / "state.safetensors"
        for how in (signal.SIGKILL, signal.SIGTERM):
            seen = state.stat().st_mtime_ns if state.exists() else 0
            process = subprocess.Popen(arguments(WORK / "killed", 60, *one), stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL)
            while process.poll() is None and not (state.exists() and state.stat().st_mtime_ns != seen):
                time.sleep(0.002)
            process.send_signal(how)
            process.wait()
            self.assertIn(process.returncode, (-9, 3), "it ended before it was stopped")
            process.stdout.close()
        self.assertFalse((WORK / "killed" / name / "network.safetensors").exists())
        rest = run(*arguments(WORK / "killed", 60, *one))
        self.assertEqual(rest.returncode, 0, rest.stderr)
        for file in ("network.safetensors", "best.safetensors"):
            self.assertEqual(weights(WORK / "killed" / name / file), weights(WORK / "whole" / name / file), file)

    def test_wrong_settings_are_refused_in_one_line(self):
        for setting in ("model.depth=3", "experiment.epochs=0", "representation.kind=voxels", "nonsense"):
            done = run(*arguments(WORK / "wrong", 2, setting))
            self.assertEqual(done.returncode, 1, setting)
            self.assertEqual(done.stdout, "")
            self.assertIn("mien-train: ", done.stderr.splitlines()[-1])


if __name__ == "__main__":
    sys.argv = sys.argv[:1]
    unittest.main()
