"""Measurement. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Measurement(_Object):
    """What was measured: numbers per zone and values per vertex. Immutable: share freely."""
    _release = "mien_measurement_release"

    def zones(self) -> MeasurementZones:
        """How many zones were measured.
        zone_count: may be left out; the number of zones given.
        zones_disjoint: may be left out; 1 when no vertex lies in two zones: zones and rest then add up.
        C: mien_measurement_get_zones()
        """
        return MeasurementZones(*_run("mien_measurement_get_zones", {"measurement": self}))

    def volume(self, zone: int) -> ZoneVolume:
        """The volume of a zone.
        zone: 0 .. zone_count - 1, MIEN_ZONE_WHOLE or MIEN_ZONE_REST.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no volume in
        it).
        C: mien_measurement_get_volume()
        """
        return _run("mien_measurement_get_volume", {"zone": zone, "measurement": self})[0]

    def distance(self, zone: int) -> ZoneDistance:
        """The distances of a zone.
        zone: 0 .. zone_count - 1 or MIEN_ZONE_WHOLE.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (no such zone, no distance
        in it).
        C: mien_measurement_get_distance()
        """
        return _run("mien_measurement_get_distance", {"zone": zone, "measurement": self})[0]

    def field(self, field: Field | int) -> numpy.ndarray:
        """Copies a field with one float64 per vertex of the before face; NaN where there was no partner.
        field: MIEN_FIELD_*.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (this measurement has no such field).
        C: mien_measurement_get_field()
        """
        return _run("mien_measurement_get_field", {"field": field, "measurement": self})[0]

    def json(self) -> str:
        """The whole measurement as JSON text.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_measurement_get_json()
        """
        return _run("mien_measurement_get_json", {"measurement": self})[0]

    def mirror_plane(self) -> MirrorPlane:
        """The mirror plane of a comparison of left and right.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (another measurement).
        C: mien_measurement_get_mirror_plane()
        """
        return _run("mien_measurement_get_mirror_plane", {"measurement": self})[0]
