"""What the readers of other libraries' meshes share."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Tuple

from numpy.typing import NDArray

Array = NDArray[Any]
Channels = Mapping[str, "Tuple[Array, Optional[Array]]"]


def name_of(mesh: Any) -> str:
    return type(mesh).__name__


def at_points(channels: Channels) -> Tuple[Dict[str, Array], List[str]]:
    """The values of those that have one for each point, and the names of the others."""
    return ({name: values for name, (values, indices) in channels.items() if indices is None},
            [name for name, (_, indices) in channels.items() if indices is not None])
