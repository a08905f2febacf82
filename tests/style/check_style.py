#!/usr/bin/env python3
"""What CONTRIBUTING.md promises about the sources and no compiler checks: check_style.py PROJECT [--allow-stale]

  arrows     a room includes itself and the rooms that src/CMakeLists.txt gives it; the core includes neither the C ABI nor
             the command; the command stands on the public headers alone
  circles    no header includes itself, not even by way of others
  length     no function in src over 80 lines
  solvers    whoever factorises asks info(): a decomposition is named, and its name asked as often as it is made
  command    src/cli computes no statistics: no quantiles of the normal distribution stand there
  eigen      src and abi include the parts of Eigen alone that tests/oom/base_oom.cpp has seen outlive failed allocations
  exceptions exceptions.txt lists what is excused, with a reason; a line that is not needed any more is a fault too, but
             with --allow-stale only a note
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from source_text import blank, functions

MOST_LINES = 80
QUANTILES = re.compile(r"\b(1\.96|1\.9599\d*|1\.645|1\.6448\d*|2\.576|2\.5758\d*|1\.2815\d*)\b")
# Those that can fail; QR always has an answer.
SOLVER = re.compile(r"\bEigen::(?:\w*EigenSolver|LLT|LDLT|JacobiSVD|BDCSVD|Simplicial\w+|SparseLU|SparseQR|ConjugateGradient)\s*<")
UNNAMED = re.compile(r"\.(?:llt|ldlt|jacobiSvd|bdcSvd)\(")
# cmake/MienEigen.cmake mends what these allocate; the others' blocks (sparse LU and QR, tensors) nobody has looked at.
MENDED_EIGEN = {"Core", "Dense", "Geometry", "Cholesky", "Eigenvalues", "LU", "QR", "SVD", "SparseCore", "SparseCholesky",
                "OrderingMethods", "StdVector"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+["<]([^">]+)[">]', re.M)


def rooms_below(cmake):
    """Room -> rooms that it may include, itself among them; from the mien_room() lines."""
    below = {}
    for name, on in re.findall(r"^mien_room\((\w+)([\w ]*)\)", cmake, re.M):
        missing = [room for room in on.split() if room not in below]
        if missing:
            raise SystemExit(f"src/CMakeLists.txt: room {name} stands on {missing[0]}, which comes later")
        below[name] = {name}.union(*(below[room] for room in on.split()))
    if len(below) < 2:
        raise SystemExit("src/CMakeLists.txt: no mien_room() lines found")
    return below


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".cpp", ".hpp", ".h", ".inc"))


def check_arrows(project, _):
    below = rooms_below((project / "src/CMakeLists.txt").read_text())
    # The optional trainer (src/training/CMakeLists.txt): nobody stands on it, and it draws with the command's plots.
    below["training"] = {"training"} | below.get("learning", set())
    for path in sources(project / "src"):
        where = path.relative_to(project)
        room = where.parts[1]
        for name in INCLUDE.findall(path.read_text()):
            top = name.split("/")[0]
            if room == "cli":
                if top in below or (project / "abi" / name).exists():
                    yield f"{where} includes {name}: the command stands on include/mien alone"
            elif room == "training" and name == "cli/plot.hpp":
                continue
            elif top == "mien" or name.startswith("abi/") or top == "cli":
                yield f"{where} includes {name}: the core knows neither the C ABI nor the command"
            elif top in below and top not in below.get(room, set()):
                yield f"{where} includes {name}: no arrow runs from {room} to {top} (src/CMakeLists.txt)"
        if room not in below and room != "cli":
            yield f"{where}: room {room} has no mien_room() line in src/CMakeLists.txt"


def check_circles(project, _):
    source = project / "src"
    edges = {}
    for path in sources(source):
        names = INCLUDE.findall(path.read_text())
        edges[path] = [p for n in names for p in (source / n, path.parent / n) if p.is_file()]
    state = {}

    def visit(path, trail):
        if state.get(path) == "done":
            return
        if path in trail:
            circle = trail[trail.index(path):] + [path]
            yield "circle of includes: " + " -> ".join(str(p.relative_to(source)) for p in circle)
            return
        for other in edges.get(path, []):
            yield from visit(other.resolve() if other not in edges else other, trail + [path])
        state[path] = "done"

    for path in sorted(edges):
        yield from visit(path, [])


def listed_exceptions(path):
    """(file, function or "quantile") -> reason; one per line: FILE WHAT REASON ..."""
    exceptions = {}
    for line in path.read_text().splitlines() if path.exists() else []:
        if line and not line.startswith("#"):
            file, function, reason = (line.split(None, 2) + ["", ""])[:3]
            if len(reason.split()) < 3:
                raise SystemExit(f"{path}: '{line}' gives no reason")
            exceptions[file, function] = reason
    return exceptions


def check_length(project, exceptions):
    count = 0
    for path in sources(project / "src"):
        where = str(path.relative_to(project))
        for name, first, lines in functions(path.read_text()):
            count += 1
            excepted = exceptions.pop((where, name), None) if lines > MOST_LINES else None
            if lines > MOST_LINES and excepted is None:
                yield f"{where}:{first}: {name} has {lines} lines, more than {MOST_LINES}: split it"
    if count == 0:
        yield "no function found in src: the reader of sources is broken"


def decompositions(code):
    """(offset, name) of each decomposition that is made under a name; name is None where it goes unnamed."""
    for found in SOLVER.finditer(code):
        at, depth = found.end(), 1
        while depth and at < len(code):
            depth += {"<": 1, ">": -1}.get(code[at], 0)
            at += 1
        after = re.match(r"\s*(\w+)\s*(;|\{|\((?!const ))", code[at:])
        if after:
            yield found.start(), after.group(1)
    for found in UNNAMED.finditer(code):
        yield found.start(), None


def check_solvers(project, _):
    for path in sources(project / "src") + sources(project / "abi"):
        code, where = blank(path.read_text()), path.relative_to(project)
        made = {}
        for at, name in decompositions(code):
            made.setdefault(name, []).append(code.count("\n", 0, at) + 1)
        for name, lines in made.items():
            asked = len(re.findall(rf"\b{name}(?:\.|->)info\(\)", code)) if name else 0
            if asked < len(lines):
                yield (f"{where}:{lines[asked]}: " + (f"{name}.info() is asked {asked} times of {len(lines)}" if name else
                       "a decomposition without a name: nobody can ask its info()"))


def check_command(project, exceptions):
    for path in sources(project / "src/cli"):
        where = str(path.relative_to(project))
        lines = [n for n, line in enumerate(blank(path.read_text()).splitlines(), 1) if QUANTILES.search(line)]
        if lines and exceptions.pop((where, "quantile"), None) is None:
            yield f"{where}:{lines[0]}: a quantile: intervals and limits belong to the library"


def check_eigen(project, _):
    for path in sources(project / "src") + sources(project / "abi"):
        text = path.read_text()
        # <Eigen/SVD> is swept but for this one, which takes its compiler ten seconds and which nobody needs.
        if re.search(r"BDCSVD|bdcSvd", text):
            yield f"{path.relative_to(project)} uses BDCSVD: nobody saw it outlive a failed allocation; use JacobiSVD"
        for name in INCLUDE.findall(text):
            part = name.partition("Eigen/")[2]
            if part and (name.startswith("unsupported") or part not in MENDED_EIGEN):
                yield (f"{path.relative_to(project)} includes {name}: nobody saw it outlive a failed allocation; sweep it in "
                       "tests/oom/base_oom.cpp and list it in check_style.py")


def check_stale(project, exceptions):
    """What is listed and was not needed by the checks before."""
    for file, what in exceptions:
        stale = f"tests/style/exceptions.txt: {file} {what} is no exception any more: drop the line"
        if "--allow-stale" in sys.argv[2:]:
            print("note: " + stale)
        else:
            yield stale


CHECKS = {"arrows": check_arrows, "circles": check_circles, "length": check_length, "solvers": check_solvers, "command": check_command,
          "eigen": check_eigen,
          "exceptions": check_stale}


def main():
    project = Path(sys.argv[1]).resolve()
    exceptions = listed_exceptions(project / "tests/style/exceptions.txt")
    faults = [f"{name}: {fault}" for name, check in CHECKS.items() for fault in check(project, exceptions)]
    print("\n".join(faults) or f"{len(sources(project / 'src'))} sources: no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
