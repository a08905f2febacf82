"""Series. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Series(_Object):
    """Several scans of one person, neutralized together. Immutable: share freely between threads."""
    _release = "mien_series_release"

    def mesh(self, index: int) -> Mesh:
        """The neutral mesh of one face of a series, in that face's frame; or the person's shared one.
        index: 0 to face_count - 1, or -1: the shared neutral face, in the training's frame.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (index), MIEN_E_NO_MEMORY.
        C: mien_series_get_mesh()
        """
        return _run("mien_series_get_mesh", {"index": index, "series": self})[0]

    def json(self) -> str:
        """The report as a JSON object: "faces", a list with each face's expression, residual_rms_mm (distance from its
        own fit), distance_to_shared_mm (root mean square distance of its neutral face from the shared one, without
        the changing vertices) and warnings.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_series_get_json()
        """
        return _run("mien_series_get_json", {"series": self})[0]
