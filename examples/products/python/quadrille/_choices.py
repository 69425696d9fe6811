"""The words that options are chosen by."""

from __future__ import annotations

from typing import Any, Literal, Mapping, TypeVar

T = TypeVar("T")

CostName = Literal["quadric", "memoryless_quadric", "thin_feature_quadric", "edge_length"]
PlacementName = Literal["optimal", "midpoint", "endpoint"]
OrderName = Literal["greedy", "relaxed"]
WeightingName = Literal["by_area", "uniform", "by_squared_area"]
AxisName = Literal["x", "y", "z"]
TopologyName = Literal["kept", "free", "components_may_vanish"]
PresetName = Literal["generated", "scan", "voxels", "print", "cad", "terrain", "game"]
HullName = Literal["outer", "inner"]
SeamsName = Literal["kept", "soft", "priced", "free"]
NewValuesName = Literal["optimal", "weights", "existing", "recomputed"]
KindName = Literal["texture", "normals", "colors", "attributes"]


def choice(name: str, value: Any, members: Mapping[str, T]) -> T:
    """The member of this name. Raises a ValueError that lists all names for an unknown one."""
    if not isinstance(value, str) or value not in members:
        raise ValueError(f"{name} is {value!r}, not one of {', '.join(members)}")
    return members[value]
