"""simplify()"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core, _objects
from ._choices import CostName, HullName, OrderName, PlacementName, TopologyName, WeightingName
from ._forms import Array
from ._levels import Levels
from ._mesh import (Mesh, ReadChannel, Simplified, Values, is_pair, no_mesh, read_attributes, read_channels,
                    set_channels, turned)
from ._missed import warn_if_missed
from ._options import Functions, function_of, make_options, read_number
from ._words import about_number, in_our_words, with_names_of_channels


@in_our_words
def simplify(
    points: Union[ArrayLike, Mesh, _objects.MeshLike, Tuple[ArrayLike, ArrayLike]],
    triangles: Optional[ArrayLike] = None,
    /,
    *,
    faces: Optional[int] = None,
    ratio: Optional[float] = None,
    target_reduction: Optional[float] = None,
    vertices: Optional[int] = None,
    error: Optional[float] = None,
    relative_error: Optional[float] = None,
    both_ways: bool = False,
    calibrated: bool = False,
    tolerance: Optional[ArrayLike] = None,
    stop: Optional[Callable[[_core.Status], bool]] = None,
    cost: Optional[Union[CostName, Callable[[_core.Pair], float]]] = None,
    placement: Optional[PlacementName] = None,
    order: OrderName = "greedy",
    threads: int = 1,
    boundary_weight: float = 100.0,
    crease_degrees: float = 180.0,
    crease_weight: float = 100.0,
    weighting: WeightingName = "by_area",
    line_weight: float = 0.0,
    normal_noise: float = 0.0,
    position_noise: float = 0.0,
    topology: Optional[TopologyName] = None,
    pairs_closer_than: Optional[float] = None,
    normal_flip: float = 90.0,
    normal_deviation: Optional[float] = None,
    no_self_intersection: bool = False,
    keep_solid: bool = False,
    keep_volume: bool = False,
    hull: Optional[HullName] = None,
    filter: Optional[Callable[[_core.Contraction], bool]] = None,
    fixed: Optional[ArrayLike] = None,
    selected: Optional[ArrayLike] = None,
    importance: Optional[ArrayLike] = None,
    labels: Optional[ArrayLike] = None,
    label_border_weight: float = 1.0,
    uv: Optional[Values] = None,
    normals: Optional[Values] = None,
    colors: Optional[Values] = None,
    attributes: Optional[Union[Mapping[str, Values], List[str]]] = None,
    split_vertices: bool = False,
    orient: bool = False,
    levels: Optional[Levels] = None,
    progress: Optional[Callable[[_core.Status], Optional[bool]]] = None,
    share: float = 0.5,
    refresh: bool = False,
) -> Simplified:
    """Simplifies a triangle surface; returns a new one and leaves the arrays of the old one alone.

        points, faces = quadrille.simplify(points, faces, faces=1000)
        result = quadrille.simplify(mesh, relative_error=0.001)      # a Mesh, as of read_mesh()
        small = quadrille.simplify(mesh, target_reduction=0.9).to_like(mesh)   # of PyVista or trimesh

    The surface:

    points     numbers of the shape (n, 3), finite, in any unit; or a Mesh, with all that it has; or a
               pair (points, triangles); or a mesh of trimesh, Open3D, PyVista, VTK (of triangles) or meshio
               (of which vertices and lines are left out), of which the points and faces are taken, and what
               attributes= names
    triangles  integers of the shape (m, 3) in [0, n): the points of each triangle. Any triangles will
               do: open, non-manifold, of several parts. Degenerate ones are dropped, those doubled
               the same way round but one, and points of no triangle. Two on the same points that run
               against each other are the sides of a sheet, and both stay. What is left keeps its
               order.
    orient     wind faces as their neighbours are, before anything else: in each piece that hangs
               together by edges of two faces the fewer are turned, with the values at their
               corners; result.remarks says how many. A piece of one side only stays as it is

    Targets, of which the first that is met ends it; half of the faces where there is none:

    faces, vertices  so many at most, at least 0
    ratio            that part of the faces, in [0, 1]
    target_reduction  the part of the faces that goes, in (0, 1), as PyVista and VTK call it: 0.9 is
                     ratio=0.1; beside no other target
    error            no point of the result further from the input than that, in the unit of the points
    relative_error   the same as a part of the diagonal of the bounding box, 0.001 say
    both_ways        error and relative_error count both ways: no point of the input is further from
                     the result either, so that thin spikes stay
    calibrated       with both_ways: go as far as error or relative_error allows when the distance is
                     measured, and not added up: half of the faces or less, in several runs, for many
                     times the time. report.hausdorff_bound is what is proved. Progress is told of each
                     run, and to end one gives the best result of those before
    tolerance        instead of these, a distance for each point, at least 0: no triangle of the input
                     further from the result than the least of its corners, see ToleranceLimit
    stop             a function of a Status, which is asked before each contraction: True is enough

    How:

    cost             'quadric' (by default, the fastest), 'memoryless_quadric' (a fifth more accurate,
                     half as fast), 'thin_feature_quadric' (the same, and thin parts stay) or
                     'edge_length'; or a function of a Pair: a number of at least 0, the least is
                     contracted first. uv, normals and the like add their own to it
    placement        where the new point goes: 'optimal' (by default but for edge_length), 'midpoint'
                     (by default for edge_length) or 'endpoint' (points of the result are of the input)
    order            'greedy' (the cheapest pair first) or 'relaxed' (in passes, which threads share)
    threads          for 'relaxed', from 1 to 1024; the result does not depend on it
    boundary_weight  how firmly borders stay, at least 0
    crease_degrees   edges are held if normals differ by more; with cost='quadric'. 180: none is
    crease_weight    how firmly
    weighting        how much a face counts: 'by_area', 'uniform' or 'by_squared_area' (triangle
                     quadrics); with cost='quadric', as the next three
    line_weight      how firmly vertices keep to lines along their normals, at least 0: 0.001 gives
                     better triangles for a little more distance, 0.01 much better ones for more
    normal_noise     the standard deviation of unit normals, at least 0; 0.1 is about 6 degrees
    position_noise   the same of points, in their unit
    topology         'kept' (by default), 'free' (parts join, holes close) or 'parts_may_vanish'
    pairs_closer_than  points closer than that may be joined without an edge, in the unit of the points;
                     topology is 'free' then by default
    normal_flip      no face turns by that many degrees or more at once, in (0, 180]
    normal_deviation  no normal is further from those of the input that it stands for, in (0, 180)
    no_self_intersection  no faces come to intersect that do not in the input; for 'greedy', and takes
                     several times as long
    keep_solid       a closed solid stays one, and the surface has to be one: see self_intersection.h; for 'greedy'
    keep_volume      what the surface encloses stays as much; for 'greedy', by 'memoryless_quadric'
    hull             'outer' (the result encloses the surface, which is closed) or 'inner' (the other
                     way round); for 'greedy', by 'memoryless_quadric'
    filter           a function of a Contraction: False forbids it
    fixed            points that stay where they are: booleans of the shape (n,), or indices
    selected         triangles that are simplified: booleans of the shape (m,), or indices. Targets are
                     of these; all points of others stay where they are
    importance       a number for each point, at least 0, of the shape (n,): where it is large more faces
                     stay, for 8 times the number about twice as many; only ratios matter
    share, refresh   for 'relaxed': see RelaxedOrder in order.h

    What goes along with the surface. Arrays here stand for those of a Mesh; see Mesh and Channel for
    shapes and forms:

    labels           an integer for each triangle: their regions stay, with their borders
    label_border_weight  how firmly these borders keep their shape, at least 0
    uv, normals, colors, attributes  values at points, or (values, indices) at corners; attributes is a
                     dict of them, or, for a mesh of another library, a list of names of its point data
                     (vertex attributes of trimesh), of which bytes in three or four columns are colours
    split_vertices   points at exactly the same place are one vertex, as in meshes that are split at
                     the seams of a texture (trimesh, glTF); the result is split again

    Watching:

    levels           a Levels, into which all levels of detail are recorded
    progress         called up to 25 times a second with a Status (status.progress goes from 0 to 1);
                     to return False ends it with the result so far, and to raise ends it with nothing

    Returns a Simplified: points, faces and whatever else the input has, in the same forms and types;
    report, image and input_faces tell what happened. Whether the target was met is told by
    result.report.is_target_reached, and one that was missed by a UserWarning, with the reason and what helps.

    Arrays of float64 and uint32 (or int32) in the order of C are read where they are; others are
    copied. Do not write to them meanwhile. Other threads of Python run on, and Ctrl-C ends it with a
    KeyboardInterrupt.

    Functions of Python (stop, cost, filter) are asked for each contraction or pair, so that a call takes
    many times as long: some microseconds for each question, beside what they do themselves. What
    they raise ends the call with nothing changed. For the same they have to answer the same.

    Raises ValueError for what is wrong with an argument, and says which and where; TypeError for
    attributes that are no dict of names, levels that are no Levels, and objects that are no surface;
    MemoryError.
    """
    mesh, of_library = _mesh_of(points, triangles)
    given: Dict[str, Any] = dict(labels=labels, uv=uv, normals=normals, colors=colors)
    added = {} if attributes is None else read_attributes(attributes, of_library)
    mesh = Mesh(mesh.points, mesh.faces, attributes={**read_attributes(mesh.attributes), **added},
                _is_split=mesh._is_split, _source=mesh._source, _source_faces=mesh._source_faces,
                **{name: getattr(mesh, name) if values is None else values
                   for name, values in given.items()})
    options = make_options(
        faces=faces, vertices=vertices, ratio=ratio, target_reduction=target_reduction, error=error,
        relative_error=relative_error, both_ways=both_ways, cost=None if callable(cost) else cost,
        placement=placement, order=order, threads=threads, boundary_weight=boundary_weight,
        crease_degrees=crease_degrees, crease_weight=crease_weight, weighting=weighting,
        line_weight=line_weight, normal_noise=normal_noise, position_noise=position_noise,
        topology=topology, pairs_closer_than=pairs_closer_than, normal_flip=normal_flip,
        normal_deviation=normal_deviation, no_self_intersection=no_self_intersection,
        keep_solid=keep_solid, share=share, refresh=refresh)
    functions = Functions(cost if callable(cost) else None, function_of("filter", filter),
                          function_of("stop", stop), function_of("progress", progress))
    way = _way_of(options, cost, hull, bool(keep_volume), bool(calibrated))
    if tolerance is not None and target_reduction is not None:
        raise ValueError("target_reduction and tolerance are both given, and are two targets")
    if tolerance is not None:
        options.tolerance = _arrays.numbers("tolerance", tolerance, len(mesh.points))
    options.label_border_weight = read_number("label_border_weight", label_border_weight)
    options.split_vertices = bool(split_vertices) or mesh._is_split
    if fixed is not None:
        options.fixed = _arrays.mask("fixed", fixed, len(mesh.points))
    if selected is not None:
        options.selected = _arrays.mask("selected", selected, len(mesh.faces), "triangle")
    if importance is not None:
        options.importance = _arrays.factors("importance", importance, len(mesh.points))
    if levels is not None and not isinstance(levels, Levels):
        raise TypeError(f"levels is a {type(levels).__name__}, not a Levels to record into")
    if calibrated:
        _check_calibrated(options, levels)
    result = _simplified(mesh, options, levels, bool(orient), way, functions)
    warn_if_missed(result.report, options, np.asarray(mesh.points), functions.stop, stacklevel=3)
    return result


def _way_of(options: _core.Options, cost: Any, hull: Any, keep_volume: bool, calibrated: bool) -> _core.Way:
    """By which engine, and what does not go with it."""
    if hull is not None and hull not in ("outer", "inner"):
        raise ValueError(f"hull is {hull!r}, neither 'outer' nor 'inner'")
    asked = [name for name, is_asked in (("hull", hull is not None), ("keep_volume", keep_volume),
                                         ("calibrated", calibrated), ("a function as cost", callable(cost)))
             if is_asked]
    if len(asked) > 1:
        raise ValueError(f"{asked[0]} does not go with {asked[1]}")
    if hull is None and not keep_volume:
        return _core.Way.calibrated if calibrated else _core.Way.compiled
    if cost not in (None, "memoryless_quadric"):
        raise ValueError(f"{asked[0]} is by cost='memoryless_quadric', not by {cost!r}")
    if options.order != _core.Order.greedy:
        raise ValueError(f"{asked[0]} is for the order 'greedy'")
    if options.placement is not None:
        raise ValueError(f"{asked[0]} says where points go, and does not go with a placement")
    options.cost = _core.Cost.memoryless_quadric
    if hull is None:
        return _core.Way.same_volume
    return _core.Way.outer_hull if hull == "outer" else _core.Way.inner_hull


def _check_calibrated(options: _core.Options, levels: Optional[Levels]) -> None:
    if not options.both_ways or (options.error is None) == (options.relative_error is None):
        raise ValueError("calibrated is for one of error and relative_error, with both_ways=True")
    if options.tolerance:
        raise ValueError("calibrated is for a limit, and does not go with a tolerance")
    if levels is not None:
        raise ValueError("calibrated does not go with levels: it runs several times")


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
    raise ValueError("there are points, but no triangles: simplify(points, triangles, ...)")


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
        report=arrays["report"], image=None if options.split_vertices else arrays["image"],
        input_faces=arrays["input_faces"], remarks=remarks)
    set_channels(result, {channel.name: channel.result(*values)
                          for channel, values in zip(channels, arrays["channels"])})
    if mesh._source is not None:
        result._is_split, result._source = mesh._is_split, mesh._source
        result._source_faces = np.ascontiguousarray(mesh._source_faces[arrays["input_faces"]])
    return result


def _oriented(points: Array, faces: Array, channels: List[ReadChannel],
              split_vertices: bool) -> Tuple[Array, List[str]]:
    """The faces wound as their neighbours are, with the corners of channels, and remarks on that."""
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
        remarks.append(f"faces turned, so that neighbours are wound alike: {np.count_nonzero(against)}")
    if one_sided > 0:
        remarks.append(f"pieces of one side only, whose faces cannot be wound alike: {one_sided}")
    return faces, remarks


def _numbered(given: Any, count: int) -> Tuple[Array, Array]:
    """Different labels, and of each face the number of its own."""
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
