#!/usr/bin/env python3
"""Holds the Conan recipe against CMake, on machines without Conan.

  check_recipe.py PROJECT_DIR

The recipe runs with stand-ins for Conan's classes: its version must be CMake's, its requirements
must be the packages that CMake looks for, in versions that CMake accepts, its options must exist
there, and CMake must accept the exported files alone.
"""
import ast
import fnmatch
import re
import shutil
import subprocess
import sys
import tempfile
import types
from pathlib import Path

# Conan's reference name, and CMake's package name, where they are not the same word.
PACKAGES = {"eigen": "Eigen3", "openmesh": "OpenMesh", "cli11": "CLI11", "libpng": "PNG",
            "libjpeg-turbo": "JPEG", "zlib": "ZLIB"}
faults = []


def check(good, fault):
    if not good:
        faults.append(fault)


class Settings(types.SimpleNamespace):
    def get_safe(self, name):
        return getattr(self, name, None)

    def rm_safe(self, name):
        self.__dict__.pop(name, None)


class StandIn:
    """What the recipe needs of conan.ConanFile, recording what it asks for."""
    def __init__(self, folder, exported, shared, cli, system, images=True):
        self.recipe_folder, self.export_sources_folder = str(folder), str(exported)
        self.version = None
        options = Settings(shared=shared, fPIC=True, cli=cli, images=images)
        self.options = options
        self.settings = Settings(os=system, compiler=Settings(cppstd="17", libcxx="libstdc++11"))
        self.info = Settings(options=options, settings=Settings(compiler=Settings(cppstd="17", libcxx="libstdc++11")))
        self.required, self.tools = {}, []
        self.cpp_info = types.SimpleNamespace(properties={}, system_libs=[], requires=[], defines=[])
        self.cpp_info.set_property = self.cpp_info.properties.__setitem__

    def requires(self, reference, **traits):
        name, version = reference.split("/")
        self.required[name] = (version, traits)

    def tool_requires(self, reference):
        self.tools.append(reference)


def copy_tool(_, pattern, source, target):
    for path in Path(source).rglob("*"):
        relative = path.relative_to(source).as_posix()
        if path.is_file() and fnmatch.fnmatch(relative, pattern) and "__pycache__" not in relative:
            destination = Path(target) / relative
            destination.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, destination)


class Toolchain:
    last = None

    def __init__(self, _):
        self.cache_variables = {}
        Toolchain.last = self

    def generate(self):
        pass


class Dependencies:
    def __init__(self, _):
        pass

    def generate(self):
        pass


def install_stand_ins():
    tools = {"conan": {"ConanFile": StandIn},
             "conan.tools": {},
             "conan.tools.build": {"check_min_cppstd": lambda *_: None, "stdcpp_library": lambda _: "stdc++", "can_run": lambda _: True},
             "conan.tools.cmake": {"CMake": object, "CMakeDeps": Dependencies, "CMakeToolchain": Toolchain, "cmake_layout": lambda _: None},
             "conan.tools.files": {"copy": copy_tool, "load": lambda _, path: Path(path).read_text()}}
    for name, content in tools.items():
        module = types.ModuleType(name)
        module.__dict__.update(content)
        sys.modules[name] = module


def version_tuple(text):
    return tuple(int(n) for n in re.findall(r"\d+", text)[:3])


def main():
    project = Path(sys.argv[1])
    for file in (project / "conan/conanfile.py", project / "conan/test_package/conanfile.py"):
        ast.parse(file.read_text())
    lists = "\n".join(p.read_text() for p in [project / "CMakeLists.txt", *(project / "src").rglob("CMakeLists.txt"),
                                               *(project / "abi").rglob("CMakeLists.txt")])
    install_stand_ins()
    recipe = {}
    exec(compile((project / "conan/conanfile.py").read_text(), "conanfile.py", "exec"), recipe)
    exec(compile((project / "conan/test_package/conanfile.py").read_text(), "test_package", "exec"), {})
    Recipe = recipe["MienConan"]

    with tempfile.TemporaryDirectory() as name:
        exported = Path(name) / "exported"
        conan = Recipe(project / "conan", exported, shared=True, cli=True, system="Linux")
        conan.set_version()
        cmake_version = re.search(r"project\(mien VERSION ([0-9.]+)", lists).group(1)
        header = (project / "include/mien/config.h").read_text()
        header_version = re.search(r'MIEN_VERSION_STRING "(.*)"', header).group(1)
        check(conan.version == cmake_version == header_version,
              f"versions differ: recipe {conan.version}, CMake {cmake_version}, header {header_version}")
        check(f'DESCRIPTION "{conan.description}"' in lists, "the description differs from CMake's")

        conan.requirements()
        conan.build_requirements()
        wanted = dict(re.findall(r"find_package\((\w+)(?: ([0-9.]+))?", lists))
        wanted.pop("Torch", None)  # for the trainer alone, which no package holds
        provided = {PACKAGES.get(n, n): v for n, (v, _) in conan.required.items()}
        for package in wanted.keys() - {"Threads"} - provided.keys():
            faults.append(f"CMake looks for {package}, the recipe does not require it")
        for package in provided.keys() - wanted.keys():
            faults.append(f"the recipe requires {package}, CMake does not look for it")
        for package, version in wanted.items():
            if version and package in provided:
                check(version_tuple(provided[package]) >= version_tuple(version),
                      f"{package} {provided[package]} is older than CMake's {version}")
        check(all(not traits.get("transitive_headers") for _, traits in conan.required.values()), "headers leak to consumers")
        minimum = re.search(r"cmake_minimum_required\(VERSION ([0-9.]+)", lists).group(1)
        check(any(minimum in tool for tool in conan.tools), f"the tool requirement does not ask for CMake {minimum}")

        # The identity of a package, as the C interface allows.
        conan.package_id()
        compiler = conan.info.settings.compiler
        check(not hasattr(compiler, "cppstd") and not hasattr(compiler, "libcxx"), "a shared package depends on cppstd or libcxx")
        static = Recipe(project / "conan", exported, shared=False, cli=False, system="Linux", images=False)
        static.package_id()
        check(hasattr(static.info.settings.compiler, "libcxx"), "a static package forgets libcxx")
        static.requirements()
        check("cli11" not in static.required, "a package without the command requires cli11")
        check(not static.required.keys() & {"libjpeg-turbo", "libpng", "zlib"}, "a package without images requires their decoders")
        static.package_info()
        check("MIEN_STATIC" in static.cpp_info.defines and "stdc++" in static.cpp_info.system_libs, "a static package does not link from C")
        windows = Recipe(project / "conan", exported, shared=True, cli=True, system="Windows")
        windows.config_options()
        windows.configure()
        check(not hasattr(windows.options, "fPIC"), "fPIC stays on Windows")
        conan.package_info()
        check(conan.cpp_info.properties.get("cmake_target_name") == "mien::mien", "the CMake target is not mien::mien")
        check(conan.cpp_info.properties.get("pkg_config_name") == "mien", "the pkg-config name is not mien")

        conan.generate()
        conan.export_sources()
        variables = Toolchain.last.cache_variables
        for variable in variables:
            check(f"option({variable} " in lists, f"CMake has no option {variable}")
        result = subprocess.run(["cmake", "-S", str(exported), "-B", name + "/build"] +
                                [f"-D{key}={'ON' if value else 'OFF'}" for key, value in variables.items()],
                                capture_output=True, text=True)
        check(result.returncode == 0, "CMake refuses the exported files:\n" + result.stderr[-2000:])
        files = sum(1 for p in exported.rglob("*") if p.is_file())
    print("\n".join(faults) if faults else f"mien/{conan.version}: {len(conan.required)} requirements, {files} exported files, CMake agrees")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
