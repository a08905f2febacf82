"""RegistrationKind. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class RegistrationKind(enum.IntEnum):
    """Fields with one value per template vertex."""
    #: signed distance to the scan, positive: the scan lies outside
    RESIDUAL_MM = 1
    #: in [0, 1]: how much of the scan's say counted
    WEIGHT = 2
    #: of the place, per axis (root mean square)
    STANDARD_DEVIATION_MM = 3
    #: the true place lies within, 95 times out of 100: the deviation's pattern in the size of the zone's
    #: expected error (mien_registration_get_expected_error)
    RADIUS95_MM = 4
    #: how far the surface may lie off the skin along its normal: what mien_measure_options wants. Since 0.2
    NORMAL_DEVIATION_MM = 5
    #: how far mien_registration_tie() moved the place. Since 0.2
    SLIDE_MM = 6
    #: -1 to 1: correlation of both visits' pictures around the place after the slide; 0: not compared. Since 0.2
    TIE_AGREEMENT = 7
    #: 0 to 1: how far the texture holds the place. Since 0.2
    TIE_SHARE = 8
    #: between both visits' places along the skin, per axis; 0 where the texture holds nothing. Since 0.2
    TIE_DEVIATION_MM = 9
