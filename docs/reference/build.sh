#!/bin/sh
# Builds the guides and the reference from the public headers: sh docs/reference/build.sh OUT_DIR
# Any word that doxygen prints is a fault of a comment: exit status 1.
set -eu
cd "$(dirname "$0")/../.."
mkdir -p "$1"
said=$(MIEN_REFERENCE_OUT=$1 doxygen docs/reference/Doxyfile 2>&1)
[ -z "$said" ] || { printf '%s\n' "$said"; exit 1; }
grep -q mien_register "$1/reference/registration_8h.html" || { echo "the reference lacks mien_register()"; exit 1; }
grep -q mien_study_create "$1/reference/"*visits*.html || { echo "the reference lacks the guides"; exit 1; }
echo "reference in $1/reference, no warnings"
