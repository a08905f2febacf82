#!/usr/bin/env python3
"""Compares the declared interface with the stored baseline by abidiff.

  witness.py compare BASELINE.abi INCLUDE_DIR   exit 1 when old programs would break
  witness.py update BASELINE.abi INCLUDE_DIR    store the present interface

abidiff wants a library with full debug information, which the real one does not carry. So each
declared function gets an empty body in a small C library, the witness. That its declarations are
those of the real library is the compiler's business: a definition in abi/ that differs from its
declaration does not compile; that its names are the real ones is that of tests/abi/symbols.sh.

Allowed: new functions, and fields appended to structs that tell their size. Nothing else.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "layout"))
from layout import growable
from read_headers import read_interface

SUPPRESSION = """[suppress_type]
  type_kind = struct
  name = {name}
  has_data_member_inserted_at = end
"""


def build_witness(include, folder):
    interface = read_interface(include, strict=False)[0]
    source = "#include <mien/mien.h>\n"
    for f in interface.functions:
        parameters = ", ".join(f"{p.type} {p.name}" for p in f.parameters) or "void"
        unused = "".join(f"(void){p.name}; " for p in f.parameters)
        value = "" if f.result == "void" else "return 0; "
        source += f"{f.result} MIEN_CALL {f.name}({parameters}) {{ {unused}{value}}}\n"
    (folder / "witness.c").write_text(source)
    library = folder / "libmien.so"
    subprocess.run(["gcc", "-std=c99", "-g", "-O0", "-fPIC", "-shared", "-Wall", "-Werror", "-fno-eliminate-unused-debug-types",
                    f"-I{Path(include).parent}", "-Wl,-soname,libmien.so.0", "-o", str(library), str(folder / "witness.c")],
                   check=True)
    return library, interface


def main():
    command, baseline, include = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        library, interface = build_witness(include, folder)
        if command == "update":
            # No paths, lines or sizes of this machine in what is stored.
            subprocess.run(["abidw", "--no-show-locs", "--no-corpus-path", "--no-comp-dir-path", "--short-locs",
                            "--out-file", baseline, str(library)], check=True)
            return 0
        suppressions = folder / "growth.ini"
        suppressions.write_text("\n".join(SUPPRESSION.format(name=n) for n in sorted(growable(interface))))
        result = subprocess.run(["abidiff", "--no-architecture", "--no-added-syms", "--suppressions", str(suppressions), baseline, str(library)],
                                capture_output=True, text=True)
        print(result.stdout + result.stderr if result.returncode else
              f"{len(interface.functions)} functions; whatever was built against {Path(baseline).name} runs")
        return 1 if result.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
