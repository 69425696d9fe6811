"""Simplifies triangle surfaces by contracting pairs of vertices under quadric error metrics.

    import quadrille
    mesh = quadrille.read_mesh("statue.obj")              # with its texture, normals and materials
    small = quadrille.simplify(mesh, faces=10_000)
    quadrille.write_mesh("small.obj", small)

    points, faces = quadrille.simplify(points, faces, ratio=0.1)      # arrays of numpy

simplify    does it; see help(quadrille.simplify)
Mesh        points, faces, and what goes along: uv, normals, colors, attributes, labels
Channel     values of one of these with options: how much it counts, what becomes of its seams
Simplified  what simplify() returns: a Mesh with a report
Levels      all levels of detail of a surface from one run, in memory and in a file
read_mesh, write_mesh  files: OFF, OBJ, PLY, STL, GOCAD
simplify_gltf  glTF documents, from file to file
simplify_file, FileJob  surfaces larger than memory, from file to file, by parts
curvature_importance, view_importance  for simplify(importance=...): where more faces stay
surface_distance  how far two surfaces are from each other
verify      does a result keep what was promised of it?

Costs are those of Garland and Heckbert 1997, and what came of them: see the manual of the C++ library.
"""

from . import _core
from ._core import Contraction, FileEstimate, FileStatus, Pair, Report, Status
from ._file_jobs import FileJob, SimplifiedFile, simplify_file
from ._files import read_mesh, write_mesh
from ._gltf import simplify_gltf
from ._importance import curvature_importance, view_importance
from ._levels import Level, Levels
from ._measures import Distance, Finding, Verdict, surface_distance, verify
from ._mesh import Channel, Mesh, Simplified
from ._simplify import simplify

__version__: str = _core.version
__all__ = ["Channel", "Contraction", "Distance", "FileEstimate", "FileJob", "FileStatus", "Finding", "Level", "Levels",
           "Mesh", "Pair", "Report", "Simplified", "SimplifiedFile", "Status", "Verdict", "curvature_importance",
           "read_mesh", "simplify", "simplify_file", "simplify_gltf", "surface_distance", "verify", "view_importance",
           "write_mesh"]
