"""simplify_gltf()"""

from __future__ import annotations

import inspect
import os
import warnings
from typing import TYPE_CHECKING, Any, Callable, Collection, Optional, TypedDict, Union

from . import _core
from ._choices import (AxisName, CostName, OrderName, PlacementName, SeamsName, TopologyName, WeightingName,
                       choice)
from ._missed import warn_if_missed
from ._options import function_of, make_options
from ._words import in_our_words

if TYPE_CHECKING:
    from typing_extensions import Unpack


class GltfOptions(TypedDict, total=False):
    """The options of simplify() without those that have a value for each point or face."""

    faces: Optional[int]
    ratio: Optional[float]
    target_reduction: Optional[float]
    vertices: Optional[int]
    error: Optional[float]
    relative_error: Optional[float]
    both_ways: bool
    cost: Optional[CostName]
    placement: Optional[PlacementName]
    order: OrderName
    threads: int
    boundary_weight: float
    crease_degrees: float
    crease_weight: float
    weighting: WeightingName
    line_weight: float
    normal_noise: float
    position_noise: float
    topology: Optional[TopologyName]
    pairs_closer_than: Optional[float]
    keep_planes: Optional[float]
    plane_flatness: Optional[float]
    voxel_size: Optional[float]
    height_field: Optional[AxisName]
    normal_flip: float
    normal_deviation: Optional[float]
    no_self_intersection: bool
    keep_solid: bool
    share: float
    refresh: bool


def simplify_gltf(
    source: Union[str, os.PathLike[str]],
    target: Union[str, os.PathLike[str]],
    /,
    *,
    seams: Optional[SeamsName] = None,
    labels: Collection[str] = (),
    stop: Optional[Callable[[_core.Status], bool]] = None,
    progress: Optional[Callable[[_core.Status], Optional[bool]]] = None,
    **options: Unpack[GltfOptions],
) -> _core.Report:
    """Simplifies a glTF document, .gltf or .glb, and writes it to another file or over the same one.

        report = quadrille.simplify_gltf("helmet.glb", "small.glb", ratio=0.25)

    All meshes of the scene are simplified together, so that the remaining triangles are where they are
    needed most. Texture coordinates, normals, tangents, colours, skins and morph targets are updated;
    nodes, materials, images, animations and everything else in the document stay.

    seams    whether texture seams may vanish: 'kept', 'soft' (the default), 'priced' or 'free'; see
             Channel
    labels   names of integer attributes, such as '_PART': the regions of their values stay, like those of
             materials. Other integer attributes have no effect: each corner gets one of the old values
    stop, progress  functions, as in simplify(); if progress returns False, the current result is written,
             and if it raises, nothing is
    options  targets and methods, as in simplify(): faces, ratio, vertices,
             target_reduction, error, relative_error, both_ways, cost (by name), placement, order,
             threads, boundary_weight, topology, normal_flip, normal_deviation, no_self_intersection and
             so on, except those with a value for each point or face; lengths are in the unit of the scene

    Returns the Report of the whole scene. Remarks, such as one on images that are files in another
    folder, and missed targets are reported as UserWarnings.

    Raises OSError if a file can't be opened, ValueError if the document or an option is wrong, and TypeError for
    an unknown option. The target is written completely, or stays as it was.
    """
    if _gltf is None:
        raise NotImplementedError("this module was built without nlohmann_json, which glTF needs")
    source, target = os.fspath(source), os.fspath(target)
    for path in (source, target):
        if os.path.splitext(path)[1].lower() not in (".gltf", ".glb"):
            raise ValueError(f"{path} is not .gltf or .glb")
    made = make_options(**options)
    seams_choice = None if seams is None else choice("seams", seams, _core.Seams.__members__)
    with open(source, "rb"):
        pass
    try:
        report, remarks = _gltf(source, target, made, seams_choice, set(labels),
                                function_of("stop", stop), function_of("progress", progress))
    except RuntimeError as error:
        raise ValueError(str(error)) from None
    for remark in remarks:
        warnings.warn(remark, stacklevel=3)
    warn_if_missed(report, made, None, stop, stacklevel=3)
    return report


simplify_gltf.option_names = tuple(inspect.signature(make_options).parameters)  # type: ignore[attr-defined]
simplify_gltf = in_our_words(simplify_gltf)
_gltf: Any = getattr(_core, "simplify_gltf", None)
