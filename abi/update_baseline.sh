#!/bin/sh
# Records the present interface as what old programs rely on. Run it when functions or fields were
# added, and at each release; a commit that changes recorded lines breaks old programs and needs a
# new ABI number (before 1.0: a new minor version).
set -e
cd "$(dirname "$0")/.."
python3 abi/layout/layout.py update include/mien
python3 abi/baseline/witness.py update abi/baseline/mien-0.abi include/mien
git diff --stat -- abi/layout abi/baseline 2>/dev/null || true
