"""The options that simplify() and simplify_gltf() share."""

from __future__ import annotations

import operator
from typing import Any, Callable, NamedTuple, Optional

from . import _core
from ._choices import AxisName, CostName, OrderName, PlacementName, PresetName, TopologyName, WeightingName, choice


class Functions(NamedTuple):
    """Functions of the user's, or None."""

    cost: Optional[Callable[[_core.Pair], float]]
    filter: Optional[Callable[[_core.Contraction], bool]]
    stop: Optional[Callable[[_core.Status], bool]]
    progress: Optional[Callable[[_core.Status], Optional[bool]]]


def make_options(
    *,
    faces: Optional[int] = None,
    ratio: Optional[float] = None,
    target_reduction: Optional[float] = None,
    vertices: Optional[int] = None,
    error: Optional[float] = None,
    relative_error: Optional[float] = None,
    both_ways: bool = False,
    cost: Optional[CostName] = None,
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
    share: float = 0.5,
    refresh: bool = False,
) -> _core.Options:
    """Converts options by their names in simplify()."""
    options = _core.Options()
    for name, count in (("faces", faces), ("vertices", vertices)):
        if count is not None:
            setattr(options, name, read_count(name, count))
    for name, number in (("ratio", ratio), ("error", error), ("relative_error", relative_error),
                         ("pairs_closer_than", pairs_closer_than), ("keep_planes", keep_planes),
                         ("plane_flatness", plane_flatness), ("voxel_size", voxel_size),
                         ("normal_deviation", normal_deviation), ("simplified_topology", simplified_topology)):
        if number is not None:
            setattr(options, name, read_number(name, number))
    if target_reduction is not None:
        options.ratio = _ratio_left(target_reduction, faces=faces, ratio=ratio, vertices=vertices,
                                    error=error, relative_error=relative_error)
    if options.ratio is not None and not 0 <= options.ratio <= 1:
        raise ValueError(f"ratio is {ratio!r}, not in [0, 1]: it is the fraction of the faces to keep")
    options.both_ways = bool(both_ways)
    options.cost = _core.Cost.quadric if cost is None else choice("cost", cost, _core.Cost.__members__)
    options.weighting = choice("weighting", weighting, _core.Weighting.__members__)
    options.order = choice("order", order, _core.Order.__members__)
    if placement is not None:
        options.placement = choice("placement", placement, _core.Placement.__members__)
    if preset is not None:
        options.preset = choice("preset", preset, _core.Preset.__members__)
    if topology is not None:
        options.topology = choice("topology", topology, _core.Topology.__members__)
    if height_field is not None:
        options.height_field = choice("height_field", height_field, _core.Axis.__members__)
    numbers = dict(boundary_weight=boundary_weight, crease_degrees=crease_degrees,
                   crease_weight=crease_weight, line_weight=line_weight, normal_noise=normal_noise,
                   position_noise=position_noise, normal_flip=normal_flip, share=share)
    for name, number in numbers.items():
        setattr(options, name, read_number(name, number))
    options.threads = read_count("threads", threads)
    options.refresh = bool(refresh)
    options.no_self_intersection = bool(no_self_intersection)
    options.keep_solid = bool(keep_solid)
    options.manifold = bool(manifold)
    return options


def function_of(name: str, function: Any) -> Any:
    if function is not None and not callable(function):
        raise ValueError(f"{name} is {function!r}, which is not a function")
    return function


def read_count(name: str, value: Any) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{name} is {value!r}, not an integer{_of_chunks(name, value)}") from None
    if number < 0 or number >= 2**32:
        raise ValueError(f"{name} is {number}, not in [0, 2**32)")
    return number


def _of_chunks(name: str, value: Any) -> str:
    is_part = name == "faces" and isinstance(value, float) and 0 < value < 1
    return f": for a fraction of the faces, pass ratio={value!r}" if is_part else ""


def read_number(name: str, value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {value!r}, not a number") from None


def _ratio_left(target_reduction: Any, **others: Any) -> float:
    given = [name for name, value in others.items() if value is not None]
    if given:
        raise ValueError(f"target_reduction and {given[0]} do not go together: both are targets")
    number = read_number("target_reduction", target_reduction)
    if not 0 < number < 1:
        raise ValueError(f"target_reduction is {number}, not in (0, 1): it is the fraction of the "
                         "faces to remove")
    return 1 - number
