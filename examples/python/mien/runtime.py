"""What the classes stand on: loading the library, owning handles, carrying arguments over and results back.

The tables in abi.py say what each parameter is; run() follows them. Nothing here knows a single function.
"""
from __future__ import annotations

import ctypes
import keyword
import os
import sys
import threading
import weakref
from pathlib import Path
from typing import Any, Callable, TypeVar, Union

import numpy

from . import abi

#: progress(stage, fraction) of a long call; False cancels it.
Progress = Callable[[int, float], Any]
Text = Union[str, "os.PathLike[str]"]
_SCRATCH_BYTES = 65536  # room of the first try where a result's size is not known


def library_path() -> str:
    """MIEN_LIBRARY, else the library beside this package (a wheel), else what the system's search finds."""
    given = os.environ.get("MIEN_LIBRARY")
    if given:
        return given
    name = {"win32": "mien-0.dll", "darwin": "libmien.0.dylib"}.get(sys.platform, "libmien.so.0")
    beside = Path(__file__).resolve().parent / "native" / name
    return str(beside) if beside.exists() else name


def _load() -> ctypes.CDLL:
    library = ctypes.CDLL(library_path())
    for name, (result, _, parameters) in abi.FUNCTIONS.items():
        function = getattr(library, name, None)
        if function is None:
            raise ImportError(f"{library_path()} has no {name}(): it is older than this package ({abi.VERSION})")
        function.restype = abi.NUMBERS[result][0] if isinstance(result, str) else result
        function.argtypes = [_argument_type(role, base) for _, role, base, *_ in parameters]
    return library


def _argument_type(role: str, base: str) -> Any:
    by_value = ("scalar", "count", "capacity", "struct_size")
    return abi.NUMBERS[base][0] if role in by_value else ctypes.c_void_p


_library = _load()
_classes: dict[str, Any] = {}


def register_classes(names: dict[str, Any]) -> None:
    _classes.update(names)


def _class_of(base: str) -> Any:
    return _classes["".join(word.capitalize() for word in base.split("_")[1:])]


class Error(Exception):
    """A failed call: the status, its name, and the first offending index or -1."""

    def __init__(self, record: Any) -> None:
        super().__init__(record.message.decode("utf-8", "replace"))
        self.status: int = record.status
        self.name: str = _library.mien_status_name(record.status).decode()
        self.detail_index: int = record.detail_index


class Cancelled(Error):
    """A progress function returned False, or a cancel token was requested."""


class _Handle:
    """One reference to a native object: given back when it is closed and no call or view uses it."""

    def __init__(self, pointer: int, release: str) -> None:
        self.pointer, self.release, self.users, self.closed = pointer, getattr(_library, release), 0, False
        self.lock, self.serial = threading.Lock(), threading.RLock()

    def acquire(self) -> int:
        with self.lock:
            if self.closed:
                raise ValueError("the object is closed")
            self.users += 1
            return self.pointer

    def done(self) -> None:
        with self.lock:
            self.users -= 1
            self._give_back()

    def close(self) -> None:
        with self.lock:
            self.closed = True
            self._give_back()

    def _give_back(self) -> None:
        if self.closed and self.users == 0 and self.pointer:
            self.release(self.pointer)
            self.pointer = 0


_Self = TypeVar("_Self", bound="Object")  # typing.Self is of Python 3.11


class Object:
    """Owns a handle. A context manager; what is never closed goes with the garbage, in any order."""

    _release, _retain = "", ""
    _kept: Any = None  # callbacks that live as long as the object

    def _take(self, pointer: int) -> None:
        if isinstance(pointer, Object):  # made by run(): take its reference over
            pointer._finalizer.detach()
            self._handle, self._kept = pointer._handle, pointer._kept
        else:
            self._handle = _Handle(pointer, self._release)
        self._finalizer = weakref.finalize(self, self._handle.close)

    @classmethod
    def _own(cls, pointer: int) -> Any:
        made = cls.__new__(cls)
        made._take(pointer)
        return made

    @classmethod
    def _adopt(cls, pointer: int) -> Any:
        """A handle that something else owns, with one more reference for this object."""
        if not pointer:
            raise ValueError("the object is closed")
        getattr(_library, cls._retain)(pointer)
        return cls._own(pointer)

    def _share(self) -> Any:
        pointer = self._handle.acquire()
        try:
            return type(self)._adopt(pointer)
        finally:
            self._handle.done()

    def close(self) -> None:
        """Gives the native object back now; calls and views that still use it finish first."""
        self._finalizer()

    def __enter__(self: _Self) -> _Self:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()


def _attribute(field: str) -> str:
    return field + "_" if keyword.iskeyword(field) else field


class Record:
    """A struct of values; fields are attributes."""

    _name = ""

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in vars(self).items())})"

    @classmethod
    def _read(cls, raw: Any) -> Any:
        made = cls.__new__(cls)
        for name, role, base, _, enum in abi.STRUCTS[cls._name]:
            value = getattr(raw, name)
            if role == "struct":
                setattr(made, _attribute(name), _class_of(base)._read(value))
            if role == "fixed":
                setattr(made, _attribute(name), numpy.array(value[:]))
            elif role == "scalar":
                setattr(made, _attribute(name), _constant(enum, value))
        return made


class Options(Record):
    """A struct with the library's defaults; name what differs: RegisterOptions(close_gap=0)."""

    def __init__(self, **fields: Any) -> None:
        raw = _fresh(self._name)
        for field, role, _, _, enum in abi.STRUCTS[self._name]:
            name = _attribute(field)
            if role == "scalar":
                setattr(self, name, _constant(enum, getattr(raw, field)))
            elif role == "fixed":
                setattr(self, name, list(getattr(raw, field)))
            elif role in ("text", "texts", "array", "structs", "matrix", "handle", "callback") and name in self._names():
                setattr(self, name, None)
        for name, value in fields.items():
            setattr(self, name, value)

    @classmethod
    def _names(cls) -> set[str]:
        return {n for n in cls.__annotations__}

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self._names():
            raise AttributeError(f"{type(self).__name__} has no field '{name}'")
        super().__setattr__(name, value)


def _constant(enum: str, value: int) -> Any:
    """A named constant where the number is known; hosts must tolerate others."""
    kind = _classes.get("_enums", {}).get(enum) if enum else None
    try:
        return kind(value) if kind else value
    except ValueError:
        return value


def _fresh(name: str) -> Any:
    """A C struct with defaults (or its size alone, where it has no defaults)."""
    raw = _raw_class(name)()
    initialise = getattr(_library, name + "_init", None)
    if initialise is not None:
        initialise(ctypes.addressof(raw), ctypes.sizeof(raw))
    elif abi.STRUCTS[name][0][0] == "struct_size":
        raw.struct_size = ctypes.sizeof(raw)
    return raw


def _raw_class(name: str) -> Any:
    return getattr(abi, "".join(word.capitalize() for word in name.split("_")[1:]))


class _Arguments:
    """Memory, handles and locks of one call."""

    def __init__(self) -> None:
        self.kept: list[Any] = []
        self.callbacks: list[Any] = []
        self.handles: list[_Handle] = []
        self.thrown: BaseException | None = None

    def use(self, owner: Object) -> int:
        if not isinstance(owner, Object):
            raise TypeError(f"an object of the library is needed, not {type(owner).__name__}")
        pointer = owner._handle.acquire()
        self.handles.append(owner._handle)
        self.kept.append(owner)
        return pointer

    def done(self) -> None:
        for handle in self.handles:
            handle.done()

    def text(self, text: Any) -> int:
        data = os.fspath(text)
        data = data.encode("utf-8", "surrogateescape") if isinstance(data, str) else data
        if b"\0" in data:
            raise ValueError("a text holds a zero byte")
        buffer = ctypes.create_string_buffer(data)
        self.kept.append(buffer)
        return ctypes.addressof(buffer)

    def numbers(self, values: Any, base: str) -> numpy.ndarray:
        array = numpy.asarray(values)
        wanted = numpy.dtype(abi.NUMBERS[base][1])
        if array.size and wanted.kind in "iu":
            if array.dtype.kind not in "iub":
                raise TypeError(f"whole numbers are needed, not {array.dtype}")
            limits = numpy.iinfo(wanted)
            if int(array.min()) < limits.min or int(array.max()) > limits.max:
                raise ValueError(f"a number lies outside {wanted}")
        array = numpy.ascontiguousarray(array, dtype=wanted)
        self.kept.append(array)
        return array

    def matrix(self, values: Any, columns: int) -> Any:
        array = numpy.asarray(values)
        if array.dtype not in (numpy.float32, numpy.float64):
            array = array.astype(numpy.float64)
        array = array.reshape(-1, columns) if array.ndim != 2 or array.shape[1] != columns else array
        if array.strides[1] != array.itemsize or array.strides[0] < 0:
            array = numpy.ascontiguousarray(array)
        self.kept.append(array)
        dtype = 1 if array.dtype == numpy.float32 else 2
        return abi.ArrayView(array.ctypes.data, len(array), array.strides[0] if len(array) else 0, dtype, 0)

    def pointers(self, values: list[int]) -> int:
        array = (ctypes.c_void_p * max(1, len(values)))(*values)
        self.kept.append(array)
        return ctypes.addressof(array)

    def structs(self, name: str, values: Any) -> Any:
        rows = (_raw_class(name) * max(1, len(values)))()
        self.kept.append(rows)
        for row, value in zip(rows, values):
            self.fill(name, row, value)
        return rows

    def fill(self, name: str, raw: Any, value: Any) -> None:
        """Writes a record into its C struct; counts follow from the arrays."""
        if not isinstance(value, Record) or value._name != name:
            raise TypeError(f"{_raw_class(name).__name__} is needed, not {type(value).__name__}")
        if "struct_size" in dict(raw._fields_):
            raw.struct_size = ctypes.sizeof(raw)
        # Numbers and views first: lengths of arrays are checked against them.
        for field, role, base, count, _ in sorted(abi.STRUCTS[name], key=lambda row: row[1] not in ("scalar", "matrix")):
            given = getattr(value, _attribute(field), None)
            if given is None or role == "count":
                continue
            if role == "scalar":
                setattr(raw, field, given)
            elif role == "fixed":
                setattr(raw, field, tuple(given))
            elif role == "struct":
                self.fill(base, getattr(raw, field), given)
            elif role == "text":
                setattr(raw, field, self.text(given))
            elif role == "handle":
                setattr(raw, field, self.use(given))
            elif role == "matrix":
                setattr(raw, field, self.matrix(given, count[0]))
            elif role == "callback":
                setattr(raw, field, self.callback(base, given))
            else:
                self.list_field(raw, field, role, base, count, given)

    def list_field(self, raw: Any, field: str, role: str, base: str, count: tuple, given: Any) -> None:
        columns = int(numpy.prod([c if isinstance(c, int) else getattr(raw, c) for c in count[1:]], dtype=int))
        if role == "structs":
            rows, address = len(given), ctypes.addressof(self.structs(base, given))
        elif role == "texts":
            rows, address = len(given), self.pointers([self.text(t) for t in given])
        else:
            array = self.numbers(given, base)
            rows, address = _rows(array.size, columns, field), array.ctypes.data
        setattr(raw, field, address if rows else None)
        names = [name for name, *_ in raw._fields_]
        if "." in count[0]:  # as many as another field has
            holder, _, inner = count[0].partition(".")
            if getattr(getattr(raw, holder), inner) != rows:
                raise ValueError(f"{field} has {rows} rows, {holder} has {getattr(getattr(raw, holder), inner)}")
        elif names.index(count[0]) != names.index(field) + 1:  # the count belongs to another array
            if getattr(raw, count[0]) != rows:
                raise ValueError(f"{field} has {rows} rows, {getattr(raw, count[0])} are expected")
        else:
            setattr(raw, count[0], rows)

    def callback(self, base: str, function: Any) -> Any:
        """A callback that lives as long as what the call makes."""
        def forward(user: int, level: int, message: bytes) -> None:
            try:
                function(level, message.decode("utf-8", "replace"))
            except BaseException as thrown:  # must not unwind through C
                sys.unraisablehook(_Unraisable(thrown, function))
        made = _raw_class(base)(forward)
        self.callbacks.append(made)
        return made

    def progress(self, function: Progress | None) -> Any:
        """Also without a function: so that Ctrl-C stops a long call."""
        def forward(user: int, stage: int, fraction: float) -> int:
            try:
                return 1 if function is not None and function(stage, fraction) is False else 0
            except BaseException as thrown:  # must not unwind through C
                self.thrown = thrown
                return 1
        made = abi.ProgressFn(forward)
        self.kept.append(made)
        return made


class _Unraisable:
    def __init__(self, thrown: BaseException, source: Any) -> None:
        self.exc_type, self.exc_value, self.exc_traceback = type(thrown), thrown, thrown.__traceback__
        self.err_msg, self.object = "Exception ignored in a callback", source


def _rows(size: int, columns: int, name: str) -> int:
    if columns == 0 or size % columns:
        raise ValueError(f"{name} has {size} values, which is no multiple of {columns}")
    return size // columns


class _Lease:
    """Keeps a native object alive for an array that looks into it."""

    def __init__(self, handle: _Handle) -> None:
        handle.acquire()
        self.finalizer = weakref.finalize(self, handle.done)


class _Run:
    """One call: inputs to C, outputs back."""

    def __init__(self, name: str, given: dict[str, Any], dtype: Any) -> None:
        self.name, self.given = name, given
        _, self.locks, self.parameters = abi.FUNCTIONS[name]
        self.arguments, self.counts, self.values = _Arguments(), {}, {}
        self.outputs: dict[str, Any] = {}
        self.dtype = None if dtype is None else numpy.dtype(dtype)

    def factor(self, factor: Any) -> int:
        """A factor of a count: a number, another argument, or one of the object's counts."""
        if isinstance(factor, int):
            return factor
        name, plus = (factor[:-2], 1) if factor.endswith("+1") else (factor, 0)
        if name.startswith("counts."):
            receiver = next(v for v in self.given.values() if isinstance(v, Object) and hasattr(v, "counts"))
            return int(getattr(receiver.counts(), name[len("counts."):])) + plus
        return int(self.counts[name] if name in self.counts else self.given[name]) + plus

    def known_rows(self, name: str, first: Any, rows: int) -> None:
        """Arrays that share a count must agree."""
        if isinstance(first, int) or first.startswith("counts."):
            expected = self.factor(first)
        else:
            name_of, plus = (first[:-2], 1) if first.endswith("+1") else (first, 0)
            if name_of not in self.counts and name_of not in self.given:
                self.counts[name_of] = rows - plus
            expected = self.factor(first)
        if rows != expected:
            raise ValueError(f"{name} has {rows} rows, {expected} are expected")

    def read_inputs(self, progress: Any, cancel: Any) -> None:
        for name, role, base, count, nullable, _ in self.parameters:
            value = self.given.get(name)
            if role == "struct" and _has_progress(base):
                self.options(name, base, value, progress, cancel)
            elif role in ("handle", "handles", "struct", "structs", "matrix", "text", "texts", "array", "bytes"):
                if value is None and not nullable:
                    raise TypeError(f"{self.name}: {name} is missing")
                self.values[name] = None if value is None else self.pointer(name, role, base, count, value)
            elif role == "scalar":
                self.values[name] = self.scalar(name, base, value)

    def options(self, name: str, base: str, value: Any, progress: Any, cancel: Any) -> None:
        raw = _fresh(base)
        if value is not None:
            self.arguments.fill(base, raw, value)
        raw.progress = self.arguments.progress(progress)
        raw.cancel = None if cancel is None else self.arguments.use(cancel)
        self.arguments.kept.append(raw)
        self.values[name] = ctypes.addressof(raw)

    def scalar(self, name: str, base: str, value: Any) -> Any:
        if name == "abi_version":
            return abi.ABI_VERSION
        if self.dtype is not None and base == "mien_dtype":
            if self.dtype not in (numpy.float32, numpy.float64):
                raise TypeError(f"float32 or float64 is needed, not {self.dtype}")
            return 1 if self.dtype == numpy.float32 else 2
        return value

    def pointer(self, name: str, role: str, base: str, count: tuple, value: Any) -> int | None:
        arguments = self.arguments
        if role == "handle":
            return arguments.use(value)
        if role == "text":
            return arguments.text(value)
        if role == "matrix":
            view = arguments.matrix(value, count[0])
            arguments.kept.append(view)
            return ctypes.addressof(view)
        if role == "struct":
            raw = _fresh(base)
            arguments.kept.append(raw)
            arguments.fill(base, raw, value)
            return ctypes.addressof(raw)
        if role == "bytes":
            array = numpy.frombuffer(value, dtype=numpy.uint8)
            arguments.kept.append(array)
            self.known_rows(name, count[0], array.size)
            return array.ctypes.data
        if role == "array":
            array = arguments.numbers(value, base)
            columns = int(numpy.prod([self.factor(c) for c in count[1:]], dtype=int))
            self.known_rows(name, count[0], _rows(array.size, columns, name))
            return array.ctypes.data if array.size else None
        self.known_rows(name, count[0], len(value))
        if role == "structs":
            return ctypes.addressof(arguments.structs(base, value))
        return arguments.pointers([arguments.use(v) if role == "handles" else arguments.text(v) for v in value])

    def make_outputs(self, capacity: int) -> None:
        for name, role, base, count, _, _ in self.parameters:
            if role in ("array_out", "text_out", "structs_out"):
                rows = capacity if count[0] == "capacity" else self.factor(count[0])
                columns = [self.factor(c) for c in count[1:]]
                if role == "text_out":
                    made = ctypes.create_string_buffer(max(1, rows))
                elif role == "structs_out":
                    made = (_raw_class(base) * max(1, rows))()
                else:
                    kind = self.dtype if base == "void" else abi.NUMBERS[base][1]
                    made = numpy.empty([rows, *columns], dtype=kind)
                self.outputs[name] = made
                if isinstance(made, numpy.ndarray):
                    self.values[name] = made.ctypes.data
            elif role in ("handle_out", "view_out"):
                self.outputs[name] = ctypes.c_void_p()
            elif role == "struct_out":
                self.outputs[name] = _fresh(base)
            elif role in ("scalar_out", "count_out"):
                self.outputs[name] = abi.NUMBERS[base][0]()
            else:
                continue
            if not isinstance(self.outputs[name], numpy.ndarray):
                self.values[name] = ctypes.addressof(self.outputs[name])

    def first_capacity(self) -> int:
        """Rows of the first try: what fits into the scratch memory."""
        widest = 1
        for _, role, base, count, _, _ in self.parameters:
            if role == "array_out" and count[0] == "capacity":
                size = 8 if base == "void" else numpy.dtype(abi.NUMBERS[base][1]).itemsize
                widest = max(widest, size * int(numpy.prod([self.factor(c) for c in count[1:]], dtype=int)))
        return max(1, _SCRATCH_BYTES // widest)

    def call(self) -> Any:
        record = abi.Error(struct_size=ctypes.sizeof(abi.Error))
        sized = any(role == "capacity" for _, role, *_ in self.parameters)
        capacity = self.first_capacity() if sized else 0
        while True:
            self.make_outputs(capacity)
            row = []
            for name, role, *_ in self.parameters:
                row.append(ctypes.addressof(record) if role == "error" else capacity if role == "capacity"
                           else self.counts.get(name, 0) if role == "count" else self.values.get(name))
            result = getattr(_library, self.name)(*row)
            if abi.FUNCTIONS[self.name][0] is not ctypes.c_int32:
                return result
            if result == -4 and sized and self.outputs["count"].value > capacity:  # MIEN_E_BUFFER_TOO_SMALL
                capacity = self.outputs["count"].value
                continue
            break
        if result != 0:
            if self.arguments.thrown is not None:
                raise self.arguments.thrown
            raise (Cancelled if record.status == -16 else Error)(record)
        return self.results()

    def results(self) -> tuple:
        count = self.outputs["count"].value if "count" in self.outputs else None
        found = []
        for name, role, base, shape, _, enum in self.parameters:
            if name not in self.outputs or role == "count_out":
                continue
            made = self.outputs[name]
            if role == "handle_out":
                owned = _class_of(base)._own(made.value)
                owned._kept = self.arguments.callbacks or None
                found.append(owned)
            elif role == "struct_out":
                found.append(_class_of(base)._read(made))
            elif role == "structs_out":
                found.append([_class_of(base)._read(row) for row in made[:self.factor(shape[0])]])
            elif role == "text_out":
                found.append(made.raw[:max(0, count - 1)].decode("utf-8", "replace"))
            elif role == "view_out":
                found.append(self.view(made.value, [count, *shape[1:]], base))
            elif role == "array_out":
                found.append(made[:count].copy() if shape[0] == "capacity" and count < len(made) else made)
            else:
                found.append(_constant(enum, made.value))
        return tuple(found)

    def view(self, address: int, shape: list[int], base: str) -> numpy.ndarray:
        """An array in the library's own memory: no copy, read-only, alive as long as any view of it."""
        kind, dtype = abi.NUMBERS[base]
        memory = (kind * int(numpy.prod(shape))).from_address(address)
        memory._lease = _Lease(next(v for v in self.given.values() if isinstance(v, Object))._handle)
        array = numpy.frombuffer(memory, dtype=dtype).reshape(shape)
        array.flags.writeable = False
        return array


def _has_progress(base: str) -> bool:
    return {"progress", "cancel"} <= {row[0] for row in abi.STRUCTS[base]}


def run(name: str, given: dict[str, Any], progress: Any = None, cancel: Any = None, dtype: Any = None) -> Any:
    """Calls a function of the library: the outputs as a tuple, or the returned value where it has no status."""
    call = _Run(name, given, dtype)
    held: list[Any] = []
    try:
        call.read_inputs(progress, cancel)
        for lock in sorted((given[n]._handle.serial for n in call.locks if n in given), key=id):
            lock.acquire()
            held.append(lock)
        result = call.call()
        return result.decode() if isinstance(result, bytes) else result
    finally:
        for lock in held:
            lock.release()
        call.arguments.done()
