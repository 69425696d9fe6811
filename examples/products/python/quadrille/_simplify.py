"""simplify()"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core, _objects
from ._forms import Array
from ._levels import Levels
from ._maps import SparseMap
from ._mesh import (Mesh, ReadChannel, Simplified, Values, is_pair, no_mesh, read_attributes, read_channels,
                    set_channels, turned)
from ._missed import warn_if_missed
from ._options import Functions, function_of, make_options, read_arrays, takes_options
from ._table import ROWS, ArrayOptions, CostName, HullName, SharedOptions
from ._words import about_number, in_our_words, with_names_of_channels

if TYPE_CHECKING:
    from typing_extensions import Unpack


class MeshOptions(SharedOptions, ArrayOptions, total=False):
    """The options of simplify() that are rows of the table of options."""


@in_our_words
@takes_options(*ROWS)
def simplify(
    points: Union[ArrayLike, Mesh, _objects.MeshLike, Tuple[ArrayLike, ArrayLike]],
    triangles: Optional[ArrayLike] = None,
    /,
    *,
    target_reduction: Optional[float] = None,
    calibrated: bool = False,
    stop: Optional[Callable[[_core.Status], bool]] = None,
    cost: Optional[Union[CostName, Callable[[_core.Pair], float]]] = None,
    keep_volume: bool = False,
    hull: Optional[HullName] = None,
    filter: Optional[Callable[[_core.Contraction], bool]] = None,
    labels: Optional[ArrayLike] = None,
    region_boundary_weight: float = 1.0,
    uv: Optional[Values] = None,
    normals: Optional[Values] = None,
    colors: Optional[Values] = None,
    attributes: Optional[Union[Mapping[str, Values], List[str]]] = None,
    split_vertices: bool = False,
    orient: bool = False,
    levels: Optional[Levels] = None,
    maps: bool = False,
    progress: Optional[Callable[[_core.Status], Optional[bool]]] = None,
    **options: Unpack[MeshOptions],
) -> Simplified:
    """Simplifies a triangle mesh, and returns a new one. The arrays of the input are not changed.

        points, faces = quadrille.simplify(points, faces, faces=1000)
        result = quadrille.simplify(mesh, relative_error=0.001)      # a Mesh, such as read_mesh() returns
        small = quadrille.simplify(mesh, target_reduction=0.9).to_like(mesh)   # of PyVista or trimesh

    The surface:

    points     finite numbers of the shape (n, 3), in any unit; or a Mesh, with everything that it contains; or a
               pair (points, triangles); or a triangle mesh of trimesh, Open3D, PyVista, VTK or meshio, from which
               the points, the faces and the attributes named by attributes= are taken (lines and single vertices
               are left out)
    triangles  integers of the shape (m, 3) in [0, n): the points of each triangle. The surface may be open,
               non-manifold or of several components. Degenerate triangles, duplicates with the same winding and
               points without a triangle are removed. Two triangles on the same points with opposite winding are
               the two sides of a double-sided face, and both stay. The remaining elements keep their order.
    orient     before anything else, turn faces so that neighbours are wound alike: in each component connected
               by edges of two faces, the smaller number of faces is turned, with the values at their corners;
               result.remarks says how many. A one-sided component stays as it is.

    Targets. The first one that is met ends the run; without any, the run ends at half of the faces:

    <Targets>
    target_reduction  the fraction of the faces to remove, in (0, 1), as in PyVista and VTK: 0.9 is
                      ratio=0.1; cannot be combined with another target
    calibrated        with both_ways: continue until the measured distance, instead of the accumulated bound,
                      reaches error or relative_error: half as many faces or fewer, in several runs that take
                      many times as long. report.hausdorff_bound is the proved bound. Progress is reported for
                      each run; to cancel one returns the best result of the runs before
    stop              a function of a Status, called before each contraction: the run ends when it returns True

    What kind of surface it is:

    <What kind of surface it is>

    How pairs are contracted. The cost may also be a function of a Pair that returns a number of at least 0: the pair
    with the smallest one is contracted first. uv, normals and others add to the cost:

    <How pairs are contracted>
    filter            a function of a Contraction, which forbids it by returning False

    What is kept:

    <What is kept>

    Attributes. These arrays replace those of a Mesh; see Mesh and Channel for shapes and forms:

    labels           an integer for each triangle: regions of equal labels stay, with their boundaries
    uv, normals, colors, attributes  values at points, or (values, indices) at corners; attributes is a
                     dict of them or, for a mesh of another library, a list of names of its point data
                     (vertex attributes in trimesh), where bytes in three or four columns are colours

    Observation:

    levels           a Levels, into which all levels of detail are recorded
    maps             the result has old_to_new and new_to_old: sparse maps between its points and those of the
                     input, see Simplified; takes several times as long
    progress         called up to 25 times a second with a Status (status.progress goes from 0 to 1);
                     returning False ends the run with the current result, raising ends it without one

    Returns a Simplified: points, faces and all attributes of the input, in the same forms and types;
    report, vertex_map and input_faces describe the run. result.report.is_target_reached says whether the target was
    met; if not, a UserWarning gives the reason and what helps.

    Contiguous arrays of float64 and uint32 (or int32) are read in place, others are copied. Do not write to them
    during the call. Other Python threads keep running, and Ctrl-C ends the call with a KeyboardInterrupt.

    Python functions (stop, cost, filter) are called for each contraction or pair, half a microsecond or more each in
    addition to their own time, so a call takes many times as long. If they raise, the call ends and nothing is
    changed. They have to return the same answer for the same argument.

    Raises ValueError if an argument is wrong, and says which one and where; TypeError if attributes is not a
    dict of names, levels is not a Levels, or the object is not a surface; MemoryError.
    """
    mesh, of_library = _mesh_of(_arrays.of_dlpack(points), _arrays.of_dlpack(triangles))
    given: Dict[str, Any] = {name: _arrays.of_dlpack(values) for name, values in (
        ("labels", labels), ("uv", uv), ("normals", normals), ("colors", colors))}
    added = {} if attributes is None else read_attributes(attributes, of_library)
    mesh = Mesh(mesh.points, mesh.faces, attributes={**read_attributes(mesh.attributes), **added},
                _is_split=mesh._is_split, _source=mesh._source, _source_faces=mesh._source_faces,
                **{name: getattr(mesh, name) if values is None else values
                   for name, values in given.items()})
    arrays = {name: options.pop(name) for name in ArrayOptions.__annotations__ if name in options}  # type: ignore[misc]
    made = make_options(target_reduction, cost=None if callable(cost) else cost,
                        region_boundary_weight=region_boundary_weight, split_vertices=split_vertices, **options)
    functions = Functions(cost if callable(cost) else None, function_of("filter", filter),
                          function_of("stop", stop), function_of("progress", progress))
    way = _way_of(made, cost, hull, bool(keep_volume), bool(calibrated))
    read_arrays(made, arrays, len(mesh.points), len(mesh.faces))
    if arrays.get("tolerance") is not None and target_reduction is not None:
        raise ValueError("target_reduction and tolerance do not go together")
    made.split_vertices = made.split_vertices or mesh._is_split
    made.maps = bool(maps)
    if levels is not None and not isinstance(levels, Levels):
        raise TypeError(f"levels is a {type(levels).__name__}, not a Levels to record into")
    if calibrated:
        _check_calibrated(made, levels)
    result = _simplified(mesh, made, levels, bool(orient), way, functions)
    warn_if_missed(result.report, made, np.asarray(mesh.points), functions.stop, stacklevel=3)
    return result


def _way_of(options: _core.Options, cost: Any, hull: Any, keep_volume: bool, calibrated: bool) -> _core.Way:
    """Chooses the engine, and rejects arguments that do not go with it."""
    if hull is not None and hull not in ("outer", "inner"):
        raise ValueError(f"hull is {hull!r}, not 'outer' or 'inner'")
    asked = [name for name, is_asked in (("hull", hull is not None), ("keep_volume", keep_volume),
                                         ("calibrated", calibrated), ("a function as cost", callable(cost)))
             if is_asked]
    if len(asked) > 1:
        raise ValueError(f"{asked[0]} does not go with {asked[1]}")
    if hull is None and not keep_volume:
        return _core.Way.calibrated if calibrated else _core.Way.compiled
    if cost not in (None, "memoryless_quadric"):
        raise ValueError(f"{asked[0]} needs cost='memoryless_quadric', not {cost!r}")
    if options.order != _core.Order.greedy:
        raise ValueError(f"{asked[0]} needs order='greedy'")
    if options.placement is not None:
        raise ValueError(f"{asked[0]} has its own placement, and does not go with placement=")
    options.cost = _core.Cost.memoryless_quadric
    if hull is None:
        return _core.Way.same_volume
    return _core.Way.outer_hull if hull == "outer" else _core.Way.inner_hull


def _check_calibrated(options: _core.Options, levels: Optional[Levels]) -> None:
    if not options.both_ways or (options.error is None) == (options.relative_error is None):
        raise ValueError("calibrated needs either error or relative_error, with both_ways=True")
    if options.tolerance:
        raise ValueError("calibrated does not go with a tolerance")
    if levels is not None:
        raise ValueError("calibrated does not go with levels: it needs several runs")
    if options.maps:
        raise ValueError("calibrated does not go with maps: it needs several runs")


def _mesh_of(points: Any, triangles: Any) -> Tuple[Mesh, Any]:
    """The surface, and the mesh of another library that it comes from, or None."""
    of_library = None if isinstance(points, Mesh) else _objects.read_object(points)
    if triangles is not None:
        if np.ndim(triangles) == 0:
            raise TypeError(about_number("the second argument", triangles, ["ratio"]))
        if isinstance(points, Mesh) or of_library is not None:
            raise ValueError(f"triangles are given in addition to a {type(points).__name__}, which has its own")
        return Mesh(np.asarray(points), np.asarray(triangles)), None
    if isinstance(points, Mesh):
        return points, None
    if of_library is not None:
        return Mesh(of_library.points, of_library.faces), of_library
    if is_pair(points):
        return Mesh(np.asarray(points[0]), np.asarray(points[1])), None
    is_list = isinstance(points, (list, tuple)) and (len(points) == 0 or np.ndim(points[0]) == 1)
    if not is_list and not hasattr(points, "__array__"):
        raise no_mesh("the first argument", points)
    raise ValueError("the triangles are missing: simplify(points, triangles, ...)")


def _simplified(mesh: Mesh, options: _core.Options, levels: Optional[Levels], orient: bool, way: _core.Way,
                functions: Functions) -> Simplified:
    points = _arrays.real_rows("points", mesh.points, 3)
    faces = _arrays.index_triples("faces", mesh.faces, len(points), "points")
    labels, label_numbers, label_type = None, None, None
    if mesh.labels is not None:
        label_type = np.asarray(mesh.labels).dtype
        labels, label_numbers = _numbered(mesh.labels, len(faces))
    channels = read_channels(mesh)
    remarks: List[str] = []
    if orient:
        faces, remarks = _oriented(points, faces, channels, options.split_vertices)
    options.coordinates_are_floats = _float_type(mesh.points).itemsize < 8
    arguments = [c.arguments() for c in channels]
    try:
        arrays = _core.simplify(points, faces, label_numbers, arguments, options,
                                None if levels is None else levels._levels, functions.progress, way,
                                functions.cost, functions.filter, functions.stop)
    except ValueError as error:
        if str(error).startswith("quadrille::"):
            error.args = (with_names_of_channels(str(error), [c.name for c in channels]),)
        raise
    if levels is not None:
        levels._names = [channel.name for channel in channels]
    result = Simplified(
        _arrays.as_type(arrays["points"], _float_type(mesh.points)),
        _arrays.as_type(arrays["faces"], _index_type(mesh.faces)),
        labels=None if labels is None else labels[arrays["labels"]].astype(label_type, copy=False),
        report=arrays["report"], vertex_map=None if options.split_vertices else arrays["vertex_map"],
        input_faces=arrays["input_faces"], remarks=remarks)
    set_channels(result, {channel.name: channel.result(*values)
                          for channel, values in zip(channels, arrays["channels"])})
    if options.maps:
        result._maps = (_map_of(arrays["old_to_new"], len(result.points)), _map_of(arrays["new_to_old"], len(points)))
    if mesh._source is not None:
        result._is_split, result._source = mesh._is_split, mesh._source
        result._source_faces = np.ascontiguousarray(mesh._source_faces[arrays["input_faces"]])
    return result


def _map_of(arrays: List[Array], columns: int) -> SparseMap:
    begins, indices, weights = arrays
    return SparseMap(begins, indices, weights, (len(begins) - 1, columns))


def _oriented(points: Array, faces: Array, channels: List[ReadChannel],
              split_vertices: bool) -> Tuple[Array, List[str]]:
    """Turns faces to agree with their neighbours, with the corners of channels; returns them with remarks."""
    places = faces
    if split_vertices:
        numbers = np.unique(points, axis=0, return_inverse=True)[1].astype(np.uint32).reshape(-1)
        places = np.ascontiguousarray(numbers[faces])
    against, one_sided = _core.winding(places, len(points))
    remarks: List[str] = []
    if against.any():
        faces = turned(faces, against)
        for channel in channels:
            channel.turn(against)
        remarks.append(f"faces turned to agree with their neighbours: {np.count_nonzero(against)}")
    if one_sided > 0:
        remarks.append(f"one-sided components, whose faces cannot be wound alike: {one_sided}")
    return faces, remarks


def _numbered(given: Any, count: int) -> Tuple[Array, Array]:
    """The different labels, and for each face the index of its label."""
    labels: Array = np.asarray(given)
    if labels.shape != (count,):
        raise ValueError(f"labels has the shape {labels.shape}, not ({count},): one for each face")
    different, numbers = np.unique(labels, return_inverse=True)
    return different, np.ascontiguousarray(numbers, dtype=np.uint32)


def _float_type(array: Any) -> Any:
    dtype = np.asarray(array).dtype
    return dtype if dtype.kind == "f" else np.dtype(np.float64)


def _index_type(array: Any) -> Any:
    dtype = np.asarray(array).dtype
    return dtype if dtype.kind in "iu" else np.dtype(np.uint32)
