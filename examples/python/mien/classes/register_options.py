"""RegisterOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class RegisterOptions(_Options):
    """mien_register_options of the C interface."""
    _name = "mien_register_options"
    #: MIEN_GROWTH_*; default constant, with annealed noise
    growth: Growth | int
    #: landmark_count landmarks; null: none. Ones that contradict the others are left out; where all lie to one
    #: side of the face they are moved back onto it, and a note of the report says by how much
    landmarks: Sequence[ScanLandmark] | None
    #: picking error per axis, > 0; default 2
    landmark_sigma_mm: float
    #: MIEN_START_*; default automatic
    start: Start | int
    #: MIEN_UNITS_*; default detect
    units: Units | int
    #: one weight in [0, 1] per scan vertex; count 0: all one
    scan_weights: ArrayLike
    #: 1: weigh scan vertices by the probability of skin colour; default 0
    skin_weights: int
    #: 1 (default): a smooth field closes what the modes leave open
    close_gap: int
    #: of the model's kernel modes; default -1: all
    max_scalar_modes: int
    #: of the model's trained modes; default -1: all. Left out where the landmarks, or without them what the fit
    #: leaves of the surface, say that the face is outside of what they span (a note tells)
    max_pca_modes: int
    #: 1 to 10000; default 0: as many as the library thinks right
    iterations: int
    #: 1 (default): places on the scan's open border do not pull
    reject_border: int
    #: noise level of a surface point in the first round; default 3
    sigma_start_mm: float
    #: and in the last; default 0.5
    sigma_end_mm: float
    #: between the normals of a vertex and its place; default 60
    max_angle_deg: float
    #: row by row, template to scan; default identity
    start_rotation: Sequence[float]
    #: mm
    start_translation: Sequence[float]
    #: default 1
    start_scale: float
    #: 1 (default): where the scan has vertex colours, its lips and brows hold the fit along the skin, and
    #: without landmarks eyes are seen to be shut; 0: by form alone. Needs landmarks of the 68-point scheme in
    #: the model (brow_*, mouth_outer_*, eye_*) or its zone "lips"
    color_features: int
    #: one unit of the scan in mm when it is known, e.g. 25.4; 0 (default): by `units` and by the landmarks,
    #: which settle it
    unit_to_mm: float
    #: MIEN_SIDES_*; default refuse
    landmark_sides: Sides | int
    #: places of the scan that are farther from their vertex do not pull, nearly so far ones less; default 0: as
    #: the noise level lets. Since 0.2
    max_distance_mm: float
    #: a place pulls a vertex while the vertex that is nearest to the place lies no farther than that from it;
    #: default 0: not asked. Below the template's spacing hardly any place pulls. Since 0.2
    mutual_mm: float
    #: soft assignment: a vertex is pulled to the mean of the scan around its nearest place, weighed by a
    #: Gaussian of this deviation; default 0: to the place itself. Since 0.2
    soft_mm: float
