"""Surfaces to test the Python module with, and a folder for their files."""

import os
import tempfile
import unittest

import numpy as np


class Folder(unittest.TestCase):
    """Tests that write files."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)


def sheet(n, m=None):
    """n by m points, bent, with two triangles for each square; and their places in [0, 1]²."""
    m = m or n
    u, v = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, m), indexing="ij")
    points = np.stack([u, v, 0.1 * np.sin(5 * u) * np.cos(7 * v)], axis=-1).reshape(-1, 3)
    corner = np.arange(n * m).reshape(n, m)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    faces = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return points, faces.astype(np.uint32), np.stack([u, v], axis=-1).reshape(-1, 2)


def torus(n, m=None):
    """A closed surface of 2 n m triangles; and, at its corners, a texture that is cut open twice."""
    m = m or n
    corner = np.arange(n * m).reshape(n, m)
    right, up = np.roll(corner, -1, axis=0), np.roll(corner, -1, axis=1)
    both = np.roll(right, -1, axis=1)
    faces = np.stack([corner, right, both, corner, both, up], axis=-1).reshape(-1, 3)
    s, t = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    around = 2 + np.cos(t) + 0.05 * np.sin(9 * s)
    points = np.stack([around * np.cos(s), around * np.sin(s), np.sin(t)], axis=-1).reshape(-1, 3)
    values = np.stack(np.meshgrid(np.arange(n + 1) / n, np.arange(m + 1) / m, indexing="ij"), axis=-1)
    place = np.arange((n + 1) * (m + 1)).reshape(n + 1, m + 1)
    a, b, c, d = place[:-1, :-1], place[1:, :-1], place[1:, 1:], place[:-1, 1:]
    triples = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return points, faces.astype(np.uint32), (values.reshape(-1, 2), triples.astype(np.uint32))


def write_obj(path, points, faces, uv):
    """With a texture at corners, two materials and a library of these."""
    values, triples = uv
    lines = ["mtllib statue.mtl"]
    lines += [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += [f"vt {s!r} {t!r}" for s, t in values.tolist()]
    for number, (face, triple) in enumerate(zip((faces + 1).tolist(), (triples + 1).tolist())):
        if number in (0, len(faces) // 2):
            lines.append("usemtl " + ("skin" if number == 0 else "cloth"))
        lines.append("f " + " ".join(f"{v}/{t}" for v, t in zip(face, triple)))
    with open(path, "w") as file:
        file.write("\n".join(lines) + "\n")
