"""surface_distance() and verify()"""

from __future__ import annotations

from typing import Any, Callable, List, NamedTuple, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core, _objects
from ._forms import Array
from ._mesh import Mesh, as_mesh
from ._options import function_of, read_number
from ._words import in_our_words

Surface = Union[Mesh, _objects.MeshLike, Tuple[ArrayLike, ArrayLike]]


class Distance(NamedTuple):
    """The distance between two surfaces, in the unit of their points. The two directions differ where
    one of the surfaces has a feature that the other lacks.

    rms        the root of the mean of both squared one-sided figures
    hausdorff  the larger of both one-sided figures
    rms_a_to_b, rms_b_to_a              from samples of one surface to the other
    hausdorff_a_to_b, hausdorff_b_to_a  the largest over samples and points
    """
    rms: float
    hausdorff: float
    rms_a_to_b: float
    rms_b_to_a: float
    hausdorff_a_to_b: float
    hausdorff_b_to_a: float


class Finding(NamedTuple):
    """A claim, and its measurement.

    claim     a description
    promised  the promised value: a distance in the unit of the points, degrees, or a count
    measured  the measured value
    error     the largest possible error of the measurement
    is_met   whether the claim is held: always if it is true, and never if the true value exceeds it by more
              than the error
    place     where the claim is broken: one of the farthest points, a point of a face that intersects another
              one, or of a component that has changed; None if the claim is held, or has no such place
    """
    claim: str
    promised: float
    measured: float
    error: float
    is_met: bool
    place: Optional[Tuple[float, float, float]] = None


class Verdict:
    """The result of verify(). It is true if all claims are held.

    findings      one or more Findings for each claim
    is_cancelled  whether progress cancelled the call: then not everything was checked
    """

    def __init__(self, findings: List[Finding], is_cancelled: bool = False):
        self.findings = findings
        self.is_cancelled = is_cancelled

    def __bool__(self) -> bool:
        return not self.is_cancelled and all(finding.is_met for finding in self.findings)

    def __repr__(self) -> str:
        lines = [f"{f.claim}: {f.promised:g} promised, {f.measured:g} measured{'' if f.is_met else ', BROKEN'}"
                 + (" near ({:g}, {:g}, {:g})".format(*f.place) if f.place else "")
                 for f in self.findings] + ["cancelled before everything was measured"] * self.is_cancelled
        return f"Verdict({'; '.join(lines)})"


@in_our_words
def surface_distance(a: Surface, b: Surface, *, samples: int = 100_000, seed: int = 0) -> Distance:
    """Returns the distance between two surfaces, from points spread evenly over each of them (as in Metro, Cignoni,
    Rocchini and Scopigno 1998) to the nearest point of the other; vertices count for Hausdorff
    figures only. Shares no code with simplify().

        quadrille.surface_distance(mesh, small).rms

    a, b     each a Mesh, a pair (points, faces), or a mesh of trimesh, Open3D, PyVista, VTK or meshio
    samples  the number of points on each surface: with 100,000, an RMS figure is accurate to about one per cent;
             a Hausdorff figure is a lower bound
    seed     equal seeds give equal points, on every platform

    Raises ValueError if an argument is wrong, or a surface has no faces.
    """
    samples, seed = _count("samples", samples), _count("seed", seed)
    return Distance(*_core.surface_distance(*_surface("a", a), *_surface("b", b), samples, seed))


@in_our_words
def verify(mesh: Surface, result: Surface, *, distance: Optional[float] = None,
           distance_both_ways: Optional[float] = None, tolerance: Optional[ArrayLike] = None,
           no_self_intersection: bool = False, solid: bool = False,
           normal_deviation: Optional[float] = None, vertex_map: Optional[ArrayLike] = None,
           progress: Optional[Callable[[float], Optional[bool]]] = None) -> Verdict:
    """Checks whether a result keeps its promises, with code that is independent of simplify(): distances by branch
    and bound over faces, intersections by exact tests, solids component by component.

        small = quadrille.simplify(mesh, error=0.01, both_ways=True)
        assert quadrille.verify(mesh, small, distance_both_ways=0.01)

    mesh, result          each a Mesh, a pair (points, faces), or a mesh of trimesh, Open3D, PyVista, VTK or meshio
    distance              no point of the result is further from the mesh than this, in the unit of the points:
                          report.distance_bound
    distance_both_ways    the same, and no point of the mesh is further from the result: report.hausdorff_bound
    tolerance             for each point of the mesh, the allowed distance there; the smallest value of its
                          corners applies to a face
    no_self_intersection  no more pairs of faces intersect than in the mesh
    solid                 the mesh is closed, and the result is the same solid: it is closed, and each component
                          of the mesh corresponds to one of the result with as many handles, its inside on the
                          same side, not flat, and inside the same other components
    normal_deviation      no normal deviates by more degrees than this from that of any face that it replaces:
                          report.normal_bound_degrees. Needs vertex_map
    vertex_map                 for each point of the mesh, the index of the point of the result that replaces it, or
                          -1; the default is the vertex_map of a result of simplify()
    progress              called up to 25 times a second with the completed fraction, from 0 to 1; returning
                          False ends the check (see Verdict.is_cancelled), as Ctrl-C does

    Claims that are not given are not checked. Raises ValueError if an argument is wrong, or a surface cannot be
    measured.
    """
    (points, faces), (new_points, new_faces) = _surface("mesh", mesh), _surface("result", result)
    claims = _core.Claims()
    claims.distance = None if distance is None else read_number("distance", distance)
    if distance_both_ways is not None:
        claims.distance_both_ways = read_number("distance_both_ways", distance_both_ways)
    if tolerance is not None:
        claims.tolerances = _arrays.numbers("tolerance", tolerance, len(points))
    claims.no_self_intersection, claims.solid = bool(no_self_intersection), bool(solid)
    if normal_deviation is not None:
        claims.normal_deviation = read_number("normal_deviation", normal_deviation)
        claims.vertex_map = _images(getattr(result, "vertex_map", None) if vertex_map is None else vertex_map,
                                len(points), len(new_points))
    rows, is_cancelled = _core.verify(points, faces, new_points, new_faces, claims, function_of("progress", progress))
    return Verdict([Finding(*row[:5], None if row[4] or row[5] is None else tuple(row[5])) for row in rows],
                   is_cancelled)


def _surface(name: str, given: Any) -> Tuple[Array, Array]:
    mesh = as_mesh(given)
    points = _arrays.real_rows(f"the points of {name}", mesh.points, 3)
    return points, _arrays.index_triples(f"the faces of {name}", mesh.faces, len(points), "points")


def _count(name: str, number: Any) -> int:
    if isinstance(number, bool) or not isinstance(number, (int, np.integer)) or number < 0:
        raise ValueError(f"{name} is {number!r}, not an integer of at least 0")
    return int(number)


def _images(given: Any, count: int, new_count: int) -> List[int]:
    if given is None:
        raise ValueError("normal_deviation needs vertex_map=, the point of the result for each point of the mesh")
    vertex_map: Array = np.asarray(given)
    if vertex_map.shape != (count,) or vertex_map.dtype.kind not in "iu":
        raise ValueError(f"vertex_map has the shape {vertex_map.shape} and the type {vertex_map.dtype}, not ({count},) of integers")
    if count > 0 and not (-1 <= int(vertex_map.min()) and int(vertex_map.max()) < new_count):
        raise ValueError(f"vertex_map has numbers from {vertex_map.min()} to {vertex_map.max()}, but there are {new_count} points")
    return np.where(vertex_map < 0, np.iinfo(np.uint64).max, vertex_map.astype(np.uint64)).tolist()
