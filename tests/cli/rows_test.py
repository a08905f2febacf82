#!/usr/bin/env python3
"""Commands over models' coefficients, codes, fields and transfers, on demo faces.

  rows_test.py MIEN MIEN_DEMO_DATA WORK_FOLDER

What these commands write is compared with what it must be: faces that come back, fields that agree. Standard library only.
"""
import json
import math
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

MIEN, DEMO, WORK = sys.argv[1], sys.argv[2], Path(sys.argv[3])
PNG = b"\x89PNG\r\n\x1a\n"


def run(*arguments):
    done = subprocess.run([MIEN, *map(str, arguments)], capture_output=True, text=True, timeout=600, check=False)
    return done.returncode, done.stdout, done.stderr


def must(*arguments):
    status, out, err = run(*arguments)
    if status != 0 or err:
        raise AssertionError(f"mien {' '.join(map(str, arguments))}\nexit {status}: {err}")
    return out


def read(path):
    return json.loads(Path(path).read_text())


def vertices(path):
    """Vertices of any mesh: written as OFF by the command, which keeps all digits."""
    off = WORK / "as_text.off"
    must("mesh", "convert", path, off)
    lines = [line for line in off.read_text().splitlines() if line and not line.startswith("#")]
    count = int(lines[1].split()[0])
    return [tuple(map(float, line.split()[:3])) for line in lines[2:2 + count]]


def farthest(a, b):
    return max(math.dist(p, q) for p, q in zip(vertices(a), vertices(b)))


def tensors(path):
    raw = Path(path).read_bytes()
    length = struct.unpack_from("<Q", raw)[0]
    header = json.loads(raw[8:8 + length])
    return {name: (e["shape"], struct.unpack_from(f"<{(e['data_offsets'][1] - e['data_offsets'][0]) // 8}d", raw,
                                                  8 + length + e["data_offsets"][0]))
            for name, e in header.items() if name != "__metadata__"}


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    demo = WORK / "demo"
    subprocess.run([DEMO, "--out", str(demo), "--subjects", "8", "--seed", "3"], check=True, capture_output=True, timeout=300)
    must("model", "build", "--template", demo / "template.ply", "--kernel", "euclidean-se", "--sigma", "30", "--modes", "120",
         "--landmarks", demo / "landmarks.json", "--zones", demo / "zones.json", "--out", WORK / "face.safetensors")
    must("train", "--data", demo / "train.safetensors", "--method", "jpca", "--identity-modes", "5", "--expression-modes", "5",
         "--out", WORK / "expr.safetensors")
    must("register", "--model", WORK / "face.safetensors", "--scan", demo / "scan/scan_grin.ply", "--landmarks",
         demo / "scan/landmarks.json", "--out", WORK / "fitted.ply", "--record", WORK / "fit.safetensors", "--accept-failed")


class Batch(unittest.TestCase):
    def batch(self, *more):
        return run("batch", "--model", WORK / "face.safetensors", "--out-dir", WORK / "fits", *more)

    def test_each_scan_has_the_bits_of_register_and_a_bad_one_stops_no_other(self):
        scans = WORK / "scans"
        scans.mkdir()
        for name in ("a", "b"):
            shutil.copy(WORK / "demo/scan/scan_grin.ply", scans / f"{name}.ply")
            shutil.copy(WORK / "demo/scan/landmarks.json", scans / f"{name}.marks.json")
        (scans / "broken.PLY").write_bytes((scans / "a.ply").read_bytes()[:5000])
        (scans / "notes.txt").write_text("no mesh")
        status, out, err = self.batch("--scans", scans, "--landmarks-suffix", ".marks.json", "--records", "--accept-failed",
                                      "--threads", "2", "--json", WORK / "fits.json")
        self.assertEqual(status, 1)
        self.assertIn("broken.PLY", err)
        self.assertIn("1 of 3", err.splitlines()[-1])
        self.assertIn("broken: not fitted", out)
        for name in ("a", "b"):
            self.assertEqual((WORK / f"fits/{name}.ply").read_bytes(), (WORK / "fitted.ply").read_bytes())
            self.assertEqual((WORK / f"fits/{name}.safetensors").read_bytes(), (WORK / "fit.safetensors").read_bytes())
            self.assertIn("radius95_mm", read(WORK / f"fits/{name}.json"))
        summary = read(WORK / "fits.json")
        self.assertEqual([row["name"] for row in summary["scans"]], ["a", "b", "broken"])
        self.assertEqual(summary["counts"]["error"], 1)
        self.assertIn("error", summary["scans"][2])
        self.assertFalse((WORK / "fits/broken.ply").exists())

    def test_two_scans_of_one_name_are_refused_before_anything_is_written(self):
        (WORK / "other").mkdir()
        shutil.copy(WORK / "demo/scan/scan_grin.ply", WORK / "other/scan_grin.ply")
        status, _, err = run("batch", "--model", WORK / "face.safetensors", "--scans", WORK / "demo/scan/scan_grin.ply",
                             WORK / "other/scan_grin.ply", "--out-dir", WORK / "clash")
        self.assertEqual(status, 1)
        self.assertIn("scan_grin", err)
        self.assertFalse((WORK / "clash").exists())

class Models(unittest.TestCase):
    def test_coefficients_of_a_sample_make_the_sample_again(self):
        must("model", "sample", WORK / "face.safetensors", "--seed", "4", "--out-dir", WORK / "samples")
        must("model", "fit", WORK / "face.safetensors", "--target", WORK / "samples/sample_000.ply", "--ridge", "0", "--out",
             WORK / "alpha.json", "--mesh-out", WORK / "again.ply", "--picture", WORK / "residual.png", "--json", WORK / "fit.json")
        self.assertLess(read(WORK / "fit.json")["residual_mm"]["max"], 0.01)
        self.assertLess(farthest(WORK / "again.ply", WORK / "samples/sample_000.ply"), 0.01)
        must("model", "synthesize", WORK / "face.safetensors", "--coefficients", WORK / "alpha.json", "--out", WORK / "third.ply")
        self.assertLess(farthest(WORK / "again.ply", WORK / "third.ply"), 1e-4)
        self.assertEqual((WORK / "residual.png").read_bytes()[:8], PNG)
        # A picture that cannot be is refused before anything is written or printed.
        for arguments in (("--target", WORK / "samples/sample_000.ply", "--align"), ("--fit", WORK / "fit.safetensors")):
            status, out, err = run("model", "fit", WORK / "face.safetensors", *arguments, "--out", WORK / "none.json", "--picture", WORK / "none.png")
            self.assertEqual((status, out), (2, ""))
            self.assertIn("--picture", err)
            self.assertFalse((WORK / "none.json").exists() or (WORK / "none.png").exists())
        # A ridge shrinks; a kept registration has coefficients too.
        must("model", "fit", WORK / "face.safetensors", "--target", WORK / "samples/sample_000.ply", "--ridge", "500", "--json",
             WORK / "stiff.json")
        self.assertLess(read(WORK / "stiff.json")["norm"], read(WORK / "fit.json")["norm"])
        must("model", "fit", WORK / "face.safetensors", "--fit", WORK / "fit.safetensors", "--ridge", "0.1", "--json",
             WORK / "kept.json")
        self.assertEqual(len(read(WORK / "kept.json")["scalar"]), 40)
        self.assertEqual(run("model", "fit", WORK / "face.safetensors")[0], 2)

    def test_a_mode_moves_one_axis_by_its_sigma(self):
        for sigma in ("1", "-2"):
            must("model", "sample", WORK / "face.safetensors", "--mode", "5", "--sigma", sigma, "--picture", WORK / "mode.png",
                 "--out-dir", WORK / f"mode{sigma}", "--json", WORK / "mode.json")
        rest, one, back = (vertices(p) for p in (WORK / "demo/template.ply", WORK / "mode1/mode_0005.ply",
                                                 WORK / "mode-2/mode_0005.ply"))
        most = 0.0
        for r, a, b in zip(rest, one, back):
            self.assertAlmostEqual(a[0], r[0], 4)
            self.assertAlmostEqual(-2 * (a[2] - r[2]), b[2] - r[2], delta=2e-4)
            most = max(most, abs(a[2] - r[2]))
        extremes = read(WORK / "mode.json")["eigenfunction_mm"]
        self.assertAlmostEqual(max(-extremes["min"], extremes["max"]), most, 3)
        self.assertEqual((WORK / "mode.png").read_bytes()[:8], PNG)
        self.assertEqual(run("model", "sample", WORK / "face.safetensors", "--mode", "9999", "--out-dir", WORK)[0], 2)

    def test_a_posterior_keeps_to_its_landmarks_as_their_noise_says(self):
        rest = vertices(WORK / "demo/template.ply")
        marks = read(WORK / "demo/landmarks.json")["vertices"]
        names = sorted(marks)[:4]
        seen = {name: [x + 2 for x in rest[marks[name]]] for name in names}
        (WORK / "seen.json").write_text(json.dumps({"points": seen}))
        must("model", "condition", WORK / "face.safetensors", "--landmarks", WORK / "seen.json", "--noise", "5", "--noise-of",
             f"{names[0]}:0.01", "--out", WORK / "posterior.safetensors", "--mean-out", WORK / "mean.ply", "--field",
             WORK / "deviation.json", "--picture", WORK / "deviation.png", "--json", WORK / "condition.json")
        mean, deviation = vertices(WORK / "mean.ply"), read(WORK / "deviation.json")
        misses = [math.dist(mean[marks[name]], seen[name]) for name in names]
        self.assertLess(misses[0], 0.1)
        self.assertLess(deviation[marks[names[0]]], 0.02)
        self.assertLess(deviation[marks[names[0]]], deviation[marks[names[1]]])
        report = read(WORK / "condition.json")
        self.assertLess(report["posterior_deviation_mm"]["mean"], report["prior_deviation_mm"]["mean"])
        must("model", "sample", WORK / "posterior.safetensors", "--seed", "1", "--out-dir", WORK / "posterior")
        drawn = vertices(WORK / "posterior/sample_000.ply")
        self.assertLess(math.dist(drawn[marks[names[0]]], seen[names[0]]), 0.2)
        self.assertEqual(run("model", "condition", WORK / "face.safetensors", "--landmarks", WORK / "seen.json", "--noise-of", "x",
                             "--out", WORK / "x.safetensors")[0], 2)

    def test_tuning_searches_a_grid(self):
        out = must("model", "tune", "--template", WORK / "demo/template.ply", "--targets", WORK / "demo/train.safetensors",
                   "--kernel", "euclidean-se", "--sigma", "20,40", "--scale", "1,4", "--levels", "1,2", "--modes", "60", "--subjects",
                   "1", "--expressions", "neutral", "--plot", WORK / "tune.png", "--json", WORK / "tune.json")
        points = read(WORK / "tune.json")["points"]
        self.assertEqual([(p["levels"], p["scale_mm"], p["sigma_mm"]) for p in points],
                         [(l, s, g) for l in (1, 2) for s in (1, 4) for g in (20, 40)])
        self.assertEqual(out.count("best"), 1)


class Expressions(unittest.TestCase):
    def test_faces_are_sampled_made_and_carried_over(self):
        must("expression", "sample", WORK / "expr.safetensors", "--expression", "grin", "--count", "2", "--out-dir", WORK / "faces")
        self.assertGreater(farthest(WORK / "faces/face_000.ply", WORK / "faces/face_001.ply"), 0.1)
        must("expression", "synthesize", WORK / "expr.safetensors", "--out", WORK / "mean_face.ply")
        must("expression", "synthesize", WORK / "expr.safetensors", "--identity", "0,30", "--out", WORK / "moved.ply")
        square = sum(math.dist(p, q) ** 2 for p, q in zip(vertices(WORK / "mean_face.ply"), vertices(WORK / "moved.ply")))
        self.assertAlmostEqual(math.sqrt(square), 30, delta=0.05)  # modes are orthonormal
        # A face's expression on its own neutral face is the face's own; on a neutral one of another it moves the mouth.
        must("expression", "sample", WORK / "expr.safetensors", "--seed", "9", "--out-dir", WORK / "other")
        must("expression", "transfer", WORK / "expr.safetensors", "--source", WORK / "faces/face_000.ply", "--target",
             WORK / "other/face_000.ply", "--out", WORK / "carried.ply")
        must("expression", "transfer", WORK / "expr.safetensors", "--source", WORK / "other/face_000.ply", "--target",
             WORK / "other/face_000.ply", "--out", WORK / "kept.ply")
        self.assertGreater(farthest(WORK / "carried.ply", WORK / "other/face_000.ply"),
                           3 * farthest(WORK / "kept.ply", WORK / "other/face_000.ply"))
        self.assertEqual(run("expression", "sample", WORK / "expr.safetensors", "--expression", "frown", "--out-dir", WORK)[0], 1)


class Codes(unittest.TestCase):
    def test_every_representation_comes_back_from_its_file(self):
        for kind in ("euclidean", "euclidean-std", "euclidean-norm", "dr", "dr-norm", "dr-std"):
            learned, code = WORK / f"{kind}.safetensors", WORK / f"{kind}_code.safetensors"
            must("spectral", "features", "--data", WORK / "demo/train.safetensors", "--kind", kind, "--out", learned)
            must("expression", "sample", WORK / "expr.safetensors", "--seed", "2", "--out-dir", WORK / "coded")
            must("spectral", "encode", "--features", learned, "--in", WORK / "coded/face_000.ply", "--out", code)
            shape, values = tensors(code)["features"]
            self.assertEqual(shape[1], 9 if kind.startswith("dr") else 3)
            self.assertTrue(all(map(math.isfinite, values)))
            must("spectral", "decode", "--features", learned, "--in", code, "--out", WORK / "decoded.ply")
            self.assertLess(farthest(WORK / "decoded.ply", WORK / "coded/face_000.ply"), 1e-3, kind)
        cut = WORK / "cut.safetensors"
        cut.write_bytes(code.read_bytes()[:-100])
        self.assertEqual(run("spectral", "decode", "--features", learned, "--in", cut, "--out", WORK / "x.ply")[0], 1)

    def test_spectral_coefficients_make_the_low_band(self):
        basis, face = WORK / "basis.safetensors", WORK / "fitted.ply"
        must("spectral", "basis", "--mean", WORK / "demo/template.ply", "--modes", "40", "--out", basis)
        must("spectral", "coefficients", "--basis", basis, "--in", face, "--modes", "30", "--out", WORK / "c.safetensors")
        self.assertEqual(tensors(WORK / "c.safetensors")["coefficients"][0], [30, 3])
        must("spectral", "synthesize", "--basis", basis, "--in", WORK / "c.safetensors", "--out", WORK / "made.ply")
        must("spectral", "split", "--basis", basis, "--in", face, "--k", "30", "--low", WORK / "low.ply")
        self.assertLess(farthest(WORK / "made.ply", WORK / "low.ply"), 1e-4)
        must("spectral", "mode", "--basis", basis, "--mode", "7", "--field", WORK / "v.json", "--picture", WORK / "v.png")
        self.assertAlmostEqual(max(read(WORK / "v.json"), key=abs), max(read(WORK / "v.json")))  # largest entry positive

    def test_maps_of_a_hierarchy_are_applied(self):
        levels, template = WORK / "levels.safetensors", WORK / "demo/template.ply"
        must("spectral", "hierarchy", "--template", template, "--levels", "2", "--out", levels, "--json", WORK / "levels.json")
        counts = read(WORK / "levels.json")["vertices"]
        must("spectral", "hierarchy", "--apply", levels, "--level", "2", "--direction", "down", "--in", template, "--out",
             WORK / "coarse.ply")
        self.assertEqual(len(vertices(WORK / "coarse.ply")), counts[2])
        (WORK / "ones.json").write_text(json.dumps([1.0] * counts[2]))
        must("spectral", "hierarchy", "--apply", levels, "--level", "2", "--direction", "up", "--field", WORK / "ones.json", "--out",
             WORK / "up.json")
        up = read(WORK / "up.json")
        self.assertEqual(len(up), counts[0])
        self.assertTrue(all(abs(x - 1) < 1e-9 for x in up))


def faces_of(path, expression):
    """{subject: [(x, y, z), ...]} of one expression of a dataset."""
    raw = Path(path).read_bytes()
    length = struct.unpack_from("<Q", raw)[0]
    header = json.loads(raw[8:8 + length])

    def numbers(name, kind):
        first, last = header[name]["data_offsets"]
        return struct.unpack_from(f"<{(last - first) // 4}{kind}", raw, 8 + length + first)

    wanted = json.loads(header["__metadata__"]["expression_names"]).index(expression)
    count, size = header["vertices"]["shape"][:2]
    places, subjects, expressions = numbers("vertices", "f"), numbers("subject", "i"), numbers("expression", "i")
    return {subjects[k]: places[3 * size * k:3 * size * (k + 1)] for k in range(count) if expressions[k] == wanted}


class Blendshapes(unittest.TestCase):
    def test_a_search_for_the_band_limit_stands_beside_the_mean_displacement(self):
        train, test = WORK / "demo/train.safetensors", WORK / "demo/test.safetensors"
        must("spectral", "basis", "--mean", WORK / "demo/template.ply", "--modes", "20", "--out", WORK / "bands.safetensors")
        out = must("transfer-expression", "--data", train, "--expression", "grin", "--basis", WORK / "bands.safetensors",
                   "--validate", test, "--candidates", "0", "10", "1000000000", "--plot", WORK / "bands.png", "--model-out",
                   WORK / "grin.safetensors", "--json", WORK / "bands.json")
        self.assertIn("mean displacement", out)
        self.assertEqual((WORK / "bands.png").read_bytes()[:8], PNG)
        report = read(WORK / "bands.json")
        self.assertEqual([row["k"] for row in report["search"]], [0, 10, 1000000000])
        # By hand, without the alignment to the mean face, which turns demo people by little.
        neutral, grin = faces_of(train, "neutral"), faces_of(train, "grin")
        moved = [sum(grin[s][i] - neutral[s][i] for s in grin) / len(grin) for i in range(len(next(iter(grin.values()))))]
        others, truth = faces_of(test, "neutral"), faces_of(test, "grin")
        l1 = sum(abs(truth[s][i] - others[s][i] - moved[i]) for s in truth for i in range(len(moved))) / (len(truth) * len(moved) / 3)
        self.assertLess(abs(report["mean_displacement"]["l1_mm"] / l1 - 1), 0.1)
        # A model from a file has no faces to take the mean of.
        must("transfer-expression", "--model", WORK / "grin.safetensors", "--expression", "grin", "--basis",
             WORK / "bands.safetensors", "--validate", test, "--candidates", "0,10", "--json", WORK / "again.json")
        self.assertEqual([row["k"] for row in read(WORK / "again.json")["search"]], [0, 10])
        self.assertIsNone(read(WORK / "again.json")["mean_displacement"])


class Scores(unittest.TestCase):
    def test_raters_are_compared_in_a_picture_of_their_confusion(self):
        (WORK / "grades.json").write_text(json.dumps({"grades": [[0, 0, 1], [1, 1, 2], [2, 1, 2], [3, 3, None], [1, 0, 1]]}))
        must("score", "agreement", "--grades", WORK / "grades.json", "--json", WORK / "agree.json", "--picture", WORK / "agree.png")
        self.assertEqual(read(WORK / "agree.json")["pairs"][0]["confusion"], [[1, 0, 0, 0], [1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
        # Three pairs stand side by side, two raters alone take a third of the width.
        (WORK / "two.json").write_text(json.dumps({"grades": [[0, 0], [1, 1], [2, 1], [3, 3]]}))
        must("score", "agreement", "--grades", WORK / "two.json", "--picture", WORK / "two.png")
        width = [struct.unpack_from(">I", (WORK / name).read_bytes(), 16)[0] for name in ("agree.png", "two.png")]
        self.assertEqual(width[0], 3 * width[1])

    def test_a_trained_score_tells_how_it_grades_faces_held_out(self):
        raw = (WORK / "demo/train.safetensors").read_bytes()
        count = json.loads(raw[8:8 + struct.unpack_from("<Q", raw)[0]])["vertices"]["shape"][0]
        grades = [k % 3 if k % 7 else None for k in range(count)]
        (WORK / "faces.json").write_text(json.dumps({"grades": grades}))
        must("score", "train", "--data", WORK / "demo/train.safetensors", "--grades", WORK / "faces.json", "--components", "1",
             "--folds", "3", "--out", WORK / "score.safetensors", "--confusion", WORK / "score.png", "--json", WORK / "score.json")
        report = read(WORK / "score.json")
        given = [g for g in grades if g is not None]
        told = [max(0, int(value + 0.5)) for value in report["held_out_predictions"]]
        self.assertEqual(len(told), len(given))
        for row, counts in enumerate(report["confusion"]):
            for column, number in enumerate(counts):
                self.assertEqual(number, sum(g == row and t == column for g, t in zip(given, told)))
        self.assertEqual((WORK / "score.png").read_bytes()[:8], PNG)

    def test_grades_of_faces_held_out_keep_to_the_range(self):
        raw = (WORK / "demo/train.safetensors").read_bytes()
        count = json.loads(raw[8:8 + struct.unpack_from("<Q", raw)[0]])["vertices"]["shape"][0]
        (WORK / "faces.json").write_text(json.dumps({"grades": [k % 3 for k in range(count)]}))
        must("score", "train", "--data", WORK / "demo/train.safetensors", "--grades", WORK / "faces.json", "--components", "1",
             "--folds", "3", "--range", "1", "1.4", "--out", WORK / "score.safetensors", "--json", WORK / "score.json")
        report = read(WORK / "score.json")
        self.assertTrue(any(not 1 <= value <= 1.4 for value in report["held_out_predictions"]))
        self.assertEqual([sum(row[k] for row in report["confusion"]) for k in range(3)], [0, count, 0])


class Fields(unittest.TestCase):
    def test_geodesics_from_landmarks(self):
        marks = read(WORK / "demo/landmarks.json")["vertices"]
        name = sorted(marks)[0]
        must("measure", "geodesic", "--model", WORK / "face.safetensors", "--from", name, "--field", WORK / "d.json", "--picture",
             WORK / "d.png", "--json", WORK / "geodesic.json")
        must("measure", "geodesic", WORK / "demo/template.ply", "--from", marks[name], "--field", WORK / "e.json")
        field = read(WORK / "d.json")
        self.assertEqual(field, read(WORK / "e.json"))
        self.assertEqual(field[marks[name]], 0)
        rest = vertices(WORK / "demo/template.ply")
        for other, vertex in marks.items():
            straight = math.dist(rest[vertex], rest[marks[name]])
            self.assertGreater(field[vertex], 0.93 * straight - 1, other)
        self.assertEqual((WORK / "d.png").read_bytes()[:8], PNG)
        self.assertEqual(run("measure", "geodesic", WORK / "demo/template.ply", "--from", "nobody")[0], 2)

    def test_metrics_show_where_they_come_from(self):
        for kind in ("l2", "dame", "fmpd"):
            must("metric", kind, WORK / "demo/template.ply", WORK / "fitted.ply", "--field", WORK / f"{kind}.json", "--picture",
                 WORK / f"{kind}.png")
            self.assertEqual((WORK / f"{kind}.png").read_bytes()[:8], PNG)
        field = read(WORK / "l2.json")
        value = float(must("metric", "l2", WORK / "demo/template.ply", WORK / "fitted.ply"))
        self.assertAlmostEqual(sum(field) / len(field), value, 6)
        must("metric", "roughness", WORK / "fitted.ply", "--picture", WORK / "rough.png")


class Transfers(unittest.TestCase):
    def test_landmarks_contours_zones_and_fields_go_there_and_back(self):
        demo = WORK / "demo"
        base = ["transfer", "--model", WORK / "face.safetensors", "--fitted", WORK / "fitted.ply", "--scan",
                demo / "scan/scan_grin.ply", "--out", WORK / "out.json"]
        marks = read(demo / "landmarks.json")["vertices"]
        zone = read(demo / "zones.json")["zones"]["mouth"]
        places = vertices(WORK / "fitted.ply")
        # Landmarks: to the scan as places, and from there back as vertices nearby.
        must(*base, "--what", demo / "landmarks.json")
        points = read(WORK / "out.json")
        (WORK / "marked.json").write_text(json.dumps(points))
        must(*base, "--what", WORK / "marked.json", "--to-template")
        back = read(WORK / "out.json")
        for name, vertex in back["vertices"].items():
            self.assertLess(math.dist(places[vertex], places[marks[name]]), 6, name)
        # A contour of vertices becomes a line of places on the scan, and the line vertices again.
        (WORK / "lines.json").write_text(json.dumps({"contours": {"line": zone[:20]}}))
        must(*base, "--what", WORK / "lines.json")
        line = read(WORK / "out.json")["contours"]["line"]
        self.assertGreater(len(line), 5)
        (WORK / "line.json").write_text(json.dumps({"contours": {"line": line}}))
        must(*base, "--what", WORK / "line.json", "--to-template")
        for vertex in read(WORK / "out.json")["contours"]["line"]:
            self.assertLess(min(math.dist(places[vertex], places[v]) for v in zone[:20]), 6)
        # A zone comes back nearly whole.
        must(*base, "--what", demo / "zones.json")
        (WORK / "zones_there.json").write_text(json.dumps({"zones": {"mouth": read(WORK / "out.json")["zones"]["mouth"]}}))
        must(*base, "--what", WORK / "zones_there.json", "--to-template")
        again = set(read(WORK / "out.json")["zones"]["mouth"])
        self.assertGreater(len(again & set(zone)) / len(again | set(zone)), 0.6)
        # A field that is a coordinate is that coordinate on the other surface.
        (WORK / "y.json").write_text(json.dumps([p[1] for p in places]))
        must(*base, "--field", WORK / "y.json", "--max-distance", "3", "--picture", WORK / "y.png")
        scan = vertices(demo / "scan/scan_grin.ply")
        carried = read(WORK / "out.json")
        known = [(c, p[1]) for c, p in zip(carried, scan) if c is not None]
        self.assertGreater(len(known), 500)
        self.assertLess(max(abs(c - y) for c, y in known), 3.1)
        self.assertEqual(run(*base, "--to-template")[0], 2)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
