"""TuneOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class TuneOptions(_Options):
    """mien_tune_options of the C interface."""
    _name = "mien_tune_options"
    #: MIEN_KERNEL_..., not NONE; default GEODESIC_SE
    kernel: KernelKind | int
    #: sigma_count length scales to try, each > 0
    sigmas_mm: ArrayLike
    #: > 0, default 1
    scale_mm: float
    #: default 2
    nu: float
    #: weight of the prior in the fits, >= 0, default 5
    rho: float
    #: 1 to 12, default 1
    levels: int
    #: deformation modes, >= 3, default 999
    num_modes: int
    #: expression_count names: these faces only; null: all
    expressions: Sequence[str] | None
    #: of the dataset's order; 0 (default): all
    max_subjects: int
    #: scale_count scales to try with each sigma, each > 0; null: scale_mm alone
    scales_mm: ArrayLike | None
    #: level_count numbers of levels to try with each of those, each 1 to 12; null: `levels` alone
    level_counts: ArrayLike | None
