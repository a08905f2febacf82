"""Landmarks. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Landmarks(_Object):
    """A list of named landmarks: places on a scan, or vertices of a template. Immutable: share freely."""
    _release = "mien_landmarks_release"
    _retain = "mien_landmarks_retain"

    def share(self) -> Landmarks:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> Landmarks:
        """Reads a landmark file, told by its content: this project's JSON ({"points": ...} or {"vertices": ...}), 3D
        Slicer's .mrk.json and .fcsv (coordinates come out as LPS), MeshLab's .pp, .pts, menpo's .ljson, tables
        name,x,y,z or name,vertex, and vertex numbers alone. What was not picked (null, not a number, "not defined",
        a repeated placeholder such as 0 0 0) is kept as such. Landmarks without a name are called by their number,
        from "1".
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_landmarks_load()
        """
        return _run("mien_landmarks_load", {"session": session, "path": path})[0]

    @staticmethod
    def create(landmarks: Sequence[ScanLandmark] | None = None) -> Landmarks:
        """Makes a list of places from the host's. A repeated placeholder, such as 0 0 0, counts as not picked.
        landmarks: landmark_count of them; null allowed when that is 0. Names must differ.
        Fails with MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_landmarks_create()
        """
        return _run("mien_landmarks_create", {"landmarks": landmarks})[0]

    def match(self, model: Model) -> Landmarks:
        """The landmarks under the names that a model has for them. Case, separators and leading zeros do not count;
        numbers alone are read as iBUG-68 (from 0 or 1) or MediaPipe (468 or 478), where the model has the 68 names
        of that scheme. What the model does not know is left out and listed in the JSON of the result.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (two names mean one landmark, numbers fit two
        schemes), MIEN_E_NOT_FOUND (none is known; the message gives examples of known names), MIEN_E_NO_MEMORY.
        C: mien_landmarks_match()
        """
        return _run("mien_landmarks_match", {"model": model, "landmarks": self})[0]

    def on_mesh(self, mesh: Mesh) -> Landmarks:
        """The landmarks as places: vertex numbers become the vertices' places on a mesh, places stay as they are.
        mesh: has the numbered vertices.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (a number that the mesh does
        not have), MIEN_E_NO_MEMORY.
        C: mien_landmarks_on_mesh()
        """
        return _run("mien_landmarks_on_mesh", {"mesh": mesh, "landmarks": self})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a landmark file by its extension: .json, .mrk.json and .fcsv (both LPS), .pp, .pts, .ljson, .csv.
        Vertex numbers go into .json and .csv. Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_landmarks_save()
        """
        _run("mien_landmarks_save", {"session": session, "path": path, "landmarks": self})

    def counts(self) -> LandmarksCounts:
        """How many landmarks there are, and how many of them are a place or a vertex.
        count: may be left out.
        picked_count: may be left out.
        C: mien_landmarks_get_counts()
        """
        return LandmarksCounts(*_run("mien_landmarks_get_counts", {"landmarks": self}))

    def name(self, index: int) -> str:
        """The name of one landmark.
        index: below the count.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (index).
        C: mien_landmarks_get_name()
        """
        return _run("mien_landmarks_get_name", {"index": index, "landmarks": self})[0]

    def mark(self, index: int) -> LandmarksMark:
        """What is known of one landmark.
        index: below the count.
        where: may be left out; MIEN_MARK_*.
        position: may be left out; x, y and z in the file's unit, zeros unless it is a place.
        vertex: may be left out; 0 unless it is a vertex.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (misaligned), MIEN_E_NOT_FOUND (index).
        C: mien_landmarks_get_mark()
        """
        return LandmarksMark(*_run("mien_landmarks_get_mark", {"index": index, "landmarks": self}))

    def json(self) -> str:
        """What the list is, as JSON text by the two-call protocol: format, system (LPS or RAS as the file says it),
        unit_to_mm (null: not told), count, picked, not_picked (names), and after mien_landmarks_match() scheme and
        unknown (names).
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_landmarks_get_json()
        """
        return _run("mien_landmarks_get_json", {"landmarks": self})[0]

    def add_profile(self, template_mesh: Mesh) -> Landmarks:
        """The landmarks of a template and, beside them, those of its profile that its shape defines by itself:
        glabella, nasion, columella, sublabiale and pogonion, where they are not among the given ones. Every face in
        the template's topology has them at the same vertices.
        template_mesh: symmetric about its plane x = 0, +y up, +z forward (mien_model_mesh()).
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (a landmark that the search
        starts from), MIEN_E_MISMATCH (vertex), MIEN_E_INVALID_MESH (not symmetric, no midline),
        MIEN_E_NO_MEMORY.
        C: mien_landmarks_add_profile()
        """
        return _run("mien_landmarks_add_profile", {"template_mesh": template_mesh, "landmarks": self})[0]
