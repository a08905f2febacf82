"""The compiler's flags of each source of the project, from a build folder's compile_commands.json."""
import json
import shlex
from pathlib import Path

WITH_VALUE = ("-isystem", "-I", "-D", "-x")
DROPPED_WITH_VALUE = ("-o", "-include", "-MF", "-MT", "-MQ")


class Commands:
    def __init__(self, project, build):
        self.project, self.flags = Path(project).resolve(), {}
        database = Path(build) / "compile_commands.json"
        for entry in json.loads(database.read_text()):
            path = Path(entry["directory"], entry["file"]).resolve()
            if "cmake_pch" in path.name or "unity_" in path.name or path.suffix == ".c":
                continue
            self.flags[path] = self._flags(shlex.split(entry["command"]))
        if not self.flags:
            raise SystemExit(f"{database}: no file compiles one by one here; take another preset than joined")

    @staticmethod
    def _flags(words):
        """Include folders, definitions, language and machine: what any compiler needs and understands."""
        kept, k = [], 0
        while k < len(words):
            word = words[k]
            if word in DROPPED_WITH_VALUE:
                k += 1
            elif word in WITH_VALUE and k + 1 < len(words):
                kept += [word, words[k + 1]]
                k += 1
            elif word.startswith(("-I", "-D", "-std=", "-m", "-isystem")):
                kept.append(word)
            k += 1
        return kept

    def sources(self, *folders):
        """Sources below the folders that the build compiles, in order."""
        roots = [self.project / folder for folder in folders]
        return sorted(p for p in self.flags if any(root in p.parents for root in roots))

    def of_header(self, header):
        """A header compiles with the flags of a source beside it, or of the room's first one."""
        near = sorted(p for p in self.flags if p.parent == header.parent)
        if not near:
            near = [p for p in sorted(self.flags) if (self.project / "abi") in p.parents]
        return self.flags[near[0]]
