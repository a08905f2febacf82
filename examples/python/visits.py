"""What changed in a face between visits, with intervals: visits.py FACE.safetensors EXPRESSIONS.safetensors SCAN.ply ..."""
import ctypes
import sys

import mien
from mien import abi

session = mien.Session()
face, expressions = session.load_model(sys.argv[1]), session.load_expression_model(sys.argv[2])
fits = [session.register(face, session.load_mesh(path)) for path in sys.argv[3:]]
handles = (ctypes.c_void_p * len(fits))(*(fit._as_parameter_.value for fit in fits))
study = mien._made(mien._Object, "mien_study_release", "mien_study_create", session, ctypes.cast(handles, ctypes.POINTER(ctypes.c_void_p)),
                   len(fits), expressions, None)
visits, zones = ctypes.c_uint32(), ctypes.c_uint32()
mien._call("mien_study_get_counts", study, ctypes.byref(visits), ctypes.byref(zones))
for visit in range(1, visits.value):
    for zone in range(zones.value):
        name, change = ctypes.create_string_buffer(64), abi.StudyChange(struct_size=ctypes.sizeof(abi.StudyChange))
        mien._call("mien_study_get_zone_name", study, zone, ctypes.addressof(name), len(name), None)
        mien._call("mien_study_get_change", study, 0, visit, zone, ctypes.byref(change))
        ml = change.signed_ml
        print("%d %-24s %11.6f %11.6f %11.6f %11.6f" % (visit, name.value.decode(), ml.value, ml.low, ml.high, ml.limit_of_detection))
