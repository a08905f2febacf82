"""Neutralization. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Neutralization(_Object):
    """A neutralized face. Immutable: share freely between threads."""
    _release = "mien_neutralization_release"

    def mesh(self) -> Mesh:
        """The neutral face with the triangles, colours and texture of the input, borrowed.
        C: mien_neutralization_mesh()
        """
        return Mesh._adopt(_run("mien_neutralization_mesh", {"neutralization": self}))

    def counts(self) -> NeutralizationCounts:
        """Numbers of vertices of the neutral face and of coordinates of mien_neutralization_get_coordinates().
        vertex_count: may be left out; #V.
        identity_modes: may be left out; those of the model.
        expression_modes: may be left out; those of the model.
        C: mien_neutralization_get_counts()
        """
        return NeutralizationCounts(*_run("mien_neutralization_get_counts", {"neutralization": self}))

    def coordinates(self) -> NeutralizationCoordinates:
        """Coordinates of the face in the model, mm along the unit modes. mien_neutralization_get_counts() says how
        many.
        identity: identity_modes values.
        expression: expression_modes values.
        C: mien_neutralization_get_coordinates()
        """
        return NeutralizationCoordinates(*_run("mien_neutralization_get_coordinates", {"neutralization": self}))

    def uncertainty(self) -> numpy.ndarray:
        """Deviation per vertex of the neutral face that comes from not knowing the expression, mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (options.uncertainty was 0, or a fit without a
        prior).
        C: mien_neutralization_get_uncertainty()
        """
        return _run("mien_neutralization_get_uncertainty", {"neutralization": self})[0]

    def reading(self, reading: Reading | int) -> ZoneReading:
        """How a treated zone is read, both ways: treatments of lips, brows and the corners of the mouth can look like
        expressions.
        reading: MIEN_READING_*.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (reading),
        MIEN_E_NOT_FOUND (nothing was treated).
        C: mien_neutralization_get_reading()
        """
        return _run("mien_neutralization_get_reading", {"reading": reading, "neutralization": self})[0]

    def json(self) -> str:
        """The report as a JSON object: expression found, its probability and the others', displacement, residual,
        coordinates; with options.treated both readings of the zone.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_neutralization_get_json()
        """
        return _run("mien_neutralization_get_json", {"neutralization": self})[0]

    def apply_to_scan(self, session: Session, scan: Mesh, max_distance_mm: float) -> Mesh:
        """Carries the neutralizing displacement onto the scan's own vertices; triangles, colours and texture of the
        scan stay. Parts far from the template move rigidly with their neighbourhood.
        scan: in the frame of the face.
        max_distance_mm: how far from the fitted face a vertex takes its displacement; 0: 6 mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION,
        MIEN_E_NO_MEMORY.
        C: mien_neutralization_apply_to_scan()
        """
        return _run("mien_neutralization_apply_to_scan", {"session": session, "scan": scan, "max_distance_mm": max_distance_mm, "neutralization": self})[0]
