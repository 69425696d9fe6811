"""The words that options are chosen by."""

from __future__ import annotations

from typing import Any, Literal, Mapping, TypeVar

T = TypeVar("T")

KindName = Literal["texture", "normals", "colors", "attributes"]


def choice(name: str, value: Any, members: Mapping[str, T]) -> T:
    """The member of this name. Raises a ValueError that lists all names for an unknown one."""
    if not isinstance(value, str) or value not in members:
        raise ValueError(f"{name} is {value!r}, not one of {', '.join(members)}")
    return members[value]
