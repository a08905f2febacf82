#!/usr/bin/env python3
"""docs/conformance.md says of every row of the feature table where it is: this reads the page and looks.

  conformance_test.py PROJECT_FOLDER MIEN_COMMAND

A function that is no exported symbol, a subcommand or option that no --help knows, a file or test that does not exist, a
row that is missing or twice, an empty cell, and "not yet" in a row that the page does not list as open are faults. Then
faults are planted into the page's text, one of each kind, and each must be found. Standard library only.
"""
import re
import subprocess
import sys
from functools import lru_cache
from pathlib import Path

ROOT, MIEN = Path(sys.argv[1]), sys.argv[2]
PAGE = ROOT / "docs/conformance.md"
ROWS = [f"J{i}" for i in range(1, 20)] + [f"K{i}" for i in range(1, 10)] + [f"B{i}" for i in range(1, 22)]
COLUMNS = ("row", "what", "functions", "command", "test", "bench", "source", "departures")
SYMBOLS = set((ROOT / "abi/symbols.txt").read_text().split())
NOT_YET = "not yet"


@lru_cache(maxsize=None)
def help_of(words):
    """The --help text of a subcommand, or None when there is no such command."""
    done = subprocess.run([MIEN, *words, "--help"], capture_output=True, text=True, timeout=60, check=False)
    # An unknown word is no usage error before --help is seen, so the usage line must name the command.
    usage = " ".join(["mien", *words])
    return done.stdout if done.returncode == 0 and re.search(rf"Usage:.*{re.escape(usage)}\b", done.stdout) else None


@lru_cache(maxsize=None)
def tests_of(path):
    """Suite.Name of every test of a C++ or Python file."""
    text = (ROOT / path).read_text(encoding="utf-8")
    if path.endswith(".py"):
        names, suite = set(), ""
        for line in text.splitlines():
            if found := re.match(r"class (\w+)", line):
                suite = found.group(1)
            elif found := re.match(r"\s+def (test_\w+)", line):
                names.add(f"{suite}.{found.group(1)}")
        return names
    return {f"{suite}.{name}" for suite, name in re.findall(r"TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", text)}


def code_in(cell):
    return re.findall(r"`([^`]+)`", cell)


def check_command(text, where):
    words = text.split()
    if words[0] != "mien":
        return []
    faults = []
    before = [w for i, w in enumerate(words[1:]) if all(not o.startswith("-") for o in words[1:i + 2])]
    for path in (before[:k + 1] for k in range(len(before))):
        if help_of(tuple(path)) is None:
            faults.append(f"{where}: there is no command 'mien {' '.join(path)}'")
            return faults
    known = help_of(tuple(before)) or ""
    if "Example" not in known and "SUBCOMMAND" not in known:
        faults.append(f"{where}: 'mien {' '.join(before)} --help' has no example")
    for option in (w for w in words if w.startswith("--")):
        if not re.search(rf"{re.escape(option)}\b", known):
            faults.append(f"{where}: 'mien {' '.join(before)}' has no option {option}")
    return faults


def check_files_and_tests(cell, where):
    faults, files = [], []
    for word in code_in(cell):
        if "/" in word and not word.startswith("mien"):
            if not (ROOT / word).exists():
                faults.append(f"{where}: there is no file {word}")
            elif word.endswith((".cpp", ".py")):
                files.append(word)
    for word in code_in(cell):
        if re.fullmatch(r"[A-Z]\w+\.\w+", word) and not any(word in tests_of(path) for path in files):
            faults.append(f"{where}: no file of the cell has a test {word}")
    return faults


def check_row(cells, is_open):
    where, faults = cells["row"], []
    for name, cell in cells.items():
        if not cell or cell in ("-", "—"):
            faults.append(f"{where}: the cell '{name}' is empty")
        if NOT_YET in cell and not is_open:
            faults.append(f"{where}: says '{NOT_YET}' and is not listed as open")
    for word in code_in(" ".join(cells.values())):
        if re.fullmatch(r"mien_\w+", word) and word not in SYMBOLS:
            faults.append(f"{where}: {word} is no function of the library")
    for word in code_in(cells["command"]):
        faults += check_command(word, where)
    faults += check_files_and_tests(cells["test"], where) + check_files_and_tests(cells["bench"], where)
    if not is_open and not re.search(r"`mien_\w+`", cells["functions"]):
        faults.append(f"{where}: names no function")
    if not is_open and not code_in(cells["test"]):
        faults.append(f"{where}: names no test")
    return faults


def faults_of(text):
    open_rows = set(re.findall(r"\b[JKB]\d+\b", next((line for line in text.splitlines() if line.startswith("Open:")), "")))
    faults, seen = [], []
    for line in text.splitlines():
        if not re.match(r"\| [JKB]\d+ \|", line):
            continue
        cells = [c.strip() for c in line.strip().strip("|").split("|")]
        if len(cells) != len(COLUMNS):
            faults.append(f"{cells[0]}: {len(cells)} cells, {len(COLUMNS)} are needed")
            continue
        seen.append(cells[0])
        faults += check_row(dict(zip(COLUMNS, cells)), cells[0] in open_rows)
    faults += [f"{row}: has no row" for row in ROWS if row not in seen]
    faults += [f"{row}: has {seen.count(row)} rows" for row in sorted(set(seen)) if seen.count(row) > 1]
    faults += [f"{row}: is listed as open and has no '{NOT_YET}'" for row in sorted(open_rows)
               if not any(line.startswith(f"| {row} |") and NOT_YET in line for line in text.splitlines())]
    return faults


def planted(text):
    """Texts with one fault each, and what the finding must say."""
    row = next(line for line in text.splitlines() if line.startswith("| J6 |"))
    cells = row.split("|")

    def with_cell(index, value):
        changed = list(cells)
        changed[index] = value
        return text.replace(row, "|".join(changed))

    yield text.replace(row + "\n", ""), "J6: has no row"
    yield text.replace(row, row + "\n" + row), "J6: has 2 rows"
    yield with_cell(3, " `mien_model_fitt` "), "mien_model_fitt is no function"
    yield with_cell(3, " "), "the cell 'functions' is empty"
    yield with_cell(4, " `mien model fitt` "), "no command 'mien model fitt'"
    yield with_cell(4, " `mien model fit --rigde` "), "no option --rigde"
    yield with_cell(5, " `tests/unit/model/no_such_test.cpp` "), "no file tests/unit/model/no_such_test.cpp"
    yield with_cell(5, " `tests/unit/model/known_fit_test.cpp` `KnownFit.IsNothing` "), "has a test KnownFit.IsNothing"
    yield with_cell(6, " `tests/bench/nothing.cpp` "), "no file tests/bench/nothing.cpp"
    yield with_cell(8, f" {NOT_YET} "), "not listed as open"


def main():
    text = PAGE.read_text(encoding="utf-8")
    faults = faults_of(text)
    for fault in faults:
        print(f"docs/conformance.md: {fault}")
    missed = 0
    for changed, expected in planted(text):
        found = faults_of(changed)
        if changed == text or not any(expected in fault for fault in found):
            print(f"a planted fault was not found: {expected} (found: {found})")
            missed += 1
    print(f"{len(ROWS)} rows, {len(faults)} faults, {missed} planted faults missed")
    return 1 if faults or missed else 0


if __name__ == "__main__":
    sys.exit(main())
