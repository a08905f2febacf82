"""DatasetWriter. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class DatasetWriter(_Object):
    """Collects faces with a subject and an expression each, then saves them as one safetensors file: vertices f32
    [s, n, 3], subject i32 [s], expression i32 [s], triangles u32 [m, 3]. Externally synchronized.
    """
    _release = "mien_dataset_writer_release"

    @staticmethod
    def create(session: Session, topology: Mesh, expression_names: Sequence[str]) -> DatasetWriter:
        """Starts a dataset in the topology of a mesh.
        topology: its triangles and vertex count hold for all faces.
        expression_names: expression_count UTF-8 names. One should be "neutral".
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_NO_MEMORY.
        C: mien_dataset_writer_create()
        """
        return _run("mien_dataset_writer_create", {"session": session, "topology": topology, "expression_names": expression_names})[0]

    def add(self, positions: ArrayLike, subject: int, expression: int) -> None:
        """Adds one face; its positions are copied.
        positions: #V x 3, F32 or F64, mm.
        subject: any number that names the person.
        expression: index into the expression names.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (vertex count),
        MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_MEMORY.
        C: mien_dataset_writer_add()
        """
        _run("mien_dataset_writer_add", {"positions": positions, "subject": subject, "expression": expression, "writer": self})

    def save(self, session: Session, path: Text) -> None:
        """Writes all faces added so far. Atomic; more may be added and saved again.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (no face), MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_dataset_writer_save()
        """
        _run("mien_dataset_writer_save", {"session": session, "path": path, "writer": self})
