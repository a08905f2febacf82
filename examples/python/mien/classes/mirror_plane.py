"""MirrorPlane. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class MirrorPlane(_Record):
    """The plane between left and right. NaN where a number is not known."""
    _name = "mien_mirror_plane"
    #: MIEN_MIRROR_BY_*
    by: MirrorBy | int
    #: of partners that counted
    pairs: int
    #: unit, to the subject's left
    normal: numpy.ndarray
    #: mm, in the plane
    centre: numpy.ndarray
    #: of the distances between a side and the other's reflection
    rms_mm: float
    #: about either direction of the plane, root mean square
    tilt_sd_rad: float
    #: along the normal
    offset_sd_mm: float
    #: angle to the plane found the other way; NaN without landmarks
    between_rad: float
    #: of that plane from the centre, along its normal
    apart_mm: float
