#!/bin/sh
# The shared library exports exactly the listed names under one version node, and needs little.
#   symbols.sh LIBRARY SYMBOLS_TXT VERSION_NODE
set -u
library=$1
symbols=$2
node=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export LC_ALL=C
failed=0
fault() { echo "FAILED: $*"; failed=1; }

nm -D --defined-only "$library" >"$folder/nm" || exit 1
# The version node itself appears as an absolute symbol.
awk '$2 != "A" { print $3 }' "$folder/nm" | sort >"$folder/exported"
sed "s/\$/@@$node/" "$symbols" | sort >"$folder/expected"
diff "$folder/expected" "$folder/exported" || fault "exports differ from $symbols (< listed, > exported)"
awk '$2 == "u" || $2 == "V" || $2 == "W"' "$folder/nm" | grep . && fault "unique or weak definitions leak"
awk '{ print $3 }' "$folder/nm" | grep '^_Z' && fault "C++ names leak"

readelf -dW "$library" >"$folder/dynamic"
grep -E 'RPATH|RUNPATH' "$folder/dynamic" && fault "the library carries a search path"
grep TEXTREL "$folder/dynamic" && fault "text relocations"
readelf -lW "$library" | grep GNU_STACK | grep -q 'RWE' && fault "an executable stack"
nm -D --undefined-only "$library" | grep -E ' (printf|puts|putchar|perror|exit|_exit|abort|getenv|secure_getenv|setlocale|system|signal|sigaction)(@|$)' >"$folder/forbidden"
# abort is allowed: the C++ runtime names it where a noexcept promise is broken.
grep -vE ' abort' "$folder/forbidden" && fault "calls into the host's output, environment or process"

soname=$(sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p' "$folder/dynamic")
needed=$(sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' "$folder/dynamic" | tr '\n' ' ')
highest() { nm -D --undefined-only "$library" | grep -o "@$1_[0-9.]*" | sed "s/@$1_//" | sort -V | tail -1; }
echo "$(wc -l <"$folder/exported") names as $node, soname $soname, needs $needed"
echo "oldest system that loads it: GLIBC $(highest GLIBC), GLIBCXX $(highest GLIBCXX)"
exit $failed
