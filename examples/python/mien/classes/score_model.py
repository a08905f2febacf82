"""ScoreModel. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ScoreModel(_Object):
    """A trained score: partial least squares on displacement and curvature. Immutable: share freely."""
    _release = "mien_score_model_release"
    _retain = "mien_score_model_retain"

    def share(self) -> ScoreModel:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def train(session: Session, dataset_path: Text, grades: ArrayLike, options: ScoreOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> ScoreModel:
        """Learns a score from graded faces in correspondence.
        dataset_path: a dataset file, faces of one subject share a fold.
        grades: grade_count values, one per face, NaN: not graded.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (settings, fewer than 6 graded faces),
        MIEN_E_MISMATCH (counts, zones), MIEN_E_NO_SOLUTION (grades do not vary), MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_score_model_train()
        """
        return _run("mien_score_model_train", {"session": session, "dataset_path": dataset_path, "grades": grades, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> ScoreModel:
        """Reads a score model file, which is treated as hostile.
        Fails with MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT,
        MIEN_E_NO_MEMORY.
        C: mien_score_model_load()
        """
        return _run("mien_score_model_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a score model as a safetensors file, atomically.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_score_model_save()
        """
        _run("mien_score_model_save", {"session": session, "path": path, "model": self})

    def predict(self, session: Session, face: Mesh) -> ScorePrediction:
        """The score of a face with its 95 % prediction interval.
        face: in the model's topology, mm, anywhere in space.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY.
        C: mien_score_model_predict()
        """
        return _run("mien_score_model_predict", {"session": session, "face": face, "model": self})[0]

    def simulate(self, session: Session, target: float, face: Mesh | None = None) -> Mesh:
        """The face as it would look with another score.
        face: may be left out: the training's mean face.
        target: the score wanted, finite.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (topology), MIEN_E_NO_MEMORY.
        C: mien_score_model_simulate()
        """
        return _run("mien_score_model_simulate", {"session": session, "target": target, "face": face, "model": self})[0]

    def latent(self, component: int) -> numpy.ndarray:
        """A latent variable on the template: how far each vertex moves, mm, at one standard deviation of it. Component
        -1: per unit of score.
        component: 0 .. components - 1, or -1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such component).
        C: mien_score_model_get_latent()
        """
        return _run("mien_score_model_get_latent", {"component": component, "model": self})[0]

    def json(self) -> str:
        """What was learned as JSON: components, cross-validated errors, held-out predictions and focus_places (how
        many places the focus takes a face for; 0: none), which are not kept in files.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_score_model_get_json()
        """
        return _run("mien_score_model_get_json", {"model": self})[0]
