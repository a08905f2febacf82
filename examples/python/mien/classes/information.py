"""What belongs to no object. Written by abi/generate_bindings.py."""
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


def status_name(status: int) -> str:
    """The name of a status, e.g. "MIEN_E_IO".
    status: any value; unknown ones give "MIEN_E_UNKNOWN".
    C: mien_status_name()
    """
    return _run("mien_status_name", {"status": status})


def version_number() -> int:
    """The library's version as MAJOR * 1000000 + MINOR * 1000 + PATCH.
    C: mien_version_number()
    """
    return _run("mien_version_number", {})


def version_string() -> str:
    """The library's version as text, e.g. "0.2.0".
    C: mien_version_string()
    """
    return _run("mien_version_string", {})


def build_id() -> str:
    """What was built, for bug reports: version, compiler, instruction sets in use on this processor.
    C: mien_build_id()
    """
    return _run("mien_build_id", {})
