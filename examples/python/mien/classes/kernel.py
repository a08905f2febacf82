"""Kernel. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Kernel(_Record):
    """One more kernel of a sum."""
    _name = "mien_kernel"
    #: MIEN_KERNEL_..., not NONE
    kind: KernelKind | int
    sigma_mm: float
    scale_mm: float
    #: read for SURFACE_MATERN only
    nu: float

    def __init__(self, kind: KernelKind | int = 0, sigma_mm: float = 0, scale_mm: float = 0, nu: float = 0) -> None:
        self.kind = kind
        self.sigma_mm = sigma_mm
        self.scale_mm = scale_mm
        self.nu = nu
