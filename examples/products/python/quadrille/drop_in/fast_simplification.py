"""The functions of the package fast-simplification."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np

from .._forms import Array
from ._target import simplified, target_of


def simplify(points: Any, triangles: Any, target_reduction: Optional[float] = None, target_count: Optional[int] = None,
             agg: float = 7.0, verbose: bool = False, return_collapses: bool = False, lossless: bool = False,
             preserve_border: bool = False) -> Tuple[Array, Array]:
    """Simplifies a surface.

    points            of the shape (n, 3); float64 stays float64, all else becomes float32
    triangles         of the shape (m, 3)
    target_reduction  the fraction of the triangles to remove, in [0, 1]
    target_count      or the number of triangles to keep
    lossless          contract only where nothing of the shape is lost
    preserve_border   points at edges of one triangle stay where they are
    agg               has no effect
    verbose           prints the report

    Returns points and triangles (int32). Raises ValueError for both targets or none, and NotImplementedError for
    return_collapses: Levels of quadrille record contractions.
    """
    if return_collapses:
        raise NotImplementedError("return_collapses: quadrille.simplify(levels=) records all contractions")
    points = np.asarray(points)
    points = points.astype(points.dtype if points.dtype == np.float64 else np.float32, copy=False)
    triangles = np.asarray(triangles)
    count = target_of(len(triangles), target_reduction, target_count)
    result = simplified(points, triangles, count, lossless, verbose, preserve_border)
    return result.points, result.faces.astype(np.int32, copy=False)


def simplify_mesh(mesh: Any, target_reduction: Optional[float] = None, target_count: Optional[int] = None,
                  agg: float = 7.0, verbose: bool = False) -> Any:
    """Simplifies a mesh of PyVista, and returns one."""
    from .. import simplify as simplify_surface

    count = target_of(mesh.n_cells, target_reduction, target_count)
    result = simplify_surface(mesh, faces=count)
    if verbose:
        print(result.report)
    return result.to_like(mesh)
