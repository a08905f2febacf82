"""AsymmetryOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class AsymmetryOptions(_Options):
    """mien_asymmetry_options of the C interface."""
    _name = "mien_asymmetry_options"
    #: MIEN_MIRROR_BY_*; default by the surface
    plane: MirrorBy | int
    #: zone_count zones of either side; null: the whole side only
    zones: Sequence[Zone] | None
    #: of the template, vertices; may be left out unless the plane is found by them
    landmarks: Landmarks | None
    #: #V, mm: deviation of each vertex along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it;
    #: count 0: not known, and no interval
    normal_sd: ArrayLike
    #: over which errors of the surface go together; default 4
    correlation_length_mm: float
