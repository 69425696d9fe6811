"""What the modules of other libraries have in common."""

from __future__ import annotations

import warnings
from typing import Any, Optional

import numpy as np

from .._forms import Array
from .._mesh import Simplified
from .._simplify import simplify


def target_of(faces: int, target_reduction: Optional[float], target_count: Optional[int]) -> int:
    """The number of faces to keep, by the fraction to remove or by itself."""
    if target_reduction is not None and target_count is not None:
        raise ValueError("target_reduction and target_count are both given, and are two targets")
    if target_reduction is None and target_count is None:
        raise ValueError("neither target_reduction nor target_count is given")
    if target_reduction is not None:
        if not 0 <= target_reduction <= 1:
            raise ValueError(f"target_reduction is {target_reduction}, not in [0, 1]")
        return int((1 - target_reduction) * faces)
    assert target_count is not None
    if not 0 <= target_count <= faces:
        raise ValueError(f"target_count is {target_count}, not in [0, {faces}], the number of faces")
    return int(target_count)


def simplified(points: Any, triangles: Any, count: int, lossless: bool, verbose: bool,
               preserve_border: bool) -> Simplified:
    """The surface with so many faces, or as many as are flat where nothing may be lost. These libraries are silent about
    a target that was missed."""
    target: Any = dict(relative_error=1e-6, both_ways=True) if lossless else dict(faces=count)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        fixed = _border_points(points, triangles) if preserve_border else None
        result = simplify(points, triangles, **target, fixed=fixed)
    if verbose:
        print(result.report)
    return result


def _border_points(points: Array, faces: Array) -> Array:
    """A mask of the points at edges of one face."""
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64), axis=1)
    different, counts = np.unique(edges, axis=0, return_counts=True)
    mask = np.zeros(len(points), bool)
    mask[different[counts == 1].reshape(-1)] = True
    return mask
