"""mien report on faces that are fitted already: what it says of no change, of a known change, of bad input."""
import base64
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import unittest
import zlib
from pathlib import Path

mien, demo_data, work = sys.argv[1], sys.argv[2], Path(sys.argv[3])


sources = Path(__file__).resolve().parents[2] / "src"
LITERAL = r'"(?:[^"\\]|\\.)*"(?:\s*"(?:[^"\\]|\\.)*")*'


def joined_literals(source):
    """The texts of a C++ source, a line each, their parts joined as the compiler does."""
    return "\n".join("".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literal)) for literal in re.findall(LITERAL, source))


def run(*arguments):
    return subprocess.run([mien, *map(str, arguments)], capture_output=True, text=True)


def picture(page, words):
    """Rows of (r, g, b) of the page's first PNG whose description holds the words."""
    return next(png_rows(base64.b64decode(data))
                for alt, data in re.findall(r'<img alt="([^"]*)" src="data:image/png;base64,([^"]*)"', page) if words in alt)


def png_rows(data):
    """Rows of pixels of an 8-bit RGB PNG that is not interlaced."""
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack_from(">IIBB", body)
            assert (depth, color) == (8, 2)
        if kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, stride = zlib.decompress(packed), 3 * width
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left, up, corner = (line[x - 3] if x >= 3 else 0), above[x], (above[x - 3] if x >= 3 else 0)
            nearest = min((left, up, corner), key=lambda v: abs(v - (left + up - corner)))
            line[x] = (line[x] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
        rows.append([tuple(line[x:x + 3]) for x in range(0, stride, 3)])
        above = line
    return rows


def colored(rows):
    """Pixels that are neither white, grey nor the dark green of rims."""
    return sum(max(p) - min(p) > 40 and not (p[1] > p[0] and p[1] > p[2]) for row in rows for p in row)


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
            if name == "b":  # in centimetres, and with a place that no model knows
                cls.must("mesh", "scale", demo / f"scan/scan_{expression}.ply", cls.base / "scans/b.ply", "--factor", "0.1")
                picked = json.loads((cls.base / "scans/b.json").read_text())
                picked["points"]["wart"] = [20, 10, 80]
                (cls.base / "scans/b.json").write_text(json.dumps(picked))
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
        page = (self.base / "page.html").read_text("utf-8")
        for said in ("one unit of the scan was taken for 10 mm", "the landmarks are in another unit than the scan",
                     "1 landmarks are unknown to the model and left out: wart"):
            self.assertIn(said, page)
        self.assertEqual(scans, self.told("kept", "--fitted"))
        self.assertIn("one unit of the scan was taken for 10 mm", (self.base / "page.html").read_text("utf-8"))
        by_name = {zone["name"]: zone for zone in scans}
        for zone in self.told("fits", "--fitted", "--zones", self.base / "demo/zones.json"):
            self.assertEqual(zone, by_name[zone["name"]])

    def test_a_last_visit_that_is_not_good_stands_before_all_numbers(self):
        doubted = self.base / "doubted"
        doubted.mkdir(exist_ok=True)
        shutil.copy(self.base / "kept/a.safetensors", doubted)
        picked = json.loads((self.base / "demo/scan/landmarks_grin.json").read_text())
        for name, place in picked["points"].items():
            place[1] += 14 if name.startswith("mouth") else 0
        (self.base / "off.json").write_text(json.dumps(picked))
        self.must("register", "--model", self.base / "face.safetensors", "--scan", self.base / "demo/scan/scan_grin.ply", "--landmarks",
                  self.base / "off.json", "--out", self.base / "off.ply", "--json", self.base / "off_fit.json", "--record",
                  doubted / "b.safetensors")
        self.assertEqual(json.loads((self.base / "off_fit.json").read_text())["quality"], "doubtful")
        self.told("doubted", "--fitted")
        page = (self.base / "page.html").read_text("utf-8")
        self.assertIn("<strong>b: fit doubtful", page)
        self.assertLess(page.index("<strong>b: fit doubtful"), page.index("<li>"))

    def test_landmarks_shifted_together_are_moved_back_and_the_page_says_so(self):
        beside = self.base / "beside"
        beside.mkdir(exist_ok=True)
        shutil.copy(self.base / "kept/a.safetensors", beside)
        scan, picked = self.base / "demo/scan/scan_neutral.ply", self.base / "demo/scan/landmarks_neutral.json"
        moved = json.loads(picked.read_text())
        moved["points"] = {name: [x + 3, y + 4, z - 3] for name, (x, y, z) in moved["points"].items()}
        (self.base / "moved.json").write_text(json.dumps(moved))
        self.must("register", "--model", self.base / "face.safetensors", "--scan", scan, "--landmarks", self.base / "moved.json",
                  "--out", self.base / "moved.ply", "--json", self.base / "moved_fit.json", "--record", beside / "b.safetensors")
        notes = json.loads((self.base / "moved_fit.json").read_text())["notes"]
        told = [float(re.match(r"the landmarks lie ([\d.]+) mm", note)[1]) for note in notes if "all to one side" in note]
        self.assertEqual(len(told), 1, notes)
        self.assertAlmostEqual(told[0], 34 ** .5, delta=1)
        zones = self.told("beside", "--fitted")
        self.assertGreater(len(zones), 5)
        self.assertEqual([zone["name"] for zone in zones if not zone["below_limit_of_detection"]], [])  # one scan, fitted twice
        self.assertIn("all to one side: they were moved back", (self.base / "page.html").read_text("utf-8"))

    def test_walls_and_skin_that_nobody_saw_are_measured_when_asked(self):
        def mouth(*more):
            self.told("kept", "--fitted", *more)
            study = json.loads((self.base / "kept.json").read_text())["study"]
            zone = next(z for z in study["visits"][1]["changes_since_first"] if z["name"] == "mouth")
            return study["recipe"]["unseen"], zone["area_before_mm2"]
        (left_out, open_skin), (kept, all_of_it) = mouth(), mouth("--unseen")
        self.assertEqual((left_out, kept), (False, True))
        self.assertGreater(all_of_it, 1.01 * open_skin)

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


class Unseen(unittest.TestCase):
    """A head of which the scalp was not seen: it moved by 10 mm there, and not at all where it was seen."""
    @classmethod
    def setUpClass(cls):
        cls.base = work / "unseen"
        shutil.rmtree(cls.base, ignore_errors=True)
        cls.base.mkdir(parents=True)
        subprocess.run([demo_data, "--out", str(cls.base / "demo"), "--subjects", "2", "--test-subjects", "1"], check=True,
                       capture_output=True)
        assert run("mesh", "convert", cls.base / "demo/scan/truth_neutral.ply", cls.base / "face.obj").returncode == 0
        lines = (cls.base / "face.obj").read_text().splitlines()
        places = [[float(x) for x in line.split()[1:4]] for line in lines if line.startswith("v ")]
        faces = [line for line in lines if line.startswith("f ")]
        seen = set(json.loads((cls.base / "demo/zones.json").read_text())["zones"]["face"])
        for name, moved in (("a", 0.0), ("b", 10.0)):
            with open(cls.base / f"{name}.obj", "w") as out:
                for v, (x, y, z) in enumerate(places):
                    out.write(f"v {x} {y} {z + (0 if v in seen else moved)}\n")
                out.write("\n".join(faces) + "\n")

    def page(self, weight_of_scalp):
        visits = self.base / "visits"
        shutil.rmtree(visits, ignore_errors=True)
        visits.mkdir()
        seen = set(json.loads((self.base / "demo/zones.json").read_text())["zones"]["face"])
        count = (self.base / "a.obj").read_text().count("\nv ") + 1
        for name in ("a", "b"):
            shutil.copy(self.base / f"{name}.obj", visits)
            (visits / f"{name}.json").write_text(json.dumps({
                "quality": "good", "weight": [1.0 if v in seen else weight_of_scalp for v in range(count)],
                "residual_mm": [0.0] * count, "standard_deviation_mm": [0.1] * count}))
        done = run("report", "--fitted", "--visits", visits, "--zones", self.base / "demo/zones.json", "--show", "mouth",
                   "--stable", "mouth", "--out", self.base / "page.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.base / "page.html").read_text()

    def test_what_was_not_seen_has_no_colour_and_no_part_in_the_range(self):
        page = self.page(0.0)
        change = picture(page, "Change against")
        self.assertEqual(colored(change), 0)
        self.assertIn("+0.5 mm gained", page)
        # And were it seen, it would be there to see.
        page = self.page(1.0)
        change = picture(page, "Change against")
        self.assertGreater(colored(change), 1000)
        self.assertIn("+10 mm gained", page)


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

    def report(self, *more, visits=None):
        if "--sd" not in more:
            more = ("--sd", "0.08", *more)
        return self.told(*more, visits=visits)

    def told(self, *more, visits=None):
        done = run("report", "--fitted", "--visits", visits or self.visits, "--zones", work / "demo/zones.json", "--show", "mouth,forehead",
                   "--json", work / "report.json", "--out", work / "report.html", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((work / "report.json").read_text())["visits"]

    def test_the_same_face_has_not_changed_and_says_so(self):
        for zone in self.report()[1]["zones"]:
            self.assertAlmostEqual(zone["signed_ml"], 0, places=6)
            self.assertTrue(zone["below_limit_of_detection"])

    def test_the_page_tells_of_visits_that_are_one_face(self):
        for language, said in (("en", "2026-02: is the same face as 2026-01"), ("de", "2026-02: ist dasselbe Gesicht wie 2026-01")):
            self.assertIn(said, self.page_of("--language", language))

    def test_what_makes_all_numbers_doubtful_stands_before_them(self):
        sized = work / "sized"
        shutil.rmtree(sized, ignore_errors=True)
        sized.mkdir()
        first = sorted(self.visits.glob("*/face.ply"))[0]
        shutil.copy(first, sized / "2026-01-01.ply")
        run("mesh", "scale", first, sized / "2026-03-01.ply", "--factor", "0.97")
        self.told("--sd", "0.08", visits=sized)
        page = (work / "report.html").read_text("utf-8")
        self.assertIn("2026-03-01: the face of 2026-03-01 is 3.0 % smaller", page)
        self.assertLess(page.index("3.0 % smaller"), page.index("<li>"))

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

    def page_of(self, *more, visits=None):
        self.report(*more, visits=visits)
        data = (work / "report.html").read_bytes()
        self.assertLess(len(data), 5_000_000)
        return data.decode("utf-8")  # strict: any other byte is an error

    def test_the_page_stands_alone_and_escapes_names(self):
        page = self.page_of("--title", "A & B")
        # The policy lets the browser reach nothing; and nothing is asked for.
        self.assertIn("default-src 'none'; img-src data:", page)
        for word in ("http:", "https:", "//www", "<link", "<iframe", "url(", "fetch(", "XMLHttpRequest", "import(", "<late>", "A & B"):
            self.assertNotIn(word, page)
        self.assertEqual(set(re.findall(r'\b(?:src|href)="(.{5})', page)), {"data:"})
        for word in ("A &amp; B", "&lt;late&gt;", "data:image/png;base64,", "<svg", 'name="viewport"', "@page{size:A4", "WebGL"):
            self.assertIn(word, page)

    def test_names_in_any_script_stay_whole(self):
        title = "J\u00fcrgen M\u00fcller \u674e\u5c0f\u9f99 \u0639\u0644\u064a"
        folder = work / "scripts"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name in ("1 \u00e4\u00f6\u00fc\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc", "2 \u674e" * 4):
            shutil.copy(self.visits / "2026-01/face.ply", folder / f"{name}.ply")
        shutil.copy(self.visits / "2026-01/face.ply", os.fsencode(folder) + b"/3 caf\xe9.ply")  # no UTF-8 at all
        done = run("report", "--fitted", "--sd", "0.08", "--visits", folder, "--zones", work / "demo/zones.json", "--show", "mouth",
                   "--title", title, "--json", work / "report.json", "--out", work / "report.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (work / "report.html").read_bytes().decode("utf-8")
        self.assertIn(title, page)
        self.assertIn("3 caf\ufffd", page)
        self.assertEqual(json.loads((work / "report.json").read_text("utf-8"))["title"], title)

    def test_a_patient_and_visits_are_told_of(self):
        (self.visits / "patient.json").write_text(json.dumps({"name": "\u00c5sa <b>", "born": "1980-02-29", "skin type": 2}))
        (self.visits / "2026-02/visit.json").write_text(json.dumps({"label": "after", "device": "Arc 5", "note": "a & b"}))
        try:
            page = self.page_of("--language", "de")
        finally:
            (self.visits / "patient.json").unlink()
            (self.visits / "2026-02/visit.json").unlink()
        for word in ("\u00c5sa &lt;b&gt;", "Geboren", "1980-02-29", "skin type", "Ger\u00e4t", "Arc 5", "a &amp; b", "<h3>after</h3>"):
            self.assertIn(word, page)

    def dated(self, *names):
        folder = work / "dated"
        shutil.rmtree(folder, ignore_errors=True)
        for name in names:
            (folder / name).mkdir(parents=True)
            shutil.copy(self.visits / "2026-01/face.ply", folder / name)
        return folder

    def test_dates_are_at_their_distance_in_time(self):
        folder = self.dated("2025-12-31 before", "20260110", "c")
        (folder / "c/visit.json").write_text(json.dumps({"date": "2026-03-01", "label": "two months"}))
        page = self.page_of(visits=folder)
        plot = page[page.index("<svg"):page.index("</svg>")]
        x = [float(value) for value in re.findall(r'<circle cx="([0-9.]+)"', plot)]
        self.assertAlmostEqual((x[1] - x[0]) / (x[2] - x[0]), 10 / 60, places=2)
        for word in ("2025-12-31, before", "2026-03-01, two months"):
            self.assertIn(word, page)
        self.assertNotIn("Not every visit has a date", page)
        self.assertIn("Not every visit has a date", self.page_of())

    def test_dates_that_are_none_or_run_backwards_are_errors(self):
        for date, word in (("2026-02-30", "no day"), ("1999-01-01", "order of their dates")):
            folder = self.dated("2026-01-01", "b")
            (folder / "b/visit.json").write_text(json.dumps({"date": date}))
            done = run("report", "--fitted", "--visits", folder, "--zones", work / "demo/zones.json", "--out", work / "none.html")
            self.assertEqual(done.returncode, 1)
            self.assertIn(word, done.stderr)

    def test_every_text_is_in_every_language(self):
        english = self.page_of("--treated", "mouth")
        for language, words in (("de", ("Mund", "Stirn", "Nachweisgrenze", "Mund und 10 mm darum herum", "Behandelt")),
                                ("fr", ("bouche", "front", "limite de d\u00e9tection", "bouche et 10 mm autour"))):
            page = self.page_of("--treated", "mouth", "--language", language)
            self.assertIn(f'<html lang="{language}"', page)
            for word in words:
                self.assertIn(word, page)
            # What is left alike are numbers, names, and words that both languages have.
            text = {piece.strip() for piece in re.findall(r">([^<>{}]+)<", page.split("<style>")[0] + page.split("</style>")[1])}
            same = {piece for piece in text & {p.strip() for p in re.findall(r">([^<>{}]+)<", english)} if re.search("[a-z]{4}", piece)}
            self.assertLessEqual(same, {"2026-03 &lt;late&gt;", "Scan", "scan", "Patient", "Software"} | {p for p in same if p.startswith("mien ")}, language)
        done = run("report", "--fitted", "--visits", self.visits, "--out", work / "none.html", "--language", "xx")
        self.assertEqual(done.returncode, 2)

    def test_the_table_of_texts_is_whole(self):
        source = "".join((sources / f"cli/report_{name}.hpp").read_text("utf-8") for name in ("texts", "sentences"))
        rows = re.findall(r"^    \{\"", source, re.M)
        joined = re.sub(r'"\s+"', "", source)
        whole = re.findall(r'\{"((?:[^"\\]|\\.)*)",\s*\{"((?:[^"\\]|\\.)*)",\s*"((?:[^"\\]|\\.)*)",\s*"((?:[^"\\]|\\.)*)"\}\}', joined)
        self.assertEqual(len(whole), len(rows))
        self.assertGreater(len(whole), 100)
        for key, *texts in whole:
            for text in texts:
                self.assertTrue(text, key)
                self.assertEqual(sorted(re.findall(r"\{\d\}", text)), sorted(re.findall(r"\{\d\}", texts[0])), key)

    def test_every_sentence_that_a_fit_can_say_is_in_the_table(self):
        # A verdict's reasons and notes are written in these files; errors and what is logged never reach the page.
        known = joined_literals((sources / "cli/report_sentences.hpp").read_text("utf-8"))
        missing, count = [], 0
        errors = ("batch", "fit_record", "fit_system", "scan_fans")  # what else these files say are errors
        for path in (*sorted((sources / "registration").glob("*.cpp")), sources / "cli/face_checks.cpp"):
            if path.stem in errors:
                continue
            text = re.sub(r"^ *#include.*|//.*", "", path.read_text("utf-8"), flags=re.M)
            if path.name == "face_checks.cpp":
                text = text[text.index("check_visits"):]
            text = re.sub(rf"\b(fail(_at)?|runtime_error|fprintf|log|metadata\[)\(?(?:{LITERAL}|[^;\"])*;", "", text)
            for said in joined_literals(text).splitlines():
                for piece in re.split(r"%[-+.\d]*l*[a-z]", said):
                    sentence = len(piece) > 20 and " " in piece
                    count += sentence
                    if sentence and piece.strip(" ;:,") not in known:
                        missing.append(f"{path.name}: {piece}")
        self.assertEqual(missing, [], "the report cannot say this in other languages")
        self.assertGreater(count, 30)

    def test_treated_zones_are_drawn(self):
        def rims(page):
            return sum(p[1] > p[0] + 20 and p[1] > p[2] + 10 for row in picture(page, "fitted face") for p in row)
        self.assertEqual(rims(self.page_of()), 0)
        self.assertGreater(rims(self.page_of("--treated", "mouth")), 100)

    def test_software_and_models_are_named_with_their_hashes(self):
        page = self.page_of()
        version = subprocess.run([mien, "--version"], capture_output=True, text=True).stdout.strip()
        self.assertIn(version, page)
        self.assertRegex(json.loads((work / "report.json").read_text())["visits"][0]["scan_sha256"], "^[0-9a-f]{64}$")

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
