"""Anthropometry. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Anthropometry(_Object):
    """The measurements of one face. Immutable: share freely."""
    _release = "mien_anthropometry_release"

    def counts(self) -> AnthropometryCounts:
        """How many measurements there are, and how many of them have a value.
        count: may be left out.
        known_count: may be left out.
        C: mien_anthropometry_get_counts()
        """
        return AnthropometryCounts(*_run("mien_anthropometry_get_counts", {"anthropometry": self}))

    def name(self, index: int) -> str:
        """The name of one measurement, such as "n-gn".
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_anthropometry_get_name()
        """
        return _run("mien_anthropometry_get_name", {"index": index, "anthropometry": self})[0]

    def value(self, index: int) -> AnthropometricValue:
        """One measurement.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_anthropometry_get_value()
        """
        return _run("mien_anthropometry_get_value", {"index": index, "anthropometry": self})[0]

    def reason(self, index: int) -> str:
        """Why one measurement has no value, in words; empty where it has one.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_anthropometry_get_reason()
        """
        return _run("mien_anthropometry_get_reason", {"index": index, "anthropometry": self})[0]

    def json(self) -> str:
        """All measurements as JSON text: name, title, kind, unit, landmarks, source, value, sd, reason, z; and which
        of the face's landmarks stand for those of the field.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_anthropometry_get_json()
        """
        return _run("mien_anthropometry_get_json", {"anthropometry": self})[0]
