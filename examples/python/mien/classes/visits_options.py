"""VisitsOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class VisitsOptions(_Options):
    """mien_visits_options of the C interface."""
    _name = "mien_visits_options"
    #: MIEN_POSE_..., default MIEN_POSE_AUTO
    pose: Pose | int
    #: variance of a fitted vertex along the skin's normal, with what no mode explains; default 0.3
    normal_noise_mm2: float
    #: along the skin: fits slide; default 30
    tangential_noise_mm2: float
    #: where the person may have changed: no witness of the expression; null: nowhere
    treated_vertices: ArrayLike | None
    #: face_count x #V, face by face, >= 0: 0 where a scan had no data; count 0: all one
    weights: ArrayLike
