"""From a raw scan to a neutral face and the volume in between.
   main_job.py FACE.safetensors EXPRESSIONS.safetensors SCAN.ply FITTED.ply NEUTRAL.ply [LANDMARKS.json]"""
import hashlib
import json
import sys

import mien

face_path, expressions_path, scan_path, fitted_path, neutral_path = sys.argv[1:6]
landmarks = json.load(open(sys.argv[6]))["points"] if len(sys.argv) > 6 else None
session = mien.Session()
face = session.load_model(face_path)
expressions = session.load_expression_model(expressions_path)
fitted = session.register(face, session.load_mesh(scan_path), landmarks)
neutral = session.neutralize(expressions, fitted)
session.save_mesh(fitted.mesh, fitted_path)
session.save_mesh(neutral.mesh, neutral_path)
print("neutral", hashlib.sha256(neutral.mesh.positions.astype("float32").tobytes()).hexdigest())
print("volume %.6f mL" % session.volume(fitted.mesh, neutral.mesh).volume().absolute_ml)
