"""Zones. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Zones(_Object):
    """A list of named sets of vertices. Immutable: share freely."""
    _release = "mien_zones_release"
    _retain = "mien_zones_retain"

    def share(self) -> Zones:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> Zones:
        """Reads a zone file {"zones": {name: [vertex, ...]}}; further lists of vertices beside "zones", such as
        "lips", are zones too.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_zones_load()
        """
        return _run("mien_zones_load", {"session": session, "path": path})[0]

    @staticmethod
    def create(zones: Sequence[Zone] | None = None) -> Zones:
        """Makes a list of zones from the host's.
        zones: zone_count of them, each of at most 16777216 vertices; null allowed when that is 0. Names must
        differ.
        Fails with MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_zones_create()
        """
        return _run("mien_zones_create", {"zones": zones})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a zone file. Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_zones_save()
        """
        _run("mien_zones_save", {"session": session, "path": path, "zones": self})

    def count(self) -> int:
        """How many zones there are.
        C: mien_zones_get_count()
        """
        return _run("mien_zones_get_count", {"zones": self})[0]

    def name(self, index: int) -> str:
        """The name of one zone.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_zones_get_name()
        """
        return _run("mien_zones_get_name", {"index": index, "zones": self})[0]

    def vertices(self, index: int) -> numpy.ndarray:
        """The vertices of one zone. With dst null and capacity 0: their number only.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_zones_get_vertices()
        """
        return _run("mien_zones_get_vertices", {"index": index, "zones": self})[0]
