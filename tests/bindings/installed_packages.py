#!/usr/bin/env python3
"""The main program of each language from its installed package, in a clean directory: all must print the same.

  installed_packages.py PROJECT_DIR BUILD_DIR WORK_DIR MODELS_DIR

MODELS_DIR is what same_bits.py made. No variable of the build's environment reaches the programs.
"""
import json
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


def lines_of(text):
    """What a host says, without the hash of the neutral face and the volume that expressions came to."""
    return [line.split(", removed")[0].rstrip() for line in text.splitlines() if not line.startswith("neutral ")]


# C++ from an installed tree: at most 40 lines, too. It prints no hash, so its file is compared with the last host's.
if shutil.which("c++") and said:
    run("cmake", "--install", build, "--prefix", clean / "prefix")
    libraries = next((clean / "prefix").rglob("libmien.so")).parent
    run("c++", "-std=c++17", "-Wall", "-Wextra", "-Werror", project / "examples/cpp/whole_job.cpp", f"-I{clean / 'prefix/include'}",
        f"-L{libraries}", "-lmien", f"-Wl,-rpath,{libraries}", "-o", clean / "whole_job")
    text = run(clean / "whole_job", *arguments[:3], clean / "cpp.ply", *arguments[4:])
    first, *rest = text.splitlines()
    quality, report = re.fullmatch(r"verdict (\w+) (.*)", first).groups()
    told = [f"verdict {quality} {'; '.join(json.loads(report)['reasons'])}".rstrip(), *rest]
    if told != lines_of(next(iter(said.values()))):
        raise SystemExit(f"FAILED: C++ prints\n{told}\nand {next(iter(said))}\n{lines_of(next(iter(said.values())))}")
    if (clean / "cpp.ply").read_bytes() != arguments[3].read_bytes():
        raise SystemExit("FAILED: C++ writes another neutral face")
    said["C++"] = text

# C from the same tree: three scans registered, so its table is the one that the report prints of them (same_bits.py).
if shutil.which("cc") and "C++" in said:
    run("cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", project / "examples/c/whole_job.c", f"-I{clean / 'prefix/include'}",
        f"-L{libraries}", "-lmien", f"-Wl,-rpath,{libraries}", "-o", clean / "whole_job_c")
    text = run(clean / "whole_job_c", *arguments[:2], clean / "c.ply", *(demo / f"scan_{name}.ply" for name in ("neutral", "grin", "mouth_stretch")))
    lines = text.splitlines()
    visits = json.loads((models / "visits.json").read_text())["visits"]
    told = [f"{zone['name']} {zone['signed_ml']:.6f} [{zone['low95_ml']:.6f}, {zone['high95_ml']:.6f}]" for zone in visits[2]["zones"]]
    if [json.loads(line)["quality"] for line in lines[:3]] != [visit["registration"]["quality"] for visit in visits] or lines[3:-1] != told:
        raise SystemExit(f"FAILED: C prints\n{text}\nand the report\n{told}")
    if "cancel" not in lines[-1]:
        raise SystemExit(f"FAILED: C is not cancelled: {lines[-1]}")
    if (clean / "c.ply").read_bytes() != arguments[3].read_bytes():
        raise SystemExit("FAILED: C writes another neutral face")
    said["C"] = text
for source in ("python/main_job.py", "csharp/Program.cs", "java/MainJob.java", "cpp/whole_job.cpp", "c/whole_job.c"):
    count = len((project / "examples" / source).read_text().splitlines())
    if count > 40:
        raise SystemExit(f"FAILED: {source} has {count} lines, 40 are the most that the main job may take")
print(f"{len(said)} hosts from installed packages agree")
