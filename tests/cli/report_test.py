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
