"""ModelFitOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ModelFitOptions(_Options):
    """mien_model_fit_options of the C interface."""
    _name = "mien_model_fit_options"
    #: 1: move the target rigidly onto the model's mean; default 0
    align: int
    #: rho: variance of the target's noise, mm^2, >= 0; default 1
    ridge_mm2: float
    #: one per vertex of the target, >= 0, which enter squared; count 0: all one
    weights: ArrayLike
    #: the first of them, the others stay 0; -1 (default): all
    scalar_modes: int
    #: the first of them, the others stay 0; -1 (default): all
    vector_modes: int
