"""FitVerdict. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class FitVerdict(_Record):
    """The verdict on a fit; the reasons in words are in the JSON report. The quality is that of the error expected
    of the whole face (mien_registration_get_expected_error()), doubtful at best where a zone has failed.
    """
    _name = "mien_fit_verdict"
    #: MIEN_QUALITY_*
    quality: Quality | int
    #: share of the template's vertices with a scan beside them
    coverage: float
    #: of those: share that lies on the scan
    inlier_share: float
    mean_residual_mm: float
    #: 0 without landmarks
    landmark_rms_mm: float
    #: fitted size over template size
    size_ratio: float
    #: of the coefficients, in standard deviations of the prior
    mean_deviation: float
    #: what one unit of the scan was taken for
    unit_to_mm: float
    landmarks_used: int
    landmarks_rejected: int
    flipped_triangles: int
    self_intersections: int
