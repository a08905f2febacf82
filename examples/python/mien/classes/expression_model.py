"""ExpressionModel. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class ExpressionModel(_Object):
    """What was learned of faces and expressions: an identity subspace, an expression subspace, a prior of both.
    Immutable: share freely between threads.
    """
    _release = "mien_expression_model_release"
    _retain = "mien_expression_model_retain"

    def share(self) -> ExpressionModel:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> ExpressionModel:
        """Loads a model file. The file is treated as hostile; the modes stay in the mapped file.
        Fails with MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT,
        MIEN_E_NO_MEMORY.
        C: mien_expression_model_load()
        """
        return _run("mien_expression_model_load", {"session": session, "path": path})[0]

    @staticmethod
    def load_memory(session: Session, data: bytes) -> ExpressionModel:
        """Loads a model from the bytes of a model file that the host holds in memory. They are copied and checked like
        a file.
        data: size bytes, any alignment; not read after the call.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_BAD_FORMAT, MIEN_E_WRONG_KIND,
        MIEN_E_UNSUPPORTED_VERSION, MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_expression_model_load_memory()
        """
        return _run("mien_expression_model_load_memory", {"session": session, "data": data})[0]

    def save(self, session: Session, path: Text) -> None:
        """Writes a model file (safetensors, kind "mien-expression-model"). Atomic.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_IO, MIEN_E_NO_MEMORY.
        C: mien_expression_model_save()
        """
        _run("mien_expression_model_save", {"session": session, "path": path, "model": self})

    def counts(self) -> ExpressionModelCounts:
        """Numbers of vertices and modes.
        vertex_count: may be left out; #V.
        identity_modes: may be left out.
        expression_modes: may be left out.
        C: mien_expression_model_get_counts()
        """
        return ExpressionModelCounts(*_run("mien_expression_model_get_counts", {"model": self}))

    def json(self) -> str:
        """What the model is, and after training how the training went, as a JSON object: sizes, expressions, noise
        levels, iterations, orthogonality score per number of components, explained shares.
        Fails with MIEN_E_INVALID_HANDLE.
        C: mien_expression_model_get_json()
        """
        return _run("mien_expression_model_get_json", {"model": self})[0]

    def synthesize(self, session: Session, identity: ArrayLike | None = None, expression: ArrayLike | None = None) -> Mesh:
        """A face made from coordinates: mean + identity modes x identity + expression modes x expression.
        identity: count identity_modes, F32 or F64, mm; count 0 (or null): the mean identity.
        expression: count expression_modes, F32 or F64, mm; count 0 (or null): neutral.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_MISMATCH (counts), MIEN_E_NO_MEMORY.
        C: mien_expression_model_synthesize()
        """
        return _run("mien_expression_model_synthesize", {"session": session, "identity": identity, "expression": expression, "model": self})[0]

    def sample(self, session: Session, seed: int, expression: Text | None = None) -> Mesh:
        """A random face of the model: identity coordinates from their Gaussian, expression coordinates from the prior
        of one expression.
        seed: any number; the same seed gives the same face on every machine.
        expression: name of an expression of the model, "neutral", "any" (all expressions together), or null:
        neutral without any expression.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NOT_FOUND (expression), MIEN_E_NO_MEMORY.
        C: mien_expression_model_sample()
        """
        return _run("mien_expression_model_sample", {"session": session, "seed": seed, "expression": expression, "model": self})[0]

    def transfer(self, session: Session, source: Neutralization, target: Neutralization) -> Mesh:
        """Puts the expression of one neutralized face onto another one's neutral face.
        source: whose expression is taken.
        target: whose neutral face receives it.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_MISMATCH (another model), MIEN_E_NO_MEMORY.
        C: mien_expression_model_transfer()
        """
        return _run("mien_expression_model_transfer", {"session": session, "source": source, "target": target, "model": self})[0]

    @staticmethod
    def train(session: Session, dataset_path: Text, options: TrainOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> ExpressionModel:
        """Trains an expression model from a dataset file (see dataset.h) with an expression named "neutral". The faces
        are read through a memory map in blocks, so the file may be larger than memory. Subjects without a neutral
        face are left out; missing expressions and repeated captures are fine.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_ARGUMENT (an option; no neutral faces; nothing to learn),
        MIEN_E_UNSUPPORTED_OPTION (a method that this library does not know), MIEN_E_IO, MIEN_E_BAD_FORMAT,
        MIEN_E_CORRUPT, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY, MIEN_E_NO_SOLUTION, MIEN_E_CANCELLED.
        C: mien_expression_model_train()
        """
        return _run("mien_expression_model_train", {"session": session, "dataset_path": dataset_path, "options": options}, progress=progress, cancel=cancel)[0]

    @staticmethod
    def merge(session: Session, shard_paths: Sequence[str], options: TrainOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> ExpressionModel:
        """Trains from shards. Equals training on all their faces at once to rounding, as long as no shard had to cut
        its rank.
        shard_paths: shard_count UTF-8 paths.
        options: may be left out: defaults. stable_vertices must be empty: the shards' own count.
        Fails with as mien_expression_model_train(); MIEN_E_WRONG_KIND, MIEN_E_MISMATCH (shards of different
        topologies, expression names or alignments), MIEN_E_INVALID_ARGUMENT (a subject in two shards).
        C: mien_expression_model_merge()
        """
        return _run("mien_expression_model_merge", {"session": session, "shard_paths": shard_paths, "options": options}, progress=progress, cancel=cancel)[0]
