"""The options that simplify() and simplify_gltf() share."""

from __future__ import annotations

import inspect
import operator
import re
from typing import Any, Callable, Dict, NamedTuple, Optional, TypeVar

from . import _arrays, _core, _table
from ._choices import choice

F = TypeVar("F", bound=Callable[..., Any])


class Functions(NamedTuple):
    """Functions of the user's, or None."""

    cost: Optional[Callable[[_core.Pair], float]]
    filter: Optional[Callable[[_core.Contraction], bool]]
    stop: Optional[Callable[[_core.Status], bool]]
    progress: Optional[Callable[[_core.Status], Optional[bool]]]


def takes_options(*names: str) -> Callable[[F], F]:
    """Gives a function of **options these options of the table as arguments, with their defaults, and puts their
    documentation at the lines <group of the table> of its own."""
    def with_options(function: F) -> F:
        signature = inspect.signature(function)
        parameters = [one for one in signature.parameters.values() if one.kind != one.VAR_KEYWORD]
        known = {one.name for one in parameters}
        parameters += [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=_table.ROWS[name].fallback)
                       for name in names if name not in known]
        function.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        function.__doc__ = re.sub("^    <(.*)>$", lambda group: _table.DOCUMENTS[group[1]], function.__doc__ or "",
                                  flags=re.MULTILINE)
        return function
    return with_options


def make_options(target_reduction: Optional[float] = None, **given: Any) -> _table.Options:
    """Converts options by their names in simplify()."""
    options = _table.Options()
    for name, value in given.items():
        if value is not None:
            setattr(options, name, _read(name, value))
    if target_reduction is not None:
        options.ratio = _ratio_left(target_reduction, given)
    if options.ratio is not None and not 0 <= options.ratio <= 1:
        raise ValueError(f"ratio is {given['ratio']!r}, not in [0, 1]: it is the fraction of the faces to keep")
    return options


def _read(name: str, value: Any) -> Any:
    row = _table.ROWS[name]
    if row.words is not None:
        return choice(name, value, row.words.__members__)
    return {"count": read_count, "number": read_number, "flag": lambda _, flag: bool(flag)}[row.kind](name, value)


def read_arrays(options: _table.Options, given: Dict[str, Any], points: int, faces: int) -> None:
    """Sets the options that have a value for each point or triangle."""
    for name, values in given.items():
        if values is None:
            continue
        kind = _table.ROWS[name].kind
        if kind == "point_numbers":
            array: Any = _arrays.factors(name, values, points)
        elif kind == "point_flags":
            array = _arrays.mask(name, values, points)
        else:
            array = _arrays.mask(name, values, faces, "triangle")
        setattr(options, name, array)


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


def _ratio_left(target_reduction: Any, options: Dict[str, Any]) -> float:
    given = [name for name in ("faces", "ratio", "vertices", "error", "relative_error") if options.get(name) is not None]
    if given:
        raise ValueError(f"target_reduction and {given[0]} do not go together: both are targets")
    number = read_number("target_reduction", target_reduction)
    if not 0 < number < 1:
        raise ValueError(f"target_reduction is {number}, not in (0, 1): it is the fraction of the "
                         "faces to remove")
    return 1 - number
