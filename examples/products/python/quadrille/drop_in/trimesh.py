"""The method of trimesh.Trimesh as a function of a mesh."""

from __future__ import annotations

import warnings
from typing import Any, Optional

from .._simplify import simplify
from ._target import target_of


def simplify_quadric_decimation(mesh: Any, percent: Optional[float] = None, face_count: Optional[int] = None,
                                aggression: Optional[int] = None) -> Any:
    """Simplifies a mesh of trimesh, and returns one.

    percent     the fraction of the faces to remove, in [0, 1]
    face_count  or the number of faces to keep
    aggression  has no effect
    """
    count = target_of(len(mesh.faces), percent, face_count)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return simplify(mesh, faces=count).to_like(mesh)
