"""Status. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Status(enum.IntEnum):
    """MIEN_STATUS_* of the C interface."""
    OK = 0
    #: a parameter is null or out of its range
    E_INVALID_ARGUMENT = -1
    #: a handle is null, released or of another type
    E_INVALID_HANDLE = -2
    #: empty, not finite, index out of range, degenerate
    E_INVALID_MESH = -3
    #: the count was written, nothing else
    E_BUFFER_TOO_SMALL = -4
    #: an option, a switch or an enumerator that this library does not know
    E_UNSUPPORTED_OPTION = -5
    #: ABI or file format of another major version
    E_UNSUPPORTED_VERSION = -6
    #: an allocation failed; the session stays usable
    E_NO_MEMORY = -7
    #: the session's max_bytes would be exceeded
    E_MEMORY_BUDGET = -8
    #: a file cannot be opened, read or written
    E_IO = -9
    #: a file is not what its format says
    E_BAD_FORMAT = -10
    #: hash mismatch, or values that are not finite
    E_CORRUPT = -11
    #: a good file of another kind
    E_WRONG_KIND = -12
    #: inputs that do not belong together
    E_MISMATCH = -13
    #: a factorisation or an iteration failed
    E_NO_SOLUTION = -14
    #: an unknown name
    E_NOT_FOUND = -15
    #: by a progress callback or a cancel token
    E_CANCELLED = -16
    #: a callback unwound
    E_CALLBACK = -17
    #: a defect of the library: please report it
    E_INTERNAL = -18
    #: the session is in a call on another thread; since 0.2
    E_BUSY = -19
    #: the session's max_seconds have passed; since 0.2
    E_TIME_LIMIT = -20
