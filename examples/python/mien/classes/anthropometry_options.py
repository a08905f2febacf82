"""AnthropometryOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class AnthropometryOptions(_Options):
    """mien_anthropometry_options of the C interface."""
    _name = "mien_anthropometry_options"
    #: #V, mm: deviation of each vertex' place per axis, as MIEN_REGISTRATION_STANDARD_DEVIATION_MM tells it;
    #: count 0: not known, and no deviation
    place_sd: ArrayLike
    #: #V, mm: along the normal, as MIEN_REGISTRATION_NORMAL_DEVIATION_MM tells it; count 0: as place_sd
    normal_sd: ArrayLike
    #: over which a template slides together along the skin; default 15
    slide_correlation_mm: float
    #: over which it errs together across the skin; default 4
    normal_correlation_mm: float
    #: may be left out: no z-scores
    norms: Norms | None
