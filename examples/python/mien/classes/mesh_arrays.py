"""MeshArrays. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class MeshArrays(_Options):
    """What a mesh is made of."""
    _name = "mien_mesh_arrays"
    #: #V x 3, F32 or F64, mm
    positions: ArrayLike
    #: #F x 3 tightly packed, counter-clockwise seen from outside; may be left out
    triangles: ArrayLike | None
    #: #V x 3 red green blue, tightly packed; may be left out
    colors: ArrayLike | None
    #: #T x 2, (0, 0) at the image's lower left corner; may be left out
    texture: ArrayLike | None
    #: #F x 3 numbers of texture; may be left out: with texture, texture has a row for each vertex
    texture_triangles: ArrayLike | None
    #: may be left out
    materials: Sequence[Material] | None
    #: #F numbers of materials; null: all are of the first
    triangle_materials: ArrayLike | None
    #: may be left out
    images: Sequence[Image] | None
