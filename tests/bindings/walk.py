"""Walks every public class of the Python package: walk.py FACE EXPRESSIONS SCAN DATASET FOLDER

Makes an object of each handle's class where the given files allow, calls each of its methods that needs no argument,
makes each options class, and checks the promises of ownership.
"""
import gc
import inspect
import sys
import threading
from pathlib import Path

import numpy

import mien
from mien.runtime import Object, Options

face_path, expressions_path, scan_path, dataset_path, folder = sys.argv[1:6]
live = {}


def keep(made):
    live.setdefault(type(made).__name__, made)
    return made


def refuses(kind, function, *arguments, **named):
    try:
        function(*arguments, **named)
    except kind as failure:
        return failure
    raise AssertionError(f"{function} did not refuse {arguments} {named}")


session = keep(mien.Session(mien.SessionOptions(num_threads=2)))
keep(mien.Cancel())
face, expressions = keep(mien.Model.load(session, face_path)), keep(mien.ExpressionModel.load(session, expressions_path))
scan = mien.Mesh.load(session, scan_path)
template = keep(face.mesh())
fitted = keep(session.register(face, scan, mien.RegisterOptions(iterations=2, close_gap=0)))
neutral = keep(session.neutralize(expressions, fitted))
keep(session.neutralize_visits(expressions, [fitted.mesh(), neutral.mesh()]))
keep(session.neutralize_series(expressions, [fitted.mesh(), neutral.mesh()]))
keep(session.measure_volume(neutral.mesh(), fitted.mesh(), mien.MeasureOptions(zones=[mien.Zone("some", range(100))])))
small = mien.Mesh.create(session, mien.MeshArrays(
    positions=[[x, y, x * y / 40] for y in range(12) for x in range(12)],
    triangles=[t for y in range(11) for x in range(11) for t in ((12 * y + x, 12 * y + x + 1, 12 * y + x + 12),
                                                              (12 * y + x + 1, 12 * y + x + 13, 12 * y + x + 12))]))
basis = keep(mien.SpectralBasis.build(session, small, mien.SpectralBasisOptions(mode_count=8)))
low, high = session.spectral_split(basis, small, 4)
assert low.counts() == small.counts()
keep(mien.Hierarchy.build_quadric(session, small, 1, 2.0))
keep(mien.Representation.train(session, dataset_path, mien.Features.EUCLIDEAN, 1))
writer = keep(mien.DatasetWriter.create(session, small, ["neutral", "grin"]))
writer.add(small.positions(), 0, 0)
writer.save(session, Path(folder) / "walk.safetensors")

# Each method that needs no argument, on each object; a result that is not there is NOT_FOUND and nothing else.
called = 0
for made in list(live.values()):
    for name, method in inspect.getmembers(made, inspect.ismethod):
        if name.startswith("_") or name == "close" or any(p.default is p.empty for p in inspect.signature(method).parameters.values()):
            continue
        try:
            method()
        except mien.Error as failure:
            assert failure.name == "MIEN_E_NOT_FOUND", f"{type(made).__name__}.{name}: {failure}"
        called += 1

options = [kind for kind in vars(mien).values() if inspect.isclass(kind) and issubclass(kind, Options)]
for kind in options:  # a batch has only what every call has, progress and cancel
    assert (kind().__dict__ or kind is mien.BatchOptions) and refuses(AttributeError, kind, no_such_field=1)

# Ownership: a view outlives its mesh, objects go in any order, a closed object refuses, errors name the place.
view = template.positions_view()
total = view.sum()
fitted.close(), face.close(), template.close()
gc.collect()
assert view.sum() == total and not view.flags.writeable
refuses(ValueError, template.counts)
assert refuses(mien.Error, mien.Mesh.create, session, mien.MeshArrays(positions=[[0, 0, 0], [0, 0, float("nan")]])).detail_index == 1
assert refuses(mien.Error, mien.Mesh.load, session, "/absent/f\u00e4ce.ply").status is not None
refuses(ValueError, mien.Mesh.create, session, mien.MeshArrays(positions=[[0, 0, 0]], colors=[[1, 2, 3]] * 2))
refuses(ValueError, session.measure_lengths, small, [1, 2, 3])
refuses(ValueError, session.measure_lengths, small, [[-1, 2]])
with mien.Model.load(session, face_path) as again:
    refuses(ZeroDivisionError, session.register, again, scan, progress=lambda stage, fraction: 1 / 0)
    token = mien.Cancel()
    threading.Timer(0, token.request).start()
    refuses(mien.Cancelled, session.register, again, scan, progress=lambda stage, fraction: token.request(), cancel=token)
classes = [kind for kind in vars(mien).values() if inspect.isclass(kind) and issubclass(kind, Object)]
others = sorted(kind.__name__ for kind in classes if kind.__name__ not in live)
assert len(live) >= 14, sorted(live)
print(f"walked {len(live)} of {len(classes)} classes ({called} methods; without an object here: {', '.join(others)}), "
      f"{len(options)} options, version {mien.__version__}")
