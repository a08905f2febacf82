"""SessionOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class SessionOptions(_Options):
    """mien_session_options of the C interface."""
    _name = "mien_session_options"
    #: 1 (default) to 256; 1 starts no thread. Results do not depend on it.
    num_threads: int
    #: memory budget of one call, 0 (default): none. Counted while the call runs, over all that the library's own
    #: code allocates, the result included; MIEN_E_MEMORY_BUDGET before it would be exceeded. Mapped files do not
    #: count.
    max_bytes: int
    #: null (default): silent. The library never prints.
    log: Callable[[int, str], None] | None
    #: time limit of one call, 0 (default): none, to 1e8; after it a call ends with MIEN_E_TIME_LIMIT as soon as
    #: it would end for a cancel token. Since 0.2.
    max_seconds: float
    #: 0 (default): model files and datasets are mapped, and a file that another program shortens meanwhile may
    #: end the process (as with any mapping; one that is replaced by renaming, as the library writes, is safe);
    #: 1: they are read into memory. Since 0.2.
    copy_files: int
