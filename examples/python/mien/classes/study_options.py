"""StudyOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class StudyOptions(_Options):
    """mien_study_options of the C interface."""
    _name = "mien_study_options"
    #: zone_count zones to measure; null: those of the registrations' model
    zones: Sequence[Zone] | None
    #: treated_count names: where the person may have changed, no witness of expression or pose; null: none
    treated_zones: Sequence[str] | None
    #: stable_count names of zones to align on; null: all but the treated ones when zones are treated and
    #: expressions taken off, otherwise "forehead" and "nose"; without any zone the whole face
    stable_zones: Sequence[str] | None
    #: visit_number_count numbers, the visit of each face, from 0 and ascending: several captures of one visit
    #: tell the limits of detection; null: each face is a visit of its own
    visits: ArrayLike | None
    #: around the treated zones, 0 to 100, measured with them as zones of their own at the end; default 10
    margin_mm: float
    #: of the intervals, above 0 and below 1; default 0.95
    level: float
    #: of a scanner's surface along its normal, where it was seen; default 0.08
    noise_mm: float
    #: over which the errors of a fitted surface go together; default 4
    correlation_length_mm: float
    #: error common to all vertices; default 0.01
    common_bias_mm: float
    #: of the volume that an expression accounted for: what no training set knew of it; default 0.06
    untrained_share: float
    #: of a zone's area that both visits must have seen, 0 to 1; default 0.1
    min_seen_share: float
    #: 1: zones keep what no scan saw, which fits guess: walls in nostrils, lips and lids, skin unseen in every
    #: visit; default 0: left out of the zones
    measure_unseen: int
