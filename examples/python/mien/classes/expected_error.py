"""ExpectedError. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ExpectedError(_Record):
    """How far a fitted zone is expected to be from the truth: the mean distance of its vertices from the true
    ones, learned from simulated fits of many people, poses and troubles. Since 0.2
    """
    _name = "mien_expected_error"
    #: MIEN_QUALITY_*, of the zone alone; doubtful at best where the fit failed or what speaks against the scan
    #: speaks against all of it (two surfaces over each other, inside out, no known unit)
    quality: Quality | int
    expected_mm: float
    #: 8 of 10 like fits are between low_mm and high_mm off
    low_mm: float
    high_mm: float
    #: 0 to 1: share of the zone that the scan had no say in
    unseen: float
