"""mien report on faces that are fitted already: what it says of no change, of a known change, of bad input."""
import json
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

mien, demo_data, work = sys.argv[1], sys.argv[2], Path(sys.argv[3])


def run(*arguments):
    return subprocess.run([mien, *map(str, arguments)], capture_output=True, text=True)


class Records(unittest.TestCase):
    """Scans that were registered today and are studied in a year."""
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(work / "records", ignore_errors=True)
        cls.base = work / "records"
        cls.base.mkdir(parents=True)
        subprocess.run([demo_data, "--out", str(cls.base / "demo"), "--subjects", "4", "--test-subjects", "0"], check=True,
                       capture_output=True)
        demo = cls.base / "demo"
        cls.must("model", "build", "--template", demo / "template.ply", "--kernel", "geodesic-se", "--sigma", 20, "--modes", 60,
                 "--landmarks", demo / "landmarks.json", "--zones", demo / "zones.json", "--out", cls.base / "face.safetensors")
        for folder in ("scans", "fits", "kept"):
            (cls.base / folder).mkdir()
        for name, expression in (("a", "neutral"), ("b", "grin")):
            shutil.copy(demo / f"scan/scan_{expression}.ply", cls.base / f"scans/{name}.ply")
            shutil.copy(demo / f"scan/landmarks_{expression}.json", cls.base / f"scans/{name}.json")
            cls.must("register", "--model", cls.base / "face.safetensors", "--scan", cls.base / f"scans/{name}.ply", "--landmarks",
                     cls.base / f"scans/{name}.json", "--out", cls.base / f"fits/{name}.ply", "--json", cls.base / f"fits/{name}.json",
                     "--record", cls.base / f"kept/{name}.safetensors")

    @staticmethod
    def must(*arguments):
        done = run(*arguments)
        if done.returncode != 0:
            raise AssertionError(f"{arguments}: {done.stderr}")
        return done.stdout

    def told(self, folder, *more):
        out = self.base / f"{folder}.json"
        self.must("report", "--visits", self.base / folder, "--json", out, "--out", self.base / "page.html", *more)
        return json.loads(out.read_text())["visits"][1]["zones"]

    def test_scans_their_records_and_their_files_give_the_same_numbers(self):
        scans = self.told("scans", "--model", self.base / "face.safetensors")
        self.assertGreater(len(scans), 5)  # the zones of the model
        self.assertEqual(scans, self.told("kept", "--fitted"))
        by_name = {zone["name"]: zone for zone in scans}
        for zone in self.told("fits", "--fitted", "--zones", self.base / "demo/zones.json"):
            self.assertEqual(zone, by_name[zone["name"]])

    def test_a_mesh_beside_its_record_is_not_a_second_capture(self):
        both = self.base / "both"
        both.mkdir(exist_ok=True)
        for name in ("a", "b"):
            (both / name).mkdir(exist_ok=True)
            shutil.copy(self.base / f"fits/{name}.ply", both / name)
            shutil.copy(self.base / f"kept/{name}.safetensors", both / name)
        self.assertEqual(self.told("kept", "--fitted"), self.told("both", "--fitted"))

    def test_measure_volume_tells_an_interval_of_fits_whose_errors_are_known(self):
        zones = ("--zones", self.base / "demo/zones.json")
        pairs = {"bare": [self.base / f"fits/{n}.ply" for n in "ab"], "kept": [self.base / f"kept/{n}.safetensors" for n in "ab"]}
        told = {}
        for kind, (before, after) in pairs.items():
            told[kind] = self.must("measure", "volume", "--before", before, "--after", after, *zones)
        told["json"] = self.must("measure", "volume", "--before", pairs["bare"][0], "--after", pairs["bare"][1], "--before-json",
                                 self.base / "fits/a.json", "--after-json", self.base / "fits/b.json", *zones)
        half = self.must("measure", "volume", "--before", pairs["bare"][0], "--after", pairs["kept"][1], *zones)
        for text in (told["bare"], half):
            self.assertIn("no interval: the surfaces' errors are unknown", text)
            self.assertNotIn("..", text)
        self.assertIn("..", told["kept"])
        self.assertEqual(told["kept"], told["json"])

    def test_an_alignment_widens_the_interval(self):
        fits = ("--before", self.base / "kept/a.safetensors", "--after", self.base / "kept/b.safetensors", "--zones",
                self.base / "demo/zones.json")
        widths = []
        for stable in ((), ("--stable", "forehead,nose")):
            self.must("measure", "volume", *fits, *stable, "--json", self.base / "volume.json")
            got = json.loads((self.base / "volume.json").read_text())["volume"]["zones"]
            chin = next(z for z in got if z["name"] == "chin")
            widths.append(chin["high95_ml"] - chin["low95_ml"])
        self.assertGreater(widths[1], widths[0])


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        subprocess.run([demo_data, "--out", str(work / "demo"), "--subjects", "2", "--test-subjects", "1"], check=True,
                       capture_output=True)
        scan = work / "demo/scan"
        cls.visits = work / "visits"
        for name, face in (("2026-01", "neutral"), ("2026-02", "neutral"), ("2026-03 <late>", "grin")):
            (cls.visits / name).mkdir(parents=True)
            shutil.copy(scan / f"truth_{face}.ply", cls.visits / name / "face.ply")

    def report(self, *more):
        if "--sd" not in more:
            more = ("--sd", "0.08", *more)
        return self.told(*more)

    def told(self, *more):
        done = run("report", "--fitted", "--visits", self.visits, "--zones", work / "demo/zones.json", "--show", "mouth,forehead",
                   "--json", work / "report.json", "--out", work / "report.html", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((work / "report.json").read_text())["visits"]

    def test_the_same_face_has_not_changed_and_says_so(self):
        for zone in self.report()[1]["zones"]:
            self.assertAlmostEqual(zone["signed_ml"], 0, places=6)
            self.assertTrue(zone["below_limit_of_detection"])

    def test_a_grin_moves_the_mouth_and_not_the_forehead(self):
        mouth, forehead = self.report()[2]["zones"]
        self.assertGreater(mouth["absolute_ml"], 1.0)
        self.assertLess(forehead["absolute_ml"], 0.2)

    def test_a_treatment_is_also_told_with_what_lies_around_its_zone(self):
        # The grin leaves the mouth's zone: the place with its margin has the zone's change and more.
        mouth, _, wider = self.report("--treated", "mouth", "--margin", "10")[2]["zones"]
        self.assertEqual(wider["name"], "mouth and 10 mm around")
        self.assertGreater(wider["absolute_ml"], mouth["absolute_ml"])
        self.assertEqual(len(self.report("--treated", "mouth", "--margin", "0")[2]["zones"]), 2)

    def test_more_doubt_widens_the_intervals(self):
        narrow = self.report("--sd", "0.05")[1]["zones"][0]
        wide = self.report("--sd", "0.5")[1]["zones"][0]
        self.assertGreater(wide["high95_ml"] - wide["low95_ml"], 2 * (narrow["high95_ml"] - narrow["low95_ml"]))

    def test_of_bare_meshes_the_errors_are_not_known_and_no_interval_is_told(self):
        for zone in self.told()[2]["zones"]:
            self.assertIsNotNone(zone["signed_ml"])
            for key in ("sd_ml", "low95_ml", "high95_ml", "limit_of_detection_ml", "below_limit_of_detection"):
                self.assertIsNone(zone[key], key)
        page = (work / "report.html").read_text()
        self.assertNotRegex(page, r"(?i)[>\s\"]-?nan[<\s\"]")
        self.assertIn("no interval: the surfaces' errors are unknown", page)
        self.assertIn("errors are unknown", (work / "report.json").read_text())

    def test_every_number_comes_with_its_error(self):
        mouth = self.report()[2]["zones"][0]
        for name in ("gained_ml", "lost_ml", "absolute_ml", "area_change_mm2", "mean_distance_mm"):
            told = mouth["more"][name]
            self.assertLessEqual(told["low95"], told["value"], name)
            self.assertGreaterEqual(told["high95"], told["value"], name)
            self.assertGreater(told["limit_of_detection"], 0, name)
        self.assertAlmostEqual(mouth["more"]["gained_ml"]["value"] + mouth["more"]["lost_ml"]["value"], mouth["signed_ml"], places=9)

    def test_a_table_is_printed(self):
        done = run("report", "--fitted", "--sd", "0.08", "--visits", self.visits, "--zones", work / "demo/zones.json", "--show", "mouth",
                   "--json", work / "report.json", "--out", work / "report.html")
        rows = [line.split() for line in done.stdout.splitlines()[:2]]
        visits = json.loads((work / "report.json").read_text())["visits"]
        for visit, row in enumerate(rows, 1):
            self.assertEqual(row[:2], [str(visit), "mouth"])
            zone = visits[visit]["zones"][0]
            for text, key in zip(row[2:], ("signed_ml", "low95_ml", "high95_ml", "limit_of_detection_ml")):
                self.assertAlmostEqual(float(text), zone[key], delta=6e-7)

    def test_the_page_stands_alone_and_escapes_names(self):
        self.report("--title", "A & B")
        page = (work / "report.html").read_text()
        self.assertLess(len(page), 5_000_000)
        for word in ("http://", "https://", "<script", "<link", "<late>", "A & B"):
            self.assertNotIn(word, page)
        for word in ("A &amp; B", "&lt;late&gt;", "data:image/png;base64,", "<svg", 'name="viewport"'):
            self.assertIn(word, page)

    def test_wrong_input_is_told(self):
        empty = work / "empty"
        empty.mkdir(exist_ok=True)
        for arguments, word in (
            (("--fitted", "--visits", empty), "two visits"),
            (("--fitted", "--visits", work / "nothing"), "not a folder"),
            (("--fitted", "--visits", self.visits, "--stable", "elbow"), "elbow"),
            (("--visits", self.visits), "--model"),
        ):
            done = run("report", "--zones", work / "demo/zones.json", "--out", work / "none.html", *arguments)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(word, done.stderr)
            self.assertFalse((work / "none.html").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
