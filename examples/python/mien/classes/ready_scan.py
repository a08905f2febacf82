"""ReadyScan. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ReadyScan(_Object):
    """A scan that was cleaned, wound, weighed and put into a search tree, for any number of models and fits.
    Immutable: share freely.
    """
    _release = "mien_ready_scan_release"
    _retain = "mien_ready_scan_retain"

    def share(self) -> ReadyScan:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def create(session: Session, scan: Mesh, options: RegisterOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> ReadyScan:
        """Prepares a scan once. Its unit is that of the options, or told by its size; no face is looked for.
        scan: as for mien_register().
        options: may be left out: defaults. Of it units, unit_to_mm, scan_weights, skin_weights, progress and
        cancel are read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_INVALID_MESH, MIEN_E_MISMATCH
        (scan_weights), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_CANCELLED,
        MIEN_E_CALLBACK.
        C: mien_ready_scan_create()
        """
        return _run("mien_ready_scan_create", {"session": session, "scan": scan, "options": options}, progress=progress, cancel=cancel)[0]

    def register(self, session: Session, model: Model, options: RegisterOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> Registration:
        """mien_register() of a prepared scan: the same bits where the scan's unit is known or that which its size
        tells.
        options: may be left out: no landmarks, all defaults. What mien_ready_scan_create() reads is not read
        again, but for progress and cancel.
        Fails with as mien_register().
        C: mien_ready_scan_register()
        """
        return _run("mien_ready_scan_register", {"session": session, "model": model, "options": options, "scan": self}, progress=progress, cancel=cancel)[0]
