#!/usr/bin/env python3
"""Counts the public functions that each language's classes reach: all of them, or the test fails. The C++ face is
written by hand and reported beside them.

  count_functions.py PROJECT_DIR

The list is abi/interface.json. A function counts where the source of the classes calls it (or, in Python, hands its
name to the runtime), not where a raw declaration merely exists.
"""
import json
import re
import sys
from pathlib import Path

project = Path(sys.argv[1])
functions = [f["name"] for f in json.loads((project / "abi/interface.json").read_text())["functions"]]
structs = {s["name"] for s in json.loads((project / "abi/interface.json").read_text())["structs"]}


def text(*patterns, without=()):
    return "\n".join(path.read_text() for pattern in patterns for path in sorted(project.glob(pattern)) if path.name not in without)


def python(name, source=text("examples/python/mien/classes/*.py")):
    # An options class names its struct: the runtime calls STRUCT_init() for its defaults.
    return f'"{name}"' in source or name.endswith("_init") and f'_name = "{name[:-5]}"' in source


def csharp(name, source=text("examples/csharp/classes/*.cs", "examples/csharp/Runtime.cs")):
    return bool(re.search(rf"\bFunctions\.{name}\b", source))


def java(name, source=text("examples/java/mien/*.java", without=("Raw.java", "RawJni.java"))):
    return bool(re.search(rf"\bRaw\.GET(?:\.|::){name}\b", source))


def java_raw(name, jni=text("examples/java/mien_jni_functions.h"), foreign=text("examples/java/foreign/mien/RawForeign.java")):
    return bool(re.search(rf"[ (\])]{name}\(", jni)) and f'"{name}"' in foreign


def cplusplus(name, source=text("include/mien/detail/*.hpp")):
    return bool(re.search(rf"\b{name}\b", source))


failed = False
unreached = [name for name in functions if not cplusplus(name)]
print(f"C++ (written by hand): {len(functions) - len(unreached)} of {len(functions)} functions" +
      (", not yet: " + ", ".join(unreached) if unreached else ""))
for language, reaches in (("C#", csharp), ("Java", java), ("Java, JNI and foreign", java_raw), ("Python", python)):
    missing = [name for name in functions if not reaches(name)]
    print(f"{language}: {len(functions) - len(missing)} of {len(functions)} functions" + (", missing: " + ", ".join(missing) if missing else ""))
    failed |= bool(missing)
sys.exit(failed)
