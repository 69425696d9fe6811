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
    """A number for each point, by which simplify(importance=...) leaves more faces where a surface is
    curved: (1 + k / mean(k)) ** strength, where k**2 is the sum of the squares of both principal
    curvatures.

        quadrille.simplify(mesh, faces=1000, importance=quadrille.curvature_importance(mesh))

    strength  at least 0; with 3, what is curved as the surface is on average gets about twice as many
              faces as what is flat, beside those that the cost gives it anyway

    Raises ValueError for what is wrong with an argument.
    """
    vertices, faces = _surface(points, triangles)
    return _core.curvature_importance(vertices, faces, float(strength))


@in_our_words
def view_importance(points: Surface, triangles: Optional[ArrayLike] = None, /, *, eye: ArrayLike,
                    turned_away: float = 1 / 64, outline: float = 8.0) -> Array:
    """A number for each point, by which simplify(importance=...) leaves more faces where a surface is
    seen from a place: in proportion to distance ** -3, so that errors look alike large at any distance.

    eye          the place: three numbers, in the unit of the points
    turned_away  how much a point counts of which no face is turned to the eye, at least 0
    outline      how much one counts of which some are and some are not, at least 0

    Raises ValueError for what is wrong with an argument.
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
