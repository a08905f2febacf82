"""SeriesOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class SeriesOptions(_Options):
    """mien_series_options of the C interface."""
    _name = "mien_series_options"
    #: MIEN_FIT_MIXTURE (default) or MIEN_FIT_MAP
    method: Fit | int
    #: MIEN_POSE_..., default MIEN_POSE_AUTO
    pose: Pose | int
    #: what differs between scans beyond the model, as a share of the noise variance; default 0.01
    scan_noise_share: float
    #: noise variance; 0 (default): the model's own
    noise_mm2: float
    #: where the identity may change between scans; null: nowhere
    changing_vertices: ArrayLike | None
    #: > 0, default 5; without effect since 0.2: what lies there is no witness of the expression at all
    expected_change_mm: float
    #: face_count x #V, face by face, >= 0: 0 where a scan had no data; count 0: all one.
    weights: ArrayLike
