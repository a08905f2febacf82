#!/usr/bin/env python3
"""Turns a downloaded ICT-FaceKit folder into a template, zones, landmarks and a training set.

  git clone https://github.com/ICT-VGL/ICT-FaceKit
  python3 convert_ict_facekit.py ICT-FaceKit --out ict --subjects 30 --seed 1

Reads FaceXModel/ of the original repository (generic_neutral_mesh.obj, identity000.obj ...,
the expression shapes, vertex_indices.json) and writes, in millimetres:

  template.ply        the skin of face, head and neck (vertices 0..11247), quads split
  landmarks.json      the 68 Multi-PIE landmarks as vertices of the template
  zones.json          face (contains all others), forehead, nose, mouth, chin, cheeks, eyes ...
  train.safetensors   random subjects x 20 expressions, for `mien train`
  shapes/             on request: the 52 shapes that face trackers drive, for `mien transfer-expression --face-tracking`

ICT-FaceKit is MIT-licensed by the USC Institute for Creative Technologies; its licence also covers
what this program writes. Needs numpy only.
"""
import argparse
import json
import struct
import sys
from pathlib import Path

import numpy as np

MM_PER_UNIT = 10.0      # the model is in centimetres
SKIN_VERTICES = 11248   # vertices 0..11247: face, head and neck without sockets, teeth, eyes
FACE_VERTICES = 9409    # of these 0..9408 are the face, the rest scalp and nape

# The 68 landmarks as the model's own documentation numbers them, in Multi-PIE order.
MULTI_PIE = [
    1225, 1888, 1052, 367, 1719, 1722, 2199, 1447, 966, 3661, 4390, 3927, 3924, 2608, 3272, 4088, 3443,
    268, 493, 1914, 2044, 1401, 3615, 4240, 4114, 2734, 2509, 978, 4527, 4942, 4857, 1140, 2075, 1147,
    4269, 3360, 1507, 1542, 1537, 1528, 1518, 1511, 3742, 3751, 3756, 3721, 3725, 3732, 5708, 5695, 2081,
    0, 4275, 6200, 6213, 6346, 6461, 5518, 5957, 5841, 5702, 5711, 5533, 6216, 6207, 6470, 5517, 5966]


def landmark_names():
    names = [f"jaw_{k:02d}" for k in range(17)]
    names += [f"brow_{side}_{k}" for side in ("right", "left") for k in range(5)]
    names += [f"nose_bridge_{k}" for k in range(4)] + [f"nose_base_{k}" for k in range(5)]
    names += [f"eye_{side}_{k}" for side in ("right", "left") for k in range(6)]
    return names + [f"mouth_outer_{k:02d}" for k in range(12)] + [f"mouth_inner_{k}" for k in range(8)]


def both(weight, *names):
    return {f"{name}_{side}": weight for name in names for side in "LR"}


# The 20 expressions of FaceWarehouse and FaceScape as weights of the model's shapes.
EXPRESSIONS = {
    "neutral": {},
    "mouth_stretch": {"jawOpen": 1.0, **both(0.3, "mouthLowerDown")},
    "smile": {**both(0.7, "mouthSmile"), **both(0.3, "cheekSquint")},
    "brow_lower": both(1.0, "browDown"),
    "brow_raiser": both(1.0, "browInnerUp", "browOuterUp"),
    "anger": {**both(0.9, "browDown", "noseSneer"), **both(0.5, "mouthPress")},
    "jaw_left": {"jawLeft": 1.0},
    "jaw_right": {"jawRight": 1.0},
    "jaw_forward": {"jawForward": 1.0},
    "mouth_left": {"mouthLeft": 1.0},
    "mouth_right": {"mouthRight": 1.0},
    "dimpler": both(1.0, "mouthDimple"),
    "chin_raiser": {"mouthShrugLower": 1.0, "mouthShrugUpper": 0.5},
    "lip_puckerer": {"mouthPucker": 1.0},
    "lip_funneler": {"mouthFunnel": 1.0, "jawOpen": 0.15},
    "sadness": both(0.8, "mouthFrown", "browInnerUp"),
    "lip_roll": {"mouthRollLower": 1.0, "mouthRollUpper": 1.0},
    "grin": {**both(0.8, "mouthSmile", "mouthUpperUp", "mouthLowerDown"), **both(0.4, "mouthStretch")},
    "cheek_blowing": both(1.0, "cheekPuff"),
    "eyes_closed": both(1.0, "eyeBlink"),
}


# The 52 names by which face trackers drive a face, but for what a side is called; and those that the model has in halves. Skin
# does not show a tongue that comes out: its shape is the neutral face.
IN_HALVES = ("browInnerUp", "cheekPuff")
ON_EITHER_SIDE = ("browDown", "browOuterUp", "cheekSquint", "eyeBlink", "eyeLookDown", "eyeLookIn", "eyeLookOut", "eyeLookUp",
                  "eyeSquint", "eyeWide", "mouthDimple", "mouthFrown", "mouthLowerDown", "mouthPress", "mouthSmile", "mouthStretch",
                  "mouthUpperUp", "noseSneer")
IN_ONE = ("jawForward", "jawLeft", "jawOpen", "jawRight", "mouthClose", "mouthFunnel", "mouthLeft", "mouthPucker", "mouthRight",
          "mouthRollLower", "mouthRollUpper", "mouthShrugLower", "mouthShrugUpper")


def face_tracking_shapes():
    """{name of the tracker: names of the model, which add up}."""
    shapes = {name: (name,) for name in IN_ONE}
    shapes.update({name: (f"{name}_L", f"{name}_R") for name in IN_HALVES})
    shapes.update({name + word: (f"{name}_{side}",) for name in ON_EITHER_SIDE for side, word in (("L", "Left"), ("R", "Right"))})
    shapes["tongueOut"] = ()
    return shapes


class Problem(Exception):
    """Something that the user can mend; the text says what, where, what to do."""


def read_obj_vertices(path, count):
    """The first `count` vertices of an OBJ file, in millimetres."""
    rows = []
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            for line in file:
                if line.startswith("v "):
                    rows.append(line.split()[1:4])
                    if len(rows) == count:
                        break
    except OSError as failure:
        raise Problem(f"{path}: cannot be read ({failure.strerror}); is this a whole ICT-FaceKit?")
    if len(rows) < count:
        raise Problem(f"{path}: {len(rows)} vertices where {count} are needed; "
                      "is it the original, not the reduced model?")
    try:
        vertices = np.array(rows, dtype=float) * MM_PER_UNIT
    except ValueError:
        raise Problem(f"{path}: a vertex line does not hold three numbers")
    if not np.isfinite(vertices).all():
        raise Problem(f"{path}: a coordinate is not finite")
    return vertices


def read_obj_triangles(path, count):
    """Polygons whose corners are all below `count`, as triangle fans."""
    triangles = []
    with open(path, encoding="ascii", errors="replace") as file:
        for line in file:
            if not line.startswith("f "):
                continue
            corners = [int(word.split("/")[0]) - 1 for word in line.split()[1:]]
            if min(corners) < 0:
                raise Problem(f"{path}: relative corner numbers are not supported")
            if max(corners) < count:
                triangles += [[corners[0], corners[k], corners[k + 1]] for k in range(1, len(corners) - 1)]
    if not triangles:
        raise Problem(f"{path}: no polygon lies within the first {count} vertices")
    return np.array(triangles, dtype=np.uint32)


def write_ply(path, vertices, triangles):
    header = ("ply\nformat binary_little_endian 1.0\ncomment ICT-FaceKit (MIT), millimetres\n"
              f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    faces = np.zeros(len(triangles), [("n", "u1"), ("corners", "<i4", 3)])
    faces["n"], faces["corners"] = 3, triangles
    Path(path).write_bytes(header.encode() + vertices.astype("<f4").tobytes() + faces.tobytes())


def write_safetensors(path, tensors, metadata):
    kinds = {"<f4": "F32", "<i4": "I32", "<u4": "U32"}
    header, offset = {"__metadata__": metadata}, 0
    for name, array in tensors.items():
        size = array.size * array.dtype.itemsize
        header[name] = {"dtype": kinds[array.dtype.str], "shape": list(array.shape),
                        "data_offsets": [offset, offset + size]}
        offset += size
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-(8 + len(text)) % 64)
    with open(path, "wb") as out:
        out.write(struct.pack("<Q", len(text)) + text)
        for array in tensors.values():
            out.write(array.tobytes())


def make_zones(vertices, marks, face_count):
    """Zones from the landmarks alone, as seen from the front. `marks`: name -> position."""
    x, y, z = (vertices - marks["nose_bridge_0"]).T
    at = {name: p - marks["nose_bridge_0"] for name, p in marks.items()}
    half_eye = 0.5 * abs(at["eye_left_3"][0] - at["eye_left_0"][0])
    eye = 0.5 * (at["eye_left_0"] + at["eye_left_3"])
    brow = np.mean([at[f"brow_left_{k}"][1] for k in range(5)])
    wing, base = abs(at["nose_base_4"][0]), at["nose_base_2"][1]
    mouth_half, mouth_y = abs(at["mouth_outer_06"][0]), at["mouth_outer_06"][1]
    lip_bottom, chin = at["mouth_outer_09"][1], at["jaw_08"][1]
    face_half = abs(at["jaw_16"][0])
    hair = brow + 0.55 * (brow - base)
    ax = np.abs(x)
    # Jaw line: depth of the jaw landmarks over their height, on both sides.
    jaw = np.array(sorted((at[f"jaw_{k:02d}"][1], at[f"jaw_{k:02d}"][2]) for k in range(8, 17)))
    in_face = (np.arange(len(vertices)) < face_count) & (y < hair) & (y > chin - 2) & (ax < 1.02 * face_half)
    in_face &= z > np.interp(y, jaw[:, 0], jaw[:, 1]) - 2
    side = {"left": x >= 0, "right": x < 0}
    free = in_face.copy()
    zones = {"face": in_face}

    def take(name, region):
        nonlocal free
        zones[name] = free & region
        free &= ~region

    nose_half = np.interp(y, [base, 0.4 * base, 0], [1.25 * wing, 1.1 * wing, 0.65 * wing])
    take("nose", (y < 2) & (y > base - 1) & (ax < nose_half))
    for name, on in side.items():
        sign = 1 if name == "left" else -1
        ellipse = ((x - sign * eye[0]) / (1.6 * half_eye)) ** 2 + ((y - eye[1]) / (1.05 * half_eye)) ** 2
        take(f"eye_{name}", on & (ellipse < 1))
    take("forehead", (y > brow + 1) & (ax < 0.75 * face_half))
    take("mouth", (y <= base) & (y > lip_bottom - 3) & (ax < mouth_half + 5))
    take("chin", (y <= lip_bottom - 3) & (ax < 0.9 * mouth_half))
    for name, on in side.items():
        # A band from beside the wing of the nose to beside the corner of the mouth.
        a, b = np.array([wing + 5, 0.7 * base]), np.array([mouth_half + 8, mouth_y])
        t = np.clip(((ax - a[0]) * (b - a)[0] + (y - a[1]) * (b - a)[1]) / ((b - a) ** 2).sum(), 0, 1)
        off = np.hypot(ax - a[0] - t * (b - a)[0], y - a[1] - t * (b - a)[1])
        take(f"nasolabial_{name}", on & (off < 5))
    for name, on in side.items():
        take(f"cheek_{name}", on & (y < eye[1] - 0.9 * half_eye) & (y > lip_bottom) & (ax < 0.9 * face_half)
             & (ax > wing))
    return {name: np.flatnonzero(members).tolist() for name, members in zones.items()}


def make_faces(mean, identity, shapes, subjects, seed):
    """Random people (unit-variance weights) with all expressions: f32 [s, n, 3] and labels."""
    rng = np.random.default_rng(seed)
    names = list(EXPRESSIONS)
    count = subjects * len(names)
    faces = np.empty((count, *mean.shape), "<f4")
    subject, expression = np.empty(count, "<i4"), np.empty(count, "<i4")
    spread = mean.std(0)
    row = 0
    for s in range(subjects):
        neutral = mean + np.tensordot(rng.standard_normal(len(identity)), identity, 1)
        scale = neutral.std(0) / spread          # a longer face opens its mouth further
        lively = 1 + 0.2 * rng.standard_normal()
        for e, name in enumerate(names):
            move = np.zeros_like(mean)
            for unit, weight in EXPRESSIONS[name].items():
                gain = np.clip(lively * (1 + 0.2 * rng.standard_normal()), 0.4, 1.25)
                move += weight * gain * shapes[unit]
            if name != "neutral":
                extra = list(shapes)[rng.integers(len(shapes))]
                move += 0.1 * rng.random() * shapes[extra]
            faces[row], subject[row], expression[row] = neutral + scale * move, s, e
            row += 1
    return faces, subject, expression


def convert(folder, out, subjects=30, seed=1, skin=SKIN_VERTICES, face=FACE_VERTICES, marks=MULTI_PIE, face_tracking=False):
    """Does it all; `skin`, `face` and `marks` describe the layout of the mesh."""
    model = Path(folder)
    if (model / "FaceXModel").is_dir():
        model = model / "FaceXModel"
    try:
        config = json.loads((model / "vertex_indices.json").read_text())
        known = list(config["expressions"])
    except OSError as failure:
        raise Problem(f"{failure.filename}: cannot be read; give the folder that holds FaceXModel/")
    except (ValueError, KeyError, TypeError):
        raise Problem(f"{model / 'vertex_indices.json'}: is not ICT-FaceKit's list of expressions")
    needed = sorted({unit for units in EXPRESSIONS.values() for unit in units} |
                    {unit for units in face_tracking_shapes().values() if face_tracking for unit in units})
    missing = [unit for unit in needed if unit not in known]
    if missing:
        raise Problem(f"{model / 'vertex_indices.json'}: lacks the expressions {', '.join(missing)}")
    neutral_path = model / "generic_neutral_mesh.obj"
    mean = read_obj_vertices(neutral_path, skin)
    triangles = read_obj_triangles(neutral_path, skin)
    identity_paths = []
    while (model / f"identity{len(identity_paths):03d}.obj").is_file():
        identity_paths.append(model / f"identity{len(identity_paths):03d}.obj")
    if not identity_paths and subjects > 0:
        raise Problem(f"{model}: no identity000.obj; the training set needs the identity shapes")

    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    write_ply(out / "template.ply", mean, triangles)
    names = landmark_names()
    (out / "landmarks.json").write_text(json.dumps({
        "scheme": "multipie68", "alignment4": ["eye_right_0", "eye_left_3", "mouth_outer_00", "mouth_outer_06"],
        "vertices": dict(zip(names, marks))}, indent=1) + "\n")
    zones = make_zones(mean, {name: mean[v] for name, v in zip(names, marks)}, face)
    (out / "zones.json").write_text(json.dumps({"zones": zones}) + "\n")
    if face_tracking:
        (out / "shapes").mkdir(exist_ok=True)
        for name, units in face_tracking_shapes().items():
            moved = sum((read_obj_vertices(model / f"{unit}.obj", skin) - mean for unit in units), mean)
            write_ply(out / "shapes" / f"{name}.ply", moved, triangles)
    if subjects > 0:
        identity = np.array([read_obj_vertices(p, skin) - mean for p in identity_paths])
        shapes = {unit: read_obj_vertices(model / f"{unit}.obj", skin) - mean
                  for unit in sorted({unit for units in EXPRESSIONS.values() for unit in units})}
        faces, subject, expression = make_faces(mean, identity, shapes, subjects, seed)
        write_safetensors(out / "train.safetensors",
                          {"vertices": faces, "subject": subject, "expression": expression,
                           "triangles": triangles.astype("<u4")},
                          {"expression_names": json.dumps(list(EXPRESSIONS)), "units": "millimetres",
                           "model": "ICT-FaceKit (MIT)", "generator": "convert_ict_facekit.py",
                           "options": json.dumps({"subjects": subjects, "seed": seed})})
    return len(mean), len(triangles), len(identity_paths)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="the downloaded ICT-FaceKit, or its FaceXModel folder")
    parser.add_argument("--out", required=True, help="folder to write")
    parser.add_argument("--subjects", type=int, default=30, help="people in the training set; 0: none (default 30)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--face-tracking", action="store_true", help="also write the 52 shapes of face trackers into OUT/shapes")
    options = parser.parse_args()
    if options.subjects < 0 or options.seed < 0:
        parser.error("--subjects and --seed must not be negative")
    try:
        vertices, triangles, identities = convert(options.folder, options.out, options.subjects, options.seed,
                                                  face_tracking=options.face_tracking)
    except (Problem, OSError) as failure:
        sys.exit(f"convert_ict_facekit: {failure}")
    print(f"{options.out}: template of {vertices} vertices and {triangles} triangles, "
          f"{options.subjects} subjects from {identities} identity shapes")


if __name__ == "__main__":
    main()
