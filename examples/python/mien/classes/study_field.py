"""StudyField. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class StudyField(enum.IntEnum):
    """Fields with one value per vertex of a visit's face."""
    #: how far the fitted surface may lie off the skin
    NORMAL_SD_MM = 1
    #: in [0, 1]: how far the scan was seen there
    WEIGHT = 2
    #: of the expression that was taken off: root of the summed posterior variance of a place's coordinates
    EXPRESSION_SD_MM = 3
