"""The bill of materials against the build, and that its check finds what is missing: sbom_test.py PROJECT_DIR BUILD_DIR"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

project, build = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()


def made(script, out):
    return subprocess.run([sys.executable, script, build, out], capture_output=True, text=True)


class Sbom(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = Path(cls.folder.name)
        done = made(project / "cmake/sbom.py", cls.out)
        assert done.returncode == 0, done.stdout + done.stderr
        cls.spdx = json.loads((cls.out / "mien.spdx.json").read_text())
        cls.cyclonedx = json.loads((cls.out / "mien.cdx.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_both_name_the_same_components_with_versions_and_licences(self):
        spdx = {p["name"]: (p["versionInfo"], p["licenseDeclared"]) for p in self.spdx["packages"]}
        other = {c["name"]: (c["version"], c["licenses"][0].get("expression") or c["licenses"][0]["license"]["id"])
                 for c in [self.cyclonedx["metadata"]["component"], *self.cyclonedx["components"]] if c["type"] == "library"}
        self.assertEqual(spdx, other)
        self.assertLessEqual({"mien", "eigen", "openmesh", "nlohmann-json", "cli11"}, set(spdx))
        self.assertLessEqual({"libpng", "zlib"}, set(spdx))  # the command draws pictures
        without = "MIEN_IMAGES:BOOL=OFF" in (build / "CMakeCache.txt").read_text()
        self.assertEqual("libjpeg-turbo" in spdx, not without)
        for name, (version, _) in spdx.items():
            self.assertRegex(version, r"^\d+\.\d+", name)

    def test_references_are_whole(self):
        known = {p["SPDXID"] for p in self.spdx["packages"] + self.spdx["files"]} | {"SPDXRef-DOCUMENT"}
        for relationship in self.spdx["relationships"]:
            self.assertLessEqual({relationship["spdxElementId"], relationship["relatedSpdxElement"]}, known)
        known = {c["bom-ref"] for c in self.cyclonedx["components"]} | {"mien"}
        for dependency in self.cyclonedx["dependencies"]:
            self.assertLessEqual({dependency["ref"], *dependency["dependsOn"]}, known)

    def changed(self, *replacements):
        text = (project / "cmake/sbom.py").read_text().replace("Path(__file__).resolve().parent.parent", f"Path({str(project)!r})")
        for old, new in replacements:
            self.assertIn(old, text)
            text = text.replace(old, new)
        script = self.out / "changed.py"
        script.write_text(text)
        return made(script, self.out / "changed")

    def test_what_is_compiled_in_but_not_named_is_an_error(self):
        done = self.changed(('r"/nlohmann/"', 'r"/nowhere/"'))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("header /usr/include/nlohmann/", done.stderr)

    def test_what_is_linked_but_not_named_is_an_error(self):
        done = self.changed(('("OpenMeshCore", "OpenMeshTools")', '("OpenMeshCore",)'))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("library OpenMeshTools", done.stderr)

    def test_what_is_named_but_not_there_is_an_error(self):
        done = self.changed(("COMPONENTS = {", 'COMPONENTS = {"boost": ("BSL-1.0", "https://boost.org", r"/boost/", "boost/version.hpp", r"(\\d+)", ()),'))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("boost is in the table", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
