#!/bin/sh
# Mien inside another project, by FetchContent: configured (not built), it must bring the target and nothing else, and install
# nothing unless MIEN_INSTALL is on.
#   inside_project.sh PROJECT_DIR WORK_DIR
set -e
project=$1
work=$2
rm -rf "$work"
mkdir -p "$work"
configure() { # BUILD option ...
    build=$work/$1
    shift
    cmake -S "$project/tests/bindings/inside" -B "$build" -G Ninja -DFETCHCONTENT_SOURCE_DIR_MIEN="$project" -DMIEN_BUILD_CLI=OFF \
        -DPROGRAM="$project/conan/test_package/test_package.c" "$@" >"$build.log" 2>&1 || { tail -20 "$build.log"; exit 1; }
}
installed_by() { find "$1" -name cmake_install.cmake -path '*mien*' -exec grep -h 'file(INSTALL' {} + | wc -l; }
configure off
[ "$(installed_by "$work/off")" = 0 ] || { echo "FAILED: Mien installs its files into the project around it"; exit 1; }
ninja -C "$work/off" -t query program | grep -q libmien || { echo "FAILED: the program does not link Mien"; exit 1; }
configure on -DMIEN_INSTALL=ON
[ "$(installed_by "$work/on")" -gt 3 ] || { echo "FAILED: MIEN_INSTALL installs nothing"; exit 1; }
echo "inside another project: the target alone; MIEN_INSTALL=ON installs $(installed_by "$work/on") sets of files"
