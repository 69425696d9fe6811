"""The arguments and results of simplify()."""

from __future__ import annotations

import dataclasses
import os
import warnings
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, TypeVar, Union

import numpy as np

from . import _arrays, _core, _objects
from ._choices import KindName, choice
from ._forms import Array
from ._maps import SparseMap
from ._table import NewValuesName, SeamsName

Like = TypeVar("Like", bound=Union[_objects.MeshLike, Tuple[Any, Any], List[Any]])
Values = Union[Array, Tuple[Array, Array], "Channel"]


@dataclasses.dataclass(eq=False)
class Channel:
    """The values of an attribute, with options for its weight and its seams.

    A Channel can be passed wherever an array of values or a pair (values, indices) is accepted.

    values        numbers of the shape (n, components): one value for each point or, with indices, any
                  number of values. If they are integers, the results are rounded; colours are from
                  0 to 255 in uint8, and from 0 to 65535 in uint16
    indices       integers of the shape (faces, 3): the value of each corner of each face, as in OBJ
    importance    a factor on the default weight, above 0
    weights       for each component, the length in the unit of the points that corresponds to a step of 1,
                  times importance. By default, texture coordinates are as long as on the surface; the
                  range of other values corresponds to 0.02 diagonals of the bounding box, of noisy
                  colors and normals to less (down to a tenth or a twentieth), of smooth normals to up
                  to twice as much
    seams         the edges at which values jump: 'kept' (they stay), 'soft' (they may vanish, at a cost
                  for what becomes visible beside a chart; the default for uv), 'priced' (they may vanish,
                  at the cost of the jump; the default for others) or 'free' (the values around a
                  point are merged at the beginning)
    chart_boundary_weight how firmly the boundaries of charts are kept where texture seams are kept or soft; by
                  default 10, or between 0.1 and 1: larger if fewer edges are seams
    new_values    'optimal' (the least cost), 'weights' (the least cost, with values of at least 0 and of
                  sum 1, as for a skin), 'existing' (one of the merged values, as for classes; not for
                  uv) or 'recomputed' (from the faces of the result; for normals only)
    linear_light  average sRGB colours as linear light
    kind          'texture', 'normals', 'colors' or 'attributes'; by default as the name of the
                  argument says
    """

    values: Array
    indices: Optional[Array] = None
    importance: float = 1.0
    weights: Optional[Sequence[float]] = None
    seams: Optional[SeamsName] = None
    chart_boundary_weight: Optional[float] = None
    new_values: NewValuesName = "optimal"
    linear_light: bool = False
    kind: Optional[KindName] = None


@dataclasses.dataclass(eq=False)
class Mesh:
    """Triangles with their attributes. All but points and faces may be None or empty.

    points      numbers of the shape (n, 3)
    faces       integers of the shape (m, 3): the points of each triangle
    uv          texture coordinates: an array of the shape (n, 2), or a pair (values, indices) of shapes
                (k, 2) and (m, 3) with the value of each corner, as in OBJ; or a Channel
    normals     the same with three components
    colors      the same with three components, or four with alpha
    attributes  anything else by name, with any number of components
    labels      an integer for each face: materials, regions, patches
    remarks     sentences: what read_mesh() left out or assumed, and what simplify() turned

    A Mesh is unpacked to its points and faces: points, faces = mesh.
    """

    points: Array
    faces: Array
    uv: Optional[Values] = None
    normals: Optional[Values] = None
    colors: Optional[Values] = None
    attributes: Dict[str, Values] = dataclasses.field(default_factory=dict)
    labels: Optional[Array] = None
    remarks: List[str] = dataclasses.field(default_factory=list)
    # The file that it was read from, and which of its faces each face is.
    _is_split: bool = dataclasses.field(default=False, repr=False)  # are points at seams there for each side?
    _source: Any = dataclasses.field(default=None, repr=False)
    _source_faces: Optional[Array] = dataclasses.field(default=None, repr=False)

    def __iter__(self) -> Iterator[Array]:
        return iter((self.points, self.faces))

    def to_like(self, mesh: Like) -> Like:
        """Returns a new mesh of the class of the given one: trimesh, Open3D, PyVista, VTK or meshio; for a pair, a
        pair (points, faces).

            small = quadrille.simplify(mesh, target_reduction=0.9, attributes=["heat"]).to_like(mesh)

        Attributes become vertex attributes (trimesh) or point data (PyVista, meshio) of the same names.
        uv, normals and colors become the corresponding arrays of trimesh and Open3D (uv with the material or the
        textures of the given mesh), uv the active texture coordinates of PyVista and VTK; otherwise they become
        point data of these names. For a result of simplify() and a Level, the given mesh has to be the one that
        was simplified: the remaining faces keep its cell or face data, and its face colours in trimesh. Labels
        become face data as well.

        A UserWarning lists what the class cannot hold, such as values at corners (Open3D holds only uv there).
        Raises TypeError for objects that are not meshes of these libraries, and ValueError for meshes that are not
        triangle meshes, or whose data do not fit.
        """
        if isinstance(mesh, Mesh):
            raise TypeError(f"a {type(mesh).__name__} is already a mesh of this library")
        channels = {c.name: (np.asarray(c.channel.values), c.indices) for c in read_channels(self)}
        given: Any = mesh
        result, lost = given, list(channels)
        if is_pair(given):
            result = type(given)((self.points, self.faces))
        else:
            result, lost = _objects.like(self, channels, given)
        if lost:
            warnings.warn(f"{type(mesh).__name__}: not kept: {', '.join(lost)}", stacklevel=2)
        return result

    def __repr__(self) -> str:
        has = [name for name in ("uv", "normals", "colors", "labels") if getattr(self, name) is not None]
        text = ", ".join([f"{len(self.points)} points, {len(self.faces)} faces", *has, *self.attributes])
        return f"<quadrille.{type(self).__name__}: {text}>"


@dataclasses.dataclass(eq=False, repr=False)
class Simplified(Mesh):
    """The Mesh that simplify() returns.

    report       a Report: what was done, why it stopped, how far the result may be from the input
    vertex_map        for each point of the input, the index of the point of the result that replaces it, or -1 if
                 it was removed; None with split_vertices
    input_faces  for each face, the index of the corresponding face of the input
    old_to_new   with maps=True, a SparseMap with a row for each point of the input: its place on the result, as
                 up to three points of it with their weights. A row is empty if the surface there has vanished,
                 or no triangle has the point
    new_to_old   with maps=True, a SparseMap with a row for each point of the result: its place on the input
    """

    report: _core.Report = None  # type: ignore[assignment] # simplify() gives it
    vertex_map: Optional[Array] = None
    input_faces: Array = None  # type: ignore[assignment] # the same
    _maps: Optional[Tuple[SparseMap, SparseMap]] = dataclasses.field(default=None, repr=False)

    @property
    def old_to_new(self) -> SparseMap:
        return self._required_maps()[0]

    @property
    def new_to_old(self) -> SparseMap:
        return self._required_maps()[1]

    def _required_maps(self) -> Tuple[SparseMap, SparseMap]:
        if self._maps is None:
            raise ValueError("this result has no sparse maps: pass maps=True to simplify()")
        return self._maps


class ReadChannel:
    """A channel of the user's on its way through the engine."""

    def __init__(self, name: str, given: Any, kind: str, mesh_counts: Tuple[int, int]):
        point_count, faces = mesh_counts
        self.name, self.given = name, given
        self.channel = given if isinstance(given, Channel) else _channel_of(name, given)
        self.kind = choice(f"the kind of {name}", self.channel.kind or kind, _core.Kind.__members__)
        columns = {_core.Kind.texture: 2, _core.Kind.normals: 3}.get(self.kind)
        self.type = np.asarray(self.channel.values).dtype
        self.is_flat = np.asarray(self.channel.values).ndim == 1
        self.whole = _whole_of_colors(self.type) if self.kind == _core.Kind.colors else 1
        self.values = _arrays.real_rows(f"{name}", self.channel.values, columns)
        if self.kind == _core.Kind.colors and self.values.shape[1] not in (3, 4):
            raise ValueError(f"{name} has the shape {self.values.shape}, not (n, 3) or (n, 4)")
        if self.whole != 1:
            self.values = self.values / self.whole
        self.indices = None
        if self.channel.indices is not None:
            self.indices = _arrays.index_triples(f"the indices of {name}", self.channel.indices,
                                                 len(self.values), "values")
            self.index_type = np.asarray(self.channel.indices).dtype
        count, what = (point_count, "points") if self.indices is None else (faces, "faces")
        if len(self.values if self.indices is None else self.indices) != count:
            raise ValueError(f"{name} has {len(self.values if self.indices is None else self.indices)} "
                             f"{'values' if self.indices is None else 'index triples'} for {count} {what}")

    def arguments(self) -> _core.Channel:
        channel, options = self.channel, _core.ChannelOptions()
        options.importance = float(channel.importance)
        options.weights = [float(weight) for weight in (() if channel.weights is None else channel.weights)]
        if channel.seams is not None:
            options.seams = choice(f"the seams of {self.name}", channel.seams, _core.Seams.__members__)
        if channel.chart_boundary_weight is not None:
            options.chart_boundary_weight = float(channel.chart_boundary_weight)
        options.new_values = choice(f"new_values of {self.name}", channel.new_values, _core.NewValues.__members__)
        options.linear_light = bool(channel.linear_light)
        return (self.kind, self.values, self.indices, options)

    def turn(self, against: Array) -> None:
        """With faces that are turned."""
        if self.indices is not None:
            self.indices = turned(self.indices, against)

    def result(self, values: Array, indices: Array) -> Values:
        """In the form in which the channel was given."""
        if self.whole != 1:
            values = values * self.whole
        values = _arrays.as_type(values, self.type)
        if self.is_flat:
            values = values[:, 0]
        if self.indices is not None:
            indices = _arrays.as_type(indices, self.index_type)
        if isinstance(self.given, Channel):
            return dataclasses.replace(
                self.channel, values=values, indices=None if self.indices is None else indices)
        return values if self.indices is None else (values, indices)


def turned(triples: Array, against: Array) -> Array:
    """A copy in which some are the other way round."""
    triples = triples.copy()
    triples[against] = triples[against][:, [0, 2, 1]]
    return triples


def read_channels(mesh: Mesh) -> List[ReadChannel]:
    counts = (len(mesh.points), len(mesh.faces))
    named = [("uv", mesh.uv, "texture"), ("normals", mesh.normals, "normals"),
             ("colors", mesh.colors, "colors")]
    named += [(name, values, "attributes") for name, values in read_attributes(mesh.attributes).items()]
    return [ReadChannel(name, values, kind, counts) for name, values, kind in named if values is not None]


def read_attributes(given: Any, mesh: Any = None) -> Dict[str, Values]:
    """A dict of them, or a list of names of the point data of a mesh of another library."""
    if hasattr(given, "keys"):
        for name in given.keys():
            if not isinstance(name, str):
                raise TypeError(f"attributes has the name {name!r}, which is a {type(name).__name__}, not a str")
        return dict(given)
    is_names = isinstance(given, (list, tuple)) and all(isinstance(name, str) for name in given)
    if mesh is None or not is_names:
        names = "" if mesh is None else f" or a list of names of point data of the {type(mesh.mesh).__name__}"
        raise TypeError(f"attributes is a {type(given).__name__}, not a dict of names and values{names}")
    data = _objects.named_point_data(mesh, given)
    return {name: Channel(values, kind="colors") if _are_bytes_of_colors(values) else values
            for name, values in data.items()}


def as_mesh(given: Any) -> Mesh:
    """A Mesh, a pair of points and faces, or points and faces of a mesh of another library."""
    if isinstance(given, Mesh):
        return given
    if is_pair(given):
        return Mesh(np.asarray(given[0]), np.asarray(given[1]))
    mesh = _objects.read_object(given)
    if mesh is None:
        raise no_mesh("mesh", given)
    return Mesh(mesh.points, mesh.faces)


def is_pair(given: Any) -> bool:
    """Points and faces in a tuple or list, and no list of two points."""
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        return False
    return np.ndim(given[0]) == 2 or (np.ndim(given[0]) == 1 and len(given[0]) == 0)


def no_mesh(name: str, given: Any) -> TypeError:
    kind, hint = type(given).__name__, ""
    if isinstance(given, (tuple, list)):
        kind += f" of {len(given)}"
    elif isinstance(given, (str, os.PathLike)):
        hint = ": read_mesh() reads a file"
    elif hasattr(given, "to_legacy"):
        hint = ": pass its to_legacy()"
    elif hasattr(given, "extract_surface") or hasattr(given, "celltypes"):
        hint = ": pass its extract_surface().triangulate()"
    elif hasattr(given, "geometry") and hasattr(given, "to_geometry"):
        hint = ": pass its to_geometry(), or the meshes in its geometry one by one"
    return TypeError(f"{name} is a {kind}, not a Mesh, a pair (points, faces) or a triangle mesh of trimesh, "
                     f"Open3D, PyVista, VTK or meshio{hint}")


def set_channels(mesh: Mesh, results: Dict[str, Values]) -> None:
    for name, values in results.items():
        if name in ("uv", "normals", "colors"):
            setattr(mesh, name, values)
        else:
            mesh.attributes[name] = values


def _channel_of(name: str, given: Any) -> Channel:
    if not isinstance(given, tuple):
        return Channel(given)
    if len(given) != 2:
        raise ValueError(f"{name} is a tuple of {len(given)}, not an array or a pair (values, indices)")
    return Channel(*given)


def _are_bytes_of_colors(values: Array) -> bool:
    return values.dtype == np.uint8 and values.ndim == 2 and values.shape[1] in (3, 4)


def _whole_of_colors(dtype: Any) -> int:
    return np.iinfo(dtype).max if dtype in (np.uint8, np.uint16) else 1
