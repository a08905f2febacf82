#!/usr/bin/env python3
"""Runs the vcpkg port with vcpkg's functions replaced by ones that look: check_port.py PROJECT_DIR CMAKE

Checked: the manifest's version, licence and dependencies against CMakeLists.txt, that every option that the port sets is one
of the project's, that each feature's option is set with it, and that the files that the port moves are those that are installed.
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

project, cmake = Path(sys.argv[1]).resolve(), sys.argv[2]
port = project / "vcpkg/mien"
manifest = json.loads((port / "vcpkg.json").read_text())
lists = (project / "CMakeLists.txt").read_text()
command = (project / "src/cli/CMakeLists.txt").read_text()
# What find_package() asks for, by vcpkg's names.
NAMES = {"Eigen3": "eigen3", "OpenMesh": "openmesh", "nlohmann_json": "nlohmann-json", "JPEG": "libjpeg-turbo", "PNG": "libpng",
         "ZLIB": "zlib", "CLI11": "cli11"}
SYSTEM = {"Threads", "Torch"}

STUBS = """
cmake_minimum_required(VERSION 3.25)
function(vcpkg_check_features)
    cmake_parse_arguments(PARSE_ARGV 0 a "" "OUT_FEATURE_OPTIONS" "FEATURES")
    set(options "")
    while(a_FEATURES)
        list(POP_FRONT a_FEATURES feature option)
        if(feature IN_LIST FEATURES)
            list(APPEND options "-D${option}=ON")
        else()
            list(APPEND options "-D${option}=OFF")
        endif()
    endwhile()
    set(${a_OUT_FEATURE_OPTIONS} "${options}" PARENT_SCOPE)
endfunction()
function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 a "" "SOURCE_PATH" "OPTIONS")
    if(NOT EXISTS "${a_SOURCE_PATH}/CMakeLists.txt")
        message(FATAL_ERROR "no project in ${a_SOURCE_PATH}")
    endif()
    message(STATUS "configure ${a_OPTIONS}")
endfunction()
function(vcpkg_cmake_install)
endfunction()
function(vcpkg_cmake_config_fixup)
    message(STATUS "config ${ARGN}")
endfunction()
function(vcpkg_fixup_pkgconfig)
endfunction()
function(vcpkg_copy_tools)
    message(STATUS "tools ${ARGN}")
endfunction()
function(vcpkg_install_copyright)
    message(STATUS "copyright ${ARGN}")
endfunction()
"""


def fail(text):
    raise SystemExit(f"FAILED: {text}")


def run_port(features):
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "run.cmake"
        script.write_text(STUBS + f'set(FEATURES "{";".join(features)}")\nset(PORT mien)\nset(CURRENT_PACKAGES_DIR "{folder}/packages")\n'
                          f'set(CURRENT_PORT_DIR "{port}")\ninclude("{port}/portfile.cmake")\n')
        done = subprocess.run([cmake, "-P", script], capture_output=True, text=True)
        if done.returncode != 0:
            fail(done.stderr)
        if not (Path(folder) / "packages/share/mien/usage").exists():
            fail("the port installs no usage")
        return done.stdout


version = re.search(r"project\(mien VERSION ([0-9.]+)", lists).group(1)
if manifest["version"] != version:
    fail(f"vcpkg.json says {manifest['version']}, CMakeLists.txt {version}")
asked = {NAMES.get(name, name) for name in re.findall(r"find_package\((\w+)", lists + command) if name not in SYSTEM}
named = {d for d in manifest["dependencies"] if isinstance(d, str)}
for feature in manifest["features"].values():
    named |= set(feature["dependencies"])
if asked != named:
    fail(f"CMake asks for {sorted(asked)}, vcpkg.json names {sorted(named)}")
options = set(re.findall(r"option\((\w+)", lists))
for features in ((), ("images",), ("images", "cli")):
    text = run_port(features)
    given = dict(re.findall(r"-D(\w+)=(ON|OFF)", re.search("configure (.*)", text).group(1)))
    if set(given) - options:
        fail(f"the port sets {sorted(set(given) - options)}, which the project has not")
    for feature, option in (("images", "MIEN_IMAGES"), ("cli", "MIEN_BUILD_CLI")):
        if (given[option] == "ON") != (feature in features):
            fail(f"{option} is {given[option]} with the features {features}")
    if ("tools" in text) != ("cli" in features):
        fail("the command is copied without having been built, or the other way round")
print(f"mien {version}: {len(named)} dependencies, {len(options & set(given))} options; the port runs with every feature")
