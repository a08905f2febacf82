"""The main job: main_job.py FACE.safetensors EXPRESSIONS.safetensors SCAN.ply NEUTRAL.ply EARLIER.ply LATER.ply
EARLIER and LATER: the same person's fitted faces of two other visits."""
import hashlib
import json
import sys

import numpy

import mien

session = mien.Session()
face = mien.Model.load(session, sys.argv[1])
expressions = mien.ExpressionModel.load(session, sys.argv[2])
file = mien.Mesh.load(session, sys.argv[3])
scan = mien.Mesh.create(session, mien.MeshArrays(positions=file.positions_view(), triangles=file.triangles(), colors=file.colors()))

fitted = session.register(face, scan)
print("verdict", fitted.verdict().quality.name, "; ".join(json.loads(fitted.json())["reasons"]))
neutral = session.neutralize(expressions, fitted)
neutral.mesh().save(session, sys.argv[4])
print("neutral", hashlib.sha256(neutral.mesh().positions(numpy.float32).tobytes()).hexdigest())

# What the expression moved, on either half of the face, with intervals from how surely each vertex is known.
x = face.mesh().positions_view()[:, 0]
zones = [mien.Zone("left", numpy.flatnonzero(x > 0)), mien.Zone("right", numpy.flatnonzero(x < 0))]
moved = session.measure_volume(neutral.mesh(), fitted.mesh(), mien.MeasureOptions(
    zones=zones, after_sd=fitted.field(mien.RegistrationKind.STANDARD_DEVIATION_MM)))
for index, zone in enumerate(zones):
    volume = moved.volume(index)
    print("zone %s %.4f mL [%.4f, %.4f]" % (zone.name, volume.signed_ml, volume.low95_ml, volume.high95_ml))

faces = [mien.Mesh.load(session, sys.argv[5]), fitted.mesh(), mien.Mesh.load(session, sys.argv[6])]
visits = session.neutralize_visits(expressions, faces)
removed = visits.removed_volume(0, 2)
print("visits %s, removed %.4f mL, sd %.4f mL" % (", ".join(visits.expression(i) for i in range(3)), removed.removed_ml, removed.sd_ml))
try:
    session.register(face, scan, progress=lambda stage, fraction: False)
except mien.Cancelled:
    print("cancelled")
