"""Mien for Python: registers 3D face scans, removes expressions, measures what changed.

    import mien

    with mien.Session() as session:
        face = mien.Model.load(session, "face.safetensors")
        scan = mien.Mesh.load(session, "scan.ply")
        fitted = session.register(face, scan)
        print(fitted.verdict().quality, fitted.mesh().positions_view().shape)

Classes follow the C interface (mien/*.h): a function mien_mesh_save() is Mesh.save(), functions of no object are
methods of Session. Arrays are numpy arrays, copied unless the method is called a view; failures raise mien.Error.
Objects are context managers and otherwise go with the garbage, in any order. The library is found by the
environment variable MIEN_LIBRARY, beside this package, or by the system's own search.
"""
from . import abi
from .classes import *  # noqa: F401,F403
from .classes import __all__ as _classes
from .runtime import Cancelled, Error, Progress, library_path

__version__ = abi.VERSION
__all__ = ["Cancelled", "Error", "Progress", "library_path", "__version__", *_classes]
