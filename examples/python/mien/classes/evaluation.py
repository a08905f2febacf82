"""Evaluation. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Evaluation(_Object):
    """Errors of neutralization over a dataset. Immutable: share freely between threads."""
    _release = "mien_evaluation_release"

    def json(self) -> str:
        """The table as a JSON object: "expressions", a list, and "all" (without the neutral faces), each with faces,
        baseline, result, against (mean_mm, sd_mm, max_vertex_mm) and the effects cohens_d, superiority; with
        options.volume_zones "volumes", the same per zone (mean_ml, sd_ml, median_ml).
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_evaluation_get_json()
        """
        return _run("mien_evaluation_get_json", {"evaluation": self})[0]
