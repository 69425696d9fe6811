"""Checks arrays, and converts them for the compiled part."""

from __future__ import annotations

from typing import Any, List, Optional, Tuple

import numpy as np

from ._forms import Array


def of_dlpack(given: Any) -> Any:
    """An array of an object that has no other way to numpy than DLPack; anything else as it is."""
    is_foreign = hasattr(given, "__dlpack__") and not hasattr(given, "__array__")
    return np.from_dlpack(given) if is_foreign else given


def _of_numbers(name: str, given: Any, kinds: str, what: str) -> Array:
    array: Array = np.asarray(of_dlpack(given))
    if array.dtype.kind not in kinds and array.size > 0:
        raise ValueError(f"{name} has the type {array.dtype}, not {what}")
    return array


def real_rows(name: str, given: Any, columns: Optional[int] = None) -> Array:
    """Of doubles in the order of C: the array itself if it is one already. One column may be flat."""
    array = _of_numbers(name, given, "fiub", "real numbers")
    if array.ndim == 1 and columns is None:
        array = array[:, np.newaxis]
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, 3 if columns is None else columns)
    if array.ndim != 2 or (columns is not None and array.shape[1] != columns) or array.shape[1] == 0:
        raise ValueError(f"{name} has the shape {array.shape}, not (n, {columns or 'components'})")
    doubles: Array = np.ascontiguousarray(array, dtype=np.float64)
    if not np.isfinite(doubles).all():
        row = int(np.flatnonzero(~np.isfinite(doubles).all(axis=1))[0])
        raise ValueError(f"{name}[{row}] is not finite: {array[row]}")
    return doubles


def _integers(name: str, given: Any) -> Array:
    array = _of_numbers(name, given, "iu", "integers")
    if array.dtype == np.uint32 and array.flags.c_contiguous:
        return array
    if array.size > 0 and int(array.min()) < 0:
        raise ValueError(f"{name} has a negative number, {int(array.min())}, at {_place(array < 0)}")
    if array.size > 0 and int(array.max()) > 0xFFFFFFFF:
        raise ValueError(f"{name} has a number beyond 32 bits, {int(array.max())}")
    if array.dtype == np.int32 and array.flags.c_contiguous:
        return array.view(np.uint32)
    return np.ascontiguousarray(array, dtype=np.uint32)


def _place(where: Array) -> Tuple[int, ...]:
    return tuple(int(i) for i in np.argwhere(where)[0])


def index_triples(name: str, given: Any, count: int, of_what: str) -> Array:
    """Of 32 bits in the order of C, each below a count: the array itself where that is so already."""
    array: Array = np.asarray(of_dlpack(given))
    if array.size == 0:
        array = np.empty((0, 3), np.uint32)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has the shape {array.shape}, not (n, 3): {_of_other_shape(name, array)}")
    triples = _integers(name, array)
    if triples.size > 0 and int(triples.max()) >= count:
        row = _place(triples >= count)[0]
        raise ValueError(f"{name}[{row}] is {array[row].tolist()}, but there are {count} {of_what}")
    return triples


def _of_other_shape(name: str, array: Array) -> str:
    """What it may be, and what helps."""
    flat = array.reshape(-1)
    if array.ndim <= 2 and array.size % 4 == 0 and (flat[::4] == 3).all():
        rows = name if array.ndim == 2 else f"{name}.reshape(-1, 4)"
        return f"it is padded in VTK's way, with a 3 before each triangle: pass {rows}[:, 1:]"
    if array.ndim == 2 and array.shape[1] == 4:
        return "it takes triangles, so split quads, np.concatenate([q[:, :3], q[:, [0, 2, 3]]])"
    if array.ndim == 3:
        return ("these are coordinates of corners, and it takes indices: simplify(corners.reshape(-1, 3), "
                "np.arange(3 * len(corners)).reshape(-1, 3), split_vertices=True)")
    return "it takes triangles"


def numbers(name: str, given: Any, count: int, of: str = "point") -> List[float]:
    """A list of real numbers, one for each of what `of` says."""
    array = _of_numbers(name, given, "fiub", "real numbers")
    if array.shape != (count,):
        raise ValueError(f"{name} has the shape {array.shape}, not ({count},): one for each {of}")
    return array.tolist()


def factors(name: str, given: Any, count: int) -> List[float]:
    """The same of at least 0, one for each point."""
    result = numbers(name, given, count)
    for i, number in enumerate(result):
        if not 0 <= number < np.inf:
            raise ValueError(f"{name}[{i}] is {number}: negative or not finite")
    return result


def mask(name: str, given: Any, count: int, of: str = "point") -> List[bool]:
    """A list of booleans of a mask, or of indices of what `of` says."""
    array: Array = np.asarray(of_dlpack(given))
    if array.dtype == bool:
        if array.shape != (count,):
            raise ValueError(f"{name} has the shape {array.shape}, not ({count},): it takes a mask of "
                             f"the {of}s, or their indices")
        return array.tolist()
    indices = _integers(name, array.reshape(-1) if array.size == 0 else array)
    if indices.ndim != 1:
        raise ValueError(f"{name} has the shape {array.shape}: it takes a mask of the {of}s, or their "
                         "indices")
    if indices.size > 0 and int(indices.max()) >= count:
        raise ValueError(f"{name} contains {of} {int(indices.max())}, but there are {count} {of}s")
    result = np.zeros(count, bool)
    result[indices] = True
    return result.tolist()


def as_type(array: Array, like: Any) -> Array:
    """Numbers in the type of an array: the nearest integers of integers."""
    if array.dtype == like:
        return array
    if np.issubdtype(like, np.integer):
        limits = np.iinfo(like)
        return np.clip(np.rint(array), limits.min, limits.max).astype(like)
    return array.astype(like)
