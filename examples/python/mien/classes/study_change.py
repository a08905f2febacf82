"""StudyChange. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class StudyChange(_Record):
    """What changed in one zone from one visit to another. Set struct_size first."""
    _name = "mien_study_change"
    #: MIEN_STUDY_*: why there is no deviation
    unknown: StudyKind | int
    #: gained and lost together; positive: gained
    signed_ml: StudyValue
    #: >= 0
    gained_ml: StudyValue
    #: <= 0
    lost_ml: StudyValue
    #: gained without lost
    absolute_ml: StudyValue
    area_change_mm2: StudyValue
    #: along the normals of the first face; positive: outside
    mean_distance_mm: StudyValue
    #: of signed_ml.sd: by the fitted surfaces
    surface_sd_ml: float
    #: by the alignment on the stable zone
    alignment_sd_ml: float
    #: by the error common to all vertices
    bias_sd_ml: float
    #: by what taking the expressions off leaves open
    expression_sd_ml: float
    #: what the expressions accounted for, signed
    expression_removed_ml: float
    #: of the zone's area, in both visits; NaN: not told
    seen_share: float
    area_before_mm2: float
    area_after_mm2: float
    #: 1: signed_ml reaches its limit of detection, 0: below it, -1: no limit known
    detected: int
