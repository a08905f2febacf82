"""Tuning. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Tuning(_Object):
    """A finished search for a kernel's settings. Immutable."""
    _release = "mien_tuning_release"

    def json(self) -> str:
        """Residuals as JSON text by the two-call protocol: best_sigma_mm, best_scale_mm, best_levels and, per
        combination, its sigma, scale and levels, and mean, deviation and every face's residual norm in mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_tuning_get_json()
        """
        return _run("mien_tuning_get_json", {"tuning": self})[0]
