#!/usr/bin/env python3
"""Calls the `mien` command as its contract says, on demo faces.

  contract_test.py MIEN MIEN_DEMO_DATA WORK_FOLDER

The main job runs once, in setUpModule; the tests look at what it left. Standard library only.
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


def run(*arguments):
    """Runs mien; returns (exit status, stdout, stderr)."""
    done = subprocess.run([MIEN, *map(str, arguments)], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout, done.stderr


def must(*arguments):
    status, out, err = run(*arguments)
    if status != 0:
        raise AssertionError(f"mien {' '.join(map(str, arguments))}\nexit {status}: {err}")
    if err:
        raise AssertionError(f"mien {arguments[0]} wrote to stderr without a terminal: {err}")
    return out


def ply_vertices(path):
    """Vertex rows of a binary little-endian PLY whose first three properties are float x, y, z."""
    raw = Path(path).read_bytes()
    head, body = raw.split(b"end_header\n", 1)
    words = [line.split() for line in head.decode().splitlines()]
    count = next(int(w[2]) for w in words if w[:2] == ["element", "vertex"])
    properties = []
    for w in words:
        if w and w[0] == "element":
            if w[1] != "vertex" and properties:
                break
        elif w and w[0] == "property":
            properties.append(w[1])
    size = sum({"float": 4, "float32": 4, "uchar": 1, "uint8": 1, "double": 8}[p] for p in properties)
    return [struct.unpack_from("<3f", body, i * size) for i in range(count)]


def mean_distance(a, b):
    return sum(sum((x - y) ** 2 for x, y in zip(p, q)) ** 0.5 for p, q in zip(a, b)) / len(a)


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    subprocess.run([DEMO, "--out", str(WORK / "demo"), "--subjects", "30", "--seed", "1"], check=True,
                   capture_output=True, timeout=300)
    demo = WORK / "demo"
    must("model", "build", "--template", demo / "template.ply", "--kernel", "geodesic-se", "--sigma", "20",
         "--modes", "600", "--landmarks", demo / "landmarks.json", "--zones", demo / "zones.json",
         "--out", WORK / "face.safetensors", "--json", WORK / "build.json", "--threads", "2")
    must("train", "--data", demo / "train.safetensors", "--method", "jpca", "--identity-modes", "25",
         "--expression-modes", "25", "--picture", WORK / "orthogonality.png", "--out", WORK / "expr.safetensors", "--json", WORK / "train.json")
    must("register", "--model", WORK / "face.safetensors", "--scan", demo / "scan/scan_grin.ply",
         "--landmarks", demo / "scan/landmarks.json", "--out", WORK / "fitted.ply",
         "--json", WORK / "register.json", "--heatmap", WORK / "heat.png", "--threads", "2")
    must("neutralize", "--model", WORK / "expr.safetensors", "--in", WORK / "fitted.ply",
         "--weights", WORK / "register.json", "--out", WORK / "neutral.ply", "--json", WORK / "neutralize.json")


class Mistyped(unittest.TestCase):
    """Wrong words end with status 2 and one line that says what was probably meant."""

    def refused(self, *arguments):
        status, out, err = run(*arguments)
        self.assertEqual((status, out), (2, ""))
        self.assertEqual(len(err.strip().splitlines()), 1, err)
        return err

    def test_a_command(self):
        self.assertIn("did you mean 'register'? 'mien --help' lists them", self.refused("regster"))
        self.assertIn("'neutralize'", self.refused("neutralise", "--fitted", "a.ply"))
        self.assertIn("mien --help", self.refused("xyzzy"))

    def test_a_command_of_a_group(self):
        self.assertIn("'volume'", self.refused("measure", "volum"))
        self.assertIn("'build'", self.refused("model", "biuld", "--template", "a.ply"))

    def test_a_command_that_stands_in_a_group(self):
        self.assertIn("'measure volume'", self.refused("volume", "--before", "a.ply"))

    def test_an_option(self):
        self.assertIn("'--template'", self.refused("model", "build", "--tempalte", "a.ply", "--out", "b"))

    def test_help_lists_every_command_under_its_job(self):
        status, out, _ = run("--help")
        self.assertEqual(status, 0)
        self.assertNotIn("Subcommands:", out)
        self.assertLess(out.index("Fit scans"), out.index("  register "))


class MainJob(unittest.TestCase):
    def test_registration_finds_the_face_behind_the_scan(self):
        fitted, truth = ply_vertices(WORK / "fitted.ply"), ply_vertices(WORK / "demo/scan/truth_grin.ply")
        self.assertEqual(len(fitted), len(truth))
        face = json.loads((WORK / "demo/zones.json").read_text())["zones"]["face"]
        error = mean_distance([fitted[i] for i in face], [truth[i] for i in face])
        self.assertLess(error, 3.0)

    @staticmethod
    def mouth_errors():
        """Distance of the fitted and of the neutralized face from the true neutral one, mm."""
        zone = json.loads((WORK / "demo/zones.json").read_text())["zones"]["mouth"]
        pick = lambda name: [ply_vertices(name)[i] for i in zone]
        truth = pick(WORK / "demo/scan/truth_neutral.ply")
        return (mean_distance(pick(WORK / "fitted.ply"), truth), mean_distance(pick(WORK / "neutral.ply"), truth))

    def test_neutralization_lowers_the_error_to_the_true_neutral_face(self):
        before, after = self.mouth_errors()
        self.assertLess(after, 0.7 * before)

    def test_reports_are_json(self):
        for name in ("build", "train", "register", "neutralize"):
            self.assertIsInstance(json.loads((WORK / f"{name}.json").read_text()), dict)

    def test_pictures_are_pngs(self):
        for name in ("heat.png", "orthogonality.png"):
            self.assertEqual((WORK / name).read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_threads_do_not_change_a_byte(self):
        demo = WORK / "demo"
        must("register", "--model", WORK / "face.safetensors", "--scan", demo / "scan/scan_grin.ply",
             "--landmarks", demo / "scan/landmarks.json", "--out", WORK / "fitted1.ply", "--threads", "1")
        self.assertEqual((WORK / "fitted1.ply").read_bytes(), (WORK / "fitted.ply").read_bytes())

    def test_colors_are_heard_and_can_be_left_out(self):
        demo = WORK / "demo"
        self.assertIn("lips", json.loads((WORK / "build.json").read_text())["zones"])
        report = json.loads((WORK / "register.json").read_text())
        agreement = report["color_agreement"]
        self.assertEqual(sorted([*agreement, *report["colors_left_out"]]), ["brow_left", "brow_right", "lips"])
        self.assertGreater(agreement["lips"], 0.8)
        must("register", "--model", WORK / "face.safetensors", "--scan", demo / "scan/scan_grin.ply", "--no-colors",
             "--landmarks", demo / "scan/landmarks.json", "--out", WORK / "plain.ply", "--json", WORK / "plain.json")
        self.assertEqual(json.loads((WORK / "plain.json").read_text())["color_agreement"], {})
        self.assertNotEqual((WORK / "plain.ply").read_bytes(), (WORK / "fitted.ply").read_bytes())

    def test_a_visit_tied_to_itself_stays_on_its_skin(self):
        demo = WORK / "demo"
        command = ("register", "--model", WORK / "face.safetensors", "--scan", demo / "scan/scan_grin.ply",
                   "--landmarks", demo / "scan/landmarks.json")
        must(*command, "--out", WORK / "first.ply", "--record", WORK / "first.safetensors")
        must(*command, "--out", WORK / "tied.ply", "--json", WORK / "tied.json", "--reference", WORK / "first.safetensors",
             "--reference-scan", demo / "scan/scan_grin.ply")
        reference = json.loads((WORK / "tied.json").read_text())["reference"]
        self.assertTrue(reference["tied"], reference)
        self.assertLess(reference["median_slide_mm"], 0.1)
        status, _, err = run(*command, "--out", WORK / "x.ply", "--reference", WORK / "first.safetensors")
        self.assertEqual(status, 2)
        self.assertIn("--reference-scan", err)

    def test_ways_to_correspond_are_heard(self):
        demo = WORK / "demo"
        for number, option in enumerate((["--soft", 1.5], ["--mutual", 6], ["--max-distance", 2], ["--max-angle", 20],
                                         ["--keep-border"])):
            must("register", "--model", WORK / "face.safetensors", "--scan", demo / "scan/scan_grin.ply", *option,
                 "--landmarks", demo / "scan/landmarks.json", "--out", WORK / f"way{number}.ply")
            self.assertNotEqual((WORK / f"way{number}.ply").read_bytes(), (WORK / "fitted.ply").read_bytes(), option)

    def test_model_files_do_not_depend_on_threads(self):
        demo = WORK / "demo"
        for threads in (1, 2):
            must("model", "build", "--template", demo / "template.ply", "--kernel", "euclidean-se", "--sigma", "30",
                 "--modes", "90", "--out", WORK / f"se{threads}.safetensors", "--threads", threads)
        self.assertEqual((WORK / "se1.safetensors").read_bytes(), (WORK / "se2.safetensors").read_bytes())


class FailedFits(unittest.TestCase):
    """A ball in a face's place: the fit fails, aloud."""

    def test_status_is_one_and_files_are_written(self):
        rings, points, triangles = 40, [], []
        for i in range(rings + 1):
            for k in range(2 * rings):
                a, b = math.pi * i / rings, math.pi * k / rings
                points.append((95 * math.sin(a) * math.cos(b), 95 * math.cos(a), 95 * math.sin(a) * math.sin(b)))
        for i in range(rings):
            for k in range(2 * rings):
                p, q = 2 * rings * i + k + 1, 2 * rings * i + (k + 1) % (2 * rings) + 1
                triangles += [(p, q, p + 2 * rings), (q, q + 2 * rings, p + 2 * rings)]
        ball = WORK / "ball.obj"
        ball.write_text("".join("v %.5f %.5f %.5f\n" % p for p in points) + "".join("f %d %d %d\n" % t for t in triangles))
        command = ("register", "--model", WORK / "face.safetensors", "--scan", ball, "--out", WORK / "ball.ply",
                   "--json", WORK / "ball.json")
        status, out, err = run(*command)
        self.assertEqual((status, err.count("\n")), (1, 1), err)
        self.assertIn("--accept-failed", err)
        self.assertIn("quality failed", out)
        self.assertEqual(json.loads((WORK / "ball.json").read_text())["quality"], "failed")
        self.assertTrue((WORK / "ball.ply").exists())
        self.assertIn("quality failed", must(*command, "--accept-failed"))
        status, _, err = run(*command, "--accept-failed", "--reference", ball, "--reference-scan", ball)
        self.assertEqual(status, 0, err)
        self.assertIn("not tied", err)
        self.assertFalse(json.loads((WORK / "ball.json").read_text())["reference"]["tied"])

    def test_the_expected_error_is_stated_of_the_face_and_its_zones(self):
        expected = json.loads((WORK / "register.json").read_text())["expected_error"]
        self.assertIn("nose", expected)
        for error in expected.values():
            self.assertTrue(0 < error["low_mm"] <= error["expected_mm"] <= error["high_mm"])


class Measures(unittest.TestCase):
    def test_volume_of_a_face_with_itself_is_zero(self):
        status, _, err = run("measure", "volume", "--before", WORK / "fitted.ply", "--after", WORK / "fitted.ply",
                             "--zones", WORK / "demo/zones.json", "--json", WORK / "volume.json")
        self.assertEqual(status, 0, err)
        self.assertIn("are the same face", err)
        report = json.loads((WORK / "volume.json").read_text())
        self.assertEqual(report["volume"]["whole"]["absolute_ml"], 0)

    def test_area_and_distance_answer(self):
        for what in ("area", "distance"):
            must("measure", what, "--before", WORK / "fitted.ply", "--after", WORK / "neutral.ply",
                 "--zones", WORK / "demo/zones.json", "--json", WORK / f"{what}.json")
            self.assertIsInstance(json.loads((WORK / f"{what}.json").read_text()), dict)

    def test_metrics_answer_for_every_kind(self):
        for kind in ("l1", "l2", "dame", "fmpd"):
            self.assertTrue(must("metric", kind, WORK / "fitted.ply", WORK / "neutral.ply").strip())


class OtherCommands(unittest.TestCase):
    def test_model_info_names_the_kernel(self):
        self.assertIn("geodesic-se", must("model", "info", WORK / "face.safetensors"))

    def test_model_info_tells_what_trained_modes_leave_of_people_left_out(self):
        must("model", "build", "--template", WORK / "demo/template.ply", "--kernel", "geodesic-se", "--modes", "30", "--pca",
             WORK / "demo/train.safetensors", "--out", WORK / "trained.safetensors")
        self.assertRegex(must("model", "info", WORK / "trained.safetensors"), r"people left out +[0-9]+\.[0-9]+ mm")
        self.assertNotIn("people left out", must("model", "info", WORK / "face.safetensors"))

    def test_samples_are_faces(self):
        must("model", "sample", WORK / "face.safetensors", "--count", "2", "--seed", "5", "--out-dir", WORK / "samples")
        self.assertEqual(len(list((WORK / "samples").glob("*.ply"))), 2)

    def test_transfer_carries_landmarks_to_the_scan(self):
        must("transfer", "--model", WORK / "face.safetensors", "--fitted", WORK / "fitted.ply",
             "--scan", WORK / "demo/scan/scan_grin.ply", "--what", "landmarks", "--out", WORK / "transferred.json")
        found = json.loads((WORK / "transferred.json").read_text())["points"]
        self.assertEqual(len(found), 68)

    def test_evaluate_reports_errors(self):
        must("evaluate", "neutralization", "--model", WORK / "expr.safetensors", "--data",
             WORK / "demo/test.safetensors", "--json", WORK / "evaluate.json")
        self.assertIsInstance(json.loads((WORK / "evaluate.json").read_text()), dict)

    def test_render_draws_a_png(self):
        must("render", WORK / "fitted.ply", "--out", WORK / "fitted.png")
        self.assertEqual((WORK / "fitted.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_a_series_shares_one_face_and_reports_each(self):
        demo = WORK / "demo/scan"
        must("neutralize", "--model", WORK / "expr.safetensors", "--in", demo / "truth_grin.ply", "--with",
             demo / "truth_mouth_stretch.ply", demo / "truth_neutral.ply", "--with-out", WORK / "series1.ply",
             WORK / "series2.ply", "--out", WORK / "series0.ply", "--identity-out", WORK / "shared.ply",
             "--zones", WORK / "demo/zones.json", "--changing", "cheek_left", "--json", WORK / "series.json")
        truth = ply_vertices(demo / "truth_neutral.ply")
        before = mean_distance(ply_vertices(demo / "truth_mouth_stretch.ply"), truth)
        for k in range(3):
            self.assertLess(mean_distance(ply_vertices(WORK / f"series{k}.ply"), truth), 0.35 * before)
        faces = json.loads((WORK / "series.json").read_text())["faces"]
        self.assertEqual([face["expression"] for face in faces], ["grin", "mouth_stretch", "neutral"])
        self.assertEqual([face["warnings"] for face in faces], [[], [], []])
        self.assertEqual(run("neutralize", "--model", WORK / "expr.safetensors", "--in", demo / "truth_grin.ply",
                             "--changing", "cheek_left", "--out", WORK / "x.ply")[0], 1)

    def test_neutralized_scan_keeps_its_own_vertices(self):
        demo = WORK / "demo"
        must("neutralize", "--model", WORK / "expr.safetensors", "--in", WORK / "fitted.ply", "--weights",
             WORK / "register.json", "--scan", demo / "scan/scan_grin.ply", "--scan-out", WORK / "scan_neutral.ply", "--out", WORK / "neutral2.ply")
        self.assertEqual(len(ply_vertices(WORK / "scan_neutral.ply")), len(ply_vertices(demo / "scan/scan_grin.ply")))
        self.assertEqual((WORK / "neutral2.ply").read_bytes(), (WORK / "neutral.ply").read_bytes())


class ExitStatus(unittest.TestCase):
    def test_help_everywhere(self):
        for command in ([], ["model"], ["model", "build"], ["model", "info"], ["model", "sample"], ["model", "tune"],
                        ["register"], ["transfer"], ["train"], ["neutralize"], ["evaluate", "neutralization"],
                        ["measure", "volume"], ["measure", "area"], ["measure", "distance"], ["score", "train"],
                        ["score", "predict"], ["score", "simulate"], ["spectral", "split"], ["spectral", "merge"],
                        ["metric", "l1"], ["transfer-expression"], ["render"]):
            status, out, _ = run(*command, "--help")
            self.assertEqual(status, 0, command)
            self.assertTrue(out, command)
            if command and command not in (["model"],):
                self.assertIn("Example", out, command)

    def test_wrong_usage_is_two(self):
        for command in ([], ["paint"], ["model", "build"], ["register", "--modle", "x"]):
            self.assertEqual(run(*command)[0], 2, command)

    def test_failure_is_one_with_one_line_that_names_the_file(self):
        for command in (["model", "info", WORK / "absent.safetensors"],
                        ["model", "info", WORK / "expr.safetensors"],
                        ["render", WORK / "absent.ply", "--out", WORK / "x.png"],
                        ["register", "--model", WORK / "face.safetensors", "--scan", WORK / "absent.ply", "--out",
                         WORK / "x.ply"]):
            status, _, err = run(*command)
            self.assertEqual(status, 1, command)
            self.assertEqual(err.count("\n"), 1, err)
            self.assertTrue("absent" in err or "expr.safetensors" in err, err)
        self.assertFalse((WORK / "x.ply").exists())

    def test_truncated_model_is_refused(self):
        raw = (WORK / "face.safetensors").read_bytes()
        (WORK / "cut.safetensors").write_bytes(raw[:len(raw) // 2])
        self.assertEqual(run("model", "info", WORK / "cut.safetensors")[0], 1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
