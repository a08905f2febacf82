"""FollowOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class FollowOptions(_Options):
    """mien_follow_options of the C interface."""
    _name = "mien_follow_options"
    #: of closest places and a solve, per frame, 1 to 100; default 3
    rounds: int
    #: of the template that pull, 100 or more; default 2500
    max_vertices: int
    #: of the model's kernel modes that move, 0 or more; default 250
    max_scalar_modes: int
    #: of the model's trained modes that move, 0 or more; default 60
    max_pca_modes: int
    #: deviation of a vertex from where it was on the head in the frame before; 0: frames know nothing of each
    #: other; default 4
    temporal_mm: float
    #: noise level of a surface point in a frame's first round; default 1.5
    sigma_start_mm: float
    #: and in its last; default 0.7
    sigma_end_mm: float
    #: the face is lost when less of it lies on what the camera sees; 0 to 1, default 0.5
    lost_share: float
    #: one unit of the frames' points in mm; default 1
    unit_to_mm: float
    #: pixels, column = focal_x x / z + centre_x; 0 (default): all four are found from each frame's points
    focal_x: float
    #: pixels, row = focal_y y / z + centre_y
    focal_y: float
    #: pixels
    centre_x: float
    #: pixels
    centre_y: float
