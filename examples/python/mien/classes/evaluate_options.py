"""EvaluateOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class EvaluateOptions(_Options):
    """mien_evaluate_options of the C interface."""
    _name = "mien_evaluate_options"
    #: MIEN_FIT_..., default MIEN_FIT_MIXTURE
    method: Fit | int
    #: of the method; default 200
    max_sweeps: int
    #: MIEN_FIT_... of the second model; default MIEN_FIT_ALTERNATING
    against_method: Fit | int
    #: default 3
    against_max_sweeps: int
    #: second model to compare with; may be left out
    against: ExpressionModel | None
    #: measure on these vertices only; null: all
    zone_vertices: ArrayLike | None
    #: align every face rigidly to its target on these first; null: not
    stable_vertices: ArrayLike | None
    #: absolute volumes to the neutral face are measured in these, too; null: none. Since 0.2
    volume_zones: Sequence[Zone] | None
