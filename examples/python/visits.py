"""What changed in a face between visits, with intervals: visits.py FACE.safetensors EXPRESSIONS.safetensors SCAN.ply ..."""
import sys

import mien

session = mien.Session()
face, expressions = mien.Model.load(session, sys.argv[1]), mien.ExpressionModel.load(session, sys.argv[2])
study = mien.Study.create(session, [session.register(face, mien.Mesh.load(session, path)) for path in sys.argv[3:]], expressions)
visits, zones = study.counts()
for visit in range(1, visits):
    for zone in range(zones):
        ml = study.change(0, visit, zone).signed_ml
        print("%d %-24s %11.6f %11.6f %11.6f %11.6f" % (visit, study.zone_name(zone), ml.value, ml.low, ml.high, ml.limit_of_detection))
