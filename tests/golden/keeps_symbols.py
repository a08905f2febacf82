#!/usr/bin/env python3
"""Every name that a release exported is still exported: keeps_symbols.py RELEASE_SYMBOLS PRESENT_SYMBOLS"""
import sys
from pathlib import Path

released, present = (set(Path(name).read_text().split()) for name in sys.argv[1:3])
if len(released) < 100:
    sys.exit(f"{sys.argv[1]} lists only {len(released)} names: it is not a release's list")
lost = sorted(released - present)
for name in lost:
    print(f"FAILED: {name} was exported and is not any more: old programs do not start")
print(f"{len(released)} names of the release, {len(present)} now, {len(lost)} lost")
sys.exit(1 if lost else 0)
