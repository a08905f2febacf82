"""Study. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Study(_Object):
    """Visits of one person: neutral faces and what changed between them. Immutable: share freely."""
    _release = "mien_study_release"
    _retain = "mien_study_retain"

    def share(self) -> Study:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def create(session: Session, registrations: Sequence[Registration], expressions: ExpressionModel | None = None, options: StudyOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Study:
        """Studies the visits of one person: takes the expressions off all faces together, aligns each visit on the
        first by what holds still, and measures what changed per zone with its errors. One registration: its neutral
        face and how surely it is known.
        registrations: registration_count fits of one model, first visit first.
        expressions: may be left out: faces are measured as they are held.
        options: may be left out: defaults, with the zones of the registrations' model. Zones are patches, as
        those of mien_measure_volume().
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (topology, zones), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION, MIEN_E_UNSUPPORTED_OPTION,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_study_create()
        """
        return _run("mien_study_create", {"session": session, "registrations": registrations, "expressions": expressions, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def create_from_meshes(session: Session, faces: Sequence[Mesh], normal_sd: ArrayLike | None = None, weights: ArrayLike | None = None, expressions: ExpressionModel | None = None, options: StudyOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Study:
        """The same from meshes that were fitted elsewhere. Without deviations nothing is said of errors: sd, low, high
        and limit_of_detection are NaN.
        faces: face_count meshes in one topology, mm, first visit first.
        normal_sd: may be left out; face_count x #V values, face by face, mm, >= 0: how far each surface may lie
        off the skin along its normal.
        weights: may be left out: all was seen, as far as is known; face_count x #V values, face by face, 0 to
        1: 0 where a scan had no data.
        expressions: may be left out: faces are measured as they are held.
        options: may be left out: defaults, without any zone. noise_mm is not read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (topology, zones, deviations, weights), MIEN_E_NOT_FOUND (a zone's name), MIEN_E_NO_SOLUTION,
        MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_study_create_from_meshes()
        """
        return _run("mien_study_create_from_meshes", {"session": session, "faces": faces, "normal_sd": normal_sd, "weights": weights, "expressions": expressions, "options": options}, progress=progress, cancel=cancel)[0]

    def counts(self) -> StudyCounts:
        """How many visits and zones a study has. The treated zones with their margin are the last zones.
        visit_count: may be left out.
        zone_count: may be left out.
        C: mien_study_get_counts()
        """
        return StudyCounts(*_run("mien_study_get_counts", {"study": self}))

    def zone_name(self, zone: int) -> str:
        """The name of a zone.
        zone: 0 to zone_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (zone).
        C: mien_study_get_zone_name()
        """
        return _run("mien_study_get_zone_name", {"zone": zone, "study": self})[0]

    def expression(self, visit: int) -> str:
        """The name of the expression that was taken off a visit.
        visit: 0 to visit_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit).
        C: mien_study_get_expression()
        """
        return _run("mien_study_get_expression", {"visit": visit, "study": self})[0]

    def mesh(self, visit: int, frame: int) -> Mesh:
        """The neutral face of a visit, in its own frame or aligned on another visit.
        visit: 0 to visit_count - 1.
        frame: the visit in whose frame to give it: its own number for its own frame.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (a visit), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_mesh()
        """
        return _run("mien_study_get_mesh", {"visit": visit, "frame": frame, "study": self})[0]

    def field(self, visit: int, field: StudyField | int) -> numpy.ndarray:
        """Copies a field with one float64 per vertex of a visit's face.
        visit: 0 to visit_count - 1.
        field: MIEN_STUDY_FIELD_*.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (visit, or nothing is known of such a field).
        C: mien_study_get_field()
        """
        return _run("mien_study_get_field", {"visit": visit, "field": field, "study": self})[0]

    def distances(self, first: int, second: int) -> numpy.ndarray:
        """How far each vertex moved between two visits: the signed distance of the second neutral face, aligned, from
        the first along the first one's normals, mm.
        first: 0 to visit_count - 1.
        second: another visit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_distances()
        """
        return _run("mien_study_get_distances", {"first": first, "second": second, "study": self})[0]

    def alignment(self, first: int, second: int) -> ZoneAlignment:
        """How the second visit was aligned on the first.
        first: 0 to visit_count - 1.
        second: another visit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_alignment()
        """
        return _run("mien_study_get_alignment", {"first": first, "second": second, "study": self})[0]

    def change(self, first: int, second: int, zone: int) -> StudyChange:
        """What changed in a zone from one visit to another.
        first: 0 to visit_count - 1.
        second: another visit.
        zone: 0 to zone_count - 1.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (first is second), MIEN_E_NOT_FOUND (a visit
        or zone), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_study_get_change()
        """
        return _run("mien_study_get_change", {"first": first, "second": second, "zone": zone, "study": self})[0]

    def json(self) -> str:
        """The study as a JSON object: "recipe" with every setting, "zones", and "visits" with the expression of each
        and "changes_since_first" per zone.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_study_get_json()
        """
        return _run("mien_study_get_json", {"study": self})[0]
