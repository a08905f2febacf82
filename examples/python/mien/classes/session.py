"""Session. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Session(_Object):
    """Threads, limits of memory and time, and logging. Externally synchronized: one call at a time; with more than
    one thread of its own, a session that is in a call on another thread refuses a second call with MIEN_E_BUSY.
    A callback may call the library with the session that called it. Objects made in a session may outlive it.
    """
    _release = "mien_session_release"

    def __init__(self, options: SessionOptions | None = None) -> None:
        """Makes a session with default options: one thread, no memory budget, silent. With options: those."""
        self._take((_run("mien_session_create_with_options", {"options": options}) if options is not None else _run("mien_session_create", {}))[0])

    def hash_file(self, path: Text) -> str:
        """The SHA-256 of a file's bytes as 64 lower-case hexadecimal digits: which model, which scan a result was made
        from. With dst null and capacity 0: the size only, without reading the file.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_NO_MEMORY,
        MIEN_E_TIME_LIMIT.
        C: mien_session_hash_file()
        """
        return _run("mien_session_hash_file", {"path": path, "session": self})[0]

    def measure_anthropometry(self, face: Mesh, landmarks: Landmarks, options: AnthropometryOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Anthropometry:
        """Lengths, lengths along the skin, angles, inclinations and proportions between the landmarks of a face: some
        hundred of the field's, always in the same order. Landmarks go by the field's names ("pronasale",
        "cheilion_left") or abbreviations ("prn", "ch_left"), or by those of the 68-point scheme that truly coincide
        with one of the field (jaw_08 is gnathion; nose_base_0 is no alare). A measurement whose landmarks are
        missing is NaN with a reason.
        face: #V x 3, mm, with triangles.
        landmarks: vertices of the face, or places on it in its frame (a measurement with a place has no
        deviation, and no length along the skin).
        options: may be left out: no deviations, no norms.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (landmarks, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_anthropometry()
        """
        return _run("mien_measure_anthropometry", {"face": face, "landmarks": landmarks, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_volume(self, before: Mesh, after: Mesh, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """The volume between two faces in correspondence: signed, positive, negative and absolute, whole and per zone,
        exact where the faces cross inside a triangle pair. A zone's edge runs linearly through the ring of
        triangles it shares; disjoint zones and the rest add up to the whole. A zone of twenty vertices or more of
        which most lie in no triangle of it is one of another template: MIEN_E_MISMATCH.
        before: #V x 3, mm, with triangles counter-clockwise seen from outside.
        after: same vertex count, in the frame of before; its triangles are not read.
        options: may be left out: the whole face, no uncertainty.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
        MIEN_E_MISMATCH (vertex counts, zones, deviations), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_measure_volume()
        """
        return _run("mien_measure_volume", {"before": before, "after": after, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_distance(self, before: Mesh, after: Mesh, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Distances between two faces in correspondence, per vertex and per zone.
        before: #V x 3, mm.
        after: same vertex count, in the frame of before.
        options: may be left out; zones, progress and cancel are read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_distance()
        """
        return _run("mien_measure_distance", {"before": before, "after": after, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_surface_distance(self, before: Mesh, after: Mesh, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Distances from the vertices of one surface to the closest place on another, in any topology; the Hausdorff
        distance takes both directions.
        before: #V x 3, mm, with triangles.
        after: a surface or a cloud of points, aligned with before.
        options: may be left out; zones (of before), max_distance_mm, skip_borders, progress, cancel.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_surface_distance()
        """
        return _run("mien_measure_surface_distance", {"before": before, "after": after, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_closed_volume(self, mesh: Mesh, close_rims: int) -> float:
        """The volume that a mesh encloses, by the divergence theorem about its centroid.
        mesh: manifold along its edges and consistently oriented.
        close_rims: 1: each open rim is closed by a fan from the mean of its vertices; 0: an open mesh is an
        error.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (close_rims),
        MIEN_E_INVALID_MESH (open, not manifold or not oriented: the message counts the edges),
        MIEN_E_NO_MEMORY.
        C: mien_measure_closed_volume()
        """
        return _run("mien_measure_closed_volume", {"mesh": mesh, "close_rims": close_rims, "session": self})[0]

    def measure_area(self, mesh: Mesh, zone: Zone | None = None) -> float:
        """The area of a surface, or of a zone of it (a triangle's area is shared by its three vertices). Zones are
        patches, as those of mien_measure_volume().
        mesh: with triangles.
        zone: may be left out: the whole surface.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zone),
        MIEN_E_NO_MEMORY.
        C: mien_measure_area()
        """
        return _run("mien_measure_area", {"mesh": mesh, "zone": zone, "session": self})[0]

    def measure_curvature(self, mesh: Mesh, radius_mm: float, robust: int, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Curvatures of a surface, per vertex and per zone, by fits of a cubic around each vertex.
        mesh: #V x 3, mm, with triangles counter-clockwise seen from outside.
        radius_mm: > 0; of the fits: what is smaller is smoothed away. 6 suits fitted faces.
        robust: 1: a second fit leaves spikes and lashes out; 0: none.
        options: may be left out; zones, progress and cancel are read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (robust),
        MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (zones), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_curvature()
        """
        return _run("mien_measure_curvature", {"mesh": mesh, "radius_mm": radius_mm, "robust": robust, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_lengths(self, mesh: Mesh, pairs: ArrayLike) -> MeasureLengths:
        """Straight lengths and lengths along the surface between pairs of vertices.
        mesh: #V x 3, mm, with triangles.
        pairs: pair_count x 2 vertex numbers.
        straight_mm: pair_count values.
        geodesic_mm: pair_count values; by the heat method, within about one percent; infinite where no surface
        joins the two.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (vertex), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_measure_lengths()
        """
        return MeasureLengths(*_run("mien_measure_lengths", {"mesh": mesh, "pairs": pairs, "session": self}))

    def measure_scan_volume(self, before: Mesh, after: Mesh, carry: Carry | int, direction: ArrayLike | None = None, options: MeasureOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> MeasureScanVolume:
        """The volume between two surfaces that are not in correspondence, scan to scan: each vertex of before is
        carried onto after, then the swept volume is measured. Triangles without a partner do not count.
        before: #V x 3, mm, with triangles.
        after: another surface with triangles, aligned with before.
        carry: MIEN_CARRY_*.
        direction: 3 numbers, any length but zero; may be left out unless carry is MIEN_CARRY_DIRECTION.
        options: may be left out; zones (of before), max_distance_mm (0: 20), limit_of_detection_ml, progress,
        cancel. Deviations are not read.
        coverage: may be left out; share of before's area that had a partner, 0 to 1.
        out: the measurement.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_SOLUTION (nothing within reach), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_scan_volume()
        """
        return MeasureScanVolume(*_run("mien_measure_scan_volume", {"before": before, "after": after, "carry": carry, "direction": direction, "options": options, "session": self}, progress=progress, cancel=cancel))

    def measure_align(self, moving: Mesh, target: Mesh, stable: Zone | None = None) -> MeasureAlign:
        """Moves one face rigidly onto another by a zone that has not changed (forehead, nose bridge), robustly: by
        correspondence first, then by closest points, because a fit slides along a scan more than it lifts off.
        Surfaces with other triangles (two scans) are brought together by closest points alone and must lie within
        15 mm of each other there. The deviations feed alignment_rotation_sd_rad, alignment_translation_sd_mm and
        alignment_centre.
        moving: #V x 3, mm, with triangles.
        target: with triangles.
        stable: may be left out: all vertices. Vertices of target.
        info: may be left out
        out: the moved mesh.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH,
        MIEN_E_NO_SOLUTION (zone too small or straight), MIEN_E_NO_MEMORY.
        C: mien_measure_align()
        """
        return MeasureAlign(*_run("mien_measure_align", {"moving": moving, "target": target, "stable": stable, "session": self}))

    def measure_asymmetry(self, face: Mesh, template_mesh: Mesh, options: AsymmetryOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Measurement:
        """Compares the left side of a face with the reflection of its right side: volume and distance, signed
        (positive: the left side lies farther out), whole and per zone, with intervals. Zones of both sides
        ("cheek_left", "cheek_right") are one comparison ("cheek"); of a zone in the middle the left half is
        compared with the right half. The result holds volumes, distances, and fields of all vertices (a right
        vertex against the reflected left side).
        face: #V x 3, mm, in the template's topology.
        template_mesh: the template, symmetric about its plane x = 0, +x to the left (mien_model_mesh()).
        options: may be left out: the whole side, no interval.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (plane),
        MIEN_E_INVALID_MESH (no triangles; the template is not symmetric), MIEN_E_MISMATCH (vertex counts,
        zones, landmarks, deviations), MIEN_E_NO_SOLUTION (no plane is determined), MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_asymmetry()
        """
        return _run("mien_measure_asymmetry", {"face": face, "template_mesh": template_mesh, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def register(self, model: Model, scan: Mesh, options: RegisterOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Registration:
        """Fits a model's template to a scan: start, then rounds of closest points, robust weights and a weighted solve
        with the model's prior, at falling noise levels; then a smooth field for the rest of the gap. A fit that
        cannot be trusted is not an error: ask mien_registration_get_verdict().
        scan: a surface or a cloud of points, any connectivity, any frame; its unit is detected (options.units),
        any rotation is found.
        options: may be left out: no landmarks, all defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (nothing left after
        cleaning), MIEN_E_MISMATCH (scan_weights; landmarks whose left and right are exchanged),
        MIEN_E_NOT_FOUND (start by landmarks, fewer than three known to the model), MIEN_E_NO_SOLUTION,
        MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED, MIEN_E_CALLBACK.
        C: mien_register()
        """
        return _run("mien_register", {"model": model, "scan": scan, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def surface_transfer_points(self, surface: Mesh, points: ArrayLike, max_distance_mm: float) -> SurfaceTransferPoints:
        """Carries places (landmarks, points of a contour) from one surface to another in the same frame, e.g. from a
        fitted template to the scan under it or back: for each the nearest place on the other surface.
        surface: where the places go; a mesh or a cloud of points, mm.
        points: #P x 3, F32 or F64, mm.
        max_distance_mm: farther places are lost (triangle 0xFFFFFFFF); 0: 10, below 0: no limit.
        triangles: triangle (cloud: vertex) numbers of `surface`.
        barycentric: rows of 3 values.
        positions: rows of 3 values in mm; a lost place keeps where it was.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_surface_transfer_points()
        """
        return SurfaceTransferPoints(*_run("mien_surface_transfer_points", {"surface": surface, "points": points, "max_distance_mm": max_distance_mm, "session": self}))

    def surface_transfer_zone(self, from_: Mesh, to: Mesh, max_distance_mm: float, vertices: ArrayLike | None = None) -> numpy.ndarray:
        """Carries a zone from one surface to another in the same frame: the vertices of `to` whose nearest place on
        `from` lies in the zone (barycentric share of its vertices at least one half), ascending.
        from: with the zone's vertices.
        vertices: vertex_count vertex numbers of `from`
        max_distance_mm: farther vertices stay out; 0: 10, below 0: no limit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (a fitted template
        without triangles), MIEN_E_MISMATCH (a vertex that `from` does not have), MIEN_E_MEMORY_BUDGET,
        MIEN_E_NO_MEMORY.
        C: mien_surface_transfer_zone()
        """
        return _run("mien_surface_transfer_zone", {"from": from_, "to": to, "max_distance_mm": max_distance_mm, "vertices": vertices, "session": self})[0]

    def surface_transfer_json(self, model: Model, fitted: Mesh, scan: Mesh, what: Transfer | int, max_distance_mm: float) -> str:
        """A model's landmarks or zones, carried from its fitted template to a scan, as JSON text in the form of the
        landmark and zone files: {"points": {name: [x, y, z]}, "distances_mm": {name: d}} or {"zones": {name: [scan
        vertex, ...]}}.
        model: whose landmarks and zones are meant.
        fitted: the model's template after registration.
        scan: in the frame of fitted, mm.
        what: MIEN_TRANSFER_LANDMARKS or MIEN_TRANSFER_ZONES.
        max_distance_mm: farther places are left out; 0: 10, below 0: no limit.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (what),
        MIEN_E_MISMATCH (fitted is not of the model), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_surface_transfer_json()
        """
        return _run("mien_surface_transfer_json", {"model": model, "fitted": fitted, "scan": scan, "what": what, "max_distance_mm": max_distance_mm, "session": self})[0]

    def spectral_split(self, basis: SpectralBasis, face: Mesh, k: int) -> SpectralSplit:
        """Splits a face at mode k: the mean moved by its low, and by its high frequencies. low + high - mean is the
        face.
        face: #V vertices, mm, aligned with the mean shape.
        k: 0 to the basis' modes.
        low: may be left out; the low band's mesh.
        high: may be left out; the high band's mesh.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_MEMORY.
        C: mien_spectral_split()
        """
        return SpectralSplit(*_run("mien_spectral_split", {"basis": basis, "face": face, "k": k, "session": self}))

    def spectral_assemble(self, basis: SpectralBasis, low: Mesh, high: Mesh, k: int) -> Mesh:
        """The low frequencies of one face with the high frequencies of another.
        low: #V vertices, mm.
        high: #V vertices, mm.
        k: 0 to the basis' modes; #V or more gives `low`.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (k), MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_MEMORY.
        C: mien_spectral_assemble()
        """
        return _run("mien_spectral_assemble", {"basis": basis, "low": low, "high": high, "k": k, "session": self})[0]

    def spectral_edit(self, basis: SpectralBasis, face: Mesh, gains: ArrayLike, limits: ArrayLike | None = None) -> Mesh:
        """Multiplies each band of a face by a gain: 0 smooths it away, 1 keeps it, more exaggerates it.
        face: #V vertices, mm.
        limits: limit_count ascending mode numbers
        gains: limit_count + 1 finite values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, gains), MIEN_E_MISMATCH (vertex
        count), MIEN_E_NO_MEMORY.
        C: mien_spectral_edit()
        """
        return _run("mien_spectral_edit", {"basis": basis, "face": face, "gains": gains, "limits": limits, "session": self})[0]

    def spectral_mix(self, basis: SpectralBasis, first: Mesh, second: Mesh, weights: ArrayLike, limits: ArrayLike | None = None) -> Mesh:
        """Moves each band of one face towards another's by its own weight; weights 1 and 0 exchange details.
        first: #V vertices, mm; weight 0.
        second: #V vertices, mm; weight 1.
        limits: limit_count ascending mode numbers
        weights: limit_count + 1 finite values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (limits, weights), MIEN_E_MISMATCH (vertex
        count), MIEN_E_NO_MEMORY.
        C: mien_spectral_mix()
        """
        return _run("mien_spectral_mix", {"basis": basis, "first": first, "second": second, "weights": weights, "limits": limits, "session": self})[0]

    def spectral_project(self, basis: SpectralBasis, face: Mesh, mode_count: int) -> numpy.ndarray:
        """Spectral coefficients of a face: U' M (face - mean), one row of x, y, z per mode, float64.
        face: #V vertices, mm, aligned with the mean shape.
        mode_count: 0 to the basis' modes: the first of them; more means all.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
        MIEN_E_NO_MEMORY.
        C: mien_spectral_project()
        """
        return _run("mien_spectral_project", {"basis": basis, "face": face, "mode_count": mode_count, "session": self})[0]

    def spectral_synthesize(self, basis: SpectralBasis, first_mode: int, coefficients: ArrayLike | None = None) -> Mesh:
        """The face that has these spectral coefficients: mean + U c. All other modes are zero.
        coefficients: row_count x 3 row-major float64, finite
        first_mode: the mode of the first row.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (modes, not finite), MIEN_E_NO_MEMORY.
        C: mien_spectral_synthesize()
        """
        return _run("mien_spectral_synthesize", {"basis": basis, "first_mode": first_mode, "coefficients": coefficients, "session": self})[0]

    def metric(self, metric: Metric | int, reference: Mesh, other: Mesh) -> float:
        """A geometric or perceptual distance. L1, L2 and DAME need correspondence, the others do not.
        metric: MIEN_METRIC_...
        reference: mm.
        other: mm.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
        MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY.
        C: mien_metric()
        """
        return _run("mien_metric", {"metric": metric, "reference": reference, "other": other, "session": self})[0]

    def metric_field(self, metric: Metric | int, reference: Mesh, other: Mesh) -> numpy.ndarray:
        """Where a distance comes from: one value per vertex of the reference. L1: |dx| + |dy| + |dz|; L2: distance of
        the two vertices; Hausdorff: of the vertex from the other surface; DAME: masked change of the dihedral
        angles around the vertex, rad; FMPD: how much rougher (above 0) or smoother (below 0) the other looks there,
        after saturation and masking.
        metric: MIEN_METRIC_...
        reference: mm.
        other: mm; the reference's triangles, but for Hausdorff.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (metric),
        MIEN_E_MISMATCH (vertex count or triangles), MIEN_E_INVALID_MESH (no triangles), MIEN_E_NO_MEMORY.
        C: mien_metric_field()
        """
        return _run("mien_metric_field", {"metric": metric, "reference": reference, "other": other, "session": self})[0]

    def metric_roughness(self, mesh: Mesh) -> numpy.ndarray:
        """Local roughness of one mesh, what FMPD is made of: the Laplacian of the angle defect, rad, zero at borders.
        mesh: with triangles.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH (no triangles),
        MIEN_E_NO_MEMORY.
        C: mien_metric_roughness()
        """
        return _run("mien_metric_roughness", {"mesh": mesh, "session": self})[0]

    def transfer_expression(self, source_neutral: Mesh, source_expression: Mesh, target_neutral: Mesh) -> Mesh:
        """Carries an expression from one face to another by deformation transfer.
        source_neutral: #V vertices, mm.
        source_expression: the same person with the expression.
        target_neutral: #V vertices, mm; its triangles hold for all.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (vertex counts), MIEN_E_INVALID_MESH (no triangles),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY.
        C: mien_transfer_expression()
        """
        return _run("mien_transfer_expression", {"source_neutral": source_neutral, "source_expression": source_expression, "target_neutral": target_neutral, "session": self})[0]

    def neutralize(self, model: ExpressionModel, fitted: Registration, options: NeutralizeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Neutralization:
        """mien_neutralize_mesh() of a registered face: its weights say where the scan had data, its pose is that of
        the scan. options.weights, where given, replace the registration's.
        fitted: registered with the template of the model's training faces.
        options: may be left out: defaults.
        Fails with as mien_neutralize_mesh().
        C: mien_neutralize()
        """
        return _run("mien_neutralize", {"model": model, "fitted": fitted, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def neutralize_mesh(self, model: ExpressionModel, face: Mesh, options: NeutralizeOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Neutralization:
        """Takes the expression off a face and keeps everything that the model does not explain.
        face: in the model's topology, or in a larger one that begins with it (there the displacement runs out
        smoothly behind the model's rim); mm.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a switch or an
        enumerator that this library does not know), MIEN_E_MISMATCH (topology, weights), MIEN_E_NO_SOLUTION
        (MIEN_FIT_EXACT with too little of the face visible), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_neutralize_mesh()
        """
        return _run("mien_neutralize_mesh", {"model": model, "face": face, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def evaluate_neutralization(self, model: ExpressionModel, dataset_path: Text, options: EvaluateOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Evaluation:
        """Neutralizes every face of a dataset whose subject has a neutral face, and compares.
        model: in the dataset's topology.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a fit that this
        library does not know), MIEN_E_MISMATCH, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_evaluate_neutralization()
        """
        return _run("mien_evaluate_neutralization", {"model": model, "dataset_path": dataset_path, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def measure_geodesic(self, mesh: Mesh, sources: ArrayLike, options: GeodesicOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> numpy.ndarray:
        """Distance of every vertex from the nearest of some vertices, along the surface, by the heat method; a model's
        template is a mesh too (mien_model_mesh()). Holes are gone around, edges are not followed.
        mesh: #V x 3, mm, with triangles.
        sources: source_count vertex numbers.
        options: may be left out: heat stays inside, a time of 4 mean edges squared.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH,
        MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_SOLUTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_measure_geodesic()
        """
        return _run("mien_measure_geodesic", {"mesh": mesh, "sources": sources, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def statistics_agreement(self, ratings: ArrayLike, rater_count: int, grade_count: int) -> str:
        """How far raters (or one rater's sessions) agree, as JSON: confusion matrices, percent agreement, Cohen's
        kappa plain, linear and quadratic, Fleiss' kappa, all six intraclass correlations, majority grades.
        ratings: subject_count x rater_count, 0 .. grade_count - 1, negative: missing.
        rater_count: 2 to 1000.
        grade_count: 2 to 1000.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (grades, no subject graded by all),
        MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY.
        C: mien_statistics_agreement()
        """
        return _run("mien_statistics_agreement", {"ratings": ratings, "rater_count": rater_count, "grade_count": grade_count, "session": self})[0]

    def statistics_repeatability(self, subjects: ArrayLike, values: ArrayLike | None = None, blanks: ArrayLike | None = None) -> str:
        """Within-subject deviation and repeatability coefficient of repeated captures, and the limit of detection from
        changes measured where nothing changed, as JSON.
        values: value_count values
        subjects: value_count numbers: who was measured.
        blanks: blank_count changes measured without any true one; may be left out when 0.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY.
        C: mien_statistics_repeatability()
        """
        return _run("mien_statistics_repeatability", {"subjects": subjects, "values": values, "blanks": blanks, "session": self})[0]

    def statistics_bland_altman(self, first: ArrayLike, second: ArrayLike) -> str:
        """Bland and Altman's comparison of two methods on the same subjects, as JSON: bias, limits of agreement, their
        intervals, and whether the bias grows with the size.
        first: value_count values.
        second: value_count values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BUFFER_TOO_SMALL, MIEN_E_NO_MEMORY.
        C: mien_statistics_bland_altman()
        """
        return _run("mien_statistics_bland_altman", {"first": first, "second": second, "session": self})[0]

    def neutralize_series(self, model: ExpressionModel, faces: Sequence[Mesh], options: SeriesOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Series:
        """Neutralizes several scans of one person together: one identity, an expression each.
        faces: face_count faces in one topology: the model's, or a larger one that begins with it (there the
        displacement runs out smoothly behind the model's rim).
        options: may be left out: defaults.
        Fails with as mien_neutralize_mesh().
        C: mien_neutralize_series()
        """
        return _run("mien_neutralize_series", {"model": model, "faces": faces, "options": options, "session": self}, progress=progress, cancel=cancel)[0]

    def template_check(self, template_mesh: Mesh, mirror: int, landmarks: Landmarks | None = None) -> str:
        """Looks for what makes a mesh a bad template: size and unit (a face, head or bust in mm), windings (inside
        out, or mixed), helpers and other pieces, degenerate and doubled parts, symmetry, and, where landmarks of
        the 68-point scheme are given, pose, left and right, closed eyes and mouth. The findings come as JSON text
        by the two-call protocol: {"errors": n, "warnings": n, "findings": [{"kind": "error" or "warning", "code",
        "text", "vertices": [...]}]}. No model should be built from a mesh with errors; mien_model_build() does not
        ask.
        template_mesh: the mesh as it is given to mien_model_build().
        landmarks: may be left out; vertices of the mesh.
        mirror: 1: symmetry about x = 0 is asked for, as by options.mirror_symmetric; 0.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a landmark that is no vertex of the mesh),
        MIEN_E_UNSUPPORTED_OPTION (mirror), MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_template_check()
        """
        return _run("mien_template_check", {"template_mesh": template_mesh, "mirror": mirror, "landmarks": landmarks, "session": self})[0]

    def expression_shard_create(self, dataset_path: Text, shard_path: Text, options: ShardOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> None:
        """Writes a shard: what a part of a dataset contributes to training, for a cluster's scheduler. Parts are made
        by subject, every part_count-th of the sorted subject numbers.
        options: may be left out: the whole dataset.
        shard_path: written atomically.
        Fails with as mien_expression_model_train(); MIEN_E_INVALID_ARGUMENT for a part that does not exist or
        is empty.
        C: mien_expression_shard_create()
        """
        _run("mien_expression_shard_create", {"dataset_path": dataset_path, "shard_path": shard_path, "options": options, "session": self}, progress=progress, cancel=cancel)

    def neutralize_visits(self, model: ExpressionModel, faces: Sequence[Mesh], options: VisitsOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Visits:
        """Takes the expressions off faces of one person, first visit first, so that the neutral faces are in
        correspondence along the skin and differ by what changed. The right road to a volume over time: fitted
        templates slide along the skin, and mien_neutralize() takes a part of the slide for expression.
        faces: face_count fitted faces, mm, in one topology: the model's, or a larger one that begins with it
        (there the displacement runs out smoothly behind the model's rim).
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a pose that this
        library does not know), MIEN_E_INVALID_MESH, MIEN_E_MISMATCH (topology, weights, treated vertices),
        MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_neutralize_visits()
        """
        return _run("mien_neutralize_visits", {"model": model, "faces": faces, "options": options, "session": self}, progress=progress, cancel=cancel)[0]
