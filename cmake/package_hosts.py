#!/usr/bin/env python3
"""Packages for Python, .NET and Java with the native library inside, made without their package tools' networks.

  package_hosts.py BUILD_DIR OUT_DIR [wheel] [nuget] [jar]     (none named: all whose tools are here)

wheel: `pip install mien-*.whl` works offline. nuget: sources as contentFiles and runtimes/RID/native, so that any
compiler and target framework fits. jar: classes, the JNI library, on Java 22 or later the Foreign Function API
without it, pom.xml; natives are unpacked on first use. For the machine that it runs on.
"""
import os
import platform
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
VERSION = re.search(r"project\(mien VERSION ([0-9.]+)", (PROJECT / "CMakeLists.txt").read_text()).group(1)
ARM = platform.machine() in ("aarch64", "arm64")
LIBRARY = "libmien.so.0"
ABOUT = "Registers, neutralizes and measures 3D face scans"
SETUP = '''from setuptools import setup
from wheel.bdist_wheel import bdist_wheel


class Wheel(bdist_wheel):
    """Of one machine, for every Python 3: the package has no extension module, but a native library."""
    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(cmdclass={"bdist_wheel": Wheel})
'''
NUSPEC = f"""<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd">
  <metadata>
    <id>Mien</id>
    <version>{VERSION}</version>
    <authors>Mien</authors>
    <description>{ABOUT}</description>
    <license type="expression">Apache-2.0</license>
    <contentFiles><files include="cs/any/**/*.cs" buildAction="Compile" /></contentFiles>
    <dependencies><group targetFramework=".NETStandard2.1" /><group targetFramework="net8.0" /></dependencies>
  </metadata>
</package>
"""
PROPS = "<Project><PropertyGroup><AllowUnsafeBlocks>true</AllowUnsafeBlocks></PropertyGroup></Project>\n"
TYPES = """<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
  <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml" />
  <Default Extension="nuspec" ContentType="application/octet" /><Default Extension="cs" ContentType="application/octet" />
  <Default Extension="props" ContentType="application/octet" /><Default Extension="0" ContentType="application/octet" />
  <Override PartName="/LICENSE" ContentType="application/octet" />
</Types>
"""
RELATIONS = """<?xml version="1.0" encoding="utf-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
  <Relationship Type="http://schemas.microsoft.com/packaging/2010/07/manifest" Target="/Mien.nuspec" Id="R1" />
</Relationships>
"""
POM = f"""<?xml version="1.0" encoding="UTF-8"?>
<project xmlns="http://maven.apache.org/POM/4.0.0">
  <modelVersion>4.0.0</modelVersion>
  <groupId>mien</groupId>
  <artifactId>mien</artifactId>
  <version>{VERSION}</version>
  <description>{ABOUT}</description>
  <licenses><license><name>Apache-2.0</name></license></licenses>
</project>
"""


def run(*command, cwd=None):
    result = subprocess.run([str(c) for c in command], cwd=cwd, capture_output=True, text=True)
    if result.returncode != 0:
        raise SystemExit(f"{' '.join(str(c) for c in command)}\n{result.stdout}{result.stderr}")


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def python_with_wheel():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import setuptools, wheel, pip"], capture_output=True).returncode == 0:
            return python
    return None


def make_wheel(library, out):
    python = python_with_wheel()
    if not python:
        return "skipped: the wheel needs Python's setuptools and wheel (Debian packages python3-setuptools, python3-wheel)"
    stage = fresh(out / "stage-python")
    shutil.copytree(PROJECT / "examples/python/mien", stage / "mien", ignore=shutil.ignore_patterns("__pycache__"))
    (stage / "mien/native").mkdir()
    shutil.copy(library, stage / "mien/native" / LIBRARY)
    shutil.copy(PROJECT / "LICENSE", stage)
    (stage / "setup.py").write_text(SETUP)
    (stage / "pyproject.toml").write_text(
        f'[build-system]\nrequires = ["setuptools>=61", "wheel"]\nbuild-backend = "setuptools.build_meta"\n\n[project]\nname = "mien"\n'
        f'version = "{VERSION}"\ndescription = "{ABOUT}"\nrequires-python = ">=3.9"\ndependencies = ["numpy"]\nlicense = {{text = "Apache-2.0"}}\n\n'
        '[tool.setuptools]\npackages = ["mien", "mien.classes"]\n\n[tool.setuptools.package-data]\nmien = ["native/*", "py.typed"]\n')
    run(python, "-m", "pip", "wheel", "--quiet", "--no-index", "--no-deps", "--no-build-isolation", "-w", out, stage)
    shutil.rmtree(stage)
    return str(next(out.glob("mien-*.whl")))


def make_nuget(library, out):
    path = out / f"Mien.{VERSION}.nupkg"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as package:
        package.writestr("[Content_Types].xml", TYPES)
        package.writestr("_rels/.rels", RELATIONS)
        package.writestr("Mien.nuspec", NUSPEC)
        package.writestr("build/Mien.props", PROPS)
        package.write(PROJECT / "LICENSE", "LICENSE")
        csharp = PROJECT / "examples/csharp"
        for source in (csharp / "Native.cs", csharp / "Runtime.cs", *sorted((csharp / "classes").glob("*.cs"))):
            package.write(source, f"contentFiles/cs/any/{source.relative_to(csharp)}")
        package.write(library, f"runtimes/linux-{'arm64' if ARM else 'x64'}/native/{LIBRARY}")
    return str(path)


def newer_javac():
    """A javac of Java 22 or later, for the Foreign Function API."""
    for java in [os.environ.get("MIEN_JAVA22", ""), *map(str, sorted(Path("/usr/lib/jvm").glob("*/bin/java")))]:
        said = subprocess.run([java, "-version"], capture_output=True, text=True).stderr if java and Path(java).exists() else ""
        version = re.search(r'version "(\d+)', said)
        if version and int(version.group(1)) >= 22 and Path(java).with_name("javac").exists():
            return Path(java).with_name("javac")
    return None


def make_jar(library, out):
    if not shutil.which("javac"):
        return "skipped: the jar needs a JDK (Debian package openjdk-17-jdk-headless)"
    home, java = Path(shutil.which("javac")).resolve().parent.parent, PROJECT / "examples/java"
    stage = fresh(out / "stage-java")
    run("javac", "--release", "17", "-d", stage, *sorted((java / "mien").glob("*.java")))
    newer = newer_javac()
    if newer:
        run(newer, "--release", "22", "-cp", stage, "-d", stage, *sorted((java / "foreign/mien").glob("*.java")))
    native = stage / f"META-INF/native/linux-{'aarch64' if ARM else 'x86_64'}"
    native.mkdir(parents=True)
    shutil.copy(library, native / LIBRARY)
    run("cc", "-std=c99", "-O2", "-shared", "-fPIC", f"-I{home}/include", f"-I{home}/include/linux", f"-I{PROJECT}/include",
        java / "mien_jni.c", "-o", native / "libmien_jni.so", f"-L{library.parent}", "-lmien")
    maven = stage / "META-INF/maven/mien/mien"
    maven.mkdir(parents=True)
    (maven / "pom.xml").write_text(POM)
    (out / f"mien-{VERSION}.pom").write_text(POM)
    shutil.copy(PROJECT / "LICENSE", stage / "META-INF/LICENSE")
    path = out / f"mien-{VERSION}.jar"
    run("jar", "--create", "--file", path, "-C", stage, ".")
    shutil.rmtree(stage)
    return str(path)


def main():
    library, out = Path(sys.argv[1]).resolve() / "abi" / LIBRARY, Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    makers = {"wheel": make_wheel, "nuget": make_nuget, "jar": make_jar}
    for name in sys.argv[3:] or makers:
        print(f"{name}: {makers[name](library.resolve().with_name(LIBRARY), out)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
