#!/usr/bin/env python3
"""The main program of each language from its installed package, in a clean directory: all must print the same.

  installed_packages.py PROJECT_DIR BUILD_DIR WORK_DIR MODELS_DIR

MODELS_DIR is what same_bits.py made. No variable of the build's environment reaches the programs.
"""
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

project, build, work, models = (Path(a).resolve() for a in sys.argv[1:5])
shutil.rmtree(work, ignore_errors=True)
clean = work / "clean"
clean.mkdir(parents=True)
environment = {"PATH": os.environ["PATH"], "HOME": str(clean), "PYTHONDONTWRITEBYTECODE": "1"}


def run(*command, **more):
    result = subprocess.run([str(c) for c in command], env={**environment, **more}, cwd=clean, capture_output=True, text=True)
    if result.returncode != 0:
        raise SystemExit(f"FAILED: {' '.join(str(c) for c in command)}\n{result.stdout}{result.stderr}")
    return result.stdout


made = run(sys.executable, project / "cmake/package_hosts.py", build, work)
print(made.strip())
demo = models / "demo/scan"
arguments = [models / "face.safetensors", models / "expressions.safetensors", demo / "scan_grin.ply", clean / "neutral.ply",
             demo / "truth_neutral.ply", demo / "truth_mouth_stretch.ply"]
said = {}
wheel = next(work.glob("mien-*.whl"), None)
if wheel and subprocess.run(["/usr/bin/python3", "-c", "import numpy"], capture_output=True).returncode == 0:
    run("/usr/bin/python3", "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--target", clean / "python", wheel)
    shutil.copy(project / "examples/python/main_job.py", clean)
    said["Python"] = run("/usr/bin/python3", clean / "main_job.py", *arguments, PYTHONPATH=str(clean / "python"))
package = next(work.glob("Mien.*.nupkg"))
names = zipfile.ZipFile(package).namelist()
for wanted in ("Mien.nuspec", "[Content_Types].xml", "_rels/.rels", "contentFiles/cs/any/classes/Session.cs", "build/Mien.props"):
    assert wanted in names, f"{wanted} is missing in the NuGet package"
assert any(re.fullmatch(r"runtimes/linux-\w+/native/libmien\.so\.0", n) for n in names), names
if shutil.which("mcs") and shutil.which("mono"):
    zipfile.ZipFile(package).extractall(clean / "nuget")
    run("mcs", "-langversion:7.2", "-unsafe", f"-out:{clean / 'nuget/main_job.exe'}", *sorted((clean / "nuget/contentFiles/cs/any").rglob("*.cs")),
        project / "examples/csharp/Program.cs")
    said["C#"] = run("mono", clean / "nuget/main_job.exe", *arguments)
jar = next(work.glob("mien-*.jar"), None)
if jar:
    assert "META-INF/maven/mien/mien/pom.xml" in zipfile.ZipFile(jar).namelist()
    run("javac", "-cp", jar, "-d", clean / "java", project / "examples/java/MainJob.java")
    said["Java"] = run("java", "-cp", f"{jar}:{clean / 'java'}", "MainJob", *arguments)
for name, text in said.items():
    print(f"{name}: {re.search('neutral ([0-9a-f]{16})', text).group(1)}...")
    if text != next(iter(said.values())):
        raise SystemExit(f"FAILED: {name} prints\n{text}\nand {next(iter(said))}\n{next(iter(said.values()))}")
print(f"{len(said)} hosts from installed packages agree")
