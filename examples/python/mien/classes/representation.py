"""Representation. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Representation(_Object):
    """A trained representation of faces: numbers for learning, with their exact inverse. Immutable: share freely."""
    _release = "mien_representation_release"
    _retain = "mien_representation_retain"

    def share(self) -> Representation:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def train(session: Session, dataset_path: Text, kind: Features | int, neutral_only: int) -> Representation:
        """mien_representation_train_with_options() without progress and cancel.
        dataset_path: a dataset file.
        kind: MIEN_FEATURES_...
        neutral_only: 1: only the faces marked neutral; 0: all.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
        neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
        MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_representation_train()
        """
        return _run("mien_representation_train", {"session": session, "dataset_path": dataset_path, "kind": kind, "neutral_only": neutral_only})[0]

    @staticmethod
    def train_with_options(session: Session, dataset_path: Text, kind: Features | int, options: RepresentationOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Representation:
        """Learns the mean shape, scale and statistics of a dataset's faces, with progress and cancel.
        dataset_path: a dataset file.
        kind: MIEN_FEATURES_...
        options: may be left out: all faces.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (kind,
        neutral_only), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NOT_FOUND (no neutral face),
        MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_representation_train_with_options()
        """
        return _run("mien_representation_train_with_options", {"session": session, "dataset_path": dataset_path, "kind": kind, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> Representation:
        """Opens a representation file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_representation_load()
        """
        return _run("mien_representation_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a representation file (safetensors). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_representation_save()
        """
        _run("mien_representation_save", {"session": session, "path": path, "representation": self})

    def counts(self) -> RepresentationCounts:
        """Numbers of vertices and of features a vertex.
        vertex_count: may be left out; #V.
        channel_count: may be left out; 3, or 9 for deformations.
        C: mien_representation_get_counts()
        """
        return RepresentationCounts(*_run("mien_representation_get_counts", {"representation": self}))

    def encode(self, session: Session, face: Mesh) -> RepresentationEncode:
        """The features of a face, #V x c row-major float64. With dst null and capacity 0: writes the count only.
        face: #V vertices, mm, anywhere.
        motion: may be left out; 12 float64: the rigid motion onto the mean, x -> R x + t, as R row by row, then
        t in mm. mien_representation_decode() takes it back.
        dst: rows of channel_count values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_representation_encode()
        """
        return RepresentationEncode(*_run("mien_representation_encode", {"session": session, "face": face, "representation": self}))

    def decode(self, session: Session, features: ArrayLike, motion: ArrayLike | None = None) -> Mesh:
        """The face that has these features.
        features: row_count x channel_count row-major float64.
        motion: may be left out: the mean's frame; 12 float64 of mien_representation_encode(), which is undone.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
        MIEN_E_MISMATCH (row_count), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_representation_decode()
        """
        return _run("mien_representation_decode", {"session": session, "features": features, "motion": motion, "representation": self})[0]
