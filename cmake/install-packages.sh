#!/bin/sh
# Installs the Debian packages that are missing: sh cmake/install-packages.sh build|test|training|long ...
# Needs root or sudo only when something is missing.
set -eu

build="g++ cmake ninja-build ccache pkg-config libeigen3-dev libopenmesh-dev
       nlohmann-json3-dev libcli11-dev libpng-dev libjpeg62-turbo-dev"
test="libgtest-dev libbenchmark-dev python3 python3-numpy python3-scipy clang clang-format clang-tidy git
      abigail-tools
      mono-mcs mono-runtime openjdk-17-jdk-headless slurm-wlm munge"
training="libtorch-dev libopenblas0-pthread"
long="valgrind gcovr"

wanted=""
for group in "$@"; do
    case "$group" in
        build) wanted="$wanted $build" ;;
        test) wanted="$wanted $test" ;;
        training) wanted="$wanted $training" ;;
        long) wanted="$wanted $long" ;;
        *) echo "install-packages.sh: unknown group '$group'" >&2; exit 2 ;;
    esac
done

missing=""
for package in $wanted; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

as_root=""
[ "$(id -u)" = 0 ] || as_root=sudo
echo "Installing:$missing"
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
# shellcheck disable=SC2086
$as_root apt-get install -y -qq --no-install-recommends $missing >/dev/null
