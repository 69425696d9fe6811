"""hidden_faces(), remove_hidden() and visibility()"""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core, _objects
from ._forms import Array
from ._mesh import Channel, Mesh, Values, as_mesh
from ._options import function_of, read_count, read_number
from ._words import in_our_words

Surface = Union[ArrayLike, Mesh, _objects.MeshLike, Tuple[ArrayLike, ArrayLike]]
Progress = Optional[Callable[[float], Optional[bool]]]


@dataclasses.dataclass(eq=False)
class HiddenGroup:
    """Hidden faces that are connected by edges.

    kind      'cavity' (the wall of an empty space), 'inner component' (closed, inside of others) or 'inner surface'
              (not closed)
    faces     the indices of the faces
    area      in the unit of the points, squared
    volume    the enclosed volume; 0 if it is not closed
    diagonal  the length of the diagonal of its bounding box
    """

    kind: str
    faces: Array
    area: float
    volume: float
    diagonal: float

    def __repr__(self) -> str:
        volume = f", volume {self.volume:g}" if self.volume > 0 else ""
        return f"<quadrille.HiddenGroup: {self.kind}, {len(self.faces)} faces, area {self.area:g}{volume}>"


@dataclasses.dataclass(eq=False)
class HiddenFaces:
    """The faces of a surface that are not seen from outside.

    is_hidden     a flag for each face
    groups        HiddenGroup objects, the largest area first
    area          the area of the hidden faces
    whole_area    the area of all faces
    cut_edges     the number of edges that hidden faces share with others
    is_cancelled  progress ended the search; then no face is hidden
    """

    is_hidden: Array
    groups: List[HiddenGroup]
    area: float
    whole_area: float
    cut_edges: int
    is_cancelled: bool = False

    def __repr__(self) -> str:
        return (f"<quadrille.HiddenFaces: {int(np.count_nonzero(self.is_hidden))} of {len(self.is_hidden)} faces hidden, "
                f"groups: {len(self.groups)}>")


@dataclasses.dataclass(eq=False)
class Visibility:
    """How much of a surface is seen from outside, in fractions of all directions, from 0 to 1.

    faces       for each face
    points      for each point: the mean of its faces
    importance  for each point, for simplify(importance=...): the fraction, but at least 1/512
    """

    faces: Array
    points: Array
    importance: Array


@in_our_words
def hidden_faces(points: Surface, triangles: Optional[ArrayLike] = None, /, *, threshold: float = 0.001,
                 directions: int = 64, front_only: bool = False, threads: int = 1,
                 progress: Progress = None) -> HiddenFaces:
    """Finds the faces that no ray from outside reaches: inner walls, cavities, components inside others.

        quadrille.hidden_faces(mesh).groups

    threshold   a face is hidden if it is seen from at most this fraction of the directions; with 0, one free ray
                is enough to be seen
    directions  the number of rays of a face, at least 16; time is proportional to it
    front_only  only fronts of faces count, for closed surfaces that are oriented outward
    threads     the number of threads; the result does not depend on it
    progress    called up to 25 times a second with the completed fraction, from 0 to 1; returning False ends the
                search, as Ctrl-C does

    Raises ValueError if an argument is wrong.
    """
    given = _given(as_mesh(points if triangles is None else (points, triangles)), directions, front_only, threads)
    is_hidden, groups, figures = _core.hidden_faces(*given, read_number("threshold", threshold),
                                                    function_of("progress", progress))
    return HiddenFaces(is_hidden, [HiddenGroup(*group) for group in groups], figures[0], figures[1], int(figures[2]),
                       figures[3] != 0)


@in_our_words
def remove_hidden(points: Surface, triangles: Optional[ArrayLike] = None, /, *, threshold: float = 0.001,
                  directions: int = 64, front_only: bool = False, threads: int = 1,
                  progress: Progress = None) -> Mesh:
    """Returns a Mesh without the faces that hidden_faces() finds, closed where that opens it: each loop of edges between
    hidden faces and others gets a cap, so a closed surface stays closed. Points stay, and added ones follow them;
    other faces keep their attributes and labels, and what is added has those of what is next to it. simplify() drops
    points without faces.

        small = quadrille.simplify(quadrille.remove_hidden(mesh), faces=1000)

    The arguments are those of hidden_faces().
    """
    mesh = as_mesh(points if triangles is None else (points, triangles))
    added, faces, sources, origins = _core.remove_hidden(*_given(mesh, directions, front_only, threads),
                                                         read_number("threshold", threshold),
                                                         function_of("progress", progress))
    all_points = np.asarray(mesh.points)
    channels = {name: _followed(getattr(mesh, name), sources, origins) for name in ("uv", "normals", "colors")}
    return Mesh(points=np.concatenate([all_points, added.astype(all_points.dtype).reshape(-1, 3)]),
                faces=faces.astype(np.asarray(mesh.faces).dtype), **channels,
                attributes={name: _followed(values, sources, origins) for name, values in mesh.attributes.items()},
                labels=None if mesh.labels is None else np.asarray(mesh.labels)[sources], remarks=list(mesh.remarks),
                _is_split=mesh._is_split, _source=mesh._source,
                _source_faces=None if mesh._source_faces is None else mesh._source_faces[sources])


@in_our_words
def visibility(points: Surface, triangles: Optional[ArrayLike] = None, /, *, directions: int = 256,
               front_only: bool = False, threads: int = 1, progress: Progress = None) -> Visibility:
    """Returns for each face and point from which fraction of all directions it is seen. Where little is seen,
    simplify() needs few faces:

        quadrille.simplify(mesh, faces=1000, importance=quadrille.visibility(mesh).importance)

    The arguments are those of hidden_faces(). If progress ends it, the arrays are empty.
    """
    mesh = as_mesh(points if triangles is None else (points, triangles))
    given = _given(mesh, directions, front_only, threads)
    return Visibility(*_core.visibility(*given, 1 / 512, function_of("progress", progress)))


def _given(mesh: Mesh, directions: int, front_only: bool, threads: int) -> Tuple[Array, Array, int, bool, int]:
    points = _arrays.real_rows("points", mesh.points, 3)
    faces = _arrays.index_triples("faces", mesh.faces, len(points), "points")
    return points, faces, read_count("directions", directions), bool(front_only), read_count("threads", threads)


def _followed(values: Any, sources: Array, origins: Array) -> Optional[Values]:
    """The values of the points, and of added ones; or of the corners of the faces, and of added ones."""
    if values is None or (not isinstance(values, (Channel, tuple)) and len(values) == 0):
        return values
    if isinstance(values, Channel):
        if values.indices is not None:
            return dataclasses.replace(values, indices=np.asarray(values.indices)[sources])
        return dataclasses.replace(values, values=_followed(values.values, sources, origins))
    if isinstance(values, tuple):
        return values[0], np.asarray(values[1])[sources]
    of_points = np.asarray(values)
    return np.concatenate([of_points, of_points[origins]])
