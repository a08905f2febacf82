"""Field. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Field(enum.IntEnum):
    """Fields with one value per vertex of the before face."""
    #: along the normal of the before face
    SIGNED_DISTANCE_MM = 1
    #: length of the displacement or to the closest place
    DISTANCE_MM = 2
    POSITIVE_VOLUME_MM3 = 3
    NEGATIVE_VOLUME_MM3 = 4
    #: 1/mm, positive where the surface bulges outwards
    CURVATURE_MAXIMAL = 5
    #: 1/mm
    CURVATURE_MINIMAL = 6
    #: 1/mm
    CURVATURE_MEAN = 7
    #: 1/mm^2
    CURVATURE_GAUSSIAN = 8
