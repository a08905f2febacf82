"""ZoneDistance. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ZoneDistance(_Record):
    """Distances of one zone, mm, weighted with area."""
    _name = "mien_zone_distance"
    #: along the normal of the before face; positive: outside
    mean_signed_mm: float
    sd_signed_mm: float
    #: of the signed ones
    mean_absolute_mm: float
    #: of the lengths
    rms_mm: float
    mean_length_mm: float
    median_length_mm: float
    p95_length_mm: float
    max_length_mm: float
    #: vertices that had a partner
    vertex_count: int
