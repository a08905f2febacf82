"""LandmarkObservation. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class LandmarkObservation(_Record):
    """Where a landmark was seen."""
    _name = "mien_landmark_observation"
    #: of a landmark of the model; null: `vertex` says which
    name: Text | None
    #: read when name is null
    vertex: int
    #: mm, in the frame of the template
    position: Sequence[float]
    #: standard deviation of each coordinate, >= 0.000001
    noise_mm: float

    def __init__(self, position: Sequence[float], vertex: int = 0, noise_mm: float = 0, name: Text | None = None) -> None:
        self.name = name
        self.vertex = vertex
        self.position = position
        self.noise_mm = noise_mm
