#!/bin/sh
# Builds mien-train against another libtorch, e.g. one with CUDA, and runs it:
#   sh cmake/train-on-accelerator.sh LIBTORCH_PREFIX CONFIG.json [--set key=value ...]
# LIBTORCH_PREFIX is an unpacked libtorch, or what a Python installation of it prints:
#   python3 -c 'import torch; print(torch.utils.cmake_prefix_path)'
# The library itself is built as ever and never linked to it.
set -eu
[ $# -ge 2 ] || { sed -n 2,5p "$0" >&2; exit 2; }
prefix=$1
shift
project=$(cd "$(dirname "$0")/.." && pwd)
cmake -S "$project" -B "$project/build/accelerator" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMIEN_TRAINING=ON \
    -DMIEN_BUILD_TESTS=OFF -DMIEN_BUILD_EXAMPLES=OFF -DMIEN_BUILD_CLI=OFF -DCMAKE_PREFIX_PATH="$prefix"
cmake --build "$project/build/accelerator" --target mien-train
exec "$project/build/accelerator/bin/mien-train" "$@" --set experiment.accelerator=true
