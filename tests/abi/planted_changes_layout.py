#!/usr/bin/env python3
"""Proves that the two ABI gates can fail: plants changes into a copy of the headers and asks them.

  planted_changes_layout.py PROJECT_DIR

Unsafe changes must be caught, safe ones must pass: in the layout gate (abi/layout), in the abidiff
gate (abi/baseline), or in both, as the table says.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

project = Path(sys.argv[1])
sys.path.insert(0, str(project / "abi"))
sys.path.insert(0, str(project / "abi" / "layout"))
from layout import growable
from read_headers import read_interface


def edit(header, pattern, replacement):
    def apply(include):
        path = include / header
        text, count = re.subn(pattern, replacement, path.read_text(), count=1, flags=re.S)
        assert count == 1, f"nothing to plant in {header}"
        path.write_text(text)
    return apply


def into_struct(struct, where):
    """Adds a field after the second field ("middle") or behind the last one ("end")."""
    body = r"(typedef struct %s \{(?:[^;{}]*;){2})" if where == "middle" else r"(typedef struct %s \{[^{}]*?)(?=\n\})"
    return edit(struct.header, body % struct.name, r"\1\n    uint64_t planted;")


def planted_changes(interface):
    """(name, edit, caught by the layout gate, caught by the abidiff gate)"""
    structs = {struct.name: struct for struct in interface.structs}
    yield "nothing", lambda include: None, False, False
    yield "insertion in the middle", into_struct(structs["mien_session_options"], "middle"), True, True
    yield "append at the end", into_struct(structs["mien_session_options"], "end"), False, False
    yield "growth of a struct without a size", into_struct(structs["mien_array_view"], "end"), True, True
    yield "fields swapped", edit("mesh.h", r"(uint64_t count;[^\n]*\n)(\s*uint64_t stride_bytes;[^\n]*\n)", r"\2\1"), True, True
    yield "a constant renumbered", edit("error.h", r"MIEN_E_IO = -9", "MIEN_E_IO = -99"), True, False
    yield "a parameter of another type", edit("mesh.h", r"uint64_t capacity", "int64_t capacity"), False, True
    yield "a function removed", edit("mesh.h", r"/\*\*(?:(?!\*/).)*\*/\nMIEN_API void MIEN_CALL mien_mesh_release\([^)]*\);\n", ""), False, True
    yield "a function added", edit("mesh.h", r"(MIEN_API void MIEN_CALL mien_mesh_release)", r"MIEN_API void MIEN_CALL mien_mesh_planted(void);\n\1"), False, False


def caught(script, *arguments):
    result = subprocess.run([sys.executable, str(project / "abi" / script), *arguments], capture_output=True, text=True)
    if result.returncode not in (0, 1) or "Traceback" in result.stderr:
        raise SystemExit(result.stdout + result.stderr)
    return result.returncode == 1


def main():
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # The present headers are the baseline here, so that this test stays about the gates alone.
        snapshot, baseline = folder / "layout.txt", folder / "baseline.abi"
        include = project / "include" / "mien"
        printed = subprocess.run([sys.executable, str(project / "abi/layout/layout.py"), "print", str(include), "gcc"],
                                 check=True, capture_output=True, text=True).stdout
        snapshot.write_text(printed)
        has_abidiff = shutil.which("abidiff") is not None
        if has_abidiff:
            subprocess.run([sys.executable, str(project / "abi/baseline/witness.py"), "update", str(baseline), str(include)],
                           check=True)
        interface = read_interface(include)

        def judge(title, plant, layout_catches, abidiff_catches):
            copy = folder / "planted" / "mien"
            shutil.copytree(include, copy)
            plant(copy)
            verdicts = [("layout", layout_catches, caught("layout/layout.py", "compare", str(snapshot), str(copy), "gcc"))]
            if has_abidiff and abidiff_catches is not None:
                verdicts.append(("abidiff", abidiff_catches, caught("baseline/witness.py", "compare", str(baseline), str(copy))))
            shutil.rmtree(copy)
            wrong = [gate for gate, expected, found in verdicts if expected != found]
            print(f"{'FAILED' if wrong else 'ok    '} {title}: " +
                  ", ".join(f"{gate} {'catches' if found else 'passes'}" for gate, _, found in verdicts))
            return bool(wrong)

        for change in planted_changes(interface):
            failed += judge(*change)
        # Every struct that may grow, in the quick gate.
        growing = growable(interface)
        for struct in interface.structs:
            if struct.name in growing:
                failed += judge(f"{struct.name}, middle", into_struct(struct, "middle"), True, None)
                failed += judge(f"{struct.name}, end", into_struct(struct, "end"), False, None)
    if not has_abidiff:
        print("skipped: no abidiff (Debian package abigail-tools)")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
