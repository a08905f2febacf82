"""BlendshapeModel. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class BlendshapeModel(_Object):
    """Predicts one expression of a person from the neutral face. Immutable: share freely."""
    _release = "mien_blendshape_model_release"
    _retain = "mien_blendshape_model_retain"

    def share(self) -> BlendshapeModel:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def train(session: Session, dataset_path: Text, expression: Text, options: BlendshapeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> BlendshapeModel:
        """Learns to predict one expression from the neutral face, on every subject of a dataset that has both.
        dataset_path: a dataset file whose names include "neutral".
        expression: a name of the dataset.
        options: may be left out.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (fewer than 2 subjects, ridge),
        MIEN_E_NOT_FOUND (expression), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_blendshape_model_train()
        """
        return _run("mien_blendshape_model_train", {"session": session, "dataset_path": dataset_path, "expression": expression, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> BlendshapeModel:
        """Opens a blendshape model file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_load()
        """
        return _run("mien_blendshape_model_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a blendshape model file (safetensors). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_save()
        """
        _run("mien_blendshape_model_save", {"session": session, "path": path, "model": self})

    def mean(self) -> Mesh:
        """The mean of the neutral training faces, centred: the mesh that a basis for this model is built on.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_get_mean()
        """
        return _run("mien_blendshape_model_get_mean", {"model": self})[0]

    def predict(self, session: Session, k: int, neutral: Mesh, basis: SpectralBasis | None = None) -> Mesh:
        """A person's expression from the neutral face, in its frame.
        basis: may be left out: then k = 0 gives the deformations' prediction, any other k the coordinates'.
        k: low frequencies from the coordinates' prediction, high ones from the deformations'; 0 to the basis'
        modes, #V or more: coordinates alone.
        neutral: #V vertices, mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex counts),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_blendshape_model_predict()
        """
        return _run("mien_blendshape_model_predict", {"session": session, "k": k, "neutral": neutral, "basis": basis, "model": self})[0]

    def search(self, session: Session, basis: SpectralBasis, dataset_path: Text, expression: Text, candidates: ArrayLike, options: BlendshapeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> list[BandChoice]:
        """Tries values of k on a dataset's subjects that the model was not trained on.
        dataset_path: subjects with a neutral face and the expression.
        candidates: candidate_count values of k; above the basis' modes: coordinates alone.
        options: may be left out; its ridge is not read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (expression),
        MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_blendshape_model_search()
        """
        return _run("mien_blendshape_model_search", {"session": session, "basis": basis, "dataset_path": dataset_path, "expression": expression, "candidates": candidates, "options": options, "model": self}, progress=progress, cancel=cancel)[0]
