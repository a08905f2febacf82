"""mien network on a network whose numbers are known, written by hand as the format says.

  network_test.py MIEN MIEN_DEMO_DATA WORK_FOLDER
"""
import hashlib
import json
import math
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

MIEN, DEMO, WORK = sys.argv[1], sys.argv[2], Path(sys.argv[3])
SIDE = 11


def run(*arguments):
    return subprocess.run([MIEN, *map(str, arguments)], capture_output=True, text=True)


def must(*arguments):
    done = run(*arguments)
    if done.returncode or done.stderr:
        raise AssertionError(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return done.stdout


def sheet(height):
    return [(6.0 * x - 30, 6.0 * y - 30, height * math.sin(0.4 * x) * math.cos(0.3 * y))
            for y in range(SIDE) for x in range(SIDE)]


def cells():
    triangles = []
    for y in range(SIDE - 1):
        for x in range(SIDE - 1):
            a = y * SIDE + x
            triangles += [(a, a + 1, a + SIDE + 1), (a, a + SIDE + 1, a + SIDE)]
    return triangles


def write_tensors(path, metadata, tensors):
    """tensors: name -> (dtype, shape, struct code, flat values), 8-byte values first."""
    header, body = {"__metadata__": {**metadata, "digest": "0" * 64}}, b""
    for name, (kind, shape, code, values) in tensors.items():
        data = struct.pack(f"<{len(values)}{code}", *values)
        header[name] = {"dtype": kind, "shape": shape, "data_offsets": [len(body), len(body) + len(data)]}
        body += data
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    whole = struct.pack("<Q", len(text)) + text + body
    # Of the file in which its own characters are zeros.
    path.write_bytes(whole.replace(b"0" * 64, hashlib.sha256(whole).hexdigest().encode(), 1))
    return path


def flat(rows):
    return [x for row in rows for x in row]


def write_network(path, name, code):
    """Linear over `code` cosines of the vertex number, orthonormal: what lies in their span comes back."""
    mean = sheet(10)
    n = 3 * len(mean)
    centred = [(x, y, z - 0.5 * (min(p[2] for p in mean) + max(p[2] for p in mean))) for x, y, z in mean]
    scale = max(abs(x) for x in flat(centred))
    basis = [[math.sqrt(2 / n) * math.cos(math.pi * (k + 1) * (i + 0.5) / n) for i in range(n)] for k in range(code)]
    middle = [x / scale for x in flat(centred)]
    to_code = [[basis[k][i] for k in range(code)] for i in range(n)]
    def layer(rows_in, channels_in, rows_out, channels_out, weight, bias):
        return {"kind": "dense", "rows_in": rows_in, "channels_in": channels_in, "rows_out": rows_out,
                "channels_out": channels_out, "elu": False, "tensors": {"weight": weight, "bias": bias}}
    layers = {"encoder": [layer(n // 3, 3, 1, code, "down", "code_bias")],
              "decoder": [layer(1, code, n // 3, 3, "up", "face_bias")]}
    statistics = {f"input.{key}": ("F64", [n // 3, 3], "d", middle) for key in ("mean", "deviation", "least", "greatest")}
    return write_tensors(path, {"kind": "mien-network", "format": "2.0", "units": "millimetres", "name": name,
                                "input.features": "euclidean", "layers": json.dumps(layers)},
                         {"input.mean_shape": ("F64", [n // 3, 3], "d", flat(centred)),
                          "input.scale_mm": ("F64", [1], "d", [scale]), **statistics,
                          "input.triangles": ("U32", [len(cells()), 3], "I", flat(cells())),
                          "down": ("F32", [n, code], "f", flat(to_code)),
                          "up": ("F32", [code, n], "f", flat(basis)),
                          "code_bias": ("F32", [code], "f", [-sum(b * m for b, m in zip(row, middle)) for row in basis]),
                          "face_bias": ("F32", [n], "f", middle)})


MODES = 6


def centred_sheet():
    mean = sheet(10)
    low, high = min(p[2] for p in mean), max(p[2] for p in mean)
    return [(x, y, z - 0.5 * (low + high)) for x, y, z in mean]


def cosines():
    """MODES orthonormal fields over the vertices, for a mass of 1 each; the first is constant."""
    n = SIDE * SIDE
    return [[math.sqrt((2 if k else 1) / n) * math.cos(math.pi * k * (i + 0.5) / n) for i in range(n)]
            for k in range(MODES)]


def dense(rows_in, channels_in, rows_out, channels_out, weight, bias):
    return {"kind": "dense", "rows_in": rows_in, "channels_in": channels_in, "rows_out": rows_out,
            "channels_out": channels_out, "elu": False, "tensors": {"weight": weight, "bias": bias}}


def features(prefix, channels, middle):
    n = SIDE * SIDE
    scale = max(abs(x) for x in flat(centred_sheet()))
    return {f"{prefix}mean_shape": ("F64", [n, 3], "d", flat(centred_sheet())),
            f"{prefix}scale_mm": ("F64", [1], "d", [scale]),
            **{f"{prefix}{key}": ("F64", [n, channels], "d", middle)
               for key in ("mean", "deviation", "least", "greatest")}}


def triangles(prefix):
    return {f"{prefix}triangles": ("U32", [len(cells()), 3], "I", flat(cells()))}


def write_bands(path):
    """Two bands at MODES modes. The low one gives its code back whole (3 numbers a mode), the high one always the
    mean's deformations, whatever its code of 2 numbers is."""
    n, code, other = SIDE * SIDE, 3 * MODES, 2
    u = cosines()
    scale = max(abs(x) for x in flat(centred_sheet()))
    middle = [x / scale for x in flat(centred_sheet())]
    down = [[u[k][i] if axis == c else 0.0 for k in range(MODES) for c in range(3)] for i in range(n) for axis in range(3)]
    bias = [-sum(down[i][k] * middle[i] for i in range(3 * n)) for k in range(code)]
    up = [[down[i][k] for i in range(3 * n)] for k in range(code)] + [[0.0] * (3 * n)] * other
    low = {"encoder": [dense(n, 3, 1, code, "down", "code_bias")],
           "decoder": [dense(1, code + other, n, 3, "up", "face_bias")], "condition": other}
    high = {"encoder": [dense(n, 9, 1, other, "down", "code_bias")],
            "decoder": [dense(1, code + other, n, 9, "up", "face_bias")], "condition": code}
    wide = {"basis.values": ("F64", [MODES], "d", [0.1 * k for k in range(MODES)]),
            "basis.mass": ("F64", [n], "d", [1.0] * n),
            "basis.vectors": ("F64", [n, MODES], "d", [u[k][i] for i in range(n) for k in range(MODES)]),
            **features("low.input.", 3, middle), **features("high.input.", 9, [0.0] * (9 * n)),
            "codes.mean": ("F64", [code + other], "d", [0.0] * (code + other)),
            "codes.factor": ("F64", [1, code + other], "d", [0.0] * 5 + [0.1] + [0.0] * (code + other - 6))}
    narrow = {**triangles("low.input."), **triangles("high.input."),
              "low.down": ("F32", [3 * n, code], "f", flat(down)), "low.code_bias": ("F32", [code], "f", bias),
              "low.up": ("F32", [code + other, 3 * n], "f", flat(up)), "low.face_bias": ("F32", [3 * n], "f", middle),
              "high.down": ("F32", [9 * n, other], "f", [0.01] * (9 * n * other)),
              "high.code_bias": ("F32", [other], "f", [0.5] * other),
              "high.up": ("F32", [code + other, 9 * n], "f", [0.0] * (9 * n * (code + other))),
              "high.face_bias": ("F32", [9 * n], "f", [0.0] * (9 * n))}
    bands = {"task": "faces", "band_limit": MODES, "conditioning": 1}
    return write_tensors(path, {"kind": "mien-network", "format": "2.0", "units": "millimetres", "name": "two bands",
                                "bands": json.dumps(bands), "basis.mass": "none", "basis.cotangents": "keep",
                                "low.layers": json.dumps(low), "low.name": "low", "low.input.features": "euclidean",
                                "high.layers": json.dumps(high), "high.name": "high",
                                "high.input.features": "deformation"}, {**wide, **narrow})


def write_expression(path, expression, shift):
    """Adds `shift` mm along z of the mean's frame to every vertex of a neutral face."""
    n = SIDE * SIDE
    scale = max(abs(x) for x in flat(centred_sheet()))
    layers = {"encoder": [dense(n, 3, 1, 1, "down", "code_bias")], "decoder": [dense(1, 1, n, 3, "up", "face_bias")]}
    neutral = [x / scale for x in flat(centred_sheet())]
    return write_tensors(path, {"kind": "mien-network", "format": "2.0", "units": "millimetres", "name": "adds",
                                "training": json.dumps({"data": {"expression": expression}}), "task": "displacement",
                                "layers": json.dumps(layers), "input.features": "euclidean",
                                "output.features": "euclidean"},
                         {**features("input.", 3, neutral), **features("output.", 3, [0.0] * (3 * n)),
                          **triangles("input."), **triangles("output."),
                          "down": ("F32", [3 * n, 1], "f", [0.01] * (3 * n)), "code_bias": ("F32", [1], "f", [0.0]),
                          "up": ("F32", [1, 3 * n], "f", [0.0] * (3 * n)),
                          "face_bias": ("F32", [3 * n], "f", [0.0, 0.0, shift / scale] * n)})


def write_obj(path, vertices):
    path.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices) +
                    "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in cells()))
    return path


def read_obj(path):
    return [tuple(map(float, line.split()[1:4])) for line in path.read_text().splitlines() if line.startswith("v ")]


def apart(a, b):
    return max(abs(x - y) for p, q in zip(a, b) for x, y in zip(p, q))


class Network(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        WORK.mkdir(parents=True)
        cls.network = write_network(WORK / "small.safetensors", "small", 8)
        cls.face = write_obj(WORK / "face.obj", [(y + 200, -x, z + 5) for x, y, z in sheet(14)])

    def test_info_tells_layers_and_costs(self):
        out = must("network", "info", "--network", self.network, "--json", WORK / "info.json")
        self.assertIn("small: 121 vertices, codes of 8 numbers", out)
        info = json.loads((WORK / "info.json").read_text())
        self.assertEqual(info["encoder_multiply_adds"], 363 * 8)
        self.assertEqual(info["weights"], 2 * 363 * 8 + 363 + 8)

    def test_encode_and_decode_are_apply_where_the_face_stands(self):
        must("network", "encode", "--network", self.network, "--in", self.face, "--out", WORK / "code.json")
        must("network", "decode", "--network", self.network, "--code", WORK / "code.json", "--out", WORK / "back.obj")
        must("network", "apply", "--network", self.network, "--in", self.face, "--out", WORK / "applied.obj")
        self.assertLess(apart(read_obj(WORK / "back.obj"), read_obj(WORK / "applied.obj")), 1e-5)
        self.assertLess(apart(read_obj(WORK / "back.obj"), read_obj(self.face)), 10)
        code = json.loads((WORK / "code.json").read_text())
        self.assertEqual(len(code["code"]), 8)
        # Without the motion the face stands where the training's mean stands.
        (WORK / "bare.json").write_text(json.dumps({"code": code["code"]}))
        must("network", "decode", "--network", self.network, "--code", WORK / "bare.json", "--out", WORK / "bare.obj")
        self.assertGreater(apart(read_obj(WORK / "bare.obj"), read_obj(self.face)), 100)

    def test_compare_says_when_the_linear_model_wins(self):
        faces = [sheet(9.0 + k) for k in range(4)]
        data = write_tensors(WORK / "faces.safetensors",
                             {"expression_names": json.dumps(["neutral"]), "units": "millimetres"},
                             {"vertices": ("F32", [4, SIDE * SIDE, 3], "f", [x for f in faces for x in flat(f)]),
                              "triangles": ("U32", [len(cells()), 3], "I", flat(cells())),
                              "subject": ("I32", [4], "i", [0, 1, 2, 3]), "expression": ("I32", [4], "i", [0] * 4)})
        pca = write_network(WORK / "pca.safetensors", "pca", 3 * SIDE * SIDE)  # gives everything back
        (WORK / "split.json").write_text('{"training": [0, 1], "validation": [], "test": [2, 3]}')
        out = must("network", "compare", "--networks", self.network, pca, "--data", data, "--subjects",
                   WORK / "split.json", "--picture", WORK / "compare.png", "--json", WORK / "compare.json")
        self.assertIn("no network beats the linear model", out)
        rows = json.loads((WORK / "compare.json").read_text())["networks"]
        self.assertEqual([row["faces"] for row in rows], [2, 2])
        self.assertLess(rows[1]["l1_mm"], rows[0]["l1_mm"])
        self.assertTrue(rows[1]["on_front"])
        self.assertTrue((WORK / "compare.png").read_bytes().startswith(b"\x89PNG"))

    def low_numbers(self, face):
        """The face's code in the low band, and whatever is left."""
        must("network", "encode", "--network", self.bands, "--in", face, "--out", WORK / "numbers.json")
        return json.loads((WORK / "numbers.json").read_text())["code"][:3 * MODES]

    def test_two_bands_are_encoded_mixed_and_made_up(self):
        self.bands = write_bands(WORK / "bands.safetensors")
        out = must("network", "info", "--network", self.bands)
        self.assertIn("two bands at 6 of 6 modes", out)
        self.assertIn("high decoder", out)
        must("network", "apply", "--network", self.bands, "--in", self.face, "--out", WORK / "applied.obj")
        apart = [[p - q for p, q in zip(a, b)] for a, b in zip(read_obj(WORK / "applied.obj"), read_obj(self.face))]
        for field in cosines():  # what is lost is of the high band alone, mm
            for axis in range(3):
                self.assertAlmostEqual(sum(u * d[axis] for u, d in zip(field, apart)), 0, delta=2e-3)
        self.assertGreater(max(abs(x) for x in flat(apart)), 0.1)
        other = write_obj(WORK / "other.obj", sheet(4))
        for command in ("network", "spectral"):
            must(command, "mix", "--network", self.bands, "--in", self.face, "--with", other, "--weights", 1, 0,
                 "--out", WORK / f"{command}.obj")
        self.assertEqual((WORK / "network.obj").read_bytes(), (WORK / "spectral.obj").read_bytes())
        mixed, of_a, of_b = (self.low_numbers(f) for f in (WORK / "network.obj", self.face, other))
        self.assertLess(math.dist(mixed, of_b), 0.1 * math.dist(of_a, of_b))
        must("network", "sample", "--network", self.bands, "--seed", 3, "--out", WORK / "made_up.obj", "--code",
             WORK / "made_up.json")
        code = json.loads((WORK / "made_up.json").read_text())["code"]
        self.assertNotEqual(code[5], 0)
        self.assertEqual([x for k, x in enumerate(code) if k != 5], [0.0] * 19)
        must("network", "decode", "--network", self.bands, "--code", WORK / "made_up.json", "--out", WORK / "again.obj")
        self.assertEqual((WORK / "made_up.obj").read_bytes(), (WORK / "again.obj").read_bytes())
        done = run("network", "mix", "--network", self.network, "--in", self.face, "--with", other, "--weights", 1, 0,
                   "--out", WORK / "x.obj")
        self.assertEqual(done.returncode, 2)

    def test_expressions_by_networks_become_one_file_with_names(self):
        grin = write_expression(WORK / "grin.safetensors", "grin", 2.0)
        pout = write_expression(WORK / "pout.safetensors", "pout", -3.0)
        must("transfer-expression", "--network", grin, "--target", self.face, "--out", WORK / "grin.obj")
        # One and the same step of 2 mm along the mean's z, which is nearly the face's own.
        steps = [[p - q for p, q in zip(a, b)] for a, b in zip(read_obj(WORK / "grin.obj"), read_obj(self.face))]
        for step in steps:
            self.assertLess(math.dist(step, steps[0]), 1e-3)
        self.assertAlmostEqual(math.hypot(*steps[0]), 2, delta=1e-3)
        self.assertGreater(steps[0][2], 1.95)
        must("transfer-expression", "--network", grin, pout, "--target", self.face, "--out", WORK / "both.glb")
        glb = (WORK / "both.glb").read_bytes()
        scene = json.loads(glb[20:20 + struct.unpack("<I", glb[12:16])[0]])
        self.assertEqual(scene["meshes"][0]["extras"]["targetNames"], ["grin", "pout"])
        for network, words in ((self.network, "gives faces back"), (self.face, "")):
            done = run("transfer-expression", "--network", network, "--target", self.face, "--out", WORK / "x.glb")
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(words, done.stderr)
        done = run("network", "compare", "--networks", grin, "--data", self.face)
        self.assertNotEqual(done.returncode, 0)

    def test_demo_faces_that_are_not_linear_come_with_an_oracle(self):
        done = subprocess.run([DEMO, "--nonlinear", "--out", WORK / "demo", "--subjects", "2", "--test-subjects", "2"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        oracle = json.loads((WORK / "demo" / "oracle.json").read_text())
        self.assertIn(f"{oracle['neutral_l1_mm']:.4f} mm", done.stdout)
        # What nobody can know is a tenth of a millimetre; what there is to know is millimetres.
        for key in ("neutral_l1_mm", "expression_l1_mm"):
            self.assertGreater(oracle[key], 0.005)
            self.assertLess(oracle[key], 0.3)
        raw = (WORK / "demo" / "train.safetensors").read_bytes()
        header = json.loads(raw[8:8 + struct.unpack("<Q", raw[:8])[0]])
        self.assertEqual(header["vertices"]["shape"][0], 40)

    def test_wrong_files_are_one_line(self):
        for text in ('{"code": [1, 2]}', '{"code": "x"}', '[]', '{"code": [1,2,3,4,5,6,7,8], "motion": [1]}'):
            (WORK / "bad.json").write_text(text)
            done = run("network", "decode", "--network", self.network, "--code", WORK / "bad.json", "--out", WORK / "x.obj")
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        done = run("network", "info", "--network", self.face)
        self.assertEqual(done.returncode, 1)
        self.assertFalse((WORK / "x.obj").exists())


if __name__ == "__main__":
    sys.argv = sys.argv[:1]
    unittest.main()
