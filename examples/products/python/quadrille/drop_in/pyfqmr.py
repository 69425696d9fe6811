"""The class of the package pyfqmr."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np

from .._forms import Array
from ._target import simplified


class Simplify:
    """Holds a mesh that is simplified: setMesh(), simplify_mesh(), getMesh()."""

    def __init__(self) -> None:
        self._points: Optional[Array] = None
        self._faces: Optional[Array] = None

    def setMesh(self, vertices: Any, faces: Any, face_colors: Any = None) -> None:  # noqa: N802
        """Takes a mesh. Colours of faces are not kept."""
        self._points, self._faces = np.asarray(vertices, np.float64), np.asarray(faces)

    def simplify_mesh(self, target_count: int = 100, update_rate: int = 5, aggressiveness: float = 7.0,
                      max_iterations: int = 100, verbose: bool = True, lossless: bool = False,
                      threshold_lossless: float = 1e-3, alpha: float = 1e-9, K: int = 3,  # noqa: N803
                      preserve_border: bool = True) -> None:
        """Simplifies the mesh to so many faces; all but verbose, lossless and preserve_border has no effect."""
        points, faces = self._mesh()
        result = simplified(points, faces, min(int(target_count), len(faces)), lossless, verbose, preserve_border)
        self._points, self._faces = result.points, result.faces

    def simplify_mesh_lossless(self, verbose: bool = True, epsilon: float = 1e-3, max_iterations: int = 9999,
                               preserve_border: bool = True) -> None:
        """Contracts where nothing of the shape is lost."""
        self.simplify_mesh(verbose=verbose, lossless=True, preserve_border=preserve_border)

    def getMesh(self) -> Tuple[Array, Array, Array]:  # noqa: N802
        """Vertices, faces (int32) and the unit normals of faces."""
        points, faces = self._mesh()
        a, b, c = (points[faces[:, i]] for i in range(3))
        normals = np.cross(b - a, c - a)
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        return points, faces.astype(np.int32, copy=False), normals / np.where(lengths > 0, lengths, 1)

    def _mesh(self) -> Tuple[Array, Array]:
        if self._points is None or self._faces is None:
            raise ValueError("there is no mesh: call setMesh() first")
        return self._points, self._faces
