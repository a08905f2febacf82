"""BandChoice. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class BandChoice(_Record):
    """One tried k of mien_blendshape_model_search()."""
    _name = "mien_band_choice"
    k: int
    l1_mm: float
    dame: float
    fmpd: float
    #: 1: no other k is better in both L1 and FMPD
    on_front: int
    #: 1: the front's knee
    chosen: int

    def __init__(self, k: int = 0, l1_mm: float = 0, dame: float = 0, fmpd: float = 0, on_front: int = 0, chosen: int = 0) -> None:
        self.k = k
        self.l1_mm = l1_mm
        self.dame = dame
        self.fmpd = fmpd
        self.on_front = on_front
        self.chosen = chosen
