"""Follow. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Follow(enum.IntEnum):
    """What became of the face in a frame."""
    FOLLOWED = 0
    #: hardly seen, or it has slid along its skin
    DOUBTFUL = 1
    #: was lost, and a search found it in this frame
    FOUND_AGAIN = 2
    #: the fitted face is that of the last frame that was not lost
    LOST = 3
