"""Network. Written by abi/generate_bindings.py; how classes work stands in runtime.py."""
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


class Network(_Object):
    """A trained network with everything that belongs to it: layers, weights, neighbour lists and statistics of one
    template. It may be one network, or two over the low and the high frequencies of a face, joined by spectral
    assembly; the code of the latter holds first the low band's numbers, then the high band's. Immutable: share
    freely.
    """
    _release = "mien_network_release"
    _retain = "mien_network_retain"

    def share(self) -> Network:
        """One more object for the same native one: each may be closed by itself."""
        return self._share()

    @staticmethod
    def load(session: Session, path: Text) -> Network:
        """Loads a network file through a memory map and checks all of it: structure, hash, finite weights, every index
        of every list. A file is treated as hostile.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT,
        MIEN_E_WRONG_KIND, MIEN_E_UNSUPPORTED_VERSION, MIEN_E_MEMORY_BUDGET, MIEN_E_NO_MEMORY.
        C: mien_network_load()
        """
        return _run("mien_network_load", {"session": session, "path": path})[0]

    @staticmethod
    def load_memory(session: Session, data: bytes) -> Network:
        """Loads a network from the bytes of a network file that the host holds in memory, e.g. as a resource of its
        program. The bytes are copied.
        data: size bytes.
        Fails with as mien_network_load(), without MIEN_E_IO.
        C: mien_network_load_memory()
        """
        return _run("mien_network_load_memory", {"session": session, "data": data})[0]

    def counts(self) -> NetworkCounts:
        """Numbers of vertices of the faces and of numbers in a code.
        vertex_count: may be left out; #V.
        code_count: may be left out; numbers of a code.
        C: mien_network_get_counts()
        """
        return NetworkCounts(*_run("mien_network_get_counts", {"network": self}))

    def json(self) -> str:
        """What the network is, as JSON: name, sizes, features, layers with their multiply-adds, and what its training
        wrote down.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_network_get_json()
        """
        return _run("mien_network_get_json", {"network": self})[0]

    def mean(self) -> Mesh:
        """The mean face of the network's training, in whose frame codes are decoded.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_NO_MEMORY.
        C: mien_network_get_mean()
        """
        return _run("mien_network_get_mean", {"network": self})[0]

    def encode(self, session: Session, face: Mesh, options: NetworkOptions | None = None) -> NetworkEncode:
        """The code of a face. With dst null and capacity 0: writes the count only.
        face: #V vertices in the network's topology, mm, anywhere.
        options: may be left out: defaults.
        motion: may be left out; 12 float64: the rigid motion onto the mean, x -> R x + t, as R row by row, then
        t in mm. mien_network_decode() takes it back.
        dst: values.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (no encoder),
        MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION (no rigid motion; a
        result that is not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_network_encode()
        """
        return NetworkEncode(*_run("mien_network_encode", {"session": session, "face": face, "options": options, "network": self}))

    def decode(self, session: Session, code: ArrayLike, motion: ArrayLike | None = None, options: NetworkOptions | None = None) -> Mesh:
        """The face of a code.
        code: code_count finite values.
        motion: may be left out: the mean's frame; 12 float64 of mien_network_encode(), which is undone.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (not finite, motion not rigid),
        MIEN_E_UNSUPPORTED_OPTION (no decoder; a network that adds an expression), MIEN_E_MISMATCH (code_count),
        MIEN_E_NO_SOLUTION (a result that is not finite), MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_network_decode()
        """
        return _run("mien_network_decode", {"session": session, "code": code, "motion": motion, "options": options, "network": self})[0]

    def apply(self, session: Session, face: Mesh, options: NetworkOptions | None = None) -> Mesh:
        """The decoded face of a face's code, in the frame of that face: an autoencoder's reconstruction, or what the
        network was trained to make of a face (a neutral one into an expression, with what is the person's own
        kept). Networks on deformations, which know no place, have their result put onto the face rigidly; one that
        deforms a neutral face alone keeps that one's centre.
        face: #V vertices in the network's topology, mm, anywhere.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is
        missing), MIEN_E_MISMATCH (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION,
        MIEN_E_NO_MEMORY, MIEN_E_CANCELLED.
        C: mien_network_apply()
        """
        return _run("mien_network_apply", {"session": session, "face": face, "options": options, "network": self})[0]

    def bands(self) -> NetworkBands:
        """Which numbers of a code belong to which band. Editing some of them changes that band of the decoded face
        (and the other one as far as its decoder was conditioned).
        low_code_count: may be left out; numbers of the low band's code, which come first; all numbers of a
        network without bands.
        band_limit: may be left out; modes of the low band; -1 for a network without bands.
        C: mien_network_get_bands()
        """
        return NetworkBands(*_run("mien_network_get_bands", {"network": self}))

    def mix(self, session: Session, a: Mesh, b: Mesh, low_weight: float, high_weight: float, options: NetworkOptions | None = None) -> Mesh:
        """A face between two, or with the bands of both: each band's code goes from a's to b's by its own weight and
        is decoded. Weights 0 and 0 give a as the network gives it back, 1 and 0 or 0 and 1 exchange a band, equal
        ones interpolate. A network without bands takes the first weight.
        a: #V vertices in the network's topology, mm, anywhere.
        b: #V vertices in the network's topology, mm, anywhere.
        low_weight: of the low band; any finite number.
        high_weight: of the high band; any finite number.
        options: may be left out: defaults.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (a weight that is not finite),
        MIEN_E_UNSUPPORTED_OPTION (a half is missing; a network that adds an expression), MIEN_E_MISMATCH
        (vertex count), MIEN_E_INVALID_MESH (not finite), MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_network_mix()
        """
        return _run("mien_network_mix", {"session": session, "a": a, "b": b, "low_weight": low_weight, "high_weight": high_weight, "options": options, "network": self})[0]

    def sample(self, seed: int, number: int, spread: float) -> numpy.ndarray:
        """The code of a made-up face: drawn from a Gaussian over the codes of the training faces, which the file
        holds. Number and seed alone decide. With dst null and capacity 0: writes the count only.
        seed: of the chance.
        number: of the code within the seed's series.
        spread: 0 the mean code, 1 as far apart as the training faces; not negative.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT (spread), MIEN_E_UNSUPPORTED_OPTION (no
        distribution in the file), MIEN_E_NO_MEMORY.
        C: mien_network_sample()
        """
        return _run("mien_network_sample", {"seed": seed, "number": number, "spread": spread, "network": self})[0]

    def evaluate(self, session: Session, dataset_path: Text, options: NetworkEvaluationOptions | None = None, progress: Progress | None = None, cancel: Cancel | None = None) -> str:
        """How well the network gives back the faces of a dataset, as JSON: l1_mm, l2_mm, dame and fmpd as means over
        the faces and by face. Judge a network on people that it was not trained on.
        dataset_path: a dataset file in the network's topology.
        options: may be left out: all faces.
        Fails with MIEN_E_INVALID_HANDLE, MIEN_E_INVALID_ARGUMENT, MIEN_E_UNSUPPORTED_OPTION (a half is missing,
        a switch, a network that adds an expression), MIEN_E_MISMATCH (vertex count), MIEN_E_NOT_FOUND (no such
        face), MIEN_E_IO, MIEN_E_BAD_FORMAT, MIEN_E_CORRUPT, MIEN_E_NO_SOLUTION, MIEN_E_NO_MEMORY,
        MIEN_E_CANCELLED.
        C: mien_network_evaluate()
        """
        return _run("mien_network_evaluate", {"session": session, "dataset_path": dataset_path, "options": options, "network": self}, progress=progress, cancel=cancel)[0]
