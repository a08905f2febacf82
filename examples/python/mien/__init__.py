"""Mien for Python: ctypes and numpy over the C interface, without copies where the interface has views.

    import mien
    session = mien.Session()
    fitted = session.register(session.load_model("face.safetensors"), session.load_mesh("scan.ply"))

The library is found by MIEN_LIBRARY, or by the system's own search.
"""
import ctypes
import ctypes.util
import os
import sys
import weakref

import numpy

from . import abi


def _load_library():
    names = {"win32": "mien-0.dll", "darwin": "libmien.0.dylib"}
    library = ctypes.CDLL(os.environ.get("MIEN_LIBRARY", names.get(sys.platform, "libmien.so.0")))
    for name, (result, arguments) in abi.SIGNATURES.items():
        function = getattr(library, name, None)
        if function is not None:  # an older library lacks the newest functions
            function.restype, function.argtypes = result, arguments
    return library


_library = _load_library()


class Error(Exception):
    """A failed call: the status, its name, and the first offending index or -1."""
    def __init__(self, record):
        super().__init__(record.message.decode("utf-8", "replace"))
        self.status = record.status
        self.name = _library.mien_status_name(record.status).decode()
        self.detail_index = record.detail_index


class Cancelled(Error):
    pass


def _call(name, *arguments):
    record = abi.Error(struct_size=ctypes.sizeof(abi.Error))
    if getattr(_library, name)(*arguments, ctypes.byref(record)):
        raise (Cancelled if record.status == abi.MIEN_E_CANCELLED else Error)(record)


def _options(structure, initialise, **fields):
    options = structure()
    getattr(_library, initialise)(ctypes.byref(options), ctypes.sizeof(options))
    for name, value in fields.items():
        setattr(options, name, value)
    return options


class _Progress:
    """Carries a Python callable into a call and its exception back out of it."""
    def __init__(self, options, function):
        self.thrown = None
        self.forward = abi.ProgressFn(self._run)  # kept alive as long as the call
        self.function = function
        if function is not None:
            options.progress = self.forward

    def _run(self, user, stage, fraction):
        try:
            return 1 if self.function(stage, fraction) is False else 0
        except BaseException as thrown:  # must not unwind through C
            self.thrown = thrown
            return 1

    def call(self, name, *arguments):
        try:
            _call(name, *arguments)
        except Cancelled:
            if self.thrown is not None:
                raise self.thrown
            raise


class _Object:
    """Owns one reference to a handle; released by the garbage collector, in any order."""
    def __init__(self, handle, release):
        self._as_parameter_ = ctypes.c_void_p(handle)
        self._finalizer = weakref.finalize(self, getattr(_library, release), handle)

    def close(self):
        """Releases the handle now."""
        self._finalizer()
        self._as_parameter_ = ctypes.c_void_p()


def _made(kind, release, name, *arguments, progress=None):
    out = ctypes.c_void_p()
    (progress.call if progress else _call)(name, *arguments, ctypes.byref(out))
    return kind(out.value, release)


def _view(array, columns):
    array = numpy.asarray(array)
    if array.dtype not in (numpy.float32, numpy.float64):
        array = array.astype(numpy.float64)
    if array.ndim != 2 or array.shape[1] != columns or array.strides[1] != array.itemsize:
        array = numpy.ascontiguousarray(array).reshape(-1, columns)
    dtype = abi.MIEN_DTYPE_F32 if array.dtype == numpy.float32 else abi.MIEN_DTYPE_F64
    return abi.ArrayView(array.ctypes.data, len(array), array.strides[0], dtype, 0), array


class Mesh(_Object):
    @property
    def positions(self):
        """#V x 3 float64 in place: no copy, read-only, alive as long as any view of it."""
        data, count = ctypes.c_void_p(), ctypes.c_uint64()
        _call("mien_mesh_positions_view", self, ctypes.byref(data), ctypes.byref(count))
        memory = (ctypes.c_double * (3 * count.value)).from_address(data.value)
        memory._mesh = self  # the array's base keeps the mesh
        array = numpy.frombuffer(memory, dtype=numpy.float64).reshape(-1, 3)
        array.flags.writeable = False
        return array

    @property
    def triangles(self):
        count = ctypes.c_uint64()
        _call("mien_mesh_get_triangles", self, None, 0, ctypes.byref(count))
        array = numpy.empty((count.value, 3), dtype=numpy.uint32)
        if count.value:
            _call("mien_mesh_get_triangles", self, array.ctypes.data, count.value, ctypes.byref(count))
        return array


class Model(_Object):
    pass


class ExpressionModel(_Object):
    pass


class _WithMesh(_Object):
    _mesh_function = None

    @property
    def mesh(self):
        borrowed = getattr(_library, self._mesh_function)(self)
        _library.mien_mesh_retain(borrowed)
        return Mesh(borrowed, "mien_mesh_release")


class Registration(_WithMesh):
    _mesh_function = "mien_registration_mesh"


class Neutralization(_WithMesh):
    _mesh_function = "mien_neutralization_mesh"


class Measurement(_Object):
    def volume(self, zone=abi.MIEN_ZONE_WHOLE):
        out = abi.ZoneVolume(struct_size=ctypes.sizeof(abi.ZoneVolume))
        _call("mien_measurement_get_volume", self, zone, ctypes.byref(out))
        return out


class Session(_Object):
    """Threads and a memory budget; one call at a time."""
    def __init__(self, num_threads=1, max_bytes=0):
        options = _options(abi.SessionOptions, "mien_session_options_init", num_threads=num_threads, max_bytes=max_bytes)
        out = ctypes.c_void_p()
        _call("mien_session_create_with_options", abi.MIEN_ABI_VERSION, ctypes.byref(options), ctypes.byref(out))
        super().__init__(out.value, "mien_session_release")

    def mesh(self, positions, triangles=None):
        arrays = _options(abi.MeshArrays, "mien_mesh_arrays_init")
        arrays.positions, kept = _view(positions, 3)
        if triangles is not None:
            triangles = numpy.ascontiguousarray(triangles, dtype=numpy.uint32).reshape(-1, 3)
            arrays.triangles, arrays.triangle_count = triangles.ctypes.data, len(triangles)
        return _made(Mesh, "mien_mesh_release", "mien_mesh_create", self, ctypes.byref(arrays))

    def load_mesh(self, path):
        return _made(Mesh, "mien_mesh_release", "mien_mesh_load", self, os.fsencode(path))

    def save_mesh(self, mesh, path):
        _call("mien_mesh_save", self, mesh, os.fsencode(path))

    def load_model(self, path):
        return _made(Model, "mien_model_release", "mien_model_load", self, os.fsencode(path))

    def load_expression_model(self, path):
        return _made(ExpressionModel, "mien_expression_model_release", "mien_expression_model_load", self, os.fsencode(path))

    def register(self, model, scan, landmarks=None, progress=None):
        """landmarks: {name: (x, y, z)} on the scan; progress(stage, fraction) returns False to cancel."""
        options = _options(abi.RegisterOptions, "mien_register_options_init")
        points = [(name.encode(), tuple(position)) for name, position in (landmarks or {}).items()]
        rows = (abi.ScanLandmark * max(1, len(points)))(*points)
        if points:
            options.landmarks, options.landmark_count = rows, len(points)
        bridge = _Progress(options, progress)
        return _made(Registration, "mien_registration_release", "mien_register", self, model, scan, ctypes.byref(options),
                     progress=bridge)

    def neutralize(self, expressions, face, progress=None):
        """face: a registration, or a mesh in the model's topology."""
        options = _options(abi.NeutralizeOptions, "mien_neutralize_options_init")
        name = "mien_neutralize" if isinstance(face, Registration) else "mien_neutralize_mesh"
        return _made(Neutralization, "mien_neutralization_release", name, self, expressions, face, ctypes.byref(options),
                     progress=_Progress(options, progress))

    def volume(self, before, after):
        options = _options(abi.MeasureOptions, "mien_measure_options_init")
        return _made(Measurement, "mien_measurement_release", "mien_measure_volume", self, before, after, ctypes.byref(options))
