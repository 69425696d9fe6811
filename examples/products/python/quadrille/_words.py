"""Hints for argument names of other libraries, and messages of the compiled part in terms of Python."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from typing import Any, Callable, List, Mapping, NamedTuple, Sequence, Tuple, TypeVar, cast

import numpy as np

F = TypeVar("F", bound=Callable[..., Any])


class _Rule(NamedTuple):
    """The hint for names that contain one of these pieces; {0} is the given value."""

    pieces: Tuple[str, ...]
    arguments: Tuple[str, ...]
    answer: str


# The first rule with a piece that the name has, and an argument that the function has, answers.
_RULES = (
    _Rule(("return", "mapping", "collapses", "vertexmap"), ("fixed",),
          "the result has these maps: result.vertex_map for points and result.input_faces for faces"),
    _Rule(("iteration", "aggress", "agg", "updaterate", "alpha", "lossless", "threshold", "sharpness"), ("error",),
          "there is no such option: the cheapest pair is always contracted first, until a target is met; error= limits "
          "the distance"),
    _Rule(("degree", "valence"), ("filter",), "a filter= function can check contraction.highest_degree"),
    _Rule(("reduction", "decimat", "percent", "fraction", "ratio", "perc", "proportion", "factor"), ("ratio",),
          "ratio= is the fraction of the faces to keep, target_reduction= the fraction to remove"),
    _Rule(("parallel", "jobs", "worker", "core", "thread", "cpu"), ("threads",),
          "threads= sets the number of threads, with order='relaxed'"),
    _Rule(("error", "tolerance", "distance", "deviation", "epsilon", "eps"), ("error", "relative_error"),
          "error= is a limit in the unit of the points, relative_error= a fraction of the diagonal"),
    _Rule(("error", "tolerance", "distance", "deviation", "epsilon", "eps"), ("distance",),
          "use distance= or distance_both_ways="),
    _Rule(("border", "boundary", "bounds"), ("boundary_weight",),
          "boundary_weight= says how firmly boundaries are kept (default: 100); fixed= takes points that must not move"),
    _Rule(("locked", "lock", "constrain", "frozen", "freeze", "pinned", "anchor"), ("fixed",),
          "fixed= takes the points that stay in place"),
    _Rule(("selec", "region", "onlyfaces", "facemask"), ("selected",), "selected= takes the triangles to simplify"),
    _Rule(("volume",), ("keep_volume",), "keep_volume=True keeps the enclosed volume"),
    _Rule(("topology", "manifold", "genus"), ("topology",),
          "topology= is 'kept' by default; 'free' and 'components_may_vanish' let it change"),
    _Rule(("verbose", "progress", "callback", "quiet", "log", "tqdm"), ("progress",),
          "progress= takes a function that receives the progress; progress=print shows it"),
    _Rule(("inplace", "copy", "overwrite"), ("fixed",),
          "nothing is changed in place: the result is a new mesh, and its to_like() converts it to the class of another mesh"),
    _Rule(("weld", "merge", "duplicate", "clean", "dedup"), ("split_vertices",),
          "split_vertices=True treats points at exactly the same place as one"),
    _Rule(("weld", "merge", "duplicate", "clean", "dedup"), ("weld",), "weld=True merges points at the same place"),
    _Rule(("color", "colour", "rgb"), ("colors",),
          "colors= takes colours, one for each point, or (values, indices) at corners"),
    _Rule(("tcoord", "texcoord", "texture", "uvs", "uv"), ("uv",),
          "uv= takes texture coordinates, one for each point, or (values, indices) at corners"),
    _Rule(("angle", "crease", "feature", "sharp"), ("crease_degrees",),
          "crease_degrees= keeps sharp edges, normal_deviation= limits how far normals turn"),
    _Rule(("normal",), ("normals",),
          "normals= takes normals, one for each point; normal_flip= and normal_deviation= limit how far faces turn"),
    _Rule(("importance", "quality", "weights", "density"), ("importance",),
          "importance= takes a number for each point; more faces stay where it is large"),
    _Rule(("regular", "shape", "planar", "line"), ("line_weight",), "line_weight= gives better triangles"),
    _Rule(("length",), ("error",), "there is no target for edge lengths; cost='edge_length' contracts the shortest edges first"),
    _Rule(("keep", "part"), ("ratio",),
          "ratio= is the fraction of the faces to keep, target_reduction= the fraction to remove"),
    _Rule(("optimal", "position", "midpoint", "endpoint", "contraction"), ("placement",),
          "placement= is 'optimal', 'midpoint' or 'endpoint'"),
    _Rule(("method", "algorithm", "metric", "mode", "strategy"), ("cost",),
          "cost= is 'quadric', 'memoryless_quadric', 'thin_feature_quadric' or 'edge_length'"),
    _Rule(("material", "segment", "group", "patch", "region"), ("labels",),
          "labels= takes an integer for each triangle"),
    _Rule(("attribute", "scalar", "vector", "tensor", "array", "pointdata", "vertexdata"), ("attributes",),
          "attributes= takes a dict of values, or a list of names of the mesh's attributes"),
    _Rule(("lod", "levels", "history"), ("levels",), "levels= takes a quadrille.Levels to record into"),
    _Rule(("voxel", "cell", "cluster", "grid"), ("pairs_closer_than",),
          "pairs_closer_than= joins points that are closer than a distance"),
    _Rule(("vert", "point", "node"), ("vertices",), "pass the number of vertices to keep as vertices={0}"),
    _Rule(("face", "triang", "tri", "poly", "target", "count", "number", "size", "max", "goal", "amount"), ("faces",),
          "pass the number of faces to keep as faces={0}"),
    _Rule(("sample", "number", "count"), ("samples",), "samples= sets the number of samples on each surface"),
    _Rule(("camera", "view", "position", "origin"), ("eye",), "eye= is the position of the viewer"),
)

def in_our_words(function: F) -> F:
    """Wraps a function: unknown names of arguments and unnamed numbers raise an error that suggests the right
    name, and errors contain no names of C++."""
    parameters = inspect.signature(function).parameters.values()
    most = sum(p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) for p in parameters)
    known = [p.name for p in parameters if p.kind in (p.KEYWORD_ONLY, p.POSITIONAL_OR_KEYWORD)]
    known += getattr(function, "option_names", ())
    takes_arrays = any(p.name == "triangles" for p in parameters)

    @functools.wraps(function)
    def call(*given: Any, **named: Any) -> Any:
        if takes_arrays:
            _require_arrays_first(function.__name__, named, known)
        if len(given) > most:
            raise TypeError(about_number(f"argument {most + 1} of {function.__name__}()", given[most], known))
        for name in named:
            if name not in known:
                raise TypeError(f"{function.__name__}() has no argument {name!r}{_meant(name, named[name], known)}")
        try:
            return function(*given, **named)
        except (ValueError, IndexError, RuntimeError) as error:
            if len(error.args) == 1 and isinstance(error.args[0], str) and "quadrille:" in error.args[0]:
                error.args = (in_words_of_python(error.args[0]),)
            raise

    return cast(F, call)


def _require_arrays_first(function: str, named: Mapping[str, Any], known: Sequence[str]) -> None:
    """Raises if a surface is passed by name."""
    for name in ("points", "vertices", "verts", "V", "v", "triangles", "faces", "F", "f", "mesh"):
        value = named.get(name)
        if name == "mesh" and value is not None:
            raise TypeError(f"the mesh comes first, without a name: {function}(mesh, ...)")
        if value is None or (name in known and np.ndim(value) != 2):
            continue
        if name == "faces" and name in known:
            raise TypeError("faces= is the number of faces to keep, and triangles are the second argument: "
                            f"{function}(points, triangles, faces=1000)")
        raise TypeError(f"points and triangles come first, without a name such as {name}=: "
                        f"{function}(points, triangles, ...)")


def about_number(what: str, value: Any, known: Sequence[str]) -> str:
    """The hint for an unnamed argument."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.number)) or "ratio" not in known:
        return f"{what} is a {type(value).__name__}: all arguments except the surface need their names"
    if float(value) > 1:
        return f"{what} is {value!r}: pass the number of faces to keep as faces={value!r}"
    return (f"{what} is {value!r}: pass the fraction of the faces to keep as ratio={value!r}, or the one to remove as "
            f"target_reduction={value!r}")


def _meant(name: str, value: Any, known: Sequence[str]) -> str:
    plain = re.sub("[^a-z]", "", name.lower())
    plain = "number" if plain in ("n", "m", "num") else plain.replace("triangle", "face")
    for near in known:
        if plain == near.replace("_", ""):
            return f": its name is {near}="
    shown = repr(value) if isinstance(value, (int, float, np.number)) and not isinstance(value, bool) else "1000"
    for rule in _RULES:
        if any(argument in known for argument in rule.arguments) and any(piece in plain for piece in rule.pieces):
            return ": " + rule.answer.format(shown)
    near = difflib.get_close_matches(name, known, 1, 0.75)
    return f": did you mean {near[0]}=?" if near else ""


# Names of C++ that messages of the compiled part have, and what they are called here.
_NAMES: List[Tuple[str, str]] = [
    (r"quadrille::ChannelOptions: ", "a Channel: "),
    (r"; CGAL::Polygon_mesh_processing::orient_to_bound_a_volume changes that",
     ": turn its faces over, faces[:, [0, 2, 1]]"),
    (r"; CGAL::Polygon_mesh_processing .*", "; orient=True winds faces alike, split_vertices=True treats points at the same place as one"),
    (r"quadrille::ThresholdPairs: the threshold", "pairs_closer_than: the distance"),
    (r"quadrille::ThresholdPairs", "pairs_closer_than"),
    (r"quadrille::NoSelfIntersection needs GreedyOrder", "no_self_intersection=True needs order='greedy'"),
    (r"quadrille::KeepSolid needs GreedyOrder", "keep_solid=True needs order='greedy'"),
    (r"quadrille::KeepSolid", "keep_solid"),
    (r"quadrille::FaceRatio: the ratio", "ratio"),
    (r"quadrille::(?:DistanceLimit|HausdorffLimit): the limit", "error or relative_error: the limit"),
    (r"quadrille::NormalDeviation", "normal_deviation"),
    (r"quadrille::NormalFlip", "normal_flip"),
    (r"quadrille::Labels: region_boundary_weight", "region_boundary_weight"),
    (r"quadrille::Levels: distances have not been recorded: .*",
     "no distances are recorded: simplify() records them with error= or relative_error="),
    (r"pass no Topology::free or (?:Topology::)?components_may_vanish",
     "it does not go with topology='free' or 'components_may_vanish'"),
    (r"the order of RelaxedOrder|RelaxedOrder", "order='relaxed'"),
    (r"GreedyOrder", "order='greedy'"),
    (r"NewValues::(\w+)", r"new_values='\1'"),
    (r"Topology::(\w+)", r"topology='\1'"),
    (r"Weighting::(\w+)", r"weighting='\1'"),
    (r"the relaxed order", "order='relaxed'"),
    (r"the cost quadric", "cost='quadric'"),
    (r"^quadrille(?:::\w+)*: ", ""),
]


def in_words_of_python(message: str) -> str:
    """A message of the compiled part without names of C++."""
    for pattern, words in _NAMES:
        message = re.sub(pattern, words, message)
    return re.sub(r"\b(?:quadrille|CGAL|std)::", "", message)


def with_names_of_channels(message: str, names: Sequence[str]) -> str:
    """A message with the names of channels where it has their numbers."""
    return re.sub(r"\bchannel (\d+)\b", lambda m: names[int(m[1])] if int(m[1]) < len(names) else m[0], message)
