#!/usr/bin/env python3
"""Says what the built files are made of, as SPDX 2.3 and CycloneDX 1.5, and checks it against what was compiled and linked.

  sbom.py BUILD_DIR OUT_DIR [LIBRARY COMMAND]     (default: the library and the command of the build folder)

Evidence: every header that the compiler read (ninja -t deps), every library on the link lines (build.ninja), every library
that the finished files ask the system for. Each must belong to a component of the table below, and each component of the
table must have been seen: a library that is added without being named here, or named without being there, is an error.
Versions are those of the headers that were read.
"""
import datetime
import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
VERSION = re.search(r"project\(mien VERSION ([0-9.]+)", (PROJECT / "CMakeLists.txt").read_text()).group(1)
# name: licence, home, header path, header with the version, its pattern, names of libraries.
COMPONENTS = {
    "eigen": ("MPL-2.0", "https://eigen.tuxfamily.org", r"/(eigen3?|Eigen)/", "Eigen/src/Core/util/Macros.h",
              r"EIGEN_(?:WORLD|MAJOR|MINOR)_VERSION (\d+)", ()),
    "openmesh": ("BSD-3-Clause", "https://www.graphics.rwth-aachen.de/software/openmesh", r"/OpenMesh/", "OpenMesh/Core/System/config.h",
                 r"define OM_VERSION 0x([0-9a-f])([0-9a-f]{2})([0-9a-f]{2})", ("OpenMeshCore", "OpenMeshTools")),
    "nlohmann-json": ("MIT", "https://github.com/nlohmann/json", r"/nlohmann/", "nlohmann/detail/abi_macros.hpp|nlohmann/json.hpp",
                      r"define NLOHMANN_JSON_VERSION_\w+ (\d+)", ()),
    "cli11": ("BSD-3-Clause", "https://github.com/CLIUtils/CLI11", r"/CLI/", "CLI/Version.hpp", r'CLI11_VERSION "([\d.]+)"', ()),
    "libjpeg-turbo": ("IJG AND BSD-3-Clause AND Zlib", "https://libjpeg-turbo.org", r"/(jpeglib|jconfig|jmorecfg|jerror)\.h$", "jconfig.h",
                      r"LIBJPEG_TURBO_VERSION +([\d.]+)", ("jpeg",)),
    "libpng": ("libpng-2.0", "http://www.libpng.org", r"/(png|pngconf|pnglibconf)\.h$", "png.h", r'PNG_LIBPNG_VER_STRING "([\d.]+)"',
               ("png", "png16")),
    "zlib": ("Zlib", "https://zlib.net", r"/(zlib|zconf)\.h$", "zlib.h", r'ZLIB_VERSION "([\d.]+)"', ("z",)),
}
# The compiler's own runtime and the system: headers in their folders, libraries of these names.
SYSTEM_HEADERS = r"^/usr/(share/mingw-w64/include|lib/gcc(-cross)?|lib/llvm|include/c\+\+|include/(x86_64|aarch64|i386)-linux-gnu/(asm|bits|c\+\+|gnu|sys)|" \
                 r"[^/]*mingw32|[^/]*-linux-gnu/include|lib/clang)/"
SYSTEM_LIBRARIES = {"c", "m", "dl", "pthread", "stdc++", "gcc_s", "gcc", "rt", "ld-linux-x86-64", "ld-linux-aarch64", "KERNEL32", "msvcrt",
                    "USER32", "ADVAPI32", "bcrypt", "kernel32", "user32", "gdi32", "winspool", "shell32", "ole32", "oleaut32", "uuid",
                    "comdlg32", "advapi32", "mien", "mien-0"}


def output_of(*command):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout


def headers_read(build):
    """Headers outside of the project and of the build folder that the shipped targets' compilers read."""
    source = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", (build / "CMakeCache.txt").read_text(), re.M).group(1) + "/"
    found, shipped = set(), False
    for line in output_of("ninja", "-C", build, "-t", "deps").splitlines():
        if not line.startswith(" "):
            shipped = re.match(r"(src|abi|examples/data)/", line) is not None and not line.startswith("src/training/")
        elif shipped:
            path = os.path.normpath(os.path.join(build, line.strip()))
            if not path.startswith((source, f"{build}/")) or "/dependencies/" in path or path.startswith(f"{build}/eigen/"):
                found.add(re.sub(r"^.*/sysroot-linux-\w+/", "/", path))  # the C library that archives are compiled against
    if not found:
        raise SystemExit(f"FAILED: {build} has no record of what its compilers read (a Ninja build is needed)")
    return found


def belongs_to_libc(path):
    return re.match(r"^/usr/include/[^/]+\.h$|^/usr/include/(linux|asm-generic|rpc|netinet|arpa)/", path) is not None


def libraries_linked(build):
    """Names of the libraries on the shipped files' link lines, without those of the build itself."""
    found, shipped = set(), False
    for line in (build / "build.ninja").read_text().splitlines():
        if line.startswith("build "):
            shipped = re.match(r"build (abi/libmien\.|bin/mien(-0\.dll|\.exe|-demo-data(\.exe)?)?[ :])", line) is not None
        elif shipped and line.startswith("  LINK_LIBRARIES ="):
            for word in line.split("=", 1)[1].split():
                name = library_name(word)
                if name and not re.match(r"(src|abi|bin|examples)/", word):
                    found.add(name)
    return found


def library_name(word):
    if word.startswith("-l"):
        return word[2:]
    match = re.search(r"(?:^|/)(?:lib)?([^/]+?)\.(?:so|a|dll|dll\.a)(?:\.[0-9.]+)?$", word)
    return match.group(1) if match and not word.startswith("-Wl") else None


def libraries_asked_for(file):
    """What the finished file asks the system's loader for."""
    head = file.read_bytes()[:2]
    if head == b"MZ":
        text = output_of("objdump", "-p", file)
        names = re.findall(r"DLL Name: (\S+)\.dll", text)
    else:
        text = output_of("readelf", "-dW", file)
        names = [library_name(n) or n.split(".so")[0] for n in re.findall(r"NEEDED.*\[(.*)\]", text)]
        names = [n[3:] if n.startswith("lib") else n for n in names]
    return set(names)


def version_of(component, headers):
    """By its own header, among those that were read or beside one of them: a library of a library is linked unread."""
    _, _, _, wanted, pattern, _ = COMPONENTS[component]
    beside = {f"{folder}/{w}" for folder in {os.path.dirname(h) for h in headers} for w in wanted.split("|")}
    for path in sorted(headers) + sorted(beside):
        if any(path.endswith("/" + w) for w in wanted.split("|")) and os.path.exists(path):
            numbers = re.findall(pattern, Path(path).read_text(errors="replace"))
            if numbers:
                parts = numbers[0] if isinstance(numbers[0], tuple) else numbers[:3]
                return ".".join(str(int(p)) if p.isdigit() else p for p in parts)
    raise SystemExit(f"FAILED: no version of {component} in the headers that were read ({wanted})")


def evidence(build, files):
    """{component: {"headers": n, "libraries": [...]}}; what belongs to none is an error."""
    headers, linked = headers_read(build), libraries_linked(build)
    asked = set().union(*(libraries_asked_for(f) for f in files))
    seen = {name: {"headers": 0, "libraries": set()} for name in COMPONENTS}
    strangers = []
    for path in headers:
        owner = next((n for n, (_, _, where, *_) in COMPONENTS.items() if re.search(where, path)), None)
        if owner:
            seen[owner]["headers"] += 1
        elif not re.match(SYSTEM_HEADERS, path) and not belongs_to_libc(path):
            strangers.append(f"header {path}")
    for name in linked | asked:
        owner = next((n for n, (*_, libraries) in COMPONENTS.items() if name in libraries), None)
        if owner:
            seen[owner]["libraries"].add(name)
        elif name not in SYSTEM_LIBRARIES:
            strangers.append(f"library {name}")
    if strangers:
        raise SystemExit("FAILED: of no component of the table in cmake/sbom.py: " + ", ".join(sorted(strangers)[:20]))
    return seen, headers


def spdx(parts, files, when):
    def package(name, version, licence, home, purpose):
        return {"name": name, "SPDXID": f"SPDXRef-{name}", "versionInfo": version, "downloadLocation": home or "NOASSERTION",
                "filesAnalyzed": False, "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION",
                "primaryPackagePurpose": purpose}
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"mien-{VERSION}",
        "documentNamespace": f"urn:mien:sbom:{VERSION}:{hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()}",
        "creationInfo": {"created": when, "creators": ["Tool: mien-cmake/sbom.py"]},
        "packages": [package("mien", VERSION, "Apache-2.0", "", "LIBRARY")] +
                    [package(p["name"], p["version"], p["licence"], p["home"], "LIBRARY") for p in parts],
        "files": [{"fileName": f"./{f.name}", "SPDXID": f"SPDXRef-File-{k}",
                   "checksums": [{"algorithm": "SHA1", "checksumValue": hashlib.sha1(f.read_bytes()).hexdigest()},
                                 {"algorithm": "SHA256", "checksumValue": hashlib.sha256(f.read_bytes()).hexdigest()}],
                   "licenseConcluded": "Apache-2.0", "copyrightText": "NOASSERTION"} for k, f in enumerate(files)],
        "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-mien"}] +
                         [{"spdxElementId": "SPDXRef-mien", "relationshipType": "STATIC_LINK" if p["inside"] else "DYNAMIC_LINK",
                           "relatedSpdxElement": f"SPDXRef-{p['name']}"} for p in parts] +
                         [{"spdxElementId": "SPDXRef-mien", "relationshipType": "CONTAINS", "relatedSpdxElement": f"SPDXRef-File-{k}"}
                          for k in range(len(files))]}


def cyclonedx(parts, files, when):
    def component(name, version, licence, kind="library"):
        licences = [{"expression": licence}] if " " in licence else [{"license": {"id": licence}}]
        return {"type": kind, "bom-ref": name, "name": name, "version": version, "licenses": licences}
    own = component("mien", VERSION, "Apache-2.0")
    return {
        "bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
        "metadata": {"timestamp": when, "tools": [{"name": "mien-cmake/sbom.py"}], "component": own},
        "components": [{**component(p["name"], p["version"], p["licence"]), "externalReferences": [{"type": "website", "url": p["home"]}],
                        "properties": [{"name": "mien:headers", "value": str(p["headers"])},
                                       {"name": "mien:libraries", "value": " ".join(p["libraries"])}]} for p in parts] +
                      [{"type": "file", "bom-ref": f"file:{f.name}", "name": f.name,
                        "hashes": [{"alg": "SHA-256", "content": hashlib.sha256(f.read_bytes()).hexdigest()}]} for f in files],
        "dependencies": [{"ref": "mien", "dependsOn": [p["name"] for p in parts]}] + [{"ref": p["name"], "dependsOn": []} for p in parts]}


def default_files(build):
    found = [*build.glob("abi/libmien.so.*.*.*"), *build.glob("bin/mien-0.dll"), *build.glob("bin/mien"), *build.glob("bin/mien.exe"),
             *build.glob("bin/mien-demo-data"), *build.glob("bin/mien-demo-data.exe")]
    if not found:
        raise SystemExit(f"FAILED: {build} holds no built library")
    return found


def main():
    build, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    files = [Path(f).resolve() for f in sys.argv[3:]] or default_files(build)
    seen, headers = evidence(build, files)
    asked = set().union(*(libraries_asked_for(f) for f in files))
    without_images = "MIEN_IMAGES:BOOL=OFF" in (build / "CMakeCache.txt").read_text()
    may_lack = {"cli11", "libjpeg-turbo"} if without_images else {"cli11"}  # libpng stays: the command draws with it
    parts = []
    for name, (licence, home, _, _, _, libraries) in COMPONENTS.items():
        if not seen[name]["headers"] and not seen[name]["libraries"]:
            if name not in may_lack:
                raise SystemExit(f"FAILED: {name} is in the table, but nothing of it was compiled or linked")
            continue
        parts.append({"name": name, "version": version_of(name, headers), "licence": licence, "home": home,
                      "headers": seen[name]["headers"], "libraries": sorted(seen[name]["libraries"]),
                      "inside": not asked & set(libraries)})
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    moment = datetime.datetime.fromtimestamp(int(epoch), datetime.timezone.utc) if epoch else datetime.datetime.now(datetime.timezone.utc)
    when = moment.strftime("%Y-%m-%dT%H:%M:%SZ")
    out.mkdir(parents=True, exist_ok=True)
    (out / "mien.spdx.json").write_text(json.dumps(spdx(parts, files, when), indent=1) + "\n")
    (out / "mien.cdx.json").write_text(json.dumps(cyclonedx(parts, files, when), indent=1) + "\n")
    for part in parts:
        where = "inside" if part["inside"] else "of the system"
        print(f"{part['name']:14} {part['version']:10} {part['licence']:34} {where}, {part['headers']} headers")
    print(f"{out}: mien.spdx.json, mien.cdx.json; {len(parts)} components, nothing else was compiled in or linked")


if __name__ == "__main__":
    main()
