"""Batch. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Batch(_Object):
    """Scans to be fitted side by side with one model, and their fits."""
    _release = "mien_batch_release"
    _retain = "mien_batch_retain"

    def share(self) -> Batch:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def create(session: Session, model: Model) -> Batch:
        """An empty batch for a model.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_batch_create()
        """
        return _run("mien_batch_create", {"session": session, "model": model})[0]

    def add(self, session: Session, scan: Mesh, options: RegisterOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> None:
        """Adds a scan with its own options. The mesh is kept until the scan has been fitted.
        scan: as for mien_register().
        options: may be left out: no landmarks, all defaults. progress and cancel are not read.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NOT_FOUND (landmarks of which the
        model knows none), MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY.
        C: mien_batch_add()
        """
        _run("mien_batch_add", {"session": session, "scan": scan, "options": options, "batch": self}, progress=progress, cancel=cancel)

    def run(self, session: Session, options: BatchOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> None:
        """Fits all scans that were added and not yet fitted, each on one thread and as many at a time as the session
        has threads; each with the bits of mien_register(). A scan that cannot be fitted does not end the others:
        mien_batch_get_registration() says why. Memory is that of as many scans as threads, and of the fits.
        options: may be left out: all defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED, MIEN_E_CALLBACK; then no scan of this call is fitted.
        C: mien_batch_run()
        """
        _run("mien_batch_run", {"session": session, "options": options, "batch": self}, progress=progress, cancel=cancel)

    def counts(self) -> BatchCounts:
        """How many scans were added, and how many of them were run.
        scan_count: may be left out.
        run_count: may be left out.
        C: mien_batch_get_counts()
        """
        return BatchCounts(*_run("mien_batch_get_counts", {"batch": self}))

    def registration(self, index: int) -> Registration:
        """The fit of one scan, or the error that it ended with.
        index: 0 to run_count - 1, in the order of mien_batch_add().
        Fails with as mien_register(), MIEN_E_NOT_FOUND (no such scan, or it was not run).
        C: mien_batch_get_registration()
        """
        return _run("mien_batch_get_registration", {"index": index, "batch": self})[0]
