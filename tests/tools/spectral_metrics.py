#!/usr/bin/env python3
"""DAME and FMPD once more, written from the definitions with numpy alone, against `mien metric`.

  spectral_metrics.py MIEN_COMMAND      exit status 0: they agree; 77: numpy is missing
"""
import itertools
import os
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    print("numpy is not installed")
    sys.exit(77)


def torus_patch(nu, nv, seed, amplitude):
    """An open patch of a torus, with noise along all axes."""
    u = np.linspace(0, 4.5, nu)[:, None]
    v = np.linspace(0, 5.0, nv)[None, :]
    x = np.stack([(30 + 10 * np.cos(v)) * np.cos(u), (30 + 10 * np.cos(v)) * np.sin(u),
                  10 * np.sin(v) + 0 * u], axis=-1).reshape(-1, 3)
    x = x + amplitude * np.random.default_rng(seed).uniform(-1, 1, x.shape)
    faces = []
    for i, j in itertools.product(range(nu - 1), range(nv - 1)):
        a, b, c, d = i * nv + j, (i + 1) * nv + j, (i + 1) * nv + j + 1, i * nv + j + 1
        faces += [[a, b, c], [a, c, d]]
    return x, np.array(faces)


def write_off(path, x, faces):
    with open(path, "w") as f:
        f.write(f"OFF\n{len(x)} {len(faces)} 0\n")
        for p in x:
            f.write("%.17g %.17g %.17g\n" % tuple(p))
        for t in faces:
            f.write("3 %d %d %d\n" % tuple(t))


def edges_of(faces):
    table = {}
    for t, (a, b, c) in enumerate(faces):
        for i, j in ((a, b), (b, c), (c, a)):
            table.setdefault((min(i, j), max(i, j)), []).append((t, i, j))
    return table


def oriented_angles(x, faces, edges):
    n = np.cross(x[faces[:, 1]] - x[faces[:, 0]], x[faces[:, 2]] - x[faces[:, 0]])
    n = n / np.linalg.norm(n, axis=1, keepdims=True)
    centre = x[faces].mean(1)
    angles = []
    for (s, _, _), (t, _, _) in edges:
        angle = np.arccos(np.clip(n[s] @ n[t], -1, 1))
        # Convex where the neighbour's centre lies behind the triangle.
        angles.append(angle * (1 if n[s] @ (centre[t] - centre[s]) < 0 else -1))
    return np.array(angles)


def areas(x, faces):
    return 0.5 * np.linalg.norm(np.cross(x[faces[:, 1]] - x[faces[:, 0]], x[faces[:, 2]] - x[faces[:, 0]]), axis=1)


def dame(x, y, faces):
    inner = [sides for sides in edges_of(faces).values() if len(sides) == 2]
    d, e = oriented_angles(x, faces, inner), oriented_angles(y, faces, inner)
    area = areas(x, faces)
    weight = np.array([area[s[0]] + area[t[0]] for s, t in inner])
    return (np.abs(d - e) * np.exp(-d ** 2) * weight).sum() / weight.sum()


def roughness(x, faces):
    n = len(x)
    table = edges_of(faces)
    border = np.zeros(n, bool)
    for (i, j), sides in table.items():
        if len(sides) == 1:
            border[[i, j]] = True
    angle_sum, weights = np.zeros(n), np.zeros((n, n))
    for face in faces:
        for k in range(3):
            p, q, r = face[k], face[(k + 1) % 3], face[(k + 2) % 3]
            u, v = x[q] - x[p], x[r] - x[p]
            cosine = u @ v / np.linalg.norm(u) / np.linalg.norm(v)
            angle = np.arccos(np.clip(cosine, -1, 1))
            angle_sum[p] += angle
            weights[q, r] += 0.5 / np.tan(angle)
            weights[r, q] += 0.5 / np.tan(angle)
    weights = np.maximum(weights, 0)
    g = np.where(border, 0, np.abs(2 * np.pi - angle_sum))
    rough = np.zeros(n)
    for i in np.flatnonzero(~border):
        near = np.flatnonzero(weights[i])
        inner = near[~border[near]]
        rough[i] = abs((weights[i, inner] * (g[inner] - g[i])).sum()) / weights[i, near].sum()
    mass = np.zeros(n)
    np.add.at(mass, faces, (areas(x, faces) / 3)[:, None])
    return rough, mass / mass.sum()


def fmpd(x, fx, y, fy):
    both = [roughness(x, fx), roughness(y, fy)]
    mean = min(r @ m for r, m in both)
    top, low, power = max(0.2, 5 * mean), 5e-4, 0.15
    turn = max(mean, low) ** power - low ** power
    total = []
    for r, m in both:
        f = np.clip(r, low, top) ** power - low ** power
        total.append(np.where(f > turn, turn + 0.5 * (f - turn), f) @ m)
    return min(1.0, 8 * abs(total[0] - total[1]))


def main():
    command, failed = sys.argv[1], False
    with tempfile.TemporaryDirectory() as folder:
        for seed, amplitude in ((1, 0.02), (2, 0.2), (3, 0.8)):
            x, faces = torus_patch(25, 20, 0, 0.05)
            y, _ = torus_patch(25, 20, seed, amplitude)
            z, other = torus_patch(19, 31, seed, amplitude)
            paths = [os.path.join(folder, name) for name in ("a.off", "b.off", "c.off")]
            write_off(paths[0], x, faces)
            write_off(paths[1], y, faces)
            write_off(paths[2], z, other)
            for name, second, expected in (("dame", paths[1], dame(x, y, faces)),
                                           ("fmpd", paths[1], fmpd(x, faces, y, faces)),
                                           ("fmpd", paths[2], fmpd(x, faces, z, other))):
                out = subprocess.run([command, "metric", name, paths[0], second], check=True,
                                     capture_output=True, text=True).stdout
                value = float(out)
                good = abs(value - expected) <= 1e-6 * max(abs(expected), 1e-3)
                failed |= not good
                print(f"{name}: {value:.9g} against {expected:.9g} {'ok' if good else 'DIFFERENT'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
