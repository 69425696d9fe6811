"""simplify()"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core, _objects
from ._choices import AxisName, CostName, HullName, OrderName, PlacementName, PresetName, TopologyName, WeightingName
from ._forms import Array
from ._levels import Levels
from ._maps import SparseMap
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
    preset: Optional[PresetName] = None,
    topology: Optional[TopologyName] = None,
    manifold: bool = False,
    simplified_topology: Optional[float] = None,
    pairs_closer_than: Optional[float] = None,
    keep_planes: Optional[float] = None,
    plane_flatness: Optional[float] = None,
    voxel_size: Optional[float] = None,
    height_field: Optional[AxisName] = None,
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
    share: float = 0.5,
    refresh: bool = False,
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

    faces, vertices  at most this many, at least 0
    ratio            this fraction of the faces, in [0, 1]
    target_reduction  the fraction of the faces to remove, in (0, 1), as in PyVista and VTK: 0.9 is
                     ratio=0.1; cannot be combined with another target
    error            no point of the result is further from the input than this, in the unit of the points
    relative_error   the same, as a fraction of the diagonal of the bounding box, such as 0.001
    both_ways        error and relative_error apply both ways: no point of the input is further from
                     the result either, so thin spikes stay
    calibrated       with both_ways: continue until the measured distance, instead of the accumulated bound,
                     reaches error or relative_error: half as many faces or fewer, in several runs that take
                     many times as long. report.hausdorff_bound is the proved bound. Progress is reported for
                     each run; to cancel one returns the best result of the runs before
    tolerance        instead of error, a distance for each point, at least 0: no triangle of the input is
                     further from the result than the smallest value of its corners; see ToleranceLimit
    stop             a function of a Status, called before each contraction: the run ends when it returns True

    Method:

    cost             'quadric' (the default and the fastest), 'memoryless_quadric' (a fifth more accurate,
                     half as fast), 'thin_feature_quadric' (as accurate, and thin features survive) or
                     'edge_length'; or a function of a Pair that returns a number of at least 0: the pair
                     with the smallest one is contracted first. uv, normals and others add to the cost
    placement        where the new point goes: 'optimal' (the default), 'midpoint' (the default with
                     edge_length) or 'endpoint' (points of the result are points of the input)
    order            'greedy' (the cheapest pair first) or 'relaxed' (in passes, which threads share)
    threads          for 'relaxed', from 1 to 1024; the result does not depend on it
    boundary_weight  how firmly boundaries are kept, at least 0
    crease_degrees   edges are kept like boundaries where the normals of their faces differ by more; for
                     cost='quadric'. 180: no edges
    crease_weight    how firmly these edges are kept
    weighting        the weight of a face: 'by_area', 'uniform' or 'by_squared_area' (triangle quadrics);
                     for cost='quadric', as are the next three
    line_weight      how firmly vertices are kept to the lines along their normals, at least 0: 0.001 gives
                     better triangles at a slightly larger distance, 0.01 much better ones at a larger one
    normal_noise     the standard deviation of unit normals, at least 0; 0.1 is about 6 degrees
    position_noise   the standard deviation of points, in their unit
    preset           the options of a kind of surface, where they are left at their defaults here: 'generated', 'scan',
                     'voxels', 'print', 'cad', 'terrain' or 'game'; doc/manual/presets.md lists them
    topology         'kept' (the default), 'free' (components join, holes close) or 'components_may_vanish' (small
                     components may be removed)
    manifold         first cuts the surface into manifold sheets, at edges of more than two faces and where
                     sheets touch
    simplified_topology  first cuts tunnels and handles up to this width, in the unit of the points, and closes
                     the surface there; Report.cut_handles counts them
    pairs_closer_than  points closer than this may be joined without an edge, in the unit of the points;
                     the topology then defaults to 'free'
    keep_planes      plane regions of at least this area stay exactly in their planes, and their outlines keep
                     their topology: see KeepPlanes in keep_planes.h
    plane_flatness   how far points of such a region may be from its plane, into which they are moved; by
                     default a millionth of the diagonal of the bounding box
    voxel_size       the surface was made of voxels of this size: its stairs are smoothed first, by at most half
                     a voxel along each axis; see VoxelSize in voxel_size.h
    height_field     'x', 'y' or 'z': the surface shows one side only to a viewer on this axis, and the result
                     does as well
    normal_flip      no single contraction turns a face by this many degrees or more, in (0, 180]
    normal_deviation  no normal deviates by more degrees than this from the normals of the input that it
                     replaces, in (0, 180)
    no_self_intersection  no faces intersect that did not intersect in the input; for 'greedy', takes
                     several times as long
    keep_solid       a closed solid stays one; the input has to be one, see guards.h; for 'greedy'
    keep_volume      the enclosed volume stays the same; for 'greedy', with 'memoryless_quadric'
    hull             'outer' (the result encloses the closed surface) or 'inner' (the surface encloses the
                     result); for 'greedy', with 'memoryless_quadric'
    filter           a function of a Contraction, which forbids it by returning False
    fixed            points that stay in place: booleans of the shape (n,), or indices
    selected         triangles to simplify: booleans of the shape (m,), or indices. Targets count only
                     these; all points of other triangles stay in place
    importance       a number of at least 0 for each point, of the shape (n,): more faces stay where it is
                     larger, about twice as many for 8 times the number; only ratios matter
    share, refresh   for 'relaxed': see RelaxedOrder in relaxed_order.h

    Attributes. These arrays replace those of a Mesh; see Mesh and Channel for shapes and forms:

    labels           an integer for each triangle: regions of equal labels stay, with their boundaries
    region_boundary_weight  how firmly these boundaries keep their shape, at least 0
    uv, normals, colors, attributes  values at points, or (values, indices) at corners; attributes is a
                     dict of them or, for a mesh of another library, a list of names of its point data
                     (vertex attributes in trimesh), where bytes in three or four columns are colours
    split_vertices   points at exactly the same place are one vertex, as in meshes that are split along
                     texture seams (trimesh, glTF); the result is split again

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
    options = make_options(
        faces=faces, vertices=vertices, ratio=ratio, target_reduction=target_reduction, error=error,
        relative_error=relative_error, both_ways=both_ways, cost=None if callable(cost) else cost,
        placement=placement, order=order, threads=threads, boundary_weight=boundary_weight,
        crease_degrees=crease_degrees, crease_weight=crease_weight, weighting=weighting,
        line_weight=line_weight, normal_noise=normal_noise, position_noise=position_noise,
        preset=preset, topology=topology, manifold=manifold, simplified_topology=simplified_topology,
        pairs_closer_than=pairs_closer_than, keep_planes=keep_planes, plane_flatness=plane_flatness,
        voxel_size=voxel_size, height_field=height_field, normal_flip=normal_flip,
        normal_deviation=normal_deviation, no_self_intersection=no_self_intersection,
        keep_solid=keep_solid, share=share, refresh=refresh)
    functions = Functions(cost if callable(cost) else None, function_of("filter", filter),
                          function_of("stop", stop), function_of("progress", progress))
    way = _way_of(options, cost, hull, bool(keep_volume), bool(calibrated))
    if tolerance is not None and target_reduction is not None:
        raise ValueError("target_reduction and tolerance do not go together")
    if tolerance is not None:
        options.tolerance = _arrays.numbers("tolerance", tolerance, len(mesh.points))
    options.region_boundary_weight = read_number("region_boundary_weight", region_boundary_weight)
    options.split_vertices = bool(split_vertices) or mesh._is_split
    options.maps = bool(maps)
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
