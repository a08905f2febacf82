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


def face(person):
    """A bump of SIDE x SIDE vertices with a few amplitudes of the person's own, mm."""
    a, b, c = (math.sin(1.7 * person + k) for k in range(3))
    points = []
    for j in range(SIDE):
        for i in range(SIDE):
            x, y = 160 * i / (SIDE - 1) - 80, 160 * j / (SIDE - 1) - 80
            z = 50 * math.exp(-(x * x + y * y) / 4000) + 4 * a * math.cos(0.04 * x) + 3 * b * math.sin(0.03 * y + a)
            points.append((x + 2 * c * math.sin(0.02 * y), y + b * math.cos(0.05 * x), z))
    return points


def write_faces(path):
    triangles = []
    for j in range(SIDE - 1):
        for i in range(SIDE - 1):
            a = j * SIDE + i
            triangles += [a, a + 1, a + SIDE + 1, a, a + SIDE + 1, a + SIDE]
    tensors = {"vertices": ("F32", [PEOPLE, SIDE * SIDE, 3], "f", [x for p in range(PEOPLE) for v in face(p) for x in v]),
               "triangles": ("U32", [len(triangles) // 3, 3], "I", triangles),
               "subject": ("I32", [PEOPLE], "i", list(range(PEOPLE))),
               "expression": ("I32", [PEOPLE], "i", [0] * PEOPLE)}
    header, body = {"__metadata__": {"expression_names": json.dumps(["neutral"]), "units": "millimetres"}}, b""
    for name, (kind, shape, code, values) in tensors.items():
        data = struct.pack(f"<{len(values)}{code}", *values)
        header[name] = {"dtype": kind, "shape": shape, "data_offsets": [len(body), len(body) + len(data)]}
        body += data
    text = json.dumps(header).encode()
    path.write_bytes(struct.pack("<Q", len(text)) + text + body)


def arguments(out, epochs, *more):
    settings = [f"data.faces={WORK / 'faces.safetensors'}", f"data.split={WORK / 'split.json'}", f"out={out}",
                f"experiment.epochs={epochs}", "experiment.batch=8", "experiment.checkpoint_every=1",
                "model.latent=8", "model.widths=[8,16]", "model.mesh_widths=[8,16,16]", "model.bases=8", *more]
    return [TRAIN, str(CONFIGS / "table.json"), *(word for s in settings for word in ("--set", s))]


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
        self.assertIn("(d)", done.stdout)
        self.assertTrue((WORK / "table" / "table.png").read_bytes().startswith(b"\x89PNG"))
        # A second run has nothing left to do.
        before = {row["name"]: weights(WORK / "table" / row["name"] / "network.safetensors") for row in table["rows"]}
        again = run(*arguments(WORK / "table", 2))
        self.assertEqual(again.stdout, done.stdout)
        for name, mark in before.items():
            self.assertEqual(weights(WORK / "table" / name / "network.safetensors"), mark)

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
