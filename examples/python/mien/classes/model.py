"""Model. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Model(_Object):
    """A template with its modes of deformation: u(x) = mean(x) + sum_j basis_j(x) a_j + sum_k mode_k(x) c_k, a and
    c standard normal; basis_j are scalar and serve x, y and z, mode_k come from faces. Built or loaded once.
    Immutable: share freely between threads.
    """
    _release = "mien_model_release"
    _retain = "mien_model_retain"

    def share(self) -> Model:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def build(session: Session, template_mesh: Mesh, options: ModelOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Model:
        """Builds a deformation model: control points, kernel columns, low-rank basis; with a dataset also the mean and
        the principal modes of its faces.
        template_mesh: #V x 3, mm, with triangles for the surface kernels.
        options: may be left out: geodesic kernel of 20 mm, 999 modes.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles, not
        symmetric), MIEN_E_MISMATCH (scales, dataset), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_model_build()
        """
        return _run("mien_model_build", {"session": session, "template_mesh": template_mesh, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> Model:
        """Loads a model file through a memory map and checks all of it: structure, hash, finite values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_WRONG_KIND,
        MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY.
        C: mien_model_load()
        """
        return _run("mien_model_load", {"session": session, "path": path})[0]

    @staticmethod
    def load_memory(session: Session, data: bytes) -> Model:
        """Loads a model from the bytes of a model file that the host holds in memory, e.g. as a resource of its
        program. They are copied and checked like a file.
        data: size bytes, any alignment; not read after the call.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_model_load_memory()
        """
        return _run("mien_model_load_memory", {"session": session, "data": data})[0]

    @staticmethod
    def load_trusted(session: Session, path: Text) -> Model:
        """Loads a model file that the host trusts: its structure is checked, its hash and values are not.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
        MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_NO_MEMORY.
        C: mien_model_load_trusted()
        """
        return _run("mien_model_load_trusted", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a model file (safetensors). Atomic: a full disk or a crash leaves an old file whole.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_model_save()
        """
        _run("mien_model_save", {"session": session, "path": path, "model": self})

    def counts(self) -> ModelCounts:
        """Numbers of vertices and modes.
        vertex_count: may be left out; #V.
        scalar_modes: may be left out; columns of the scalar basis; 3 times as many deformation modes.
        vector_modes: may be left out; modes trained on faces.
        C: mien_model_get_counts()
        """
        return ModelCounts(*_run("mien_model_get_counts", {"model": self}))

    def json(self) -> str:
        """What the model is: counts, kernel and its settings, rank, variance explained, largest pointwise variance
        error, clipped negative mass, names of landmarks and zones. As JSON text by the two-call protocol.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_model_get_json()
        """
        return _run("mien_model_get_json", {"model": self})[0]

    def variance(self) -> numpy.ndarray:
        """Prior variance of each coordinate of each vertex, #V x 3 float64, mm^2, modes of both kinds together.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_get_variance()
        """
        return _run("mien_model_get_variance", {"model": self})[0]

    def sample(self, session: Session, seed: int, index: int, strength: float) -> Mesh:
        """A random face: the template moved by the mean and `strength` times a draw from the prior. Face `index` of
        `seed` is the same whatever else was drawn; strength 0 gives the mean.
        seed: any number.
        index: any number.
        strength: >= 0; 1: the prior itself.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_sample()
        """
        return _run("mien_model_sample", {"session": session, "seed": seed, "index": index, "strength": strength, "model": self})[0]

    def condition(self, session: Session, observations: Sequence[LandmarkObservation]) -> Model:
        """The posterior model: what the template may still do once landmarks were seen. It is a model like any other,
        with a mean of its own, and may be conditioned again.
        observations: observation_count of them.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (name),
        MIEN_E_UNSUPPORTED_OPTION (mirror correlation), MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_model_condition()
        """
        return _run("mien_model_condition", {"session": session, "observations": observations, "model": self})[0]

    @staticmethod
    def tune(session: Session, template_mesh: Mesh, dataset: Text, options: TuneOptions, progress: Progress | None = None, cancel: Cancel | None = None) -> Tuning:
        """Fits faces of known correspondence with a kernel of each length scale, and of each scale and number of
        levels that is asked for, and reports what is left.
        template_mesh: #V x 3, mm.
        dataset: UTF-8 path of a dataset in the template's correspondence, its faces may cover only the
        template's first vertices.
        options: sigmas_mm at least.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_NOT_FOUND
        (expression), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_model_tune()
        """
        return _run("mien_model_tune", {"session": session, "template_mesh": template_mesh, "dataset": dataset, "options": options}, progress=progress, cancel=cancel)[0]

    def mesh(self) -> Mesh:
        """The template.
        C: mien_model_mesh()
        """
        return Mesh._adopt(_run("mien_model_mesh", {"model": self}))

    def landmarks(self) -> Landmarks:
        """The landmarks of a model: names and vertices of its template.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_get_landmarks()
        """
        return _run("mien_model_get_landmarks", {"model": self})[0]

    def zones(self) -> Zones:
        """The zones of a model: names and vertices of its template.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_model_get_zones()
        """
        return _run("mien_model_get_zones", {"model": self})[0]

    def fit(self, session: Session, target: Mesh, options: ModelFitOptions | None = None) -> numpy.ndarray:
        """The coefficients that bring the template nearest to a face in its correspondence: least squares, weighted
        per vertex, with a ridge.
        target: mm, in the template's frame unless options.align; the vertices of the template, or its first
        ones.
        options: may be left out: no weights, a ridge of 1 mm^2, all modes.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertices, weights),
        MIEN_E_INVALID_MESH, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_model_fit()
        """
        return _run("mien_model_fit", {"session": session, "target": target, "options": options, "model": self})[0]

    def synthesize(self, session: Session, coefficients: ArrayLike | None = None) -> Mesh:
        """The face that has these coefficients: the template moved by the mean and the modes.
        coefficients: coefficient_count finite values
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (coefficient_count),
        MIEN_E_NO_MEMORY.
        C: mien_model_synthesize()
        """
        return _run("mien_model_synthesize", {"session": session, "coefficients": coefficients, "model": self})[0]
