"""Follower. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Follower(_Object):
    """A face that is followed. Changes with each frame: not to be shared between threads."""
    _release = "mien_follower_release"
    _retain = "mien_follower_retain"

    def share(self) -> Follower:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def create(session: Session, model: Model, start: Registration, options: FollowOptions | None = None) -> Follower:
        """Begins to follow a face from a registration, of whatever origin: its fitted mesh becomes the shape that the
        model's modes move about.
        model: of the registration.
        start: in the camera's frame.
        options: may be left out: all defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (the registration is of
        another template), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_follower_create()
        """
        return _run("mien_follower_create", {"session": session, "model": model, "start": start, "options": options})[0]

    def fit(self, session: Session, points: ArrayLike, width: int, height: int) -> FollowState:
        """Fits the next frame. A face that is gone is not an error: it is told as lost, and searched in each frame
        until it is found.
        points: #P x 3, F32 or F64: one point a pixel, row by row, in the camera's frame and the unit of the
        options; not finite, or of depth 0: nothing was seen.
        width: pixels in a row, 3 or more.
        height: rows, 3 or more; width x height is the number of points.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (points that are no pinhole camera's),
        MIEN_E_MISMATCH (width x height), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_follower_fit()
        """
        return _run("mien_follower_fit", {"session": session, "points": points, "width": width, "height": height, "follower": self})[0]

    def mesh(self) -> Mesh:
        """The fitted template of the last frame that was not lost: template topology, the camera's frame, millimetres.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_follower_get_mesh()
        """
        return _run("mien_follower_get_mesh", {"follower": self})[0]

    def motion(self) -> numpy.ndarray:
        """The head's motion in that frame, from the template's frame to the camera's, as a row-major 4 x 4 matrix.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_follower_get_motion()
        """
        return _run("mien_follower_get_motion", {"follower": self})[0]
