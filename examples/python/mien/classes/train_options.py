"""TrainOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class TrainOptions(_Options):
    """mien_train_options of the C interface."""
    _name = "mien_train_options"
    #: MIEN_TRAIN_..., default MIEN_TRAIN_JPCA
    method: Train | int
    #: 1 to 4000; 0 (default since 0.2, 50 before): of 25, 50, 75 and 100 the fewest that serve people left out
    #: of the training
    identity_modes: int
    #: 1 to 4000; 0 (default): as above
    expression_modes: int
    #: QOJPCA; default 1000
    max_iterations: int
    #: over the data, 1 to 50, default 4
    passes: int
    #: QOJPCA; 0 (default): lambda_factor x the top eigenvalue of k XX'
    lambda_: float
    #: default 10
    lambda_factor: float
    #: QOJPCA stops when no subspace turns farther; default 0.001
    angle_tolerance_rad: float
    #: noise variance of the fits; 0 (default): by cross-validation
    noise_mm2: float
    #: posture: every face is aligned rigidly on these vertices (forehead, nose bridge), in training and in every
    #: fit; null: faces as they lie
    stable_vertices: ArrayLike | None
