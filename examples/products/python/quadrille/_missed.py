"""The warning about a missed target."""

from __future__ import annotations

import warnings
from typing import Any, List, Optional

import numpy as np

from . import _core
from ._forms import Array

_HINTS = {
    "constraint": "fixed points, and points of triangles that are not selected, stay in place",
    "normal flip": "faces would turn over; normal_flip=180 allows it",
    "normal deviation": "normal_deviation does not allow more",
    "distance": "error, relative_error or tolerance does not allow more",
    "seam": "boundaries of labels stay, and so do seams of a Channel with seams='kept'; seams='soft' removes "
            "seams where this is hardly visible",
    "texture": "faces would turn over in the texture",
    "hull": "the hull allows no other placement",
    "volume": "no placement keeps the volume",
    "filter": "the filter returned False",
    "self-intersection": "faces would intersect",
}


def warn_if_missed(report: _core.Report, options: _core.Options, points: Optional[Array],
                   stop: Optional[Any], stacklevel: int, has_tolerance: bool = False) -> None:
    """Issues one UserWarning with the reason and what helps, unless the run was cancelled."""
    if report.is_target_reached or report.stop == "cancelled":
        return
    hints = _hints(report, options, points)
    text = (f"the target was not reached: {report.faces_after} of {report.faces_before} faces are left, but "
            f"{_asked(options, stop, has_tolerance)} asked for ({report.stop})")
    warnings.warn("; ".join([text, *hints]), stacklevel=stacklevel + 1)


def _asked(options: _core.Options, stop: Optional[Any], has_tolerance: bool) -> str:
    asked = [f"{name}={value!r}" for name in ("faces", "vertices", "ratio", "error", "relative_error")
             for value in [getattr(options, name)] if value is not None]
    asked += ["a tolerance"] if options.tolerance or has_tolerance else []
    asked += ["stop"] if stop is not None else []
    return f"{' or '.join(asked)} was" if asked else "half of them were"


def _hints(report: _core.Report, options: _core.Options, points: Optional[Array]) -> List[str]:
    hints: List[str] = []
    is_free = options.topology == _core.Topology.free or (options.topology is None and options.pairs_closer_than is not None)
    doubled = 0 if points is None or options.split_vertices else _doubled(points)
    if doubled > 0:
        hints.append(f"{doubled} points coincide with another one, and faces that only meet there are not connected: "
                     "split_vertices=True treats such points as one")
    elif report.components_after > 1 and not is_free:
        ways = ["pairs_closer_than= joins components"]
        if options.topology != _core.Topology.components_may_vanish:
            ways.insert(0, "topology='components_may_vanish' removes small ones")
        hints.append(f"{report.components_after} components are left, and each keeps some faces: {', '.join(ways)}")
    elif report.rejections.get("topology", 0) > 0 and not is_free:
        hints.append("the topology is kept: topology='free' lets holes close and thin features collapse")
    least = sum(report.rejections.values()) / 100  # what is rarer is not in the way
    hints += [f"{hint} ({report.rejections[cause]} contractions)" for cause, hint in _HINTS.items()
              if report.rejections.get(cause, 0) > least]
    return hints


def _doubled(points: Array) -> int:
    return len(points) - len(np.unique(points + 0.0, axis=0))  # -0 is 0
