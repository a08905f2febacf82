"""ScoreOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ScoreOptions(_Options):
    """mien_score_options of the C interface."""
    _name = "mien_score_options"
    #: MIEN_PLS_*; default NIPALS
    method: Pls | int
    #: 0 (default): by cross-validation and the one-standard-error rule
    num_components: int
    #: tried in cross-validation, 1 to 50; default 10
    max_components: int
    #: over subjects; 0: leave one subject out; default 10
    folds: int
    #: of the folds; default 1
    seed: int
    #: total variance of the curvature features over that of the displacements; 0: none; default 0.1
    curvature_share: float
    #: of the fits that estimate curvature; default 8
    curvature_radius_mm: float
    #: range that predictions are cut to
    lowest: float
    #: equal (default): none
    highest: float
    #: of interest; null: all
    zone_vertices: ArrayLike | None
    #: faces are aligned on these; null: on all, robustly
    stable_vertices: ArrayLike | None
    #: 1 (default): vertices count by how far they move with the score, found anew in each fold; 0: by their area
    #: alone
    focus: int
    #: MIEN_SCORE_FEATURES_*; default displacement and curvature. Since 0.2
    features: ScoreFeatures | int
