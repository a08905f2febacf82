"""AnthropometricValue. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class AnthropometricValue(_Record):
    """One measurement of a face. NaN where a number is not known."""
    _name = "mien_anthropometric_value"
    #: MIEN_MEASURE_*
    kind: Measure | int
    #: NaN: mien_anthropometry_get_reason() says why
    value: float
    #: of the value, by the errors of the landmarks' places
    sd: float
    #: (value - norm_mean) / norm_sd
    z: float
    #: sd / norm_sd
    z_sd: float
    #: over the people of the norms
    norm_mean: float
    norm_sd: float
    #: 0: no norm
    norm_people: int
