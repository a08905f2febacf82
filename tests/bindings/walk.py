"""Walks every public class of the Python package: walk.py FACE EXPRESSIONS SCAN DATASET FOLDER

Makes an object of every handle's class, calls each of its methods that needs no argument, makes each options class, and
checks type hints and the promises of ownership. FOLDER holds walk_network.safetensors, over the faces of small_face().
"""
import gc
import inspect
import math
import sys
import threading
import typing
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
triangles = [t for y in range(11) for x in range(11) for t in ((12 * y + x, 12 * y + x + 1, 12 * y + x + 12),
                                                              (12 * y + x + 1, 12 * y + x + 13, 12 * y + x + 12))]


def small_face(person=0, grin=0):
    """A sheet of 12 x 12 vertices, bent by who it is and by an expression."""
    return numpy.array([[x, y, x * y / 40 + 0.2 * person * math.sin(0.5 * x + person) + 0.3 * grin * math.cos(0.4 * y)]
                        for y in range(12) for x in range(12)])


small = mien.Mesh.create(session, mien.MeshArrays(positions=small_face(), triangles=triangles))
basis = keep(mien.SpectralBasis.build(session, small, mien.SpectralBasisOptions(mode_count=8)))
low, high = session.spectral_split(basis, small, 4)
assert low.counts() == small.counts()
keep(mien.Hierarchy.build_quadric(session, small, 1, 2.0))
keep(mien.Representation.train(session, dataset_path, mien.Features.EUCLIDEAN, 1))
writer = keep(mien.DatasetWriter.create(session, small, ["neutral", "grin"]))
for person, grin in ((person, grin) for person in range(12) for grin in (0, 1)):
    writer.add(small_face(person, grin), person, grin)
faces = Path(folder) / "walk.safetensors"
writer.save(session, faces)
few = mien.ExpressionModel.train(session, faces, mien.TrainOptions(identity_modes=3, expression_modes=1))
keep(session.evaluate_neutralization(few, faces))
keep(mien.BlendshapeModel.train(session, faces, "grin"))
keep(mien.ScoreModel.train(session, faces, [0.5 * k for k in range(24)], mien.ScoreOptions(folds=4, curvature_share=0)))
keep(mien.Model.tune(session, small, faces, mien.TuneOptions(sigmas_mm=[5.0], num_modes=6)))
keep(mien.Network.load(session, Path(folder) / "walk_network.safetensors"))
keep(mien.Study.create_from_meshes(session, [small, small], options=mien.StudyOptions(zones=[mien.Zone("some", range(100))], stable_zones=["some"])))
named = keep(face.landmarks())
keep(face.zones())
keep(session.measure_anthropometry(template, named))
picked = Path(folder) / "walk_landmarks.json"
picked.write_text('{"vertices": {"pronasale": 70, "subnasale": 40, "gnathion": 6}}')
keep(mien.Norms.create(session, faces, mien.Landmarks.load(session, picked)))
keep(mien.ReadyScan.create(session, scan))
batch = keep(mien.Batch.create(session, face))
batch.add(session, scan, mien.RegisterOptions(iterations=1, close_gap=0))
batch.run(session)
assert batch.counts().run_count == 1
keep(mien.Follower.create(session, face, fitted))

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
# What is dropped is given back at once, without a collection: far more than would fit beside it.
places = numpy.arange(300000.0).reshape(-1, 3) % 977
statm = Path("/proc/self/statm")
resident = lambda: 4096 * int(statm.read_text().split()[1]) if statm.exists() else 0
before = resident()
for _ in range(200):
    mien.Mesh.create(session, mien.MeshArrays(positions=places))
assert resident() - before < 240 << 20, f"{resident() - before} bytes more"

# Type hints: whole, and they name what there is.
assert (Path(mien.__file__).parent / "py.typed").exists()
assert isinstance(typing.get_type_hints(mien.Session.__enter__, vars(mien.runtime))["return"], typing.TypeVar)  # of the class itself
assert mien.__version__ == mien.version_string()
hints = 0
for kind in {kind for kind in (mien, *vars(mien).values()) if kind is mien or inspect.isclass(kind)}:
    for name, function in inspect.getmembers(kind, lambda member: inspect.isfunction(member) or inspect.ismethod(member)):
        if name.startswith("_") and name != "__init__" or not getattr(function, "__module__", "").startswith("mien"):
            continue
        names = {**vars(mien.runtime), **vars(mien), **vars(sys.modules[function.__module__])}
        told = typing.get_type_hints(getattr(function, "__func__", function), names)
        parameters = [p for p in inspect.signature(function).parameters.values() if p.name != "self"]
        missing = [p.name for p in parameters if p.name not in told and p.kind is not p.VAR_KEYWORD] + ["return"] * ("return" not in told)
        assert not missing, f"{kind.__name__}.{name} has no type hint for {missing}"
        hints += len(parameters) + 1

classes = [kind for kind in vars(mien).values() if inspect.isclass(kind) and issubclass(kind, Object)]
others = sorted(kind.__name__ for kind in classes if kind.__name__ not in live)
assert not others, f"not walked: {others}"
print(f"walked {len(live)} of {len(classes)} classes ({called} methods), "
      f"{len(options)} options, {hints} type hints, version {mien.__version__}")
