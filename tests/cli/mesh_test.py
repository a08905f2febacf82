#!/usr/bin/env python3
"""`mien mesh`, `mien landmarks` and `mien model check`: what error messages tell people to do works.

  mesh_test.py MIEN MIEN_DEMO_DATA WORK_FOLDER
"""
import json
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

MIEN, DEMO, WORK = sys.argv[1], sys.argv[2], Path(sys.argv[3])


def run(*arguments):
    done = subprocess.run([MIEN, *map(str, arguments)], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout, done.stderr


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    subprocess.run([DEMO, "--out", str(WORK / "demo"), "--subjects", "2", "--seed", "1"], check=True,
                   capture_output=True, timeout=300)


class MeshCommands(unittest.TestCase):
    scan = WORK / "demo/scan/scan_grin.ply"

    def info(self, path):
        status, out, err = run("mesh", "info", path, "--json", WORK / "info.json")
        self.assertEqual((status, err), (0, ""))
        return json.loads((WORK / "info.json").read_text()), out

    def test_a_scan_in_metres_is_named_and_scaled_back(self):
        self.assertEqual(run("mesh", "scale", self.scan, WORK / "m.ply", "--factor", "0.001")[0], 0)
        report, out = self.info(WORK / "m.ply")
        self.assertEqual(report["plausible_units"][0], "m")
        self.assertIn("mien mesh scale --units m", out)
        self.assertEqual(run("mesh", "scale", WORK / "m.ply", WORK / "mm.ply", "--units", "m")[0], 0)
        self.assertEqual(self.info(WORK / "mm.ply")[0]["plausible_units"][0], "mm")

    def test_an_inside_out_scan_is_named_and_turned_back(self):
        run("mesh", "turn", self.scan, WORK / "in.ply", "--inside-out")
        report, out = self.info(WORK / "in.ply")
        self.assertLess(report["outward"], -0.3)
        self.assertIn("--inside-out", out)
        run("mesh", "turn", WORK / "in.ply", WORK / "out.ply", "--inside-out")
        self.assertGreater(self.info(WORK / "out.ply")[0]["outward"], 0.3)

    def test_quarter_turns_come_back_exactly(self):
        run("mesh", "convert", self.scan, WORK / "a.ply")
        run("mesh", "turn", WORK / "a.ply", WORK / "b.ply", "--rotate", "90,0,270")
        run("mesh", "turn", WORK / "b.ply", WORK / "c.ply", "--rotate", "0,0,90")
        run("mesh", "turn", WORK / "c.ply", WORK / "d.ply", "--rotate", "270,0,0")
        self.assertEqual((WORK / "a.ply").read_bytes(), (WORK / "d.ply").read_bytes())

    def test_clean_and_decimate_write_what_they_say(self):
        self.assertEqual(run("mesh", "clean", self.scan, WORK / "clean.ply")[0], 0)
        self.assertEqual(self.info(WORK / "clean.ply")[0]["equal_vertices"], 0)
        status, out, _ = run("mesh", "decimate", WORK / "clean.ply", WORK / "small.obj", "--vertices", "500")
        self.assertEqual(status, 0, out)
        self.assertLess(self.info(WORK / "small.obj")[0]["vertices"], 600)

    def test_missing_choices_are_named(self):
        for arguments in (("scale",), ("turn",), ("decimate",)):
            status, _, err = run("mesh", *arguments, self.scan, WORK / "x.ply")
            self.assertEqual(status, 1)
            self.assertIn("give --", err)

    def test_surfaces_of_different_units_are_refused(self):
        run("mesh", "scale", self.scan, WORK / "cm.ply", "--factor", "0.1")
        status, _, err = run("measure", "distance", "--surfaces", "--before", self.scan, "--after", WORK / "cm.ply")
        self.assertEqual(status, 1)
        self.assertIn("unit", err)


class LandmarkCommands(unittest.TestCase):
    marks = WORK / "demo/scan/landmarks.json"

    def test_every_kind_comes_back(self):
        given = json.loads(self.marks.read_text())["points"]
        for kind in ("mrk.json", "fcsv", "pp", "ljson", "csv"):
            self.assertEqual(run("landmarks", "convert", self.marks, WORK / f"l.{kind}")[0], 0)
            status, out, err = run("landmarks", "convert", WORK / f"l.{kind}", WORK / "back.json")
            self.assertEqual((status, err), (0, ""), out)
            back = json.loads((WORK / "back.json").read_text())["points"]
            self.assertEqual(set(back), set(given))
            for name in given:
                for a, b in zip(back[name], given[name]):
                    self.assertAlmostEqual(a, b, places=9)

    def test_places_of_vertex_numbers(self):
        status, _, err = run("landmarks", "convert", WORK / "demo/landmarks.json", WORK / "v.pp")
        self.assertEqual(status, 1)
        self.assertIn("vertex numbers", err)
        status, _, err = run("landmarks", "convert", WORK / "demo/landmarks.json", WORK / "v.pp",
                             "--mesh", WORK / "demo/template.ply")
        self.assertEqual((status, err), (0, ""))


class TemplateCheck(unittest.TestCase):
    template = WORK / "demo/template.ply"

    def test_a_good_template_is_told_so(self):
        status, out, err = run("model", "check", self.template, "--landmarks", WORK / "demo/landmarks.json",
                               "--picture", WORK / "check.png", "--json", WORK / "check.json")
        self.assertEqual((status, err), (0, ""), out)
        self.assertEqual(json.loads((WORK / "check.json").read_text())["errors"], 0)
        self.assertGreater((WORK / "check.png").stat().st_size, 1000)

    def test_no_model_is_built_from_an_inside_out_template(self):
        run("mesh", "turn", self.template, WORK / "in.ply", "--inside-out")
        build = ("model", "build", "--template", WORK / "in.ply", "--kernel", "euclidean-se", "--modes", "30",
                 "--out", WORK / "x.safetensors")
        status, out, err = run(*build)
        self.assertEqual(status, 1)
        self.assertIn("inside out", out)
        self.assertFalse((WORK / "x.safetensors").exists())
        self.assertEqual(run(*build, "--accept-faults")[0], 0)

    def test_a_template_in_decimetres_is_refused_with_the_reason(self):
        run("mesh", "scale", self.template, WORK / "dm.ply", "--factor", "0.01")
        status, out, _ = run("model", "check", WORK / "dm.ply")
        self.assertEqual(status, 1)
        self.assertIn("dm", out)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
