"""Cancel. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Cancel(_Object):
    """Tells a running call to stop. Thread-safe, sticky, single-use."""
    _release = "mien_cancel_release"

    def __init__(self) -> None:
        """Makes a cancel token: name it in the options of one call, request it from any thread."""
        self._take((_run("mien_cancel_create", {}))[0])

    def request(self) -> None:
        """Asks the call that was given this token to return MIEN_E_CANCELLED soon. Sticky.
        C: mien_cancel_request()
        """
        _run("mien_cancel_request", {"cancel": self})
