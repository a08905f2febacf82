#!/usr/bin/env python3
"""Writes everything that repeats the headers: abi/interface.json, the guide to functions by task, and the bindings' declarations
and classes.

  generate_bindings.py [--check]     with --check: exit 1 when a written file is out of date
  generate_bindings.py --list        the functions that each language reaches, by the plan

The headers are read by one strict parser (read_headers.py, documentation.py); host_plan.py says how a
function looks in a language with classes; write_LANGUAGE.py writes it. By hand stand only the runtimes:
loading, ownership, errors, progress, arrays.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import write_csharp
import write_guide
import write_java
import write_python
from host_plan import make_plan
from interface import as_text
from read_headers import HeaderError, read_interface

PROJECT = Path(__file__).resolve().parent.parent


def written(plan):
    """(path, text) of every generated file."""
    yield "abi/interface.json", as_text(plan.interface)
    yield "docs/guides/functions.md", write_guide.page(plan.interface)
    yield "examples/python/mien/abi.py", write_python.abi_module(plan)
    for name, text in write_python.files(plan):
        yield f"examples/python/mien/classes/{name}.py", text
    yield "examples/csharp/Native.cs", write_csharp.native_file(plan)
    for name, text in write_csharp.files(plan):
        yield f"examples/csharp/classes/{name}.cs", text
    for name, text in write_java.files(plan):
        yield f"examples/java/mien/{name}.java", text
    yield "examples/java/mien/Raw.java", write_java.raw_interface(plan)
    yield "examples/java/mien/RawJni.java", write_java.raw_jni(plan)
    yield "examples/java/mien_jni_functions.h", write_java.jni_functions(plan)
    yield "examples/java/foreign/mien/RawForeign.java", write_java.raw_foreign(plan)


# Folders that hold nothing but written files: what is not written any more goes.
WRITTEN_FOLDERS = ("examples/python/mien/classes/*.py", "examples/csharp/classes/*.cs")


def main():
    try:
        plan = make_plan(read_interface(PROJECT / "include/mien"))
    except HeaderError as problem:
        print(problem)
        return 1
    stale, names = [], set()
    for name, text in written(plan):
        path = PROJECT / name
        names.add(path)
        if path.exists() and path.read_text() == text:
            continue
        stale.append(name)
        if "--check" not in sys.argv:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    for path in (p for folder in WRITTEN_FOLDERS for p in PROJECT.glob(folder) if p not in names):
        stale.append(str(path.relative_to(PROJECT)))
        if "--check" not in sys.argv:
            path.unlink()
    if "--check" in sys.argv and stale:
        print("out of date, run python3 abi/generate_bindings.py: " + ", ".join(stale))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
