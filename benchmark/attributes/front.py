#!/usr/bin/env python3
# Distance against error of colours at weights of the colours, ours and those of meshoptimizer and VTK, on ten models. Needs the Debian
# packages python3-numpy, python3-vtk9 and nodejs, the Python module quadrille of the build, and `npm install meshoptimizer` in a
# folder of its own:
#   PYTHONPATH=BUILD/examples/products/python NODE_MODULES=... python3 benchmark/attributes/front.py MESHES OUT.csv [--ratio 0.1] [--only MODEL...] [--contenders NAME...]
# MESHES is the folder data/meshes of libcgal-demo; seven of the models are taken from $QUADRILLE_DATA.
import argparse
import csv
import os
import subprocess
import sys
import tempfile
import time

import numpy as np
import quadrille
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

sys.path.insert(0, os.path.dirname(__file__))
import coloured_models  # noqa: E402
from asset_measures import Surface, measured  # noqa: E402
from coloured_models import Coloured  # noqa: E402

OURS = {"quadric": {}, "passes": {"order": "relaxed"}, "passes refreshed": {"order": "relaxed", "share": 0.2, "refresh": True},
        "memoryless": {"cost": "memoryless_quadric"}}
IMPORTANCES = (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 10)
WEIGHTS = (0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 1, 2, 5)
VTK, VTK_WEIGHTS = "VTK", (0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1)
PEER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "front_peer.mjs")


def ours(model, count, importance, options):
    points, triangles, colours = model
    start = time.process_time()
    result = quadrille.simplify(points, triangles, faces=count,
                                colors=quadrille.Channel(colours, importance=importance), **options)
    spent = time.process_time() - start
    return 1000 * spent, Coloured(result.points, result.faces, np.asarray(result.colors.values))


def theirs(model, count, weight, update):
    """Its positions are about the centre of the box, so that floats lose no digits there."""
    points, triangles, colours = model
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    with tempfile.TemporaryDirectory() as folder:
        source, target = os.path.join(folder, "in"), os.path.join(folder, "out")
        with open(source, "wb") as file:
            for array in (np.array([len(points), len(triangles)], np.uint32), (points - centre).astype(np.float32),
                          colours.astype(np.float32), triangles.astype(np.uint32)):
                file.write(array.tobytes())
        run = subprocess.run(["node", PEER, source, target, str(count), str(weight), str(int(update))], check=True,
                             capture_output=True, text=True)
        with open(target, "rb") as file:
            data = file.read()
    vertices, faces = np.frombuffer(data, np.uint32, 2)
    floats = np.frombuffer(data, np.float32, 6 * vertices, 8).reshape(2, -1, 3).astype(float)
    indices = np.frombuffer(data, np.uint32, 3 * faces, 8 + 24 * int(vertices)).reshape(-1, 3)
    return float(run.stdout), Coloured(floats[0] + centre, indices.astype(int), np.clip(floats[1], 0, 1))


def vtks(model, count, weight):
    """vtkQuadricDecimation, to which colours are vectors, since scalars would be one number."""
    points, triangles, colours = model
    surface = vtkPolyData()
    surface.SetPoints(vtkPoints())
    surface.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    cells = np.insert(triangles, 0, 3, axis=1).astype(np.int64).ravel()
    surface.SetPolys(vtkCellArray())
    surface.GetPolys().ImportLegacyFormat(numpy_to_vtkIdTypeArray(cells, deep=True))
    surface.GetPointData().SetVectors(numpy_to_vtk(colours, deep=True))
    decimation = vtkQuadricDecimation()
    decimation.SetInputData(surface)
    decimation.SetTargetReduction(1 - count / len(triangles))
    decimation.AttributeErrorMetricOn()
    decimation.VectorsAttributeOn()
    decimation.SetVectorsWeight(weight)
    for others in (decimation.SetScalarsAttribute, decimation.SetNormalsAttribute, decimation.SetTCoordsAttribute,
                   decimation.SetTensorsAttribute):
        others(False)
    start = time.process_time()
    decimation.Update()
    spent = time.process_time() - start
    result = decimation.GetOutput()
    faces = vtk_to_numpy(result.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    values = vtk_to_numpy(result.GetPointData().GetVectors())
    return 1000 * spent, Coloured(vtk_to_numpy(result.GetPoints().GetData()), faces, np.clip(values, 0, 1))


PEERS = {"meshoptimizer": False, "meshoptimizer update": True}


def rows(model, count, contenders):
    for name in contenders:
        for weight in IMPORTANCES if name in OURS else VTK_WEIGHTS if name == VTK else WEIGHTS:
            if name in OURS:
                run = ours(model, count, weight, OURS[name])
            elif name == VTK:
                run = vtks(model, count, weight)
            else:
                run = theirs(model, count, weight, PEERS[name])
            yield name, weight, *run


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("meshes")
    parser.add_argument("out")
    parser.add_argument("--ratio", type=float, default=0.1)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--contenders", nargs="*", default=[*OURS, *PEERS, VTK])
    given = parser.parse_args()
    with open(given.out, "w") as file:
        table = csv.writer(file)
        table.writerow(("model", "contender", "weight", "faces", "ms", "shape", "colour"))
        for name, make in coloured_models.models(given.meshes).items():
            if given.only and name not in given.only:
                continue
            model = make()
            original = Surface(Coloured(*model))
            for contender, weight, spent, result in rows(model, int(given.ratio * len(model[1])), given.contenders):
                errors = measured(original, Surface(result))
                row = (name, contender, weight, errors["faces"], *(f"{x:.4g}" for x in (spent, errors["shape"], errors["colour"])))
                table.writerow(row)
                file.flush()
                print(*row, flush=True)


if __name__ == "__main__":
    main()
