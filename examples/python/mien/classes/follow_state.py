"""FollowState. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class FollowState(_Record):
    """What is told of a frame."""
    _name = "mien_follow_state"
    #: MIEN_FOLLOW_*
    state: Follow | int
    #: 0 to 1: of the vertices that face the camera, those on the surface
    share: float
    #: mean distance of these from it
    residual_mm: float
    #: median way of the vertices along the skin since the start: expressions move a part of a face, sliding
    #: moves most of it
    slide_mm: float
