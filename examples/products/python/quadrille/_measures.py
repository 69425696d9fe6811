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
    """How far two surfaces are from each other, in the unit of their points. Both directions differ where
    one of them has a part that the other lacks.

    rms        root of the mean of both squared one-sided figures
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
    """A claim, and what has been measured.

    claim     in words
    promised  a distance in the unit of the points, degrees, or a number of what is named
    measured  the same
    error     by how much what is measured may be wrong, at most
    is_held   is what is measured as it was promised? Always if that is so of the truth, and never if the
              truth is beyond it by more than the error
    place     where it is broken: a point of the farthest, of a face that intersects another one, of a part
              that has changed; None where it is held, or where there is no such place
    """
    claim: str
    promised: float
    measured: float
    error: float
    is_held: bool
    place: Optional[Tuple[float, float, float]] = None


class Verdict:
    """What verify() has found. It is true if all claims are held.

    findings      one Finding for each claim, or some
    is_cancelled  by the function progress: then not all has been looked at
    """

    def __init__(self, findings: List[Finding], is_cancelled: bool = False):
        self.findings = findings
        self.is_cancelled = is_cancelled

    def __bool__(self) -> bool:
        return not self.is_cancelled and all(finding.is_held for finding in self.findings)

    def __repr__(self) -> str:
        lines = [f"{f.claim}: {f.promised:g} promised, {f.measured:g} measured{'' if f.is_held else ', BROKEN'}"
                 + (" near ({:g}, {:g}, {:g})".format(*f.place) if f.place else "")
                 for f in self.findings] + ["cancelled before all was measured"] * self.is_cancelled
        return f"Verdict({'; '.join(lines)})"


@in_our_words
def surface_distance(a: Surface, b: Surface, *, samples: int = 100_000, seed: int = 0) -> Distance:
    """The distance between two surfaces, from points spread evenly over each of them (as Metro of Cignoni,
    Rocchini and Scopigno 1998) to the nearest point of the other; points of the mesh count for Hausdorff
    figures only. Shares nothing with simplify().

        quadrille.surface_distance(mesh, small).rms

    a, b     each a Mesh, a pair (points, faces), or a mesh of trimesh, Open3D, PyVista, VTK or meshio
    samples  on each surface: with 100,000 an RMS figure is good to about one per cent, and a Hausdorff
             figure is a lower bound
    seed     equal seeds give equal points, on every platform

    Raises ValueError for what is wrong with an argument, or a surface without faces.
    """
    samples, seed = _count("samples", samples), _count("seed", seed)
    return Distance(*_core.surface_distance(*_surface("a", a), *_surface("b", b), samples, seed))


@in_our_words
def verify(mesh: Surface, result: Surface, *, distance: Optional[float] = None,
           distance_both_ways: Optional[float] = None, tolerance: Optional[ArrayLike] = None,
           no_self_intersection: bool = False, solid: bool = False,
           normal_deviation: Optional[float] = None, image: Optional[ArrayLike] = None,
           progress: Optional[Callable[[float], Optional[bool]]] = None) -> Verdict:
    """Does a result keep what was promised of it? Measured by code that shares nothing with simplify():
    distances by branch and bound over faces, intersections by exact tests, solids part by part.

        small = quadrille.simplify(mesh, error=0.01, both_ways=True)
        assert quadrille.verify(mesh, small, distance_both_ways=0.01)

    mesh, result          each a Mesh, a pair (points, faces), or a mesh of trimesh, Open3D, PyVista, VTK or meshio
    distance              no point of the result is further from the mesh than that, in the unit of the points:
                          report.distance_bound
    distance_both_ways    the same, and no point of the mesh is further from the result: report.hausdorff_bound
    tolerance             of each point of the mesh, how far points may be there; a face has the least of its
                          corners
    no_self_intersection  no more pairs of faces intersect than in the mesh
    solid                 the mesh, which is closed, and the result are solids alike: the result is closed, and
                          each part of the mesh has become one of it, with as many handles, its inside on the
                          same side, not flat, and in the same ones of the others
    normal_deviation      no normal is further than so many degrees from that of any face that has become it:
                          report.normal_bound_degrees. Needs the image
    image                 of each point of the mesh, the point of the result that it has become, or -1; that of
                          a result of simplify() is known
    progress              called up to 25 times a second with the part that is done, from 0 to 1; to return
                          False ends it: Verdict.is_cancelled. Ctrl-C ends it, too

    What is left out is not looked at. Raises ValueError for what is wrong with an argument, or for a
    surface that cannot be measured.
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
        claims.images = _images(getattr(result, "image", None) if image is None else image,
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
        raise ValueError(f"{name} is {number!r}, not a whole number of at least 0")
    return int(number)


def _images(given: Any, count: int, new_count: int) -> List[int]:
    if given is None:
        raise ValueError("normal_deviation needs image: of each point of the mesh, what it has become")
    image: Array = np.asarray(given)
    if image.shape != (count,) or image.dtype.kind not in "iu":
        raise ValueError(f"image has the shape {image.shape} and the type {image.dtype}, not ({count},) of integers")
    if count > 0 and not (-1 <= int(image.min()) and int(image.max()) < new_count):
        raise ValueError(f"image has numbers from {image.min()} to {image.max()}, but there are {new_count} points")
    return np.where(image < 0, np.iinfo(np.uint64).max, image.astype(np.uint64)).tolist()
