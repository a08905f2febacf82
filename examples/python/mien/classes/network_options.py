"""NetworkOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class NetworkOptions(_Options):
    """How to run; initialise with mien_network_options_init()."""
    _name = "mien_network_options"
    #: may be left out; looked at between layers
    cancel: Cancel | None
    #: mien_network_apply() of a network that adds an expression in two bands: modes of the low one; default 0:
    #: the file's own; negative: none, deformations alone; more than the file's basis has: coordinates alone
    band_limit: int
