#!/usr/bin/env python3
"""check_style.py finds what it is there for: each kind of fault is planted in a small project of its own."""
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
CLEAN = {
    "src/CMakeLists.txt": "mien_room(base)\nmien_room(mesh base)\nmien_room(model mesh)\n",
    "src/base/error.hpp": "#pragma once\nnamespace mien {\nint fail(int status = {1}[0]);\n}\n",
    "src/mesh/mesh.hpp": '#pragma once\n#include "base/error.hpp"\nstruct Mesh { int n = 0; };\n',
    "src/mesh/mesh.cpp": '#include "mesh/mesh.hpp"\nint f(int a) {\n    return a;  // 1.96 {\n}\n',
    "src/model/model.cpp": '#include "mesh/mesh.hpp"\n#include "base/error.hpp"\n',
    "src/cli/main.cpp": '#include <mien/mien.hpp>\n#include "commands.hpp"\nint main() { return 0; }  // 1.96\n',
    "src/cli/commands.hpp": "#pragma once\n",
}
LONG = "int g(int a) {\n" + "    ++a;\n" * 79 + "    return a;\n}\n"
LONG_MEMBER = "struct S {\n    S() : a_{1}, b_(2) {\n" + "        ++b_;\n" * 80 + "    }\n    int a_, b_;\n};\n"
SOLVES = ("struct S { Eigen::LLT<Matrix> factor; };\nint f(S& s) { return s.factor.info(); }\n"
          "int g() {\n    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(a);\n    if (factor.info()) return 0;\n    return 1;\n}\n")
PLANTED = {
    "an arrow upward": ({"src/mesh/mesh.cpp": '#include "model/model.hpp"\n'}, "no arrow runs from mesh to model"),
    "the C ABI in the core": ({"src/base/error.cpp": "#include <mien/mien.h>\n"}, "the core knows neither"),
    "the core in the command": ({"src/cli/main.cpp": '#include "mesh/mesh.hpp"\n'}, "stands on include/mien alone"),
    "a room without a line": ({"src/attic/a.cpp": "int a;\n"}, "has no mien_room() line"),
    "a circle": ({"src/base/error.hpp": '#include "base/other.hpp"\n', "src/base/other.hpp": '#include "base/error.hpp"\n'},
                 "circle of includes"),
    "a long function": ({"src/mesh/long.cpp": LONG}, "g has 82 lines"),
    "a long constructor": ({"src/mesh/long.cpp": LONG_MEMBER}, "has 82 lines"),
    "an unasked solver": ({"src/mesh/solve.cpp": SOLVES.replace("if (factor.info()) return 0;", "")}, "factor.info() is asked 1 times of 2"),
    "an unnamed solver": ({"src/mesh/solve.cpp": "int f(M a) { return a.ldlt().solve(1); }\n"}, "without a name"),
    "a stale exception": ({"tests/style/exceptions.txt": "src/mesh/mesh.cpp f one tight loop\n"}, "is no exception any more"),
    "an exception without a reason": ({"tests/style/exceptions.txt": "src/mesh/mesh.cpp f\n"}, "gives no reason"),
    "a part of Eigen that leaks": ({"src/mesh/solve.cpp": "#include <Eigen/SparseLU>\n"}, "outlive a failed allocation"),
    "a decomposition that nobody swept": ({"src/mesh/solve.cpp": "Eigen::BDCSVD<Matrix> svd;\n"}, "use JacobiSVD"),
    "a foreign Eigen in the ABI": ({"abi/a.cpp": "#include <unsupported/Eigen/MatrixFunctions>\n"}, "outlive a failed"),
    "a quantile in the command": ({"src/cli/main.cpp": "double limit(double s) { return 1.96 * s; }\n"}, "a quantile"),
}
EXCUSED = {"src/mesh/long.cpp": LONG, "tests/style/exceptions.txt": "src/mesh/long.cpp g it is a table of steps\n"}


def verdict(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**CLEAN, **files}.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        run = subprocess.run([sys.executable, str(HERE / "check_style.py"), folder], capture_output=True, text=True)
        return run.returncode, run.stdout + run.stderr


failures = 0
for what, files in (("a clean project", {}), ("a long function with a reason", EXCUSED),
                    ("solvers that are asked", {"src/mesh/solve.cpp": SOLVES})):
    code, text = verdict(files)
    if code:
        print(f"FAILED: {what} is refused:\n{text}")
        failures += 1
for what, (files, expected) in PLANTED.items():
    code, text = verdict(files)
    if code == 0 or expected not in text:
        print(f"FAILED: {what} gives {code}:\n{text}")
        failures += 1
print(f"{len(PLANTED)} faults planted, {failures} failures")
sys.exit(1 if failures else 0)
