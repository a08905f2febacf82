"""Pose. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Pose(enum.IntEnum):
    """Where a face lies against the training faces."""
    #: on the model's stable zone where it has one; else rigid when the face lies more than 3 degrees or 8 mm
    #: away from the mean face and a rigid motion explains it clearly better, else kept
    AUTO = 0
    #: in the training's frame
    KEEP = 1
    #: anywhere: a rigid motion is fitted together with the face
    RIGID = 2
