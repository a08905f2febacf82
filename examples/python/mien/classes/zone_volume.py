"""ZoneVolume. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ZoneVolume(_Record):
    """Volume of one zone, mL. signed = positive + negative, absolute = positive - negative; positive: the after
    face lies outside. NaN where a number is not known.
    """
    _name = "mien_zone_volume"
    #: 1: |signed| reaches the limit of detection, 0: below it, -1: no limit given
    detected: int
    signed_ml: float
    #: >= 0
    positive_ml: float
    #: <= 0
    negative_ml: float
    absolute_ml: float
    #: of signed_ml; NaN when no deviation was given
    sd_ml: float
    #: 95 % interval of signed_ml
    low95_ml: float
    high95_ml: float
    area_before_mm2: float
    #: NaN for surfaces not in correspondence
    area_after_mm2: float
