#!/usr/bin/env python3
"""Writes docs/guides/traceability.md from docs/guides/requirements.json: requirement, tests, files.

  trace_requirements.py [PROJECT_DIR] [--check]

A test is "Suite.Name" of GoogleTest or the name of a CTest test. One that does not exist in the sources, a requirement
without a test or a number given twice is an error. --check: exit 1 when the page is out of date.
"""
import json
import re
import sys
from pathlib import Path

HEAD = """# Requirements and tests

Written by `tests/docs/trace_requirements.py` from `docs/guides/requirements.json`. Each test exists in the sources and runs with
`sh tests/run.sh`; a name with a dot is a case of GoogleTest, another one is a test of CTest.

"""


def known_tests(project):
    """Name -> the file that defines it."""
    found = {}
    for path in sorted((project / "tests").rglob("*.cpp")):
        for suite, name in re.findall(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", path.read_text(), re.M):
            found.setdefault(f"{suite}.{name}", path)
    for path in sorted([*(project / "tests").rglob("CMakeLists.txt"), *(project / "tests").rglob("*.cmake")]):
        for name in re.findall(r"add_test\(\s*(?:NAME\s+)?(\w+)\b(?!\$)", path.read_text()):
            found.setdefault(name, path)
    return found


def page(project):
    requirements = json.loads((project / "docs/guides/requirements.json").read_text())
    tests, problems, seen, rows, area = known_tests(project), [], set(), [HEAD.rstrip("\n")], None
    for entry in requirements:
        if entry["id"] in seen:
            problems.append(f"{entry['id']}: given twice")
        seen.add(entry["id"])
        if not entry["tests"]:
            problems.append(f"{entry['id']}: no test")
        missing = [name for name in entry["tests"] if name not in tests]
        problems += [f"{entry['id']}: there is no test {name}" for name in missing]
        if missing:
            continue
        if entry["area"] != area:
            area = entry["area"]
            rows += ["", f"## {area}", "", "| | requirement | tests |", "|---|---|---|"]
        named = "; ".join(f"`{name}` in `{tests[name].relative_to(project).as_posix()}`" for name in entry["tests"])
        rows.append(f"| {entry['id']} | {entry['requirement']} | {named} |")
    return "\n".join(rows) + "\n", problems, len(seen)


def main():
    arguments = [a for a in sys.argv[1:] if not a.startswith("--")]
    project = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent.parent
    text, problems, count = page(project)
    path = project / "docs/guides/traceability.md"
    if not problems and "--check" not in sys.argv:
        path.write_text(text)
    elif not problems and (not path.exists() or path.read_text() != text):
        problems = ["docs/guides/traceability.md is out of date: run python3 tests/docs/trace_requirements.py"]
    print("\n".join(problems) or f"{count} requirements, each traced to tests")
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main())
