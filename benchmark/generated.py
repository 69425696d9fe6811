#!/usr/bin/env python3
"""Surfaces as generators of shapes make them, by the program quadrille.

  generated.py matrix PROGRAM [SEED...]   what must hold of each result, for many surfaces
  generated.py table PROGRAM N|FILE...    faces, seconds and distances beside meshoptimizer and VTK

The surfaces are those of gen_shell.py in the folder that QUADRILLE_CASES names, or in binary PLY files. `matrix` prints each
failure and fails if there is any; `table` prints rows of Markdown. Both need numpy, `table` also the
packages libmeshoptimizer-dev and python3-vtk9 of Debian.
"""
import ctypes
import filecmp
import itertools
import json
import os
import resource
import subprocess
import sys
import tempfile

import numpy as np

GENERATOR = os.path.join(os.environ.get("QUADRILLE_CASES", ""), "wild", "gen_shell.py")


def generate(path, n, seed, tunnels=0.002, floaters=200, rounds=3):
    arguments = [path, n, seed, tunnels, floaters, rounds]
    subprocess.run([sys.executable, GENERATOR, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


TYPES = {b"uchar": "u1", b"float": "<f4", b"double": "<f8", b"int": "<i4", b"uint": "<u4"}


def read_ply(path):
    """Points and triangles of a binary PLY file."""
    with open(path, "rb") as file:
        elements = {}
        while (line := file.readline().split()) != [b"end_header"]:
            if line[0] == b"element":
                elements[line[1]] = int(line[2]), (fields := [])
            elif line[:2] == [b"property", b"list"]:
                fields += [("k", TYPES[line[2]]), ("v", TYPES[line[3]], 3)]
            elif line[0] == b"property":
                fields.append((line[2].decode(), TYPES[line[1]]))
        rows = {name: np.fromfile(file, np.dtype(fields), count) for name, (count, fields) in elements.items()}
    vertices = rows[b"vertex"]
    assert (rows[b"face"]["k"] == 3).all()
    return np.stack([vertices[x].astype(np.float64) for x in "xyz"], 1), rows[b"face"]["v"].astype(np.int32)


def write_ply(path, points, triangles):
    rows = np.empty(len(triangles), np.dtype([("k", "u1"), ("v", "<i4", 3)]))
    rows["k"], rows["v"] = 3, triangles
    with open(path, "wb") as file:
        file.write(("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                    "property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n"
                    % (len(points), len(triangles))).encode())
        file.write(points.astype("<f4").tobytes())
        file.write(rows.tobytes())


def faces_at_edges(triangles):
    """For each edge, how many faces have it."""
    ends = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), 1)
    return np.unique(ends.astype(np.int64) @ np.array([1 << 32, 1]), return_counts=True)[1]


# --- What must hold of each result ---------------------------------------------------------------

def simplify(program, path, out, faces, *options):
    report = out + ".json"
    command = [program, path, out, "--faces", str(faces), "--force", "--quiet", "--report", report, *options]
    run = subprocess.run(command, capture_output=True, text=True)
    if not os.path.exists(report):
        return None, run.stderr.strip()
    with open(report) as file:
        figures = json.load(file)
    os.remove(report)
    return (figures["results"][0] if "results" in figures else figures), run.stderr.strip()


MODES = {"plain": [], "manifold": ["--manifold"], "generated": ["--preset", "generated"],
         "cuts": ["--manifold", "--cut-handles", "1.5"], "threads": ["--order", "relaxed", "--threads", "2"]}


def failures_of(program, path, folder, faces, mode):
    """What does not hold of results of one count: sentences."""
    out, again = os.path.join(folder, "a.ply"), os.path.join(folder, "b.ply")
    figures, errors = simplify(program, path, out, faces, *MODES[mode])
    if figures is None:
        return ["no result: " + errors]
    failures = []
    points, triangles = read_ply(out)
    if abs(len(triangles) - faces) > 1 and figures["target_met"]:
        failures.append(f"{len(triangles)} faces, and the target is said to be met")
    if abs(len(triangles) - faces) > 1 and figures["stop"] in ("target met", "target passed"):
        failures.append(f"{len(triangles)} faces, and that is not said to be the least")
    counts = faces_at_edges(triangles)
    if (counts == 1).any():
        failures.append(f"{(counts == 1).sum()} open edges")
    if mode not in ("plain", "threads") and (counts > 2).any():
        failures.append(f"{(counts > 2).sum()} edges of more than two faces")
    options = MODES[mode]
    for run in range(1, 4):
        if mode == "threads":
            options = ["--order", "relaxed", "--threads", str(1 + run % 2)]
        simplify(program, path, again, faces, *options)
        if not filecmp.cmp(out, again, shallow=False):
            failures.append(f"run {run + 1} gives another result")
    return failures


def matrix(program, seeds):
    failed = runs = 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "in.ply")
        for tunnels, floaters, rounds, seed in itertools.product((0, 0.002, 0.02), (0, 200, 2000), (0, 2, 5), seeds):
            generate(path, 60, seed, tunnels, floaters, rounds)
            total = len(read_ply(path)[1])
            print(f"{runs} counts, {failed} failures; next: tunnels {tunnels}, floaters {floaters}, rounds {rounds}, "
                  f"seed {seed}, {total} faces", file=sys.stderr, flush=True)
            for faces, mode in itertools.product((total // 4, total // 20, 500), MODES):
                runs += 1
                for failure in failures_of(program, path, folder, faces, mode):
                    failed += 1
                    print(f"tunnels {tunnels}, floaters {floaters}, rounds {rounds}, seed {seed}, {total} -> {faces} "
                          f"faces, {mode}: {failure}", flush=True)
    print(f"{runs} counts, {failed} failures")
    return failed == 0


# --- The table -----------------------------------------------------------------------------------

def timed(action):
    """The processor time of this process and of those that it starts, in seconds."""
    def now():
        return sum(sum(resource.getrusage(who)[:2]) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    begin = now()
    result = action()
    return result, now() - begin


def by_meshoptimizer(points, triangles, faces):
    library = ctypes.CDLL("libmeshoptimizer.so")
    function = library.meshopt_simplify
    function.restype = ctypes.c_size_t
    function.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_size_t,
                         ctypes.c_size_t, ctypes.c_size_t, ctypes.c_float, ctypes.c_uint, ctypes.c_void_p]
    floats = np.ascontiguousarray(points, np.float32)
    indices = np.ascontiguousarray(triangles, np.uint32)
    left = np.empty_like(indices)
    count = function(left.ctypes.data, indices.ctypes.data, indices.size, floats.ctypes.data, len(floats), 12,
                     3 * faces, 1e9, 0, None)
    return points, left.reshape(-1, 3)[:count // 3].astype(np.int32)


def to_vtk(points, triangles):
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    data, place, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    place.SetData(numpy_to_vtk(points, deep=True))
    rows = np.concatenate([np.full((len(triangles), 1), 3), triangles], 1).astype(np.int64).ravel()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows, deep=True))
    data.SetPoints(place)
    data.SetPolys(cells)
    return data


def by_vtk(points, triangles, faces):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkQuadricDecimation
    decimation = vtkQuadricDecimation()
    decimation.SetInputData(to_vtk(points, triangles))
    decimation.SetTargetReduction(1 - faces / len(triangles))
    decimation.Update()
    result = decimation.GetOutput()
    return (vtk_to_numpy(result.GetPoints().GetData()).astype(np.float64),
            vtk_to_numpy(result.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int32))


def distance(points, triangles, other_points, other_triangles, count=20000):
    """The root mean square distance of points of the first surface from the second."""
    from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
    from vtkmodules.vtkCommonCore import mutable
    from vtkmodules.vtkCommonDataModel import vtkGenericCell
    locator = vtkStaticCellLocator()
    locator.SetDataSet(to_vtk(other_points, other_triangles))
    locator.BuildLocator()
    random = np.random.default_rng(1)
    corners = points[triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    chosen = corners[random.choice(len(triangles), count, p=area / area.sum())]
    u, v = random.random((2, count, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    samples = chosen[:, 0] + u * (chosen[:, 1] - chosen[:, 0]) + v * (chosen[:, 2] - chosen[:, 0])
    closest, cell, number, part, squared = [0.0] * 3, vtkGenericCell(), mutable(0), mutable(0), mutable(0.0)
    total = 0.0
    for sample in samples:
        locator.FindClosestPoint(sample, closest, cell, number, part, squared)
        total += float(squared)
    return (total / count) ** 0.5


def row(name, asked, got, seconds, points, triangles, result):
    counts = faces_at_edges(result[1])
    rms = max(distance(points, triangles, *result), distance(*result, points, triangles))
    print(f"| {len(triangles):,} | {asked:,} | {name} | {got:,} | {seconds:.1f} | {(counts == 1).sum():,} | "
          f"{(counts > 2).sum():,} | {rms:.2f} |", flush=True)


def table(program, surfaces):
    print("| faces | asked | by | got | seconds | open edges | edges of more than two faces | RMS, voxels |\n"
          "|--:|--:|---|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.ply")
        for surface in surfaces:
            path = surface
            if surface.isdigit():
                path = os.path.join(folder, "in.ply")
                generate(path, int(surface), 1)
            points, triangles = read_ply(path)
            for faces in (len(triangles) // 10, 20000, 2000):
                for name, options in (("quadrille", []), ("quadrille --preset generated", ["--preset", "generated"])):
                    _, seconds = timed(lambda: simplify(program, path, out, faces, *options))
                    result = read_ply(out)
                    row(f"`{name}`", faces, len(result[1]), seconds, points, triangles, result)
                for name, function in (("meshoptimizer", by_meshoptimizer), ("VTK", by_vtk)):
                    result, seconds = timed(lambda: function(points, triangles, faces))
                    row(name, faces, len(result[1]), seconds, points, triangles, result)
    return True


if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[1] not in ("matrix", "table"):
        sys.exit(__doc__)
    program = os.path.abspath(sys.argv[2])
    if sys.argv[1] == "matrix":
        is_good = matrix(program, [int(word) for word in sys.argv[3:]] or [11, 12, 13, 14])
    else:
        is_good = table(program, sys.argv[3:] or ["200"])
    sys.exit(0 if is_good else 1)
