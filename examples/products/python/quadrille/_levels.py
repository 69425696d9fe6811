"""Levels of detail."""

from __future__ import annotations

import dataclasses
import json
import os
import tempfile
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _core
from ._forms import Array
from ._mesh import Mesh, set_channels
from ._words import in_our_words


@dataclasses.dataclass(eq=False, repr=False)
class Level(Mesh):
    """A Mesh at a level of detail.

    error           as Report.error
    distance_bound  no point is further from the input; infinite for runs without error=
    hausdorff_bound no point of the input is further from the level, or the other way round; infinite for runs
                    without both_ways=True
    contractions    the number of contractions that lead to this level
    input_points, input_faces  for each point and face, the index of its point and face in the input, for
                    looking up labels and materials
    """

    error: float = 0.0
    distance_bound: float = float("inf")
    hausdorff_bound: float = float("inf")
    contractions: int = 0
    input_points: Array = None  # type: ignore[assignment] # Levels.at() gives it
    input_faces: Array = None  # type: ignore[assignment] # the same


@dataclasses.dataclass(eq=False, repr=False)
class Splits:
    """Levels as arrays: the coarsest level, and the vertex splits that refine it to the input.

    Level s has the points 0 to point_counts[s] - 1 and the faces 0 to face_counts[s] - 1. Level 0 is the coarsest
    one, with the first points and faces; the last level is the input. Split s leads from level s to level s + 1:

        flat[corners[corner_begins[s]:corner_begins[s + 1]]] = children[s]      # flat = faces_now.reshape(-1)
        # the next points and faces are appended, up to point_counts[s + 1] and face_counts[s + 1]
        points_now[parents[s]] = parent_points[s]

    With splits = levels.export_splits(), level s is the bytes of levels.at(contractions=len(splits.parents) - s),
    whose points and faces are in the order of input_points and input_faces. Integers are int64. Channels are not
    included.

    points         (n, 3): the position of each point when it appears, at level 0 or after its split
    faces          (m, 3): the points of each face when it appears
    input_points, input_faces  for each point and face, its index in the input
    point_counts, face_counts, errors  for each level; errors as Level.error
    parents        for each split, the point that is split; -1 for one that only restores faces, such as a
                   component that has vanished
    children       for each split, the last point that it adds, usually the only one; -1 in the same case
    merged_points  (splits, 3): the position of the parent before the split
    parent_points  (splits, 3): the position of the parent after it
    corner_begins  (splits + 1,): for each split its first entry in corners, and their number at the end
    corners        the corners that move from the parent to the child, as 3 * face + corner
    """

    points: Array
    faces: Array
    input_points: Array
    input_faces: Array
    point_counts: Array
    face_counts: Array
    errors: Array
    parents: Array
    children: Array
    merged_points: Array
    parent_points: Array
    corner_begins: Array
    corners: Array

    def __repr__(self) -> str:
        return (f"<quadrille.Splits: {self.face_counts[0]} to {self.face_counts[-1]} faces by {len(self.parents)} "
                "splits>")


class Levels:
    """All levels of detail of a surface, from one run:

        levels = quadrille.Levels()
        quadrille.simplify(points, faces, faces=64, levels=levels)
        level = levels.at(faces=1000)
        levels.save("cow.qlv")

    A level is the result of simplify() with that target, except that values are not rounded to float32 or
    integers; `levels.at(...)` takes a few nanoseconds per face. Channels keep their names.

    Only one call of simplify() may record at a time, and Levels cannot be read meanwhile: both raise ValueError.
    Levels, like meshes and reports, can be copied and pickled.
    """

    def __init__(self) -> None:
        self._levels = _core.Levels()
        self._names: List[str] = []

    def __bool__(self) -> bool:
        return not self._levels.empty()

    def __repr__(self) -> str:
        if not self:
            return "<quadrille.Levels: nothing recorded>"
        finest, coarsest = self.finest, self.coarsest
        text = f"{finest['faces']} to {coarsest['faces']} faces by {coarsest['contractions']} contractions"
        return f"<quadrille.Levels: {', '.join([text, *self._names])}>"

    def __copy__(self) -> "Levels":
        levels = Levels()
        levels._levels, levels._names = self._levels.copy(), list(self._names)
        return levels

    def __deepcopy__(self, memo: Any) -> "Levels":
        return self.__copy__()

    def __reduce__(self) -> Any:
        """Pickles the bytes of a file."""
        if not self:
            return Levels, ()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "levels.qlv")
            self.save(path)
            with open(path, "rb") as file:
                return _levels_of, (file.read(),)

    @in_our_words
    def at(self, *, faces: Optional[int] = None, vertices: Optional[int] = None,
           error: Optional[float] = None, distance: Optional[float] = None,
           contractions: Optional[int] = None) -> Level:
        """Returns a level, chosen by one of

        faces, vertices  the finest level with at most this many
        error            the coarsest level whose error is at most this
        distance         the coarsest level within this distance of the input; for runs with error= or
                         relative_error=
        contractions     the level after this many contractions

        If no level is as coarse, returns the coarsest. Raises ValueError if nothing is recorded.
        """
        arrays = self._levels.at(*_stop(faces=faces, vertices=vertices, error=error,
                                        distance=distance, contractions=contractions))
        info = arrays["info"]
        level = Level(arrays["points"], arrays["faces"], error=info["error"],
                      distance_bound=info["distance_bound"],
                      hausdorff_bound=info["hausdorff_bound"], contractions=info["contractions"],
                      input_points=arrays["input_points"], input_faces=arrays["input_faces"])
        set_channels(level, {name: values if indices is None else (values, indices)
                             for name, (values, indices) in zip(self._names, arrays["channels"])})
        return level

    @in_our_words
    def info(self, *, faces: Optional[int] = None, vertices: Optional[int] = None,
             error: Optional[float] = None, distance: Optional[float] = None,
             contractions: Optional[int] = None) -> Dict[str, Any]:
        """Returns the figures of a level without its surface: faces, vertices, contractions, error, distance_bound,
        hausdorff_bound."""
        return self._levels.info(*_stop(faces=faces, vertices=vertices, error=error,
                                        distance=distance, contractions=contractions))

    @property
    def finest(self) -> Dict[str, Any]:
        """The figures of the input, as info() returns them."""
        self._require_any()
        return self._levels.finest()

    @property
    def coarsest(self) -> Dict[str, Any]:
        """The figures of the last level, as info() returns them."""
        return self._levels.coarsest()

    def export_splits(self) -> Splits:
        """Returns all levels as vertex splits, in arrays: see Splits. Raises ValueError if nothing is recorded."""
        self._require_any()
        arrays = {name: array if array.dtype.kind == "f" else array.astype(np.int64)
                  for name, array in self._levels.splits().items()}
        for name in ("parents", "children"):
            arrays[name][arrays[name] == 2**32 - 1] = -1
        return Splits(**arrays)

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes all levels to a file. An existing file is replaced only once everything is written. C++ programs
        read the file with <quadrille/levels_file.h>. Raises OSError."""
        self._require_any()
        try:
            self._levels.save(os.fspath(path), json.dumps({"channels": self._names}))
        except RuntimeError as error:
            raise OSError(str(error)) from None

    @staticmethod
    def load(path: Union[str, os.PathLike[str]]) -> "Levels":
        """Reads a file. Raises OSError if it can't be read, and ValueError if it is damaged or not a file of
        levels."""
        with open(path, "rb"):
            pass
        levels = Levels()
        try:
            levels._levels, comment = _core.load_levels(os.fspath(path))
        except RuntimeError as error:
            raise ValueError(str(error)) from None
        levels._names = _names_in(comment)
        return levels

    def _require_any(self) -> None:
        if not self:
            raise ValueError("nothing has been recorded: pass levels= to simplify()")


def _levels_of(content: bytes) -> Levels:
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "levels.qlv")
        with open(path, "wb") as file:
            file.write(content)
        return Levels.load(path)


def _names_in(comment: str) -> List[str]:
    """The names of channels, or numbers if another program wrote the file."""
    try:
        return [str(name) for name in json.loads(comment)["channels"]]
    except (ValueError, KeyError, TypeError):
        return [str(i) for i in range(1000)]


def _stop(**given: Optional[float]) -> Tuple[str, float]:
    stops = [(name, value) for name, value in given.items() if value is not None]
    if len(stops) != 1:
        raise ValueError(f"pass exactly one of {', '.join(given)}, not {len(stops)}")
    name, value = stops[0]
    if not value >= 0:
        raise ValueError(f"{name} is {value!r}, not at least 0")
    return name, float(value)
