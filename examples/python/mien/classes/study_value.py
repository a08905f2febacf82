"""StudyValue. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class StudyValue(_Record):
    """A number with its error. NaN: not known."""
    _name = "mien_study_value"
    value: float
    #: standard deviation
    sd: float
    #: of the interval at the study's level
    low: float
    #: of the interval at the study's level
    high: float
    #: the minimal detectable change: a smaller size cannot be told from no change at the study's level, as the
    #: interval holds zero; from repeated captures where there are enough
    limit_of_detection: float

    def __init__(self, value: float = 0, sd: float = 0, low: float = 0, high: float = 0, limit_of_detection: float = 0) -> None:
        self.value = value
        self.sd = sd
        self.low = low
        self.high = high
        self.limit_of_detection = limit_of_detection
