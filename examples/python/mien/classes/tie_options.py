"""TieOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class TieOptions(_Options):
    """mien_tie_options of the C interface."""
    _name = "mien_tie_options"
    #: 0.1 to 20; default 6: no place moves farther
    max_slide_mm: float
    #: 0 to 1; default 0.2: of the skin that both visits see, the share on which their pictures must agree, or
    #: nothing moves
    least_share: float
