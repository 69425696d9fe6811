"""curvature_importance() and view_importance()"""

from __future__ import annotations

from typing import Any, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core, _objects
from ._forms import Array
from ._mesh import Mesh, as_mesh
from ._words import in_our_words

Surface = Union[ArrayLike, Mesh, _objects.MeshLike, Tuple[ArrayLike, ArrayLike]]


@in_our_words
def curvature_importance(points: Surface, triangles: Optional[ArrayLike] = None, /, *,
                         strength: float = 3.0) -> Array:
    """Returns a number for each point, with which simplify(importance=...) keeps more faces where a surface is
    curved: (1 + k / mean(k)) ** strength, where k**2 is the sum of the squares of both principal
    curvatures.

        quadrille.simplify(mesh, faces=1000, importance=quadrille.curvature_importance(mesh))

    strength  at least 0; with 3, regions of average curvature get about twice as many faces as flat ones, in
              addition to the effect of the cost itself

    Raises ValueError if an argument is wrong.
    """
    vertices, faces = _surface(points, triangles)
    return _core.curvature_importance(vertices, faces, float(strength))


@in_our_words
def view_importance(points: Surface, triangles: Optional[ArrayLike] = None, /, *, eye: ArrayLike,
                    turned_away: float = 1 / 64, outline: float = 8.0) -> Array:
    """Returns a number for each point, with which simplify(importance=...) keeps more faces where a viewer sees
    the surface: in proportion to distance ** -3, so that errors look equally large at any distance.

    eye          the position of the viewer: three numbers, in the unit of the points
    turned_away  the factor for points with no face towards the viewer, at least 0
    outline      the factor for points with faces towards the viewer and away from it, at least 0

    Raises ValueError if an argument is wrong.
    """
    place = np.asarray(eye, dtype=np.float64)
    if place.shape != (3,):
        raise ValueError(f"eye has the shape {place.shape}, not (3,)")
    vertices, faces = _surface(points, triangles)
    return _core.view_importance(vertices, faces, place.tolist(), float(turned_away), float(outline))


def _surface(points: Any, triangles: Any) -> Tuple[Array, Array]:
    if triangles is None:
        points, triangles = as_mesh(points)
    points = _arrays.real_rows("points", points, 3)
    return points, _arrays.index_triples("faces", triangles, len(points), "points")
