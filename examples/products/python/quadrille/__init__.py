"""Simplifies triangle surfaces by contracting pairs of vertices under quadric error metrics.

    import quadrille
    mesh = quadrille.read_mesh("statue.obj")              # with its texture, normals and materials
    small = quadrille.simplify(mesh, faces=10_000)
    quadrille.write_mesh("small.obj", small)

    points, faces = quadrille.simplify(points, faces, ratio=0.1)      # arrays of numpy

simplify    simplifies a surface; see help(quadrille.simplify)
Mesh        points and faces with uv, normals, colors, attributes and labels
Channel     the values of an attribute, with options for its weight and its seams
Simplified  the result of simplify(): a Mesh with a report
Levels      all levels of detail of a surface from one run, in memory and in a file
Splits      levels as arrays of vertex splits
SparseMap   where the points of the input are on the result, and the other way round, as a sparse matrix
read_mesh, write_mesh  files: OFF, OBJ, PLY, STL, GOCAD
simplify_gltf  glTF documents, from file to file
simplify_file, FileJob  surfaces larger than memory, from file to file, in chunks
hidden_faces, remove_hidden  faces that are not seen from outside
visibility  how much of each face and point is seen, also for simplify(importance=...)
curvature_importance, view_importance  for simplify(importance=...): where to keep more faces
surface_distance  how far two surfaces are from each other
verify      checks whether a result keeps its promises

The costs follow Garland and Heckbert 1997 and later papers: see the manual of the C++ library.
"""

from . import _core
from ._core import Contraction, FileEstimate, FileStatus, Pair, Report, Status
from ._file_jobs import FileJob, SimplifiedFile, simplify_file
from ._files import read_mesh, write_mesh
from ._gltf import simplify_gltf
from ._hidden import HiddenFaces, HiddenGroup, Visibility, hidden_faces, remove_hidden, visibility
from ._importance import curvature_importance, view_importance
from ._levels import Level, Levels, Splits
from ._maps import SparseMap
from ._measures import Distance, Finding, Verdict, surface_distance, verify
from ._mesh import Channel, Mesh, Simplified
from ._simplify import simplify

__version__: str = _core.version
__all__ = ["Channel", "Contraction", "Distance", "FileEstimate", "FileJob", "FileStatus", "Finding", "HiddenFaces",
           "HiddenGroup", "Level", "Levels", "Mesh", "Pair", "Report", "Simplified", "SimplifiedFile", "SparseMap",
           "Splits", "Status", "Verdict", "Visibility", "curvature_importance", "hidden_faces", "read_mesh",
           "remove_hidden", "simplify", "simplify_file", "simplify_gltf", "surface_distance", "verify",
           "view_importance", "visibility", "write_mesh"]
