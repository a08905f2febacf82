"""Material. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Material(_Record):
    """A material of a mesh, read in place and only during the call."""
    _name = "mien_material"
    #: UTF-8; may be left out
    name: Text | None
    #: number of the base colour's image, -1: none
    image: int
    #: 0 to 1; an image is times this
    red: float
    green: float
    blue: float

    def __init__(self, image: int = 0, red: float = 0, green: float = 0, blue: float = 0, name: Text | None = None) -> None:
        self.name = name
        self.image = image
        self.red = red
        self.green = green
        self.blue = blue
