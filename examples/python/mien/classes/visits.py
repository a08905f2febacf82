"""Visits. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
from __future__ import annotations

import enum  # noqa: F401
from typing import TYPE_CHECKING, Callable, NamedTuple, Sequence  # noqa: F401

import numpy  # noqa: F401
from numpy.typing import ArrayLike, DTypeLike  # noqa: F401

from ..runtime import Object as _Object  # noqa: F401
from ..runtime import Options as _Options  # noqa: F401
from ..runtime import Progress, Text  # noqa: F401
from ..runtime import Record as _Record  # noqa: F401
from ..runtime import run as _run  # noqa: F401

if TYPE_CHECKING:
    from . import *  # noqa: F401,F403


class Visits(_Object):
    """One person's faces at several visits, without their expressions. Immutable: share freely between threads."""
    _release = "mien_visits_release"

    def mesh(self, index: int) -> Mesh:
        """The neutral face of one visit, in the frame of its face.
        index: 0 to face_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY.
        C: mien_visits_get_mesh()
        """
        return _run("mien_visits_get_mesh", {"index": index, "visits": self})[0]

    def expression(self, index: int) -> str:
        """The name of the expression found at one visit.
        index: 0 to face_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index).
        C: mien_visits_get_expression()
        """
        return _run("mien_visits_get_expression", {"index": index, "visits": self})[0]

    def removed_volume(self, first: int, second: int, zone: Zone | None = None) -> VisitsRemovedVolume:
        """What the expressions that were taken off amount to in a volume between two visits, and how surely they are
        known. A neutral volume carries that doubt beside the doubts of the fits.
        first: 0 to face_count - 1.
        second: 0 to face_count - 1.
        zone: may be left out: the whole face.
        removed_ml: may be left out; signed, mL.
        sd_ml: may be left out; posterior deviation, mL.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (zone), MIEN_E_NOT_FOUND (a
        visit), MIEN_E_NO_MEMORY.
        C: mien_visits_get_removed_volume()
        """
        return VisitsRemovedVolume(*_run("mien_visits_get_removed_volume", {"first": first, "second": second, "zone": zone, "visits": self}))
