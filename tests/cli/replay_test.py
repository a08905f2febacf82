"""mien replay: the same bits or what differs. mien transfer --to: a face in another template's topology.

  replay_test.py MIEN MIEN_DEMO_DATA WORK_FOLDER
"""
import json
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

MIEN_SOURCE = Path(__file__).resolve().parents[2]
MIEN, DEMO, WORK = Path(sys.argv[1]).resolve(), sys.argv[2], Path(sys.argv[3]).resolve()


def run(*arguments):
    done = subprocess.run([MIEN, *map(str, arguments)], capture_output=True, text=True, cwd=WORK, timeout=300)
    return done.returncode, done.stdout, done.stderr


def must(*arguments):
    status, out, err = run(*arguments)
    if status != 0:
        raise AssertionError(f"mien {' '.join(map(str, arguments))}\nexit {status}: {err}")
    return out


def setUpModule():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    subprocess.run([DEMO, "--out", WORK / "demo", "--subjects", "2", "--test-subjects", "0"], check=True, capture_output=True)
    must("model", "build", "--template", "demo/template.ply", "--modes", 30, "--zones", "demo/zones.json", "--landmarks",
         "demo/landmarks.json", "--out", "face.safetensors", "--json", "model.json", "--run-record", "model_run.json")


class Replay(unittest.TestCase):
    def sampled(self):
        """A run with a folder of output and a report that names files."""
        must("model", "sample", "face.safetensors", "--count", 2, "--seed", 5, "--out-dir", "faces", "--json", "faces.json",
             "--run-record", "run.json")
        return json.loads((WORK / "run.json").read_text())

    def test_a_record_names_all_files_with_their_hashes_the_options_and_the_software(self):
        record = json.loads((WORK / "model_run.json").read_text())
        self.assertEqual(record["command"], "model build")
        self.assertEqual({f["path"] for f in record["inputs"]}, {"demo/template.ply", "demo/zones.json", "demo/landmarks.json"})
        self.assertEqual({f["path"] for f in record["outputs"]}, {"face.safetensors", "model.json"})
        for file in record["inputs"] + record["outputs"]:
            told = subprocess.run(["sha256sum", WORK / file["path"]], capture_output=True, text=True).stdout.split()[0]
            self.assertEqual(file["sha256"], told)
        self.assertEqual(record["options"]["--modes"], "30")
        self.assertEqual(record["options"]["--sigma"], "20")  # a default
        self.assertEqual(record["software"], must("--version").strip())

    def test_the_same_run_gives_the_same_bits_and_touches_nothing(self):
        self.sampled()
        (WORK / "faces/sample_001.ply").unlink()  # what was written then is not needed
        before = (WORK / "faces.json").stat().st_mtime_ns
        self.assertIn("the same bits, 3 files", must("replay", "run.json", "--json", "replay.json"))
        self.assertFalse((WORK / "faces/sample_001.ply").exists())
        self.assertEqual((WORK / "faces.json").stat().st_mtime_ns, before)
        self.assertEqual(json.loads((WORK / "replay.json").read_text())["differences"], [])
        self.assertIn("the same bits", must("replay", "model_run.json"))

    def test_what_differs_is_named(self):
        record = self.sampled()
        record["arguments"][record["arguments"].index("5")] = "6"  # as if chance had another seed
        (WORK / "run.json").write_text(json.dumps(record))
        status, out, err = run("replay", "run.json")
        self.assertEqual(status, 1)
        self.assertIn("output: faces/sample_000.ply differs", out)
        self.assertIn("3 of 3 files differ although the software is the same", err)

    def test_other_software_is_named(self):
        record = self.sampled()
        record["software"] = "mien 0.1.0 gcc 9 portable"
        (WORK / "run.json").write_text(json.dumps(record))
        self.assertIn("recorded with mien 0.1.0 gcc 9 portable", must("replay", "run.json"))

    def test_changed_and_missing_inputs_are_named_before_anything_is_run(self):
        shutil.copy(WORK / "face.safetensors", WORK / "own.safetensors")
        for change, word in ((lambda p: p.write_bytes(p.read_bytes() + b"x"), "is another file now"), (Path.unlink, "is not there")):
            shutil.copy(WORK / "face.safetensors", WORK / "own.safetensors")
            must("model", "sample", "own.safetensors", "--out-dir", "own", "--run-record", "own.json")
            change(WORK / "own.safetensors")
            status, out, err = run("replay", "own.json")
            self.assertEqual(status, 1)
            self.assertIn(f"input: own.safetensors {word}", out)
            self.assertIn("inputs have changed", err)

    def test_a_folder_of_input_is_recorded_file_by_file(self):
        for visit in ("2026-01-01", "2026-02-01"):
            (WORK / "visits" / visit).mkdir(parents=True, exist_ok=True)
            shutil.copy(WORK / "demo/scan/truth_neutral.ply", WORK / "visits" / visit / "face.ply")
        must("report", "--fitted", "--visits", "visits", "--zones", "demo/zones.json", "--out", "page.html", "--json", "page.json",
             "--run-record", "page_run.json")
        record = json.loads((WORK / "page_run.json").read_text())
        self.assertIn("visits/2026-02-01/face.ply", {f["path"] for f in record["inputs"]})
        self.assertIn("the same bits, 2 files", must("replay", "page_run.json"))

    def test_other_files_are_no_records(self):
        status, _, err = run("replay", "model.json")
        self.assertEqual(status, 1)
        self.assertIn("is no record of a run", err)


class OtherTopology(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        must("mesh", "decimate", "demo/template.ply", "other.ply", "--vertices", 3000)
        must("transfer", "--model", "face.safetensors", "--to", "other.ply", "--correspondence", "other.json")

    @staticmethod
    def distance(before, after, surfaces=False):
        must("measure", "distance", "--before", before, "--after", after, "--json", "distance.json",
             *(("--surfaces",) if surfaces else ()))
        return json.loads((WORK / "distance.json").read_text())

    @staticmethod
    def vertices(path):
        must("mesh", "convert", path, "shown.obj")
        return [tuple(map(float, line.split()[1:4])) for line in (WORK / "shown.obj").read_text().splitlines() if line.startswith("v ")]

    def test_the_template_itself_becomes_the_other_template(self):
        must("transfer", "--correspondence", "other.json", "--fitted", "demo/template.ply", "--out", "same.ply")
        for got, wanted in zip(self.vertices("same.ply"), self.vertices("other.ply"), strict=True):
            self.assertLess(max(abs(a - b) for a, b in zip(got, wanted)), 1e-3)

    def test_a_face_in_the_other_topology_lies_on_the_face(self):
        face = "demo/scan/truth_grin.ply"
        must("transfer", "--correspondence", "other.json", "--fitted", face, "--out", "grin.ply")
        must("transfer", "--model", "face.safetensors", "--to", "other.ply", "--fitted", face, "--out", "grin2.ply")
        self.assertEqual((WORK / "grin.ply").read_bytes(), (WORK / "grin2.ply").read_bytes())
        self.assertEqual(len(self.vertices("grin.ply")), len(self.vertices("other.ply")))
        must("measure", "distance", "--before", "grin.ply", "--after", face, "--surfaces", "--field", "field.txt")
        field = [abs(float(d)) for d in (WORK / "field.txt").read_text().split() if "nan" not in d]
        self.assertLess(max(field), 0.01)  # the smaller template keeps places of the larger one

    def test_wrong_input_is_told(self):
        for arguments, status, word in (
            (("--correspondence", "other.json", "--fitted", "other.ply", "--out", "x.ply"), 1, "vertices, the correspondence is from"),
            (("--correspondence", "model.json", "--fitted", "other.ply", "--out", "x.ply"), 1, "is no correspondence"),
            (("--to", "other.ply", "--fitted", "other.ply", "--out", "x.ply"), 2, "--model"),
            (("--correspondence", "other.json", "--out", "x.ply"), 2, "--fitted"),
            (("--to", "other.ply", "--model", "face.safetensors"), 2, "--out"),
        ):
            got, _, err = run("transfer", *arguments)
            self.assertEqual(got, status, err)
            self.assertIn(word, err)
            self.assertFalse((WORK / "x.ply").exists())

    def test_points_of_a_numbering_are_carried_where_the_user_has_its_template(self):
        # A cloud of the 68 points in iBUG's order, and a surface with as many vertices as MediaPipe's: point k of the face is vertex k.
        places = self.vertices("demo/template.ply")
        marks = list(json.loads((WORK / "demo/landmarks.json").read_text())["vertices"].values())
        self.assertEqual(len(marks), 68)
        (WORK / "ibug68.xyz").write_text("".join("%.9g %.9g %.9g\n" % places[v] for v in marks))
        must("mesh", "decimate", "demo/template.ply", "mediapipe.ply", "--vertices", 468)
        face = "demo/scan/truth_grin.ply"
        for template, count in (("ibug68.xyz", 68), ("mediapipe.ply", 468)):
            must("transfer", "--model", "face.safetensors", "--to", template, "--fitted", face, "--out", "numbered.ply")
            self.assertEqual(len(self.vertices("numbered.ply")), count)
            if template == "ibug68.xyz":
                there = self.vertices(face)
                for got, vertex in zip(self.vertices("numbered.ply"), marks, strict=True):
                    self.assertLess(max(abs(a - b) for a, b in zip(got, there[vertex])), 1e-3)

    def test_face_tracking_gives_52_named_targets_of_a_person_in_their_order(self):
        # Made shapes: each moves its own 40 vertices of a small head by 5 mm.
        names = re.findall(r'"(\w+)"', re.search(r"kNames\{(.*?)\}", (MIEN_SOURCE / "src/cli/topology.cpp").read_text(), re.S).group(1))
        self.assertEqual(len(set(names)), 52)
        must("mesh", "decimate", "demo/template.ply", "small.ply", "--vertices", 2200)
        must("transfer", "--model", "face.safetensors", "--to", "small.ply", "--fitted", "demo/scan/truth_neutral.ply", "--out", "person.ply")
        must("mesh", "convert", "small.ply", "small.obj")
        lines = (WORK / "small.obj").read_text().splitlines()
        vertices = [k for k, line in enumerate(lines) if line.startswith("v ")]
        (WORK / "shapes").mkdir()
        for k, name in enumerate(names):
            moved = list(lines)
            for row in vertices[40 * k:40 * k + 40] if name != "tongueOut" else ():
                word = moved[row].split()
                moved[row] = " ".join((*word[:3], str(float(word[3]) + 5), *word[4:]))
            (WORK / f"shapes/{name}.obj").write_text("\n".join(moved) + "\n")
        must("transfer-expression", "--source-neutral", "small.obj", "--target", "person.ply", "--face-tracking", "--out", "tracked.glb",
             "--source-expression", *(f"shapes/{name}.obj" for name in reversed(names)))
        raw = (WORK / "tracked.glb").read_bytes()
        size = int.from_bytes(raw[12:16], "little")
        gltf = json.loads(raw[20:20 + size])
        self.assertEqual(gltf["meshes"][0]["extras"]["targetNames"], names)
        targets = gltf["meshes"][0]["primitives"][0]["targets"]
        self.assertEqual(len(targets), 52)
        most = {name: max(map(abs, gltf["accessors"][t["POSITION"]]["max"] + gltf["accessors"][t["POSITION"]]["min"]))
                for name, t in zip(names, targets)}
        self.assertLess(most.pop("tongueOut"), 1e-6)
        # glTF counts in metres.
        self.assertEqual(gltf["nodes"][0]["scale"], [0.001] * 3)  # millimetres, shown in glTF's metres
        self.assertGreater(min(most.values()), 0.5)
        self.assertLess(max(most.values()), 50)

    def test_face_tracking_wants_all_52_names(self):
        shutil.copy(WORK / "demo/template.ply", WORK / "jawOpen.ply")
        shutil.copy(WORK / "demo/template.ply", WORK / "grinning.ply")
        base = ("transfer-expression", "--source-neutral", "demo/template.ply", "--target", "demo/template.ply", "--out", "x.glb",
                "--face-tracking", "--source-expression")
        status, _, err = run(*base, "jawOpen.ply")
        self.assertEqual(status, 1)
        self.assertIn("browInnerUp", err)
        self.assertNotIn("jawOpen", err)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
