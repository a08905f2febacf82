"""MeasureOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class MeasureOptions(_Options):
    """mien_measure_options of the C interface."""
    _name = "mien_measure_options"
    #: surfaces not in correspondence: 1 (default) leaves out places whose partner lies on an open border, where
    #: nothing is known
    skip_borders: int
    #: zone_count zones; null: the whole face only
    zones: Sequence[Zone] | None
    #: #V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it;
    #: count 0: exact. Without that of either face there is no interval (since 0.2), whatever the alignment's
    before_sd: ArrayLike
    after_sd: ArrayLike
    #: over which errors of a surface go together; default 4, in 0.1: 10
    correlation_length_mm: float
    #: of the after face against the before face; default 0
    alignment_rotation_sd_rad: float
    #: default 0
    alignment_translation_sd_mm: float
    #: mm; what the alignment turns about, e.g. the stable zone's centre
    alignment_centre: Sequence[float]
    #: error common to all vertices; default 0
    common_bias_mm: float
    #: smaller changes are marked as below it; default 0: unknown
    limit_of_detection_ml: float
    #: surfaces not in correspondence: farther partners are none; default 0: no limit
    max_distance_mm: float
