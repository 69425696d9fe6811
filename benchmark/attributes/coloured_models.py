# Ten models with colours at their vertices: of $QUADRILLE_DATA, and meshes of Debian's libcgal-demo that are painted.
import os
import sys

import numpy as np
import vtk
from asset import Asset, creased_normals
from vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../doc/gallery"))
import models as gallery  # noqa: E402


class Coloured(Asset):
    """Points, triangles and the colours of points, from 0 to 1, as an asset of one material without an image."""

    def __init__(self, points, triangles, colours):
        p = points[triangles]
        is_face = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) > 0
        triangles = triangles[is_face]
        super().__init__(points[triangles], creased_normals(points, triangles, 180), np.zeros((len(triangles), 3, 2)),
                         np.zeros(len(triangles), int), ["only"], [])
        self.corner_colours = colours[triangles]

    def colours(self, faces, weights):
        return np.einsum("ni,nij->nj", weights, self.corner_colours[faces])


def read_ply(path):
    """Points, triangles, colours; points at one place with one colour are one, and what has no area is left out."""
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    colours = vtk_to_numpy(mesh.GetPointData().GetScalars())[:, :3] / 255
    both, inverse = np.unique(np.hstack([points, colours]), axis=0, return_inverse=True)
    triangles = inverse.ravel()[triangles]
    p = both[triangles][:, :, :3]
    triangles = triangles[np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) > 0]
    return both[:, :3], triangles, both[:, 3:]


def data(name):
    return read_ply(os.path.join(os.environ["QUADRILLE_DATA"], "public/coloured", name))


# --- Painted ---------------------------------------------------------------------------------------

def waves(x):
    """Slow hues in all directions, with a little of a faster pattern."""
    phases = np.array([0, 2.1, 4.2])
    slow = np.sin(7 * x[:, 0] + 3 * np.sin(5 * x[:, 1]))[:, None] + np.cos(6 * x[:, 2] - 4 * x[:, 1])[:, None]
    return 0.5 + 0.3 * np.sin(1.6 * slow + phases) + 0.15 * np.sin(40 * x[:, :1]) * np.sin(40 * x[:, 1:2]) * np.sin(40 * x[:, 2:])


def stripes(x):
    """Of two colours, with shores as sharp as vertices allow."""
    side = np.tanh(12 * np.sin(26 * x[:, 1] + 4 * np.sin(6 * x[:, 0]) + 3 * np.cos(8 * x[:, 2])))[:, None]
    return np.where(side > 0, side * np.array([0.95, 0.75, 0.25]), -side * np.array([0.2, 0.25, 0.5])) + 0.05 * (1 - abs(side))


def spots(x, count=90):
    """Cells of colours of their own around points of space, with dark shores."""
    random = np.random.default_rng(3)
    centres, colours = random.random((count, 3)), 0.25 + 0.7 * random.random((count, 3))
    distances = np.linalg.norm(x[:, None] - centres, axis=2)
    nearest = np.sort(distances, axis=1)
    shore = np.clip((nearest[:, 1] - nearest[:, 0]) / 0.02, 0, 1)[:, None]
    return colours[distances.argmin(axis=1)] * (0.2 + 0.8 * shore)


def painted(path, paint):
    points, triangles = gallery.read_off(path)
    low, size = points.min(axis=0), np.ptp(points, axis=0).max()
    colours = np.clip(paint((points - low) / size), 0, 1)
    return points, triangles, np.round(255 * colours) / 255


def models(meshes):
    """Functions that give points, triangles and colours, by name; those of $QUADRILLE_DATA where that is set."""
    mesh = lambda name: os.path.join(meshes, name)
    found = {"bunny, waves": lambda: painted(mesh("bunny00.off"), waves),
             "elephant, stripes": lambda: painted(mesh("refined_elephant.off"), stripes),
             "lion-head, spots": lambda: painted(mesh("lion-head.off"), spots)}
    if "QUADRILLE_DATA" in os.environ:
        for name in ("ankylosaurus_70k", "gargo_50k", "banana_baked_16k", "knot_errormap_26k", "steampunk_baked_24k", "spot_baked_6k",
                     "scissors_baked_16k"):
            found[name.split("_")[0]] = lambda name=name: data(name + ".ply")
    return found
