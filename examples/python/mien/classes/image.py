"""Image. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Image(_Record):
    """A texture image of the host's, read in place and only during the call: either pixels or the bytes of a file."""
    _name = "mien_image"
    #: UTF-8 file name without a folder; may be left out
    name: Text | None
    #: height rows of width x 3 red green blue, from the top; may be left out
    pixels: ArrayLike | None
    #: from row to row; 0: tightly packed
    row_stride_bytes: int
    #: of pixels, else 0
    width: int
    #: of pixels, else 0
    height: int
    #: the bytes of a JPEG or PNG file; may be left out: when pixels are given
    file: ArrayLike | None

    def __init__(self, row_stride_bytes: int = 0, width: int = 0, height: int = 0, name: Text | None = None, pixels: ArrayLike | None = None, file: ArrayLike | None = None) -> None:
        self.name = name
        self.pixels = pixels
        self.row_stride_bytes = row_stride_bytes
        self.width = width
        self.height = height
        self.file = file
