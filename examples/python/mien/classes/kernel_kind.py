"""KernelKind. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class KernelKind(enum.IntEnum):
    """Kernels: what makes two vertices of the template move alike."""
    #: no kernel: modes from faces alone (needs pca_dataset)
    NONE = 0
    #: squared exponential of the straight distance
    EUCLIDEAN_SE = 1
    #: of the distance along the surface: mouth and eyes may open
    GEODESIC_SE = 2
    #: cubic B-splines on a grid in space
    BSPLINE = 3
    #: Matern along the surface, positive definite by construction
    SURFACE_MATERN = 4
