# What a simplified asset has lost, by code that shares nothing with the library. Needs python3-vtk9 and python3-numpy.
from collections import defaultdict

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


class Surface:
    """An asset with its points at one place made one, and nearest points of it."""

    def __init__(self, asset):
        self.asset = asset
        self.points, triangles = np.unique(asset.points.reshape(-1, 3), axis=0, return_inverse=True)
        self.triangles = triangles.reshape(-1, 3)
        edges = np.sort(np.stack([self.triangles, np.roll(self.triangles, -1, axis=1)], -1).reshape(-1, 2), axis=1)
        self.edges, self.edge_of_side, self.counts = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
        self.faces_at = defaultdict(list)
        for side, edge in enumerate(self.edge_of_side.ravel()):
            self.faces_at[edge].append(side // 3)
        for corner, vertex in enumerate(self.triangles.ravel()):
            self.faces_at[-1 - vertex].append(corner // 3)
        p = self.points[self.triangles]
        crossed = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        self.areas = np.linalg.norm(crossed, axis=1) / 2
        self.locator = vtk.vtkStaticCellLocator()
        self.locator.SetDataSet(self.poly_data())
        self.locator.BuildLocator()

    def poly_data(self):
        cells = vtk.vtkCellArray()
        cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(self.triangles.ravel(), np.int64), deep=True))
        mesh = vtk.vtkPolyData()
        mesh.SetPoints(vtk.vtkPoints())
        mesh.GetPoints().SetData(numpy_to_vtk(self.points, deep=True))
        mesh.SetPolys(cells)
        return mesh

    def diagonal(self):
        return np.linalg.norm(np.ptp(self.points, axis=0))

    def samples(self, count, seed):
        """Faces and barycentric coordinates, uniform by area."""
        random = np.random.default_rng(seed)
        faces = random.choice(len(self.areas), count, p=self.areas / self.areas.sum())
        s, t = random.random((2, count))
        root = np.sqrt(s)
        return faces, np.stack([1 - root, root * (1 - t), root * t], 1)

    def places(self, faces, weights):
        return np.einsum("ni,nij->nj", weights, self.points[self.triangles[faces]])

    def nearest(self, places, normals, materials):
        """Of each place the nearest point: face, barycentric coordinates, distance. Of faces that share the point the one
        of this material and of the closest shading normal."""
        cell, sub, squared, point = vtk.reference(0), vtk.reference(0), vtk.reference(0.0), [0.0] * 3
        faces, points = np.empty(len(places), int), np.empty((len(places), 3))
        for i, place in enumerate(places):
            self.locator.FindClosestPoint(place, point, cell, sub, squared)
            faces[i], points[i] = int(cell), point
        weights = self.barycentric(faces, points)
        for i in np.flatnonzero(weights.min(axis=1) < 1e-7):
            around = np.array(self.around(faces[i], weights[i]))
            here = self.barycentric(around, np.repeat(points[i:i + 1], len(around), 0))
            likeness = self.asset.shading_normals(around, here) @ normals[i] + 3 * (self.asset.materials[around] == materials[i])
            best = np.argmax(likeness)
            faces[i], weights[i] = around[best], here[best]
        return faces, weights, np.linalg.norm(places - points, axis=1)

    def around(self, face, weights):
        on = np.flatnonzero(weights >= 1e-7)
        if len(on) == 1:
            return self.faces_at[-1 - self.triangles[face, on[0]]]
        side = {(0, 1): 0, (1, 2): 1, (0, 2): 2}[tuple(on)]
        return self.faces_at[self.edge_of_side.ravel()[3 * face + side]]

    def barycentric(self, faces, points):
        a, b, c = (self.points[self.triangles[faces, i]] for i in range(3))
        n = np.cross(b - a, c - a)
        square = np.maximum(np.einsum("ij,ij->i", n, n), 1e-300)
        v = np.einsum("ij,ij->i", np.cross(points - a, c - a), n) / square
        w = np.einsum("ij,ij->i", np.cross(b - a, points - a), n) / square
        weights = np.clip(np.stack([1 - v - w, v, w], 1), 0, 1)
        return weights / weights.sum(axis=1, keepdims=True)


def one_way(source, target, count, seed):
    """Squares of the distances and of the differences of colours and of angles, and whether materials differ."""
    faces, weights = source.samples(count, seed)
    normals, materials = source.asset.shading_normals(faces, weights), named(source, faces)
    numbers = np.array([target.asset.names.index(m) if m in target.asset.names else -1 for m in materials])
    there, weights_there, distances = target.nearest(source.places(faces, weights), normals, numbers)
    colours = source.asset.colours(faces, weights) - target.asset.colours(there, weights_there)
    cosines = np.einsum("ij,ij->i", normals, target.asset.shading_normals(there, weights_there))
    return {"shape": distances ** 2, "colour": (colours ** 2).mean(axis=1),
            "normal": np.degrees(np.arccos(np.clip(cosines, -1, 1))) ** 2, "material": materials != named(target, there)}


def named(surface, faces):
    return np.array(surface.asset.names)[surface.asset.materials[faces]]


def boundary_places(surface):
    return surface.points[surface.edges[surface.counts == 1]]


def torn_edges(original, result):
    """Edges of one face, both ends of which lie further from every such edge of the original than 0.5 % of the diagonal."""
    edges, old = boundary_places(result), boundary_places(original)
    if not len(old) or not len(edges):
        return len(edges)
    a, d = old[:, 0], old[:, 1] - old[:, 0]
    squares = np.einsum("ij,ij->i", d, d)

    def is_far(place):
        t = np.clip(np.einsum("ij,ij->i", place - a, d) / squares, 0, 1)[:, None]
        return np.linalg.norm(a + t * d - place, axis=1).min() > 0.005 * original.diagonal()
    return sum(is_far(p) and is_far(q) for p, q in edges)


def measured(original, result, count=20000):
    """RMS of both ways together: distance in % of the diagonal, colour from 0 to 1, angle of normals in degrees, part of wrong
    material in %; and torn edges."""
    ways = [one_way(original, result, count, 1), one_way(result, original, count, 2)]
    mean = {key: np.mean([way[key].mean() for way in ways]) for key in ways[0]}
    return {"faces": len(result.triangles), "shape": 100 * np.sqrt(mean["shape"]) / original.diagonal(),
            "colour": np.sqrt(mean["colour"]), "normal": np.sqrt(mean["normal"]),
            "material": 100 * mean["material"], "torn": torn_edges(original, result)}
