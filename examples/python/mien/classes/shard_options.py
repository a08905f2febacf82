"""ShardOptions. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ShardOptions(_Options):
    """mien_shard_options of the C interface."""
    _name = "mien_shard_options"
    #: 0 to part_count - 1, default 0: which subjects
    part: int
    #: default 1: all subjects
    part_count: int
    #: of identities and of expressions, default 512; parts with fewer subjects and faces are exact
    max_rank: int
    #: as in mien_train_options; all parts of a dataset are aligned alike; null: faces as they lie
    stable_vertices: ArrayLike | None
