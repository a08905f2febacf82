#!/usr/bin/env python3
"""The main job from every host on the same demo scan: all must give the same vertices to the bit.

  same_bits.py PROJECT_DIR BUILD_DIR WORK_DIR LIBRARY

Makes a small study and two models with the project's own commands, then runs C, C++, Python, C#, Java
through JNI, Java through the Foreign Function API (where a JDK of 22 or later is found) and the command,
which goes through files. Hosts whose tools are missing are skipped by name.
"""
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

project, build, work, library = (Path(a).resolve() for a in sys.argv[1:5])
work.mkdir(parents=True, exist_ok=True)
environment = dict(os.environ, MIEN_LIBRARY=str(library), PYTHONPATH=str(project / "examples/python"),
                   PYTHONDONTWRITEBYTECODE="1", LD_LIBRARY_PATH=str(library.parent))
failed, skipped = [], []


def run(*command, quiet=False):
    result = subprocess.run([str(c) for c in command], env=environment, cwd=work, capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError(f"{' '.join(str(c) for c in command)}\n{result.stdout}{result.stderr}")
    return result.stdout


def vertices_of(path):
    """The vertex coordinates of a binary PLY file, as the bytes of #V x 3 float32."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode()
    count = int(re.search(r"element vertex (\d+)", header).group(1))
    block = header.split("element vertex")[1].split("element")[0]
    sizes = {"float": 4, "float32": 4, "uchar": 1, "uint8": 1, "int": 4, "double": 8}
    properties = re.findall(r"property (\w+) (\w+)", block)
    assert [p for _, p in properties[:3]] == ["x", "y", "z"] and properties[0][0].startswith("float"), header
    row = sum(sizes[kind] for kind, _ in properties)
    return b"".join(data[end + i * row:end + i * row + 12] for i in range(count))


def digest(path):
    return hashlib.sha256(vertices_of(path)).hexdigest()


def python_with_numpy():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy"], capture_output=True).returncode == 0:
            return python
    return None


def foreign_java():
    """A java of version 22 or later: the one in use, $MIEN_JAVA22, or any below /usr/lib/jvm."""
    found = [os.environ.get("MIEN_JAVA22", ""), shutil.which("java") or "", *map(str, sorted(Path("/usr/lib/jvm").glob("*/bin/java")))]
    for java in filter(None, found):
        said = subprocess.run([java, "-version"], capture_output=True, text=True)
        version = re.search(r'version "(\d+)', said.stderr)
        if said.returncode == 0 and version and int(version.group(1)) >= 22 and (Path(java).resolve().parent / "javac").exists():
            return java
    return None


def check_foreign_layout(source):
    """The Java program names three fields of the options: their places must be those of the C struct."""
    facts = dict(line.rsplit(" ", 1) for line in (project / "abi/layout/x86_64.txt").read_text().splitlines())
    padding = int(re.search(r"paddingLayout\((\d+)\)", source.read_text()).group(1))
    places = {"progress": 4 + padding, "progress_user": 12 + padding, "cancel": 20 + padding}
    for field, place in places.items():
        if int(facts[f"field mien_register_options.{field} offset"]) != place:
            failed.append(f"{source.name}: mien_register_options.{field} is not at {place}")


def host(name, neutral, command, saved):
    """Runs one host, and compares what it saved with what it says."""
    try:
        text = run(*command)
    except RuntimeError as failure:
        failed.append(f"{name}: {failure}")
        return
    neutral[name] = digest(saved)
    said = re.search(r"neutral ([0-9a-f]{64})", text)
    if said and said.group(1) != neutral[name]:
        failed.append(f"{name}: prints another hash than that of the file it wrote")


def table_of(text):
    """The lines "visit zone signed low high limit" among what a program prints."""
    return [line.rstrip().lower() for line in text.splitlines() if re.match(r"\d+ \S.* [-\d.naN]+ +[-\d.naN]+ +[-\d.naN]+ +[-\d.naN]+$", line)]


def compare_visits(mien, models, scans, python):
    """What changed between three visits: every host prints the numbers of the report."""
    folder = work / "visits"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for k, scan in enumerate(scans):
        shutil.copy(scan, folder / f"{k}.ply")
    programs = {"C": [build / "bin/mien-visits"], "C++": [build / "bin/mien-visits-cpp"]}
    if python:
        programs["Python"] = [python, project / "examples/python/visits.py"]
    tables = {name: table_of(run(*command, *models, *scans)) for name, command in programs.items()}
    tables["report"] = table_of(run(mien, "report", "--visits", folder, "--model", models[0], "--expressions", models[1], "--json",
                                    work / "visits.json", "--out", work / "visits.html"))
    print("visits: %d numbers" % (4 * len(tables["report"])))
    if len(tables["report"]) < 10:
        failed.append("visits: the report prints no table")
    told = json.loads((work / "visits.json").read_text())["visits"][1:]
    first = [zone["signed_ml"] for visit in told for zone in visit["zones"]]
    if [f"{value:.6f}" for value in first] != [line.split()[-4] for line in tables["report"]]:
        failed.append("visits: the table is not what the report's JSON says")
    for name, table in tables.items():
        if table != tables["report"]:
            failed.append(f"visits: {name} prints other numbers than the report:\n" + "\n".join(table))


def main():
    demo, face, expressions = work / "demo", work / "face.safetensors", work / "expressions.safetensors"
    mien = build / "bin/mien"
    if not expressions.exists():
        run(build / "bin/mien-demo-data", "--out", demo, "--subjects", "4", "--test-subjects", "1")
        run(mien, "model", "build", "--template", demo / "template.ply", "--kernel", "geodesic-se", "--sigma", "20",
            "--modes", "99", "--landmarks", demo / "landmarks.json", "--zones", demo / "zones.json", "--out", face)
        run(mien, "train", "--data", demo / "train.safetensors", "--method", "jpca", "--identity-modes", "3",
            "--expression-modes", "5", "--out", expressions)
    scan = demo / "scan/scan_grin.ply"
    models = [face, expressions, scan]

    neutral = {}
    host("C", neutral, [build / "bin/mien-first-program", *models, work / "c.ply"], work / "c.ply")
    small = ["sh", "-c", 'ulimit -s 256 && exec "$@"', "sh"]
    host("C, stack of 256 kB", neutral, [*small, build / "bin/mien-first-program", *models, work / "small.ply"], work / "small.ply")
    host("C++", neutral, [build / "bin/mien-main-job", *models, work / "cpp_fitted.ply", work / "cpp.ply", work / "cpp_file.ply"],
         work / "cpp.ply")

    python = python_with_numpy()
    if python:
        host("Python", neutral, [python, project / "examples/python/main_job.py", *models, work / "py_fitted.ply", work / "py.ply"],
             work / "py.ply")
    else:
        skipped.append("Python: no numpy (Debian package python3-numpy)")

    if shutil.which("mcs") and shutil.which("mono"):
        program = work / "main_job.exe"
        run("mcs", "-langversion:7", "-unsafe", "-warnaserror", f"-out:{program}", *sorted((project / "examples/csharp").glob("*.cs")))
        print("C#:", run("mono", program, "--self-test", project / "abi/layout/x86_64.txt").strip())
        host("C#", neutral, ["mono", program, *models, work / "cs_fitted.ply", work / "cs.ply"], work / "cs.ply")
    else:
        skipped.append("C#: no mono (Debian packages mono-mcs, mono-runtime, libmono-system-core4.0-cil)")

    if shutil.which("javac") and shutil.which("java"):
        home = Path(shutil.which("javac")).resolve().parent.parent
        classes, jni = work / "classes", work / "libmien_jni.so"
        run("cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-pedantic", "-shared", "-fPIC", f"-I{home}/include",
            f"-I{home}/include/linux", f"-I{project}/include", project / "examples/java/mien_jni.c", "-o", jni,
            f"-L{library.parent}", "-lmien")
        sources = [*sorted((project / "examples/java").glob("*.java")), *sorted((project / "examples/java/mien").glob("*.java"))]
        run("javac", "-Xlint:all", "-Werror", "-d", classes, *sources)
        java = ["java", "-Xcheck:jni", f"-Dmien.jni={jni}", "-cp", classes, "MainJob"]
        said = run(*java, "--self-test")
        print("Java:", said.strip().splitlines()[-1])
        if "WARNING" in said or "FATAL" in said:
            failed.append("Java: -Xcheck:jni complains:\n" + said)
        host("Java", neutral, [*java, *models, work / "java_fitted.ply", work / "java.ply"], work / "java.ply")
    else:
        skipped.append("Java: no JDK (Debian package openjdk-17-jdk-headless)")

    java = foreign_java()
    source = project / "examples/java/foreign/MainJobForeign.java"
    check_foreign_layout(source)
    if java:
        host("Java, no C", neutral, [java, "--enable-native-access=ALL-UNNAMED", f"-Dmien.library={library}", source, *models,
                                     work / "foreign_fitted.ply", work / "foreign.ply"], work / "foreign.ply")
    else:
        skipped.append("Java by the Foreign Function API: no JDK of 22 or later (set MIEN_JAVA22 to its java)")

    # The command keeps the fitted face and its weights in files between its two steps.
    run(mien, "register", "--model", face, "--scan", scan, "--out", work / "cli_fitted.ply", "--json", work / "cli_fit.json")
    run(mien, "neutralize", "--model", expressions, "--in", work / "cli_fitted.ply", "--weights", work / "cli_fit.json",
        "--out", work / "cli.ply")
    neutral["command"] = digest(work / "cli.ply")
    # The same without the weights that only a registration knows.
    run(mien, "neutralize", "--model", expressions, "--in", work / "cli_fitted.ply", "--out", work / "cli_file.ply")
    from_file = {"C++": digest(work / "cpp_file.ply"), "command": digest(work / "cli_file.ply")}
    fitted = {"C++": digest(work / "cpp_fitted.ply"), "command": digest(work / "cli_fitted.ply")}

    compare_visits(mien, [face, expressions], [demo / f"scan/scan_{name}.ply" for name in ("neutral", "grin", "mouth_stretch")], python)

    for title, hashes in (("neutral face", neutral), ("fitted face", fitted), ("neutral face of a bare mesh", from_file)):
        print(title)
        for name, value in hashes.items():
            print(f"  {name:20} {value}")
        if len(set(hashes.values())) > 1:
            failed.append(f"{title}: the hosts differ")
    for line in skipped:
        print("skipped:", line)
    print("\n".join(failed) if failed else "all hosts agree to the bit")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
