"""NeutralizeOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class NeutralizeOptions(_Options):
    """mien_neutralize_options of the C interface."""
    _name = "mien_neutralize_options"
    #: MIEN_FIT_..., default MIEN_FIT_MIXTURE
    method: Fit | int
    #: alternating; 1 to 100000, default 200
    max_sweeps: int
    #: 1: compute the deviation per vertex; default 0
    uncertainty: int
    #: MIEN_POSE_..., default MIEN_POSE_AUTO
    pose: Pose | int
    #: alternating: stop when a sweep moves less; default 1e-6
    tolerance_mm: float
    #: 0 (default): the model's own
    noise_mm2: float
    #: how far a displacement reaches beyond the model's rim; default 25
    decay_mm: float
    #: #V x 1, >= 0: 0 where the scan had no data; count 0: all one
    weights: ArrayLike
    #: treated_count vertices where the person may have been changed: no witness of expression or pose, so that
    #: filler in a lip stays on the face and is not taken for a rolled lip; null: none. Since 0.2
    treated: ArrayLike | None
    #: around them, no witness either; treatments spread; 0 to 100, default 10
    treated_margin_mm: float
