#!/usr/bin/env python3
"""The guides say what is true: their blocks compile and run, their links lead somewhere, and they leave out nothing.

  guides_test.py words PROJECT_DIR                               links, statuses, functions (seconds)
  guides_test.py compile PROJECT_DIR                             every ```c and ```cpp block against the headers
  guides_test.py run PROJECT_DIR MIEN DEMO_DATA LIBRARY WORK_DIR every ```sh and ```python block, in the order of the index

A block of C that includes mien/mien.h is a program; one that begins with a function is that function; others are
statements, which find the handles of FRAME. Exit 77: nothing to run with.
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

project = Path(sys.argv[2]).resolve()
guides = project / "docs/guides"
problems = []

FRAME = """#include <mien/mien.h>
#include <stdio.h>
#include <stdlib.h>
{functions}
int block(mien_session* session, const mien_model* face, const mien_expression_model* expressions, const mien_mesh* scan,
          const mien_registration* fitted, const mien_registration* first_fit, const mien_registration* second_fit);
int block(mien_session* session, const mien_model* face, const mien_expression_model* expressions, const mien_mesh* scan,
          const mien_registration* fitted, const mien_registration* first_fit, const mien_registration* second_fit) {{
    mien_error error = {{.struct_size = sizeof error}};
    (void)session, (void)face, (void)expressions, (void)scan, (void)fitted, (void)first_fit, (void)second_fit, (void)error;
{statements}
    return 0;
}}
"""
FRAME_CPP = "#include <mien/mien.hpp>\n#include <stdexcept>\nvoid block();\nvoid block() {{\n{statements}\n}}\n"


def blocks(page, *languages):
    """(line, language, text) of the fenced blocks in these languages."""
    found, start, language = [], None, ""
    lines = page.read_text().split("\n")
    for number, line in enumerate(lines):
        fence = re.fullmatch(r"```([\w+]*)", line)
        if fence and start is None:
            start, language = number + 1, fence.group(1)
        elif fence:
            if language in languages:
                found.append((start + 1, language, "\n".join(lines[start:number])))
            start = None
    if start is not None:
        problems.append(f"{page.name}:{start}: a block without an end")
    return found


def ordered_pages():
    """The pages in the order of the index; each must be named there."""
    named = re.findall(r"\]\(([\w-]+\.md)\)", (guides / "README.md").read_text())
    pages = [guides / name for name in dict.fromkeys(named)]
    for page in sorted(guides.glob("*.md")):
        if page not in pages and page.name != "README.md":
            problems.append(f"README.md does not name {page.name}")
    return [page for page in pages if page.exists()]


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def check_links():
    count = 0
    # Every page of the project; cmake/archive-README.md links from inside the archive, where other folders lie.
    listed = subprocess.run(["git", "-C", str(project), "ls-files", "*.md"], capture_output=True, text=True).stdout.split()
    pages = [project / name for name in listed if name != "cmake/archive-README.md"]
    pages = pages or [project / "README.md", *sorted((project / "docs").rglob("*.md"))]  # unpacked without git
    for page in pages:
        text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.S | re.M)
        for target in re.findall(r"\]\(([^)\s]+)\)", text):
            if re.match(r"[a-z]+://|mailto:", target):
                continue
            count += 1
            path, _, anchor = target.partition("#")
            file = page.parent / path if path else page
            if not file.exists():
                problems.append(f"{page.relative_to(project)}: {target} leads nowhere")
            elif anchor and anchor not in [slug(h) for h in re.findall(r"^#+ (.+)$", file.read_text(), re.M)]:
                problems.append(f"{page.relative_to(project)}: {target} names no heading")
    print(f"{count} relative links in {len(pages)} pages")


def check_completeness():
    text = "\n".join(page.read_text() for page in sorted(guides.glob("*.md")))
    examples = "\n".join(p.read_text() for folder in ("c", "cpp") for p in sorted((project / "examples" / folder).glob("*.c*")))
    functions = (project / "abi/symbols.txt").read_text().split()
    missing = [name for name in functions if not re.search(rf"\b{name}\b", text + examples)]
    problems.extend(f"no guide and no example names {name}()" for name in missing)
    print(f"{len(functions) - len(missing)} of {len(functions)} public functions are named by a guide or an example")
    statuses = re.findall(r"\b(MIEN_(?:OK|E_\w+))\b +?= ?", re.sub(r"\s+", " ", (project / "include/mien/error.h").read_text()))
    rows = set(re.findall(r"^\| `(MIEN_\w+)` \|", (guides / "errors.md").read_text(), re.M))
    problems.extend(f"errors.md has no row for {name}" for name in statuses if name not in rows)
    problems.extend(f"errors.md has a row for {name}, which error.h does not have" for name in rows - set(statuses))
    print(f"{len(statuses)} statuses, each with a row in errors.md")
    known = set(re.findall(r"\b(?:mien|MIEN)_\w+", "\n".join(p.read_text() for p in sorted((project / "include/mien").glob("*.h")))))
    for page in sorted(guides.glob("*.md")):
        for word in sorted(set(re.findall(r"\b(?:mien_\w+|MIEN_[A-Z]\w+)\b", page.read_text())) - known):
            if not word.endswith("_") and word not in ("MIEN_STATIC", "MIEN_LIBRARY"):
                problems.append(f"{page.name} names {word}, which no header declares")


def source_of(language, text):
    if "#include" in text:
        return text
    if language == "cpp":
        return FRAME_CPP.format(statements=text)
    function = re.match(r"(?:static )?\w+ (\w+)\(.*\) \{", text)
    if function:
        return FRAME.format(functions=text, statements=f"    (void){function.group(1)};")
    return FRAME.format(functions="", statements=text)


def compile_blocks():
    count = 0
    for page in ordered_pages():
        for line, language, text in blocks(page, "c", "cpp"):
            count += 1
            compiler = ["c++", "-std=c++17", "-xc++"] if language == "cpp" else ["cc", "-std=c99", "-pedantic", "-xc"]
            result = subprocess.run([*compiler, "-fsyntax-only", "-Wall", "-Wextra", "-Werror", f"-I{project}/include", "-"],
                                    input=source_of(language, text), capture_output=True, text=True)
            if result.returncode:
                problems.append(f"{page.name}:{line}: {result.stderr}")
    print(f"{count} blocks of C and C++ compiled")
    if count == 0:
        problems.append("no block of C or C++ was found")


def run_blocks(mien, demo_data, library, work):
    python = next((p for p in (sys.executable, "/usr/bin/python3")
                   if subprocess.run([p, "-c", "import numpy"], capture_output=True).returncode == 0), None)
    if python is None:
        print("skipped: no Python with numpy")
        sys.exit(77)
    shutil.rmtree(work, ignore_errors=True)
    (work / "bin").mkdir(parents=True)
    for name, program in (("mien", mien), ("mien-demo-data", demo_data)):
        (work / "bin" / name).symlink_to(Path(program).resolve())
    environment = dict(os.environ, PATH=f"{work / 'bin'}:{os.environ['PATH']}", MIEN_LIBRARY=str(Path(library).resolve()),
                       PYTHONPATH=str(project / "examples/python"), PYTHONDONTWRITEBYTECODE="1")
    told, counts = "", {"sh": 0, "python": 0}
    for page in ordered_pages():
        for line, language, text in blocks(page, "sh", "python"):
            counts[language] += 1
            if language == "python":  # one program over all pages, run once more from its beginning at the end
                told += f"# {page.name}:{line}\n{text}\n"
                continue
            result = subprocess.run(["sh", "-eu", "-c", text], cwd=work, env=environment, capture_output=True, text=True)
            print(f"{page.name}:{line}: exit {result.returncode}")
            if result.returncode:
                problems.append(f"{page.name}:{line}: {text}\n{result.stdout[-2000:]}{result.stderr[-2000:]}")
                return
    (work / "guides.py").write_text(told)
    result = subprocess.run([python, "guides.py"], cwd=work, env=environment, capture_output=True, text=True)
    print(f"{counts['sh']} shell and {counts['python']} Python blocks run\n{result.stdout}")
    if result.returncode:
        problems.append(f"the Python blocks: {result.stderr}")
    if not all(counts.values()):
        problems.append("no shell or no Python block was found")
    for name in ("fitted.ply", "neutral.ply", "report.html", "error.png"):
        if not (work / name).is_file() or (work / name).stat().st_size == 0:
            problems.append(f"the guides' commands made no {name}")
    zones = json.loads((work / "report.json").read_text())["visits"][1]["zones"]
    if not zones:
        problems.append("the guides' report has no zone")


def check_commands(mien):
    """Commands outside of the guides, which are too long to run here: each names a command and options that there are."""
    pages = [project / name for name in ("README.md", "cmake/archive-README.md", "docs/networks.md", "docs/algorithms.md", "CHANGELOG.md")]
    count, helps = 0, {}
    for page in pages:
        for line, _, text in blocks(page, "sh"):
            for command in re.findall(r"^(?:bin/)?mien (.*)$", re.sub(r"\\\n\s*", " ", text), re.M):
                words = re.sub(r"[|;#].*", "", command).split()
                path = tuple(word for k, word in enumerate(words[:2]) if re.fullmatch(r"[a-z][a-z-]+", word) and not any(w.startswith("-") for w in words[:k]))
                if path not in helps:
                    done = subprocess.run([mien, *path, "--help"], capture_output=True, text=True)
                    helps[path] = done.stdout if done.returncode == 0 else ""
                known = set(re.findall(r"--[\w-]+", helps[path]))
                unknown = [word for word in words if word.startswith("--") and word.split("=")[0] not in known]
                if unknown or not helps[path]:
                    problems.append(f"{page.relative_to(project)}:{line}: mien {' '.join(path)} knows no {', '.join(unknown) or 'such command'}")
                count += 1
    print(f"{count} commands of other pages name what there is")
    if count < 5:
        problems.append("no commands were found in the README")


def main():
    mode = sys.argv[1]
    if mode == "words":
        ordered_pages()
        check_links()
        check_completeness()
    elif mode == "compile":
        compile_blocks()
    else:
        check_commands(sys.argv[3])
        run_blocks(*sys.argv[3:6], Path(sys.argv[6]).resolve())
    print("\n".join(problems))
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main())
