"""ZoneAlignment. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ZoneAlignment(_Record):
    """A rigid alignment on a stable zone and how sure it is."""
    _name = "mien_zone_alignment"
    #: that counted
    pairs: int
    #: left over along the normals
    rms_mm: float
    #: about the centre, root mean square over the axes
    rotation_sd_rad: float
    #: per axis, root mean square
    translation_sd_mm: float
    #: of the zone on the target
    centre: numpy.ndarray
    #: 4 x 4 row by row, moving to target
    matrix: numpy.ndarray
