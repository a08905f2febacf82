"""Norms. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Norms(_Object):
    """Mean and deviation of each measurement over the people of a dataset. Immutable: share freely."""
    _release = "mien_norms_release"

    @staticmethod
    def create(session: Session, dataset_path: Text, landmarks: Landmarks, options: AnthropometryOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Norms:
        """Norms over the neutral faces of a dataset, one vote per person. Norms are for the population of the dataset
        and for faces in its topology: the same landmark lies elsewhere on another template.
        dataset_path: faces of ten people or more.
        landmarks: vertices of the dataset's faces.
        options: may be left out; progress and cancel are read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than ten people, landmarks that are no
        vertices), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_NOT_FOUND (no neutral faces, no measurement has its
        landmarks), MIEN_E_MISMATCH (landmarks), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_norms_create()
        """
        return _run("mien_norms_create", {"session": session, "dataset_path": dataset_path, "landmarks": landmarks, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> Norms:
        """Reads norms that mien_norms_save() wrote, or that a host wrote from the literature: {"norms": {"n-gn":
        {"mean": 121.3, "sd": 6.8, "people": 109}}}.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a norm of fewer than ten people, or given
        twice), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_norms_load()
        """
        return _run("mien_norms_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes norms as JSON. Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_norms_save()
        """
        _run("mien_norms_save", {"session": session, "path": path, "norms": self})

    def json(self) -> str:
        """The norms as JSON text, as mien_norms_save() writes it.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_norms_get_json()
        """
        return _run("mien_norms_get_json", {"norms": self})[0]
