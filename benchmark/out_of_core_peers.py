#!/usr/bin/env python3
"""Simplifies a binary PLY file by what streams, or goes by chunks, and tells time, memory as the kernel counts
it, distances, and whether seams can be found, in a table.

    out_of_core_peers.py BUILD IN.ply FACES FOLDER [MEMORY]

BUILD has examples/products/program/quadrille, benchmark/quadrille_seams and benchmark/clustered. Needs Debian's
python3-vtk9, python3-numpy and libmeshoptimizer-dev. Rows:

- Quadrille: --out-of-core with MEMORY, 500M by default, and in memory through the same files
- clustering: cluster_vertices of the library, in memory (Lindstrom 2000 streams)
- VTK clustering: vtkQuadricClustering, a chunk after the other
- meshoptimizer: meshopt_simplify, a chunk after the other, with borders locked, once; VTK decimation the same with
  vtkDecimatePro, which keeps borders by its option

A chunk are 500,000 faces in the order of the file. Their borders are those of vertices that several chunks have.
"""
import ctypes
import pathlib
import resource
import subprocess
import sys
import time

import numpy as np

CHUNK = 500_000
FACE = np.dtype([("n", "u1"), ("v", "<u4", 3)])


class Input:
    """A little-endian file of floats and of triangles."""

    def __init__(self, path):
        self.path = path
        with open(path, "rb") as file:
            head = file.read(4096)
        self.begin = head.index(b"end_header\n") + 11
        words = head[:self.begin].decode().split()
        counts = [int(words[i + 2]) for i, word in enumerate(words) if word == "element"]
        self.vertices, self.faces = counts
        self.faces_begin = self.begin + 12 * self.vertices

    def positions(self, ids):
        """Of ascending vertices, read in runs: of a file in order they lie close together."""
        result = np.empty((len(ids), 3), "<f4")
        breaks = np.flatnonzero(np.diff(ids) > 4096) + 1
        with open(self.path, "rb") as file:
            for run in np.split(np.arange(len(ids)), breaks):
                first, last = int(ids[run[0]]), int(ids[run[-1]])
                file.seek(self.begin + 12 * first)
                rows = np.fromfile(file, "<f4", 3 * (last - first + 1)).reshape(-1, 3)
                result[run] = rows[ids[run] - first]
        return result

    def chunks(self):
        """Vertices in ascending order, places, and triangles of these."""
        for first in range(0, self.faces, CHUNK):
            with open(self.path, "rb") as file:
                file.seek(self.faces_begin + FACE.itemsize * first)
                corners = np.fromfile(file, FACE, CHUNK)["v"]
            ids, local = np.unique(corners, return_inverse=True)
            yield ids, self.positions(ids), local.reshape(-1, 3).astype(np.uint32)


def write_ply(path, points, faces):
    with open(path, "wb") as file:
        file.write((f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\n"
                    f"property float y\nproperty float z\nelement face {len(faces)}\n"
                    "property list uchar int vertex_indices\nend_header\n").encode())
        file.write(np.asarray(points, "<f4").tobytes())
        rows = np.empty(len(faces), FACE)
        rows["n"], rows["v"] = 3, faces
        file.write(rows.tobytes())


def polydata(points, triangles):
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    cells = np.empty((len(triangles), 4), np.int64)
    cells[:, 0], cells[:, 1:] = 3, triangles
    data, place, faces = vtkPolyData(), vtkPoints(), vtkCellArray()
    place.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    faces.SetCells(len(triangles), numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
    data.SetPoints(place)
    data.SetPolys(faces)
    return data


def arrays(data):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    faces = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(data.GetPoints().GetData()), faces


def vtk_clustering(source, output, target):
    """The filter is told cells and no number of faces: those that leave about as many are looked for by some runs over
    the whole file, of which the last one counts."""
    from vtkmodules.vtkFiltersCore import vtkQuadricClustering
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for _, points, _ in source.chunks():
        low, high = np.minimum(low, points.min(0)), np.maximum(high, points.max(0))
    bounds = np.stack([low, high], 1).ravel()
    cells, seconds = (target / 4) ** 0.5, 0
    for _ in range(4):
        begin = time.process_time()
        filter_ = vtkQuadricClustering()
        filter_.AutoAdjustNumberOfDivisionsOff()
        extents = (high - low) / (high - low).max()
        filter_.SetNumberOfDivisions([max(1, int(np.ceil(cells * e))) for e in extents])
        filter_.SetInputData(polydata(np.float32([low, high, low]), [[0, 1, 2]]))
        filter_.Update()  # or Append() ends with a segmentation fault, in VTK 9.1
        filter_.StartAppend(bounds)
        for _, points, triangles in source.chunks():
            filter_.Append(polydata(points, triangles))
        filter_.EndAppend()
        points, faces = arrays(filter_.GetOutput())
        seconds = time.process_time() - begin
        if abs(len(faces) / target - 1) < 0.03:
            break
        cells *= (target / len(faces)) ** 0.5
    write_ply(output, points, faces)
    print("seconds", seconds)


class Sewn:
    """Chunks whose vertices keep their numbers, or get new ones."""

    def __init__(self, source):
        count = np.zeros(source.vertices, np.uint8)
        for ids, _, _ in source.chunks():
            count[ids] += 1
        self.is_shared = count > 1
        self.source, self.faces, self.ids, self.points = source, [], [], []

    def write(self, output):
        ids = np.concatenate(self.ids)
        points = np.concatenate(self.points)
        used, first = np.unique(ids, return_index=True)
        write_ply(output, points[first], np.searchsorted(used, np.concatenate(self.faces)))

    def write_boundaries(self, path):
        """Edges of the input between shared vertices."""
        with open(path, "w") as file:
            for ids, points, triangles in self.source.chunks():
                shared = self.is_shared[ids]
                for a, b in ((0, 1), (1, 2), (2, 0)):
                    for v, w in triangles[shared[triangles[:, a]] & shared[triangles[:, b]]][:, [a, b]]:
                        for p in points[[v, w]]:
                            file.write("v %.9g %.9g %.9g\n" % tuple(p))


def meshoptimizer(source, output, target):
    library = ctypes.CDLL("libmeshoptimizer.so")
    library.meshopt_simplify.restype = ctypes.c_size_t
    library.meshopt_simplify.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p,
                                         ctypes.c_size_t, ctypes.c_size_t, ctypes.c_size_t, ctypes.c_float,
                                         ctypes.c_uint, ctypes.c_void_p]
    sewn = Sewn(source)
    for ids, points, triangles in source.chunks():
        left = np.empty(triangles.size, np.uint32)
        wanted = int(len(triangles) * target / source.faces) * 3
        count = library.meshopt_simplify(left.ctypes.data, triangles.ctypes.data, triangles.size, points.ctypes.data,
                                         len(points), 12, wanted, 1e9, 1, None)
        faces = left[:count].reshape(-1, 3)
        sewn.faces.append(ids[faces])
        used = np.unique(faces)
        sewn.ids.append(ids[used])
        sewn.points.append(points[used])
    sewn.write(output)
    sewn.write_boundaries(str(output) + ".obj")


def vtk_decimate_pro(source, output, target):
    """Its vertices are those of the input, at the same places."""
    from vtkmodules.vtkFiltersCore import vtkDecimatePro
    sewn = Sewn(source)
    for ids, points, triangles in source.chunks():
        filter_ = vtkDecimatePro()
        filter_.SetInputData(polydata(points, triangles))
        filter_.SetTargetReduction(1 - target / source.faces)
        filter_.PreserveTopologyOn()
        filter_.BoundaryVertexDeletionOff()
        filter_.Update()
        places, faces = arrays(filter_.GetOutput())
        key = np.ascontiguousarray(points).view("V12").ravel()
        order = np.argsort(key)
        found = order[np.searchsorted(key[order], np.ascontiguousarray(places, "<f4").view("V12").ravel())]
        sewn.faces.append(ids[found[faces]])
        sewn.ids.append(ids[found])
        sewn.points.append(points[found])
    sewn.write(output)
    sewn.write_boundaries(str(output) + ".obj")


PYTHON = {"vtk_clustering": vtk_clustering, "meshoptimizer": meshoptimizer, "vtk_decimate_pro": vtk_decimate_pro}


def measured(command):
    """Seconds of processor and bytes of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen(["/usr/bin/time", "-f", "%M"] + command, stderr=subprocess.PIPE, stdout=subprocess.PIPE)
    told, said = (text.decode() for text in process.communicate())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if process.returncode != 0:
        raise RuntimeError(said)
    if told.startswith("seconds "):
        return float(told.split()[1]), int(said.split()[-1]) * 1024
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, int(said.split()[-1]) * 1024


def main():
    if sys.argv[1] == "--one":
        name, path, output, target = sys.argv[2:]
        PYTHON[name](Input(path), output, int(target))
        return
    build, path, target, folder = (pathlib.Path(sys.argv[1]), sys.argv[2], str(int(float(sys.argv[3]))),
                                   pathlib.Path(sys.argv[4]))
    memory = sys.argv[5] if len(sys.argv) > 5 else "500M"
    folder.mkdir(parents=True, exist_ok=True)
    program = str(build / "examples/products/program/quadrille")
    common = ["--faces", target, "--cost", "memoryless", "--quiet", "--force"]
    rows = {"parts": [program, path, "OUT", *common, "--threads", "1", "--out-of-core", str(folder / "scratch"), "--memory", memory],
            "in memory": [program, path, "OUT", *common],
            "clustering": [str(build / "benchmark/clustered"), path, "OUT", target]}
    for name in PYTHON:
        rows[name] = [sys.executable, __file__, "--one", name, path, "OUT", target]
    for name, command in rows.items():
        output = folder / (name.replace(" ", "_") + ".ply")
        try:
            seconds, size = measured([str(output) if word == "OUT" else word for word in command])
        except RuntimeError as error:
            print(f"| {name} | {error}", flush=True)
            continue
        borders = pathlib.Path(str(output) + ".obj")
        what = subprocess.run([str(build / "benchmark/quadrille_seams"), "measure", path, str(output)]
                              + ([str(borders)] if borders.exists() else []), capture_output=True, text=True).stdout
        print(f"| {name} | {seconds:.1f} s | {size / 1e9:.2f} GB | {what.strip()} |", flush=True)


if __name__ == "__main__":
    main()
