"""What is said of a target that was missed."""

from __future__ import annotations

import warnings
from typing import Any, List, Optional

import numpy as np

from . import _core
from ._forms import Array

_HINTS = {
    "constraint": "points that are fixed, or beside triangles that are not selected, stay",
    "normal flip": "faces would turn over, which normal_flip=180 allows",
    "normal deviation": "normal_deviation allows no more",
    "distance": "error, relative_error or tolerance allows no more",
    "seam": "borders of labels stay, and so do seams of a Channel with seams='kept'; seams='soft' lets them "
            "vanish where that shows little",
    "texture": "faces would turn over in the texture",
    "hull": "no place is left that a hull allows",
    "volume": "no place is left that keeps the volume",
    "filter": "the filter refused",
    "self-intersection": "faces would intersect",
}


def warn_if_missed(report: _core.Report, options: _core.Options, points: Optional[Array],
                   stop: Optional[Any], stacklevel: int, has_tolerance: bool = False) -> None:
    """One UserWarning with the reason, and what helps. Nothing where it was ended on purpose."""
    if report.is_target_reached or report.stop == "cancelled":
        return
    hints = _hints(report, options, points)
    text = (f"the target is missed: {report.faces_after} of {report.faces_before} faces are left, where "
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
        hints.append(f"{doubled} points lie exactly where another one does, and faces that only meet there are not "
                     "joined: split_vertices=True takes such points as one")
    elif report.components_after > 1 and not is_free:
        ways = ["pairs_closer_than= joins parts"]
        if options.topology != _core.Topology.parts_may_vanish:
            ways.insert(0, "topology='parts_may_vanish' lets small ones go")
        hints.append(f"{report.components_after} parts are left, and each keeps some faces: {', '.join(ways)}")
    elif report.rejections.get("topology", 0) > 0 and not is_free:
        hints.append("the topology is kept: topology='free' lets holes close and thin parts become sheets")
    least = sum(report.rejections.values()) / 100  # what is rarer is not in the way
    hints += [f"{hint} ({report.rejections[cause]} contractions)" for cause, hint in _HINTS.items()
              if report.rejections.get(cause, 0) > least]
    return hints


def _doubled(points: Array) -> int:
    return len(points) - len(np.unique(points + 0.0, axis=0))  # -0 is 0
