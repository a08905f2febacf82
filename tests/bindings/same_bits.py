#!/usr/bin/env python3
"""The main job from every host on the same demo scan: all must give the same vertices to the bit.

  same_bits.py PROJECT_DIR BUILD_DIR WORK_DIR LIBRARY

Makes a small study and two models with the project's own commands, then runs C (also from arrays), C++, Python, C#, Java (these
rebuild the scan from arrays with its colours, and must also say the same of verdict, zones, visits and cancelling)
through JNI, Java through the Foreign Function API (where a JDK of 22 or later is found) and the command,
which goes through files. Hosts whose tools are missing are skipped by name.
"""
import hashlib
import json
import os
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

project, build, work, library = (Path(a).resolve() for a in sys.argv[1:5])
work.mkdir(parents=True, exist_ok=True)
environment = dict(os.environ, MIEN_LIBRARY=str(library), PYTHONPATH=str(project / "examples/python"),
                   PYTHONDONTWRITEBYTECODE="1")
failed, skipped = [], []


def run(*command, **more):
    """What the command prints; `more`: variables of its environment."""
    result = subprocess.run([str(c) for c in command], env={**environment, **more}, cwd=work, capture_output=True, text=True)
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


def host(name, neutral, command, saved, said_by=None):
    """Runs one host, and compares what it saved with what it says; said_by collects everything that it says."""
    try:
        text = run(*command)
    except RuntimeError as failure:
        failed.append(f"{name}: {failure}")
        return
    neutral[name] = digest(saved)
    said = re.search(r"neutral ([0-9a-f]{64})", text)
    if said and said.group(1) != neutral[name]:
        failed.append(f"{name}: prints another hash than that of the file it wrote")
    if said_by is not None:
        said_by[name] = text.replace("\r", "")


def build_java():
    """(class path, JNI library, class path with the foreign part or None)."""
    home = Path(shutil.which("javac")).resolve().parent.parent
    classes, jni, java = work / "classes", work / "libmien_jni.so", project / "examples/java"
    run("cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-pedantic", "-shared", "-fPIC", f"-I{home}/include",
        f"-I{home}/include/linux", f"-I{project}/include", java / "mien_jni.c", "-o", jni, f"-L{library.parent}", "-lmien")
    run("javac", "-Xlint:all", "-Werror", "-d", classes, *sorted(java.glob("*.java")), *sorted((java / "mien").glob("*.java")),
        project / "tests/bindings/Walk.java")
    newer = foreign_java()
    if not newer:
        return classes, jni, None
    run(Path(newer).resolve().parent / "javac", "-Xlint:all,-restricted", "-Werror", "-cp", classes, "-d", work / "foreign",
        *sorted((java / "foreign/mien").glob("*.java")))
    return classes, jni, f"{classes}:{work / 'foreign'}"


def write_small_network(path, side=12):
    """A network over sheets of side x side vertices, by hand as the format says: one dense layer to 3 numbers, and one back."""
    n, code = side * side, 3
    mean = [x for v in range(n) for x in (v % side - (side - 1) / 2, v // side - (side - 1) / 2, 0.0)]
    scale = max(mean)
    triangles = [t for y in range(side - 1) for x in range(side - 1) for a in [side * y + x]
                 for t in (a, a + 1, a + side, a + 1, a + side + 1, a + side)]
    weights = [0.05 * ((7 * k) % 11 - 5) for k in range(3 * n * code)]
    tensors = {"input.mean_shape": ("F64", [n, 3], "d", mean), "input.scale_mm": ("F64", [1], "d", [scale]),
               **{f"input.{key}": ("F64", [n, 3], "d", [x / scale for x in mean]) for key in ("mean", "least", "greatest")},
               "input.deviation": ("F64", [n, 3], "d", [1.0] * (3 * n)), "input.triangles": ("U32", [len(triangles) // 3, 3], "I", triangles),
               "down": ("F32", [3 * n, code], "f", weights), "up": ("F32", [code, 3 * n], "f", weights),
               "zero_code": ("F32", [code], "f", [0.0] * code), "zero_face": ("F32", [3 * n], "f", [0.0] * (3 * n))}
    layers = {"encoder": [{"kind": "dense", "rows_in": n, "channels_in": 3, "rows_out": 1, "channels_out": code, "elu": False,
                           "tensors": {"weight": "down", "bias": "zero_code"}}],
              "decoder": [{"kind": "dense", "rows_in": 1, "channels_in": code, "rows_out": n, "channels_out": 3, "elu": False,
                           "tensors": {"weight": "up", "bias": "zero_face"}}]}
    header, body = {"__metadata__": {"kind": "mien-network", "format": "1.0", "units": "millimetres", "name": "small",
                                     "input.features": "euclidean_standardised", "layers": json.dumps(layers)}}, b""
    for name, (kind, shape, letter, values) in tensors.items():
        data = struct.pack(f"<{len(values)}{letter}", *values)
        header[name] = {"dtype": kind, "shape": shape, "data_offsets": [len(body), len(body) + len(data)]}
        body += data
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    path.write_bytes(struct.pack("<Q", len(text)) + text + body)


def table_of(text):
    """The lines "visit zone signed low high limit" among what a program prints."""
    return [line.rstrip().lower() for line in text.splitlines() if re.match(r"\d+ \S.* [-\d.naN]+ +[-\d.naN]+ +[-\d.naN]+ +[-\d.naN]+$", line)]


def compare_visits(mien, models, scans, programs):
    """What changed between three visits: every program (name -> command) prints the numbers of the report."""
    folder = work / "visits"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for k, scan in enumerate(scans):
        shutil.copy(scan, folder / f"{k}.ply")
    tables = {name: table_of(run(*command, *models, *scans)) for name, command in programs.items()}
    tables["report"] = table_of(run(mien, "report", "--visits", folder, "--model", models[0], "--expressions", models[1], "--json",
                                    work / "visits.json", "--out", work / "visits.html"))
    print("visits: %d numbers from %s" % (4 * len(tables["report"]), ", ".join(tables)))
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

    visits = {"C": [build / "bin/mien-visits"], "C++": [build / "bin/mien-visits-cpp"]}
    neutral = {}
    host("C", neutral, [build / "bin/mien-first-program", *models, work / "c.ply"], work / "c.ply")
    small = ["sh", "-c", 'ulimit -s 256 && exec "$@"', "sh"]
    host("C, stack of 256 kB", neutral, [*small, build / "bin/mien-first-program", *models, work / "small.ply"], work / "small.ply")
    if shutil.which("cc"):
        run("cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", project / "tests/bindings/from_arrays.c", f"-I{project}/include",
            f"-L{library.parent}", "-lmien", f"-Wl,-rpath,{library.parent}", "-o", work / "from_arrays")
        host("C, from arrays", neutral, [work / "from_arrays", *models, work / "c_arrays.ply"], work / "c_arrays.ply")
    host("C++", neutral, [build / "bin/mien-main-job", *models, work / "cpp_fitted.ply", work / "cpp.ply", work / "cpp_file.ply"],
         work / "cpp.ply")

    said, others = {}, [demo / "scan/truth_neutral.ply", demo / "scan/truth_mouth_stretch.ply"]
    walk = [face, expressions, scan, demo / "train.safetensors", work]
    write_small_network(work / "walk_network.safetensors")
    python = python_with_numpy()
    if python:
        host("Python", neutral, [python, project / "examples/python/main_job.py", *models, work / "py.ply", *others], work / "py.ply", said)
        visits["Python"] = [python, project / "examples/python/visits.py"]
        print("Python:", run(python, project / "tests/bindings/walk.py", *walk).strip().splitlines()[-1])
    else:
        skipped.append("Python: no numpy (Debian package python3-numpy)")

    if shutil.which("mcs") and shutil.which("mono"):
        csharp = project / "examples/csharp"
        sources = [csharp / "Native.cs", csharp / "Runtime.cs", *sorted((csharp / "classes").glob("*.cs"))]
        flags = ["-langversion:7.2", "-unsafe", "-warnaserror"]
        run("mcs", *flags, f"-out:{work / 'main_job.exe'}", *sources, project / "examples/csharp/Program.cs")
        run("mcs", *flags, f"-out:{work / 'visits.exe'}", *sources, project / "examples/csharp/ThreeVisits.cs")
        visits["C#"] = ["mono", work / "visits.exe"]
        run("mcs", *flags, f"-out:{work / 'walk.exe'}", *sources, project / "tests/bindings/Walk.cs")
        host("C#", neutral, ["mono", work / "main_job.exe", *models, work / "cs.ply", *others], work / "cs.ply", said)
        # The library by the setting, which counts more than the environment.
        print("C#:", run("mono", work / "walk.exe", *walk, project / "abi/layout/x86_64.txt", library, MIEN_LIBRARY="/absent").strip().splitlines()[-1])
    else:
        skipped.append("C#: no mono (Debian packages mono-mcs, mono-runtime, libmono-system-core4.0-cil)")

    if shutil.which("javac") and shutil.which("java"):
        classes, jni, newer = build_java()
        java = ["java", "-Xcheck:jni", f"-Dmien.library={library}", f"-Dmien.jni={jni}", "-cp", classes]
        host("Java", neutral, [*java, "MainJob", *models, work / "java.ply", *others], work / "java.ply", said)
        visits["Java"] = [*java, "ThreeVisits"]
        text = run(*java, "Walk", *walk)
        print("Java:", text.strip().splitlines()[-1])
        if "WARNING" in text or "FATAL" in text:
            failed.append("Java: -Xcheck:jni complains:\n" + text)
        if newer:
            foreign = [foreign_java(), "--enable-native-access=ALL-UNNAMED", "-Dmien.binding=foreign", f"-Dmien.library={library}", "-cp", newer]
            host("Java, no C", neutral, [*foreign, "MainJob", *models, work / "foreign.ply", *others], work / "foreign.ply", said)
            visits["Java, no C"] = [*foreign, "ThreeVisits"]
            print("Java, no C:", run(*foreign, "Walk", *walk).strip().splitlines()[-1])
        else:
            skipped.append("Java by the Foreign Function API: no JDK of 22 or later (set MIEN_JAVA22 to its java)")
    else:
        skipped.append("Java: no JDK (Debian package openjdk-17-jdk-headless)")
    for name, text in said.items():
        if text != next(iter(said.values())):
            failed.append(f"{name} says something else than {next(iter(said))}:\n{text}\n{next(iter(said.values()))}")

    # The command keeps the fitted face and its weights in files between its two steps.
    run(mien, "register", "--model", face, "--scan", scan, "--out", work / "cli_fitted.ply", "--json", work / "cli_fit.json")
    run(mien, "neutralize", "--model", expressions, "--in", work / "cli_fitted.ply", "--weights", work / "cli_fit.json",
        "--out", work / "cli.ply")
    neutral["command"] = digest(work / "cli.ply")
    # The same without the weights that only a registration knows.
    run(mien, "neutralize", "--model", expressions, "--in", work / "cli_fitted.ply", "--out", work / "cli_file.ply")
    from_file = {"C++": digest(work / "cpp_file.ply"), "command": digest(work / "cli_file.ply")}
    fitted = {"C++": digest(work / "cpp_fitted.ply"), "command": digest(work / "cli_fitted.ply")}

    compare_visits(mien, [face, expressions], [demo / f"scan/scan_{name}.ply" for name in ("neutral", "grin", "mouth_stretch")], visits)

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
