"""ScoreFeatures. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ScoreFeatures(enum.IntEnum):
    """What each vertex gives. jousse-2022 (B.2) has 17 numbers a vertex without naming them; ours are displacement
    (3), change of the normal (3), k1, k2, mean and Gaussian curvature, curvedness, and the curvature tensor
    (6), each of them an equal part of curvature_share.
    """
    #: displacement, k1, k2
    DISPLACEMENT_AND_CURVATURE = 0
    #: all 17
    ALL = 1
