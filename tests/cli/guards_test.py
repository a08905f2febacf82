#!/usr/bin/env python3
"""What every command refuses before it works, and what measuring commands say of faces that do not belong together.

  guards_test.py MIEN MIEN_DEMO_DATA WORK_FOLDER
"""
import json
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

MIEN, DEMO, WORK = sys.argv[1], sys.argv[2], Path(sys.argv[3])


def run(*arguments, **streams):
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **streams}
    done = subprocess.run([MIEN, *map(str, arguments)], text=True, timeout=300, **streams)
    return done.returncode, done.stdout, done.stderr


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    subprocess.run([DEMO, "--out", str(WORK / "demo"), "--subjects", "2", "--seed", "1"], check=True,
                   capture_output=True, timeout=300)
    run("mesh", "convert", WORK / "demo/template.ply", WORK / "face.ply")
    run("mesh", "scale", WORK / "face.ply", WORK / "metres.ply", "--factor", "0.001")
    run("mesh", "turn", WORK / "face.ply", WORK / "turned.ply", "--rotate", "0,35,0")
    run("mesh", "turn", WORK / "face.ply", WORK / "mirrored.ply", "--mirror", "x")
    run("mesh", "turn", WORK / "mirrored.ply", WORK / "mirrored_back.ply", "--inside-out")
    run("mesh", "turn", WORK / "face.ply", WORK / "inside.ply", "--inside-out")


FACE = WORK / "face.ply"


class Refusals(unittest.TestCase):
    def refused(self, said, *arguments, status=2):
        got, _, err = run(*arguments)
        self.assertEqual(got, status, err)
        self.assertIn(said, err)

    def test_numbers_that_only_a_c_library_reads(self):
        for number in ("nan", "inf", "-inf", "1e999", "0x10", "", "5mm", ",5", "1 2"):
            with self.subTest(number=number):
                self.refused("is not a finite number", "mesh", "scale", FACE, WORK / "o.ply", "--factor", number)
        for number in ("0x10", "1.5", "nan", "", "-1", "1e3"):
            with self.subTest(number=number):
                self.refused("--vertices", "mesh", "decimate", FACE, WORK / "o.ply", "--vertices", number)
        for unit in ("0x19", "nan", "-25.4", "0"):
            with self.subTest(unit=unit):
                self.refused("--units", "mesh", "scale", FACE, WORK / "o.ply", "--units", unit, status=1)
        self.assertFalse((WORK / "o.ply").exists())

    def test_plain_numbers_pass(self):
        for number in ("2", "+2", "2.", ".5", "1e-3", "2.5E+1"):
            self.assertEqual(run("mesh", "scale", FACE, WORK / "plain.ply", "--factor", number)[0], 0, number)

    def test_a_result_over_an_input_which_would_be_lost(self):
        scan = WORK / "kept.ply"
        shutil.copy(FACE, scan)
        os.link(scan, WORK / "link.ply")
        before = scan.read_bytes()
        for arguments in (["mesh", "info", scan, "--json", scan], ["mesh", "convert", scan, scan],
                          ["mesh", "clean", scan, WORK / "demo/../kept.ply"], ["mesh", "clean", scan, WORK / "link.ply"],
                          ["measure", "area", scan, f"--json={scan}"]):
            with self.subTest(arguments=arguments):
                self.refused("would be lost", *arguments)
                self.assertEqual(scan.read_bytes(), before)

    def test_two_results_in_one_file(self):
        self.refused("name two files", "mesh", "convert", FACE, WORK / "two.ply", "--json", WORK / "two.ply")
        self.assertFalse((WORK / "two.ply").exists())
        self.assertEqual(run("mesh", "info", FACE, "--json", "/dev/null")[0], 0)

    def test_a_batch_into_the_folder_of_its_scans(self):
        (WORK / "visits").mkdir()
        shutil.copy(FACE, WORK / "visits/a.ply")
        run("model", "build", "--template", FACE, "--kernel", "geodesic-se", "--sigma", "60", "--modes", "3",
            "--out", WORK / "small.safetensors")
        before = (WORK / "visits/a.ply").read_bytes()
        self.refused("over its scan", "batch", "--model", WORK / "small.safetensors", "--scans", WORK / "visits",
                     "--out-dir", WORK / "visits", status=1)
        self.assertEqual((WORK / "visits/a.ply").read_bytes(), before)

    def test_pictures_that_are_named_as_no_png(self):
        self.refused("name it .png", "render", FACE, "--out", WORK / "face.jpg")

    def test_options_without_what_they_are_about(self):
        pair = ["--before", FACE, "--after", WORK / "turned.ply"]
        for said, arguments in (
                ("--surfaces", ["measure", "distance", *pair, "--max-distance", "3"]),
                ("--surfaces", ["measure", "distance", *pair, "--keep-borders"]),
                ("--surfaces", ["measure", "volume", *pair, "--direction", "0", "0", "1"]),
                ("--compare", ["render", FACE, "--signed", "--out", WORK / "o.png"]),
                ("--landmarks", ["register", "--model", "m", "--scan", FACE, "--out", WORK / "o.ply", "--mend-landmarks"]),
                ("--landmarks", ["register", "--model", "m", "--scan", FACE, "--out", WORK / "o.ply", "--landmark-sigma", "3"]),
                ("--mirror", ["model", "build", "--template", FACE, "--mirror-correlation", "0.5", "--out", WORK / "m"]),
                ("--pca", ["model", "build", "--template", FACE, "--pca-neutral", "--out", WORK / "m"])):
            with self.subTest(arguments=arguments):
                self.refused(said, *arguments)
        self.refused("below --max", "render", FACE, "--compare", WORK / "turned.ply", "--min", "3", "--max", "1",
                     "--out", WORK / "o.png")

    def test_one_name_twice_in_a_file(self):
        (WORK / "twice.json").write_text('{"zones": {"cheek": [1, 2, 3], "cheek": [4]}}')
        self.refused("twice", "measure", "area", FACE, "--zones", WORK / "twice.json", status=1)
        (WORK / "apart.json").write_text('{"zones": {"cheek": [1, 2, 3]}, "more": {"cheek": [4]}}')
        self.assertEqual(run("measure", "area", FACE, "--zones", WORK / "apart.json")[0], 0)

    @unittest.skipUnless(os.path.exists("/dev/full"), "this system has no device that is always full")
    def test_printed_results_that_did_not_arrive(self):
        for arguments in (["measure", "area", FACE], ["--help"]):
            with self.subTest(arguments=arguments), open("/dev/full", "w") as full:
                status, _, err = run(*arguments, stdout=full)
                self.assertEqual(status, 1)
                self.assertIn("standard output", err)

    @unittest.skipIf(sys.platform == "win32", "closed streams are a habit of POSIX shells")
    def test_closed_streams_do_not_run_into_the_file(self):
        run("mesh", "convert", FACE, WORK / "open.ply")
        subprocess.run(["sh", "-c", '"$0" mesh convert "$1" "$2" <&- >&- 2>&-', MIEN, str(FACE), str(WORK / "closed.ply")],
                       timeout=60)
        self.assertEqual((WORK / "closed.ply").read_bytes(), (WORK / "open.ply").read_bytes())


class FacesThatDoNotBelongTogether(unittest.TestCase):
    def measured(self, before, after, what="volume"):
        status, out, err = run("measure", what, "--before", before, "--after", after, "--json", WORK / "m.json")
        return status, err

    def test_as_many_vertices_in_another_order(self):
        lines = (WORK / "face.obj")
        run("mesh", "convert", FACE, lines)
        text = lines.read_text().splitlines()
        vertices = [line for line in text if line.startswith("v ")]
        faces = [[int(corner.split("/")[0]) for corner in line.split()[1:]] for line in text if line.startswith("f ")]
        count = len(vertices)
        (WORK / "reversed.obj").write_text("\n".join(vertices[::-1] + ["f " + " ".join(str(count + 1 - v) for v in f)
                                                                      for f in faces]) + "\n")
        (WORK / "rolled.obj").write_text("\n".join(vertices + [f"f {f[1]} {f[2]} {f[0]}" for f in faces]) + "\n")
        for what in ("volume", "distance"):
            status, err = self.measured(lines, WORK / "reversed.obj", what)
            self.assertEqual(status, 1)
            self.assertIn("not the same triangles", err)
            self.assertEqual(self.measured(lines, WORK / "rolled.obj", what)[0], 0, "triangles may begin anywhere")

    def test_a_face_that_is_wound_inside_out(self):
        status, err = self.measured(FACE, WORK / "inside.ply")
        self.assertEqual(status, 1)
        self.assertIn("wound the other way", err)
        status, err = self.measured(WORK / "inside.ply", WORK / "inside.ply")
        self.assertEqual(status, 1)
        self.assertIn("--inside-out", err)

    def test_faces_of_two_frames_are_told(self):
        for what in ("volume", "distance"):
            status, err = self.measured(FACE, WORK / "turned.ply", what)
            self.assertEqual(status, 0)
            self.assertIn("not in one frame", err)
            self.assertIn("not in one frame", json.loads((WORK / "m.json").read_text())["warnings"][0])

    def test_a_mirror_image_is_told(self):
        run("mesh", "turn", WORK / "demo/scan/scan_grin.ply", WORK / "scan_mirror.ply", "--mirror", "x")
        run("mesh", "turn", WORK / "scan_mirror.ply", WORK / "scan_mirror_back.ply", "--inside-out")
        run("mesh", "turn", WORK / "demo/scan/scan_grin.ply", WORK / "scan_moved.ply", "--rotate", "0,10,5")
        for other, told in (("scan_mirror_back.ply", True), ("scan_moved.ply", False)):
            _, err = self.measured(WORK / "demo/scan/scan_grin.ply", WORK / other, "distance")
            self.assertEqual("mirror" in err, told and "wound" not in err, err)

    def test_one_face_twice_is_told(self):
        status, err = self.measured(FACE, FACE)
        self.assertEqual(status, 0)
        self.assertIn("are the same face", err)

    def report(self, **visits):
        folder = WORK / "patient"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name, face in visits.items():
            shutil.copy(face, folder / (name.replace("_", "-") + ".ply"))
        status, _, err = run("report", "--visits", folder, "--fitted", "--zones", WORK / "demo/zones.json",
                             "--show", "mouth", "--out", WORK / "page.html", "--json", WORK / "page.json")
        return status, err

    def test_visits_that_do_not_belong_together(self):
        for text, expected, later in (("is the same face", 0, FACE), ("not in one unit", 1, WORK / "metres.ply"),
                                      ("mirror image", 1, WORK / "mirrored_back.ply")):
            with self.subTest(text=text):
                status, err = self.report(**{"2026_01_01": FACE, "2026_03_01": later})
                self.assertEqual(status, expected, err)
                self.assertIn(text, err)
        self.assertEqual(self.report(**{"2026_01_01": FACE, "2026_03_01": WORK / "turned.ply"}), (0, ""))

    def test_a_visit_of_another_size_is_told(self):
        for factor, told in (("0.97", "3.0 % smaller"), ("1.03", "3.0 % larger"), ("0.995", None)):
            with self.subTest(factor=factor):
                run("mesh", "scale", FACE, WORK / "sized.ply", "--factor", factor)
                status, err = self.report(**{"2026_01_01": FACE, "2026_03_01": WORK / "sized.ply"})
                self.assertEqual(status, 0, err)
                self.assertEqual(err.count("calibrated?"), 1 if told else 0, err)
                self.assertIn(told or "", err)

    def test_zones_of_another_template_are_refused(self):
        zones = json.loads((WORK / "demo/zones.json").read_text())
        count = 1 + max(v for zone in zones["zones"].values() for v in zone)
        zones["zones"] = {name: [(v * 5077) % count for v in zone] for name, zone in zones["zones"].items()}
        (WORK / "other_zones.json").write_text(json.dumps(zones))
        status, _, err = run("measure", "volume", "--before", FACE, "--after", WORK / "turned.ply", "--zones", WORK / "other_zones.json")
        self.assertEqual(status, 1)
        self.assertIn("is scattered over the face", err)

    def test_visits_without_dates_are_told_in_the_order_taken(self):
        status, err = self.report(before=FACE, after=WORK / "turned.ply")
        self.assertEqual(status, 0, err)
        self.assertIn("order of their names: 'after', 'before'", err)

    def test_a_face_in_metres_is_told(self):
        for arguments in (["area", WORK / "metres.ply"], ["curvature", WORK / "metres.ply"],
                          ["volume", "--before", WORK / "metres.ply", "--after", WORK / "metres.ply"]):
            with self.subTest(arguments=arguments):
                self.assertIn("by its size it is in m", run("measure", *arguments)[2])
        self.assertEqual(run("measure", "area", FACE)[2], "")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
