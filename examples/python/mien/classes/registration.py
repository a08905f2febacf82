"""Registration. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Registration(_Object):
    """A fitted template: places, residuals, confidence, verdict. Immutable: share freely."""
    _release = "mien_registration_release"
    _retain = "mien_registration_retain"

    def share(self) -> Registration:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    def mesh(self) -> Mesh:
        """The fitted template: template topology, the scan's frame, millimetres.
        C: mien_registration_mesh()
        """
        return Mesh._adopt(_run("mien_registration_mesh", {"registration": self}))

    def verdict(self) -> FitVerdict:
        """The verdict.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_registration_get_verdict()
        """
        return _run("mien_registration_get_verdict", {"registration": self})[0]

    def expected_error(self, zone: Text | None = None) -> ExpectedError:
        """The error that is expected of a zone of the model, or of the whole face.
        zone: a zone of the model by its name; null: the whole face.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, or the
        registration was made of arrays or read from a file that states none).
        C: mien_registration_get_expected_error()
        """
        return _run("mien_registration_get_expected_error", {"zone": zone, "registration": self})[0]

    def field(self, field: RegistrationKind | int) -> numpy.ndarray:
        """Copies a field with one float64 per template vertex.
        field: one of MIEN_REGISTRATION_RESIDUAL_MM, MIEN_REGISTRATION_WEIGHT,
        MIEN_REGISTRATION_STANDARD_DEVIATION_MM, MIEN_REGISTRATION_RADIUS95_MM,
        MIEN_REGISTRATION_NORMAL_DEVIATION_MM, MIEN_REGISTRATION_SLIDE_MM, MIEN_REGISTRATION_TIE_AGREEMENT,
        MIEN_REGISTRATION_TIE_SHARE, MIEN_REGISTRATION_TIE_DEVIATION_MM.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (no such field, or it is not known of this
        registration).
        C: mien_registration_get_field()
        """
        return _run("mien_registration_get_field", {"field": field, "registration": self})[0]

    def correspondence(self) -> RegistrationCorrespondence:
        """The dense correspondence: for every template vertex the scan's triangle (or point, for a cloud) nearest to
        its fitted place, and barycentric coordinates in it. Numbers are those of the scan as it was given.
        triangles: numbers.
        barycentric: rows of 3 values.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_registration_get_correspondence()
        """
        return RegistrationCorrespondence(*_run("mien_registration_get_correspondence", {"registration": self}))

    def motion(self) -> numpy.ndarray:
        """The motion from the template's frame to the scan's as a row-major 4 x 4 matrix.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT.
        C: mien_registration_get_motion()
        """
        return _run("mien_registration_get_motion", {"registration": self})[0]

    def json(self) -> str:
        """Verdict with reasons, energies, motion, color_agreement (correlation of each feature's colour with the
        template, -1 to 1; empty when colours had no say), measures and expected_error of every zone and summaries
        as JSON text.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_registration_get_json()
        """
        return _run("mien_registration_get_json", {"registration": self})[0]

    def save(self, session: Session, path: Text) -> None:
        """Keeps a registration as a file: the fitted template, its residuals, weights and deviations, the verdict with
        its reasons and notes, the tie to another visit and the model's zones, so that visits can be registered
        today and studied in a year. The scan is not in it.
        path: UTF-8; replaced whole.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_registration_save()
        """
        _run("mien_registration_save", {"session": session, "path": path, "registration": self})

    @staticmethod
    def load(session: Session, path: Text) -> Registration:
        """Reads a registration that mien_registration_save() kept. It gives the same bits as the registration itself.
        path: UTF-8.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH, MIEN_E_NO_MEMORY.
        C: mien_registration_load()
        """
        return _run("mien_registration_load", {"session": session, "path": path})[0]

    @staticmethod
    def create(session: Session, mesh: Mesh, quality: Quality | int, weight: ArrayLike | None = None, residual: ArrayLike | None = None, standard_deviation: ArrayLike | None = None) -> Registration:
        """A registration of a face that was fitted elsewhere, or whose arrays a host kept itself. What is not given
        here is zero or empty in it.
        mesh: the fitted template, mm.
        weight: may be left out: not known; #V values, 0 to 1: how far the scan was seen there.
        residual: may be left out: zero; #V values, mm: signed distance to the scan.
        standard_deviation: may be left out: not known; #V values, mm, >= 0: of the place, per axis.
        quality: MIEN_QUALITY_*: the verdict on the fit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (lengths), MIEN_E_NO_MEMORY.
        C: mien_registration_create()
        """
        return _run("mien_registration_create", {"session": session, "mesh": mesh, "quality": quality, "weight": weight, "residual": residual, "standard_deviation": standard_deviation})[0]

    def tie(self, session: Session, model: Model, reference_scan: Mesh, registration: Registration, scan: Mesh, options: TieOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Registration:
        """Ties a later visit's registration to an earlier one's along the skin: its places slide along the scan until
        each lies on the freckles and pores that it lay on at the earlier visit, where both scans' pictures (a
        texture image, or colours at the vertices) show the same detail, and go on smoothly where they do not. Form,
        verdict and weights stay; residuals, correspondence and deviations are those of the moved places. When the
        pictures agree on too little (another person, plain skin, very unlike light) nothing moves: that is no
        error, and the JSON report says so under "reference", with why.
        model: which both registrations were made with.
        reference_scan: the scan that it was made of, with colours.
        registration: the later visit.
        scan: the scan that it was made of, with colours.
        options: may be left out: the defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (options; a scan without colours),
        MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MISMATCH (a fit of another template; a scan that does not lie under
        its fit), MIEN_E_INVALID_MESH, MIEN_E_CANCELLED, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_registration_tie()
        """
        return _run("mien_registration_tie", {"session": session, "model": model, "reference_scan": reference_scan, "registration": registration, "scan": scan, "options": options, "reference": self}, progress=progress, cancel=cancel)[0]

    def coefficients(self, session: Session, model: Model, ridge_mm2: float) -> numpy.ndarray:
        """The coefficients of a registered face: its fitted template, brought back into the model's frame by the
        registration's own motion and fitted as by mien_model_fit(). What the fit took from the model comes back;
        what it moved beyond the model's span, to close the last gap to the scan, is left out.
        ridge_mm2: mm^2, >= 0; 0: the nearest face of the model's span.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (of another model),
        MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_registration_get_coefficients()
        """
        return _run("mien_registration_get_coefficients", {"session": session, "model": model, "ridge_mm2": ridge_mm2, "registration": self})[0]
