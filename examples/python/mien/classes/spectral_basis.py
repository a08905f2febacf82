"""SpectralBasis. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class SpectralBasis(_Object):
    """The first Laplace-Beltrami eigenvectors of a mean shape. Immutable: share freely."""
    _release = "mien_spectral_basis_release"
    _retain = "mien_spectral_basis_retain"

    def share(self) -> SpectralBasis:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def build(session: Session, mean: Mesh, options: SpectralBasisOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> SpectralBasis:
        """Computes the first eigenpairs of the mean shape's Laplacian by spectrum slicing; inertia counts prove that
        none is missing.
        mean: the mean shape, mm. Any triangle mesh.
        options: may be left out: 500 modes, mixed Voronoi mass, intrinsic Delaunay.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode_count), MIEN_E_UNSUPPORTED_OPTION,
        MIEN_E_INVALID_MESH, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_spectral_basis_build()
        """
        return _run("mien_spectral_basis_build", {"session": session, "mean": mean, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def load(session: Session, path: Text) -> SpectralBasis:
        """Opens a basis file; the vectors stay in the mapped file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_load()
        """
        return _run("mien_spectral_basis_load", {"session": session, "path": path})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a basis file (safetensors). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_save()
        """
        _run("mien_spectral_basis_save", {"session": session, "path": path, "basis": self})

    def counts(self) -> SpectralBasisCounts:
        """Numbers of vertices and modes.
        vertex_count: may be left out; #V.
        mode_count: may be left out; k.
        C: mien_spectral_basis_get_counts()
        """
        return SpectralBasisCounts(*_run("mien_spectral_basis_get_counts", {"basis": self}))

    def eigenvalues(self) -> numpy.ndarray:
        """Copies the eigenvalues, ascending, 1/mm^2. With dst null and capacity 0: writes the count only.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_spectral_basis_get_eigenvalues()
        """
        return _run("mien_spectral_basis_get_eigenvalues", {"basis": self})[0]

    def vector(self, mode: int) -> numpy.ndarray:
        """Copies one eigenvector, U's column: a value per vertex, orthonormal in the mass matrix, so 1/mm (plain
        without mass).
        mode: 0 to the basis' modes - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (mode), MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_get_vector()
        """
        return _run("mien_spectral_basis_get_vector", {"mode": mode, "basis": self})[0]

    def mass(self) -> numpy.ndarray:
        """Copies the diagonal of the mass matrix: mm^2 per vertex, ones without mass.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_spectral_basis_get_mass()
        """
        return _run("mien_spectral_basis_get_mass", {"basis": self})[0]

    def mean(self) -> Mesh:
        """The mean shape that the basis belongs to.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_spectral_basis_get_mean()
        """
        return _run("mien_spectral_basis_get_mean", {"basis": self})[0]
