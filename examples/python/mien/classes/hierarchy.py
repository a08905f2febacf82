"""Hierarchy. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Hierarchy(_Object):
    """Levels of a template with maps between them. Immutable: share freely."""
    _release = "mien_hierarchy_release"
    _retain = "mien_hierarchy_retain"

    def share(self) -> Hierarchy:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def build_quadric(session: Session, mesh: Mesh, level_count: int, factor: float) -> Hierarchy:
        """Levels by quadric edge collapse, with barycentric maps up and selections down.
        mesh: an orientable manifold.
        level_count: levels below the mesh itself, 1 to 32; fewer when no collapse is legal.
        factor: vertices are divided by this from level to level; above 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_hierarchy_build_quadric()
        """
        return _run("mien_hierarchy_build_quadric", {"session": session, "mesh": mesh, "level_count": level_count, "factor": factor})[0]

    @staticmethod
    def build_connectivity(session: Session, mesh: Mesh, level_count: int, stride: int, radius: int) -> Hierarchy:
        """Levels sampled from the connectivity alone.
        level_count: levels below the mesh itself, 1 to 32.
        stride: least distance of kept vertices in edges, at least 1.
        radius: edges over which the maps reach, stride - 1 to 64.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_hierarchy_build_connectivity()
        """
        return _run("mien_hierarchy_build_connectivity", {"session": session, "mesh": mesh, "level_count": level_count, "stride": stride, "radius": radius})[0]

    @staticmethod
    def load(session: Session, path: Text) -> Hierarchy:
        """Opens a hierarchy file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_hierarchy_load()
        """
        return _run("mien_hierarchy_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a hierarchy file (safetensors; maps as compressed rows). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_hierarchy_save()
        """
        _run("mien_hierarchy_save", {"session": session, "path": path, "hierarchy": self})

    def level_count(self) -> int:
        """Number of levels, the finest included.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_hierarchy_get_level_count()
        """
        return _run("mien_hierarchy_get_level_count", {"hierarchy": self})[0]

    def level(self, level: int) -> Mesh:
        """The mesh of a level; level 0 is the finest. Sampled levels of the connectivity kind have no triangles.
        level: 0 to level_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (level), MIEN_E_NO_MEMORY.
        C: mien_hierarchy_get_level()
        """
        return _run("mien_hierarchy_get_level", {"level": level, "hierarchy": self})[0]

    def apply(self, level: int, direction: MapKind | int, values: ArrayLike, channel_count: int) -> numpy.ndarray:
        """Applies a map to values on vertices: dst = map values.
        level: 1 to level_count - 1: the coarser level of the map.
        direction: MIEN_MAP_DOWN or MIEN_MAP_UP.
        values: row_count x channel_count row-major float64.
        channel_count: values a vertex, 1 to 4096.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction),
        MIEN_E_MISMATCH (row_count), MIEN_E_NO_MEMORY.
        C: mien_hierarchy_apply()
        """
        return _run("mien_hierarchy_apply", {"level": level, "direction": direction, "values": values, "channel_count": channel_count, "hierarchy": self})[0]

    def map(self, level: int, direction: MapKind | int) -> HierarchyMap:
        """A map as a sparse matrix: its entries by rows, ascending, each row adding up to one. With all arrays null
        and capacity 0: the counts only.
        level: 1 to level_count - 1: the coarser level of the map.
        direction: MIEN_MAP_DOWN or MIEN_MAP_UP.
        rows: numbers of vertices that the map ends at.
        columns: numbers of vertices that it starts from.
        values: float64.
        row_count: may be left out; vertices that the map ends at.
        column_count: may be left out; vertices that it starts from.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (direction).
        C: mien_hierarchy_get_map()
        """
        return HierarchyMap(*_run("mien_hierarchy_get_map", {"level": level, "direction": direction, "hierarchy": self}))
