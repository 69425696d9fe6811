"""What the other files of the package call, by functions of C: see _library.py."""

from __future__ import annotations

import ctypes
import enum
import json
import math
import sys
import time
from ctypes import POINTER, Structure, byref, c_char_p, c_double, c_int32, c_int64, c_size_t, c_void_p, string_at
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

import numpy as np

from . import _library
from ._forms import Array
from ._table import ChannelOptions, Cost, NewValues, Options, Order, Placement, Preset, Seams, Topology, Weighting
from ._library import (PART_FUNCTION, Bag, CArray, CContraction, CFileStatus, CLevelInfo, CPair, CStatus, array_of,
                       declare, guarded, raise_error, text_in, text_of, texts_in, view_of)

_ARRAY = POINTER(CArray)
_call_new = declare("quadrille_call_new", c_void_p)
_call_delete = declare("quadrille_call_delete", None, c_void_p)
_error = declare("quadrille_error", c_char_p, c_void_p)
_set_array = declare("quadrille_set_array", c_int32, c_void_p, c_char_p, _ARRAY)
_set_double = declare("quadrille_set_unchecked", c_int32, c_void_p, c_int64, c_char_p, c_double)
_set_text = declare("quadrille_set_text", c_int32, c_void_p, c_char_p, c_char_p)
_add_channel = declare("quadrille_add_channel", c_int32, c_void_p, c_char_p, _ARRAY, _ARRAY)
_set_channel_text = declare("quadrille_set_channel_text", c_int32, c_void_p, c_size_t, c_char_p, c_char_p)
_set_channel_array = declare("quadrille_set_channel_array", c_int32, c_void_p, c_size_t, c_char_p, _ARRAY)
_set_levels = declare("quadrille_set_levels", None, c_void_p, c_void_p)
_simplify = declare("quadrille_simplify", c_int32, c_void_p)
_result = declare("quadrille_result", c_int32, c_void_p, c_char_p, c_size_t, _ARRAY)
_report = declare("quadrille_report", c_char_p, c_void_p)
_report_text = declare("quadrille_report_text", c_char_p, c_void_p)
_levels_new = declare("quadrille_levels_new", c_void_p)
_levels_copy = declare("quadrille_levels_copy", c_void_p, c_void_p)
_levels_delete = declare("quadrille_levels_delete", None, c_void_p)
_levels_error = declare("quadrille_levels_error", c_char_p, c_void_p)
_levels_empty = declare("quadrille_levels_empty", c_int32, c_void_p)
_levels_save = declare("quadrille_levels_save", c_int32, c_void_p, c_char_p, c_char_p)
_levels_load = declare("quadrille_levels_load", c_int32, c_void_p, c_char_p)
_levels_comment = declare("quadrille_levels_comment", c_char_p, c_void_p)
_levels_info = declare("quadrille_levels_info", c_int32, c_void_p, c_char_p, c_double, POINTER(CLevelInfo), c_char_p,
                       c_size_t)
_levels_at = declare("quadrille_levels_at", c_int32, c_void_p, c_char_p, c_double, POINTER(c_void_p), c_char_p,
                     c_size_t)
_level_delete = declare("quadrille_level_delete", None, c_void_p)
_level_figures = declare("quadrille_level_figures", CLevelInfo, c_void_p)
_level_channels = declare("quadrille_level_channels", c_size_t, c_void_p)
_level_array = declare("quadrille_level_array", c_int32, c_void_p, c_char_p, c_size_t, _ARRAY)
_levels_splits = declare("quadrille_levels_splits", c_int32, c_void_p, POINTER(c_void_p), c_char_p, c_size_t)
_splits_delete = declare("quadrille_splits_delete", None, c_void_p)
_splits_array = declare("quadrille_splits_array", c_int32, c_void_p, c_char_p, _ARRAY)
_functions_delete = declare("quadrille_functions_delete", None, c_void_p)
_job_delete = declare("quadrille_file_job_delete", None, c_void_p)

version: str = declare("quadrille_version", c_char_p)().decode()
has_threads: bool = declare("quadrille_has_threads", c_int32)() != 0


def _words(name: str, *words: str) -> Any:
    """An enumeration, whose members are the words of an option."""
    return enum.Enum(name, {word: number for number, word in enumerate(words)}, module=__name__)


Way = _words("Way", "compiled", "calibrated", "outer_hull", "inner_hull", "same_volume")
Kind = _words("Kind", "texture", "normals", "colors", "attributes")
_DEFAULTS = {name: value for name, value in vars(Options).items() if not name.startswith("_")}


class Status(CStatus):
    """The argument of a progress function."""


class Pair(CPair):
    """The argument of a cost function: two points that may be contracted to one."""

    @property
    def first(self) -> Array:
        """Its current position, of the shape (3,)."""
        return np.frombuffer(self, np.float64, 3, 16)

    @property
    def second(self) -> Array:
        return np.frombuffer(self, np.float64, 3, 40)

    @property
    def target(self) -> Array:
        """The position of the new point."""
        return np.frombuffer(self, np.float64, 3, 64)


# The numbers of a quadrille_changed_face, after its index, that are its corners.
_CORNERS_BEFORE, _CORNERS_AFTER = (np.array([*moving, *range(7, 13)]) for moving in (range(1, 4), range(4, 7)))


class Contraction(CContraction):
    """The argument of a filter: the next contraction."""

    _kept: Optional[Tuple[bytes, bytes]] = None

    def _keep(self) -> None:
        """Copies the faces that change and those that go, which the library lends until the filter answers."""
        self._kept = self._changed(), self._removed()

    def _changed(self) -> bytes:
        return self._kept[0] if self._kept else string_at(self._faces, 104 * self._face_count)

    def _removed(self) -> bytes:
        return self._kept[1] if self._kept else string_at(self._removed_faces, 8 * self._removed_face_count)

    @property
    def target(self) -> Array:
        """The position of the new point, of the shape (3,)."""
        return np.frombuffer(self, np.float64, 3, 16)

    @property
    def faces(self) -> Array:
        """The faces that change, as indices of the input's."""
        return np.frombuffer(self._changed(), np.int64)[::13].copy()

    @property
    def before(self) -> Array:
        """Their current corners, of the shape (faces, 3, 3), the moving corner first."""
        return self._corners(_CORNERS_BEFORE)

    @property
    def after(self) -> Array:
        """Their corners after the contraction."""
        return self._corners(_CORNERS_AFTER)

    def _corners(self, columns: Array) -> Array:
        return np.frombuffer(self._changed()).reshape(-1, 13).take(columns, 1).reshape(-1, 3, 3)

    @property
    def removed_faces(self) -> Array:
        """The faces that are removed, as indices of the input's."""
        return np.frombuffer(self._removed(), np.int64).copy()


_COUNTS = ("faces_before", "counted_faces", "faces_after", "vertices_before", "vertices_after", "contractions",
           "non_edge_contractions", "components_before", "components_after", "vanished_components",
           "joined_gaps", "open_gaps", "cut_handles",
           "split_components", "split_vertices", "split_edges", "kept_planes", "non_manifold_edges",
           "non_manifold_vertices", "duplicated_vertices", "doubled_faces", "doubled_labels")
_REALS = ("largest_vanished_component", "cut_distance", "error")
_BOUNDS = ("distance_bound", "hausdorff_bound")  # infinite where JSON has null
_UNKNOWN = ("volume_before", "volume_after", "normal_bound_degrees")  # or a number
_STAGES = ("read", "prepare", "contract", "write")
_STOPS = ("target met", "target passed", "no pair left", "all pairs rejected", "target unreachable", "cancelled")
_CAUSES = ("topology", "constraint", "normal flip", "shape", "degree", "distance", "position", "destruction", "seam",
           "texture", "hull", "volume", "filter", "self-intersection", "normal deviation", "chord")
_MEMBERS = ("faces_before", "counted_faces", "faces_after", "vertices_before", "vertices_after", "contractions",
            "non_edge_contractions", "components_before", "components_after", "vanished_components",
            "largest_vanished_component", "joined_gaps", "open_gaps", "cut_handles", "split_components",
            "cut_distance", "split_vertices",
            "split_edges", "kept_planes", "non_manifold_edges", "non_manifold_vertices", "duplicated_vertices",
            "doubled_faces", "doubled_labels", "stop", "is_target_reached", "error", "distance_bound",
            "hausdorff_bound", "used_tolerance", "volume_before", "volume_after", "self_intersections",
            "normal_bound_degrees", "rejections", "seconds")


class Report:
    """What simplify() did. str(report) is one line."""

    def __init__(self, members: Any):
        self._given = members  # a dict of all figures, or bytes of JSON, which are parsed once somebody asks

    @property
    def _members(self) -> Dict[str, Any]:
        if isinstance(self._given, bytes):
            self._given = json.loads(self._given)
        return self._given  # type: ignore[no-any-return]

    @property
    def is_target_reached(self) -> bool:
        if isinstance(self._given, bytes):  # each call asks this
            return b'"is_target_reached": true' in self._given
        return self._given["is_target_reached"]  # type: ignore[no-any-return]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._members:
            raise AttributeError(f"a Report has no {name}")
        value = self._members[name]
        if name in _BOUNDS and value is None:
            return math.inf
        return dict(value) if name == "rejections" else value

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *self._members]

    @property
    def used_tolerance(self) -> Optional[Tuple[float, List[float]]]:
        """The largest fraction of its tolerance that a triangle may have used, and the centre of that triangle in the
        result; None without tolerance."""
        used = self._members["used_tolerance"]
        return None if used is None else (used[0], list(used[1]))

    @property
    def seconds(self) -> float:
        """The duration of the call."""
        seconds = self._members["seconds"]
        return seconds["read"] + seconds["prepare"] + seconds["contract"] + seconds["write"]  # type: ignore[no-any-return]

    def to_dict(self) -> Dict[str, Any]:
        """Returns all figures by name, as values that JSON can represent: an infinite bound is None, and seconds are given
        by phase."""
        members = dict(self._members)
        members["rejections"], members["seconds"] = dict(members["rejections"]), dict(members["seconds"])
        members["used_tolerance"] = self.used_tolerance
        return members

    @staticmethod
    def from_dict(members: Any) -> Report:
        """Returns the report that to_dict() has converted."""
        return Report({name: _member(members, name) for name in _MEMBERS})

    def to_json(self) -> str:
        """Returns to_dict() as a JSON str."""
        return json.dumps(self.to_dict())

    @staticmethod
    def from_json(text: str) -> Report:
        """Returns the report that to_json() has converted."""
        return Report.from_dict(json.loads(text))

    def keys(self) -> Any:
        return self.to_dict().keys()

    def __getitem__(self, name: str) -> Any:
        return self.to_dict()[name]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Report) and self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __getstate__(self) -> Dict[str, Any]:
        return self.to_dict()

    def __setstate__(self, state: Any) -> None:
        self._given = Report.from_dict(state)._given

    def __repr__(self) -> str:
        return f"<quadrille.Report: {self}>"

    def __str__(self) -> str:
        return _line_of(self)


def _line_of(r: Report) -> str:
    """The words in which Report of the library prints itself."""
    parts = [f"{r.faces_before} -> {r.faces_after} faces", f"{r.vertices_before} -> {r.vertices_after} vertices",
             f"{r.contractions} contractions", f"stopped: {r.stop}", f"error {r.error:g}"]

    def add(is_told: Any, text: Callable[[], str]) -> None:
        if is_told:
            parts.append(text())

    add(r.distance_bound < math.inf, lambda: f"within {r.distance_bound:g} of the input")
    add(r.hausdorff_bound < math.inf, lambda: f"{r.hausdorff_bound:g} both ways")
    add(r.used_tolerance, lambda: f"{r._members['used_tolerance'][0]:g} of the tolerance used")
    add(r.volume_before is not None and r.volume_after is not None,
        lambda: f"volume {r.volume_before:g} -> {r.volume_after:g}")
    add(r.self_intersections, lambda: "self-intersections {} -> {}".format(*r.self_intersections))
    add(r.normal_bound_degrees is not None, lambda: f"normals within {r.normal_bound_degrees:g} degrees")
    add(r.non_edge_contractions, lambda: f"{r.non_edge_contractions} contractions without an edge")
    add(r.components_before != r.components_after,
        lambda: f"{r.components_before} -> {r.components_after} components")
    add(r.vanished_components,
        lambda: f"{r.vanished_components} components vanished, of sizes up to {r.largest_vanished_component:g}")
    add(r.joined_gaps, lambda: f"{r.joined_gaps} gaps joined")
    add(r.open_gaps, lambda: f"{r.open_gaps} gaps left open")
    add(r.cut_handles, lambda: f"{r.cut_handles} handles cut")
    add(r.split_components, lambda: f"{r.split_components} components cut in two")
    add(r.cut_distance, lambda: f"cuts closed within {r.cut_distance:g} of the input")
    add(r.split_vertices, lambda: f"{r.split_vertices} vertices split")
    add(r.split_edges, lambda: f"{r.split_edges} edges split")
    add(r.kept_planes, lambda: f"{r.kept_planes} plane regions kept")
    add(r.non_manifold_edges + r.non_manifold_vertices,
        lambda: f"{r.non_manifold_edges} non-manifold edges, {r.non_manifold_vertices} non-manifold vertices")
    add(r.doubled_faces, lambda: f"{r.doubled_faces} duplicate faces left out")
    add(r.doubled_labels, lambda: f"{r.doubled_labels} duplicate faces with other labels")
    rejections = r.rejections
    add(rejections, lambda: "rejected: " + ", ".join(f"{rejections[c]} {c}" for c in _CAUSES if c in rejections))
    return ", ".join([*parts, f"{r.seconds:g} s"])


def _member(members: Any, name: str) -> Any:
    """What a dict of a report has by a name. Raises ValueError if that is missing, or something else."""
    if name == "is_target_reached":
        return _member(members, "stop") in ("target met", "target passed")
    if name not in members:
        raise ValueError(f"not a report: it has no {name}")
    value = members[name]
    known = {"stop": _STOPS, "rejections": _CAUSES}.get(name, ())
    words = [value] if name == "stop" else list(value) if name == "rejections" and isinstance(value, dict) else []
    for word in words:
        if isinstance(word, str) and word not in known:
            raise ValueError(f"not a report: it has the unknown name '{word}'")
    if name == "seconds" and isinstance(value, dict):
        for stage in _STAGES:
            if stage not in value:
                raise ValueError(f"not a report: it has no {stage}")
    if not _is_member(name, value):
        raise ValueError(f"not a report: its {name} is {value!r}")
    return value


def _is_member(name: str, value: Any) -> bool:
    def is_count(x: Any) -> bool:
        return isinstance(x, int) and not isinstance(x, bool) and x >= 0

    def is_real(x: Any) -> bool:
        return isinstance(x, (int, float)) and not isinstance(x, bool)

    if name in _COUNTS:
        return is_count(value)
    if name in _REALS:
        return is_real(value)
    if name in _BOUNDS or name in _UNKNOWN:
        return value is None or is_real(value)
    if name == "stop":
        return isinstance(value, str)
    if name == "rejections":
        return isinstance(value, dict) and all(is_count(count) for count in value.values())
    if name == "seconds":
        return isinstance(value, dict) and all(is_real(value.get(stage)) for stage in _STAGES)
    if name == "self_intersections":
        return value is None or (len(value) == 2 and all(map(is_count, value)))
    return value is None or (len(value) == 2 and is_real(value[0]) and len(value[1]) == 3)


# --- Functions of the user's


class _Asked(Structure):
    """quadrille_asked"""

    PROGRESS = ctypes.CFUNCTYPE(c_int32, Status)
    FILTER = ctypes.CFUNCTYPE(c_int32, Contraction)
    COST = ctypes.CFUNCTYPE(c_double, Pair)
    _fields_ = [("progress", PROGRESS), ("stop", PROGRESS), ("filter", FILTER), ("cost", COST)]


_functions_new = declare("quadrille_functions_new", c_void_p, c_void_p, POINTER(_Asked))


def _proceeds(progress: Optional[Callable[[Any], Any]]) -> Callable[[Any], int]:
    """The answer of a progress function, in which None is yes. Signals are handled when it is asked."""
    if progress is None:
        return lambda status: 1

    def proceeds(status: Any) -> int:
        answer = progress(status)
        return 1 if answer is None or bool(answer) else 0

    return proceeds


def _truth(name: str, function: Callable[[Any], Any]) -> Callable[[Any], int]:
    def truth(told: Any) -> int:
        answer = function(told)
        if answer is None:  # a forgotten return
            raise ValueError(f"{name} returned None instead of True or False")
        return 1 if answer else 0

    return truth


def _allows(function: Callable[[Any], Any]) -> Callable[[Any], int]:
    def allows(contraction: Contraction) -> int:
        references = sys.getrefcount(contraction)
        answer = function(contraction)
        if sys.getrefcount(contraction) > references:  # the function keeps it for later
            contraction._keep()
        if answer is None:
            raise ValueError("filter returned None instead of True or False")
        return 1 if answer else 0

    return allows


def _number(function: Callable[[Any], Any]) -> Callable[[Any], float]:
    def number(pair: Any) -> float:
        answer = function(pair)
        try:
            if 0 <= answer < math.inf:
                return float(answer)
        except (TypeError, ValueError):
            raise ValueError(f"cost returned {answer!r}, not a number") from None
        raise ValueError(f"cost returned {answer!r}, which is negative or not finite")

    return number


class _Functions:
    """Functions of the user's as those of a call, and what they have raised."""

    def __init__(self, call: int, progress: Any, stop: Any = None, filter: Any = None, cost: Any = None):
        self.caught: List[BaseException] = []
        asked = _Asked(progress=guarded(_Asked.PROGRESS, _proceeds(progress), -1, self.caught))
        if stop is not None:
            asked.stop = guarded(_Asked.PROGRESS, _truth("stop", stop), -1, self.caught)
        if filter is not None:
            asked.filter = guarded(_Asked.FILTER, _allows(filter), -1, self.caught)
        if cost is not None:
            asked.cost = guarded(_Asked.COST, _number(cost), -1.0, self.caught)
        self._kept = asked
        self._handle = _functions_new(call, byref(asked))
        if not self._handle:
            raise MemoryError

    def __del__(self) -> None:
        _functions_delete(self._handle)


# --- Calls


class _Call:
    """quadrille_call"""

    def __init__(self) -> None:
        self.handle = _call_new()
        if not self.handle:
            raise MemoryError
        self.kept: List[Any] = []  # arrays, until it has run

    def __del__(self) -> None:
        _call_delete(self.handle)

    def check(self, code: int, caught: Any = ()) -> None:
        if code != 0 or caught:
            raise_error(code, text_of(_error(self.handle)), caught)

    def view(self, array: Array) -> Any:
        self.kept.append(array)
        return byref(view_of(array))

    def set_options(self, options: Options) -> None:
        for name, value in vars(options).items():
            is_array = isinstance(value, (list, np.ndarray))
            if value is None or (len(value) == 0 if is_array else value == _DEFAULTS[name]):
                continue
            key = name.encode()
            if isinstance(value, enum.Enum):
                self.check(_set_text(self.handle, key, value.name.encode()))
            elif is_array:
                array = np.asarray(value)
                array = array.view(np.uint8) if array.dtype == bool else array.astype(np.float64, copy=False)
                self.check(_set_array(self.handle, key, self.view(array)))
            else:
                self.check(_set_double(self.handle, -1, key, value))

    def add_channel(self, index: int, kind: Any, values: Array, corners: Optional[Array],
                    options: ChannelOptions) -> None:
        corner_view = None if corners is None else self.view(corners)
        self.check(_add_channel(self.handle, kind.name.encode(), self.view(values), corner_view))
        for name, value in vars(options).items():
            key = name.encode()
            if isinstance(value, enum.Enum):
                self.check(_set_channel_text(self.handle, index, key, value.name.encode()))
            elif isinstance(value, (list, tuple)):
                if len(value) > 0:
                    array = np.array(value, np.float64)
                    self.check(_set_channel_array(self.handle, index, key, self.view(array)))
            elif value is not None:
                self.check(_set_double(self.handle, index, key, value))

    def result(self, name: str, channel: int = 0) -> Array:
        view = CArray()
        self.check(_result(self.handle, name.encode(), channel, byref(view)))
        return array_of(view, self, view.columns == 1 and name not in ("values", "points"))

    def report(self) -> Report:
        return Report(_report(self.handle))


Channel = Tuple[Any, Array, Optional[Array], ChannelOptions]


def simplify(points: Array, faces: Array, labels: Optional[Array], channels: Any, options: Options,
             levels: Optional[Levels], progress: Any, way: Any, cost: Any, filter: Any, stop: Any) -> Dict[str, Any]:
    call = _Call()
    call.check(_set_array(call.handle, b"points", call.view(points)))
    call.check(_set_array(call.handle, b"triangles", call.view(faces)))
    if labels is not None:
        call.check(_set_array(call.handle, b"labels", call.view(labels)))
    for index, channel in enumerate(channels):
        call.add_channel(index, *channel)
    call.set_options(options)
    if way in (Way.outer_hull, Way.inner_hull):
        call.check(_set_text(call.handle, b"hull", way.name[:5].encode()))
    elif way in (Way.same_volume, Way.calibrated):
        call.check(_set_double(call.handle, -1, b"keep_volume" if way == Way.same_volume else b"calibrated", 1))
    functions = _Functions(call.handle, progress, stop, filter, cost)
    code = _simplify(call.handle) if levels is None else levels._record(call)
    call.check(code, functions.caught)
    call.kept.clear()
    result: Dict[str, Any] = {name: call.result(name) for name in ("points", "input_faces", "vertex_map")}
    result["faces"] = call.result("triangles")
    result["labels"] = None if labels is None else call.result("labels")
    result["channels"] = [(call.result("values", i), call.result("corners", i)) for i in range(len(channels))]
    result["report"] = call.report()
    if options.maps:
        for name in ("old_to_new", "new_to_old"):
            result[name] = [call.result(f"{name}_{part}") for part in ("begins", "indices", "weights")]
    return result


# --- Levels


class Levels:
    """quadrille_levels, shared by threads of Python: several may read at a time. To read while a call records, or to record
    while a thread reads, is a ValueError."""

    def __init__(self, handle: Optional[int] = None) -> None:
        self._handle = handle or _levels_new()
        if not self._handle:
            raise MemoryError
        self._readers, self._is_recorded = 0, False

    def __del__(self) -> None:
        _levels_delete(self._handle)

    def _record(self, call: _Call) -> int:
        if self._is_recorded or self._readers > 0:
            raise ValueError("these Levels are being " + ("recorded by another call of simplify()"
                                                          if self._is_recorded else "read by another thread"))
        self._is_recorded = True
        try:
            _set_levels(call.handle, self._handle)
            return _simplify(call.handle)  # type: ignore[no-any-return]
        finally:
            self._is_recorded = False

    def _read(self, function: Callable[..., int], *arguments: Any) -> None:
        """Calls a function of the library whose last arguments are room for an error."""
        if self._is_recorded:
            raise ValueError("these Levels are being recorded by another call of simplify()")
        error = ctypes.create_string_buffer(1000)
        self._readers += 1
        try:
            code = function(self._handle, *arguments, error, len(error))
        finally:
            self._readers -= 1
        if code != 0:
            raise_error(code, text_of(error.value))

    def copy(self) -> Levels:
        if self._is_recorded:
            raise ValueError("these Levels are being recorded by another call of simplify()")
        handle = _levels_copy(self._handle)
        if not handle:
            raise MemoryError
        return Levels(handle)

    def empty(self) -> bool:
        if self._is_recorded:
            raise ValueError("these Levels are being recorded by another call of simplify()")
        return _levels_empty(self._handle) != 0

    def info(self, stop: str, number: float) -> Dict[str, Any]:
        info = CLevelInfo()
        self._read(_levels_info, stop.encode(), number, byref(info))
        return _dict_of(info)

    def finest(self) -> Dict[str, Any]:
        return self.info("finest", 0)

    def coarsest(self) -> Dict[str, Any]:
        return self.info("coarsest", 0)

    def at(self, stop: str, number: float) -> Dict[str, Any]:
        made = c_void_p()
        self._read(_levels_at, stop.encode(), number, byref(made))
        return _LevelHandle(made).arrays()

    def save(self, path: str, comment: str) -> None:
        def write(handle: int, *_: Any) -> int:
            return _levels_save(handle, _library._bytes_of(path), comment.encode())  # type: ignore[no-any-return]

        try:
            self._read(write)
        except Exception as error:
            raise type(error)(text_of(_levels_error(self._handle))) from None


    def splits(self) -> Dict[str, Array]:
        made = c_void_p()
        self._read(_levels_splits, byref(made))
        return _SplitsHandle(made).arrays()


def _dict_of(info: CLevelInfo) -> Dict[str, Any]:
    return {name: getattr(info, name) for name, _ in CLevelInfo._fields_}


class _LevelHandle:
    """quadrille_level"""

    def __init__(self, handle: c_void_p):
        self._handle = handle

    def __del__(self) -> None:
        _level_delete(self._handle)

    def _array(self, name: str, channel: int = 0) -> Array:
        view = CArray()
        _level_array(self._handle, name.encode(), channel, byref(view))
        return array_of(view, self, name.startswith("input_"))

    def arrays(self) -> Dict[str, Any]:
        result: Dict[str, Any] = {name: self._array(name) for name in ("points", "input_points", "input_faces")}
        result["info"], result["faces"] = _dict_of(_level_figures(self._handle)), self._array("triangles")
        result["channels"] = []
        for channel in range(_level_channels(self._handle)):
            corners = self._array("corners", channel)
            has_corners = len(corners) > 0 or len(result["faces"]) == 0
            result["channels"].append((self._array("values", channel), corners if has_corners else None))
        return result


class _SplitsHandle:
    """quadrille_splits"""

    def __init__(self, handle: c_void_p):
        self._handle = handle

    def __del__(self) -> None:
        _splits_delete(self._handle)

    def arrays(self) -> Dict[str, Array]:
        result: Dict[str, Array] = {}
        for name in ("points", "faces", "input_points", "input_faces", "point_counts", "face_counts", "errors",
                     "parents", "children", "merged_points", "parent_points", "corner_begins", "corners"):
            view = CArray()
            _splits_array(self._handle, name.encode(), byref(view))
            result[name] = array_of(view, self, view.columns == 1)
        return result


def load_levels(path: str) -> Tuple[Levels, str]:
    levels = Levels()
    code = _levels_load(levels._handle, _library._bytes_of(path))
    raise_error(code, text_of(_levels_error(levels._handle)))
    return levels, text_of(_levels_comment(levels._handle))


# --- Files


class MeshFile:
    """What a file of a mesh holds. It is constant."""

    def __init__(self, taken: Dict[str, Any]):
        self._source = {name: array for name, array in taken.items() if name.startswith("source.")}
        self.points, self.faces, self.vertex_uv = taken["points"], taken["faces"], taken["vertex_uv"].reshape(-1, 2)
        self.uv, self.normals = (None if name not in taken else (taken[name], taken[f"{name}.indices"])
                                 for name in ("uv", "normals"))
        unit = taken.get("colors.unit")
        self.colors = None if unit is None else (taken["colors"], float(unit[0]), bool(unit[1]))
        self.labels = taken.get("labels")
        names, types = texts_in(taken, "vertex_numbers"), texts_in(taken, "vertex_numbers.types")
        self.vertex_numbers = [(name, taken[f"vertex_numbers.{i}"], types[i]) for i, name in enumerate(names)]
        self.remarks = texts_in(taken, "remarks")

    def __deepcopy__(self, memo: Any) -> MeshFile:
        return self

    def __getstate__(self) -> Any:
        """What write_mesh() takes; the rest is in arrays of a Mesh by then."""
        return {name: array.copy() for name, array in self._source.items()}

    def __setstate__(self, state: Any) -> None:
        self._source = state


class WrittenArrays:
    """What is written to a file."""

    def __init__(self, points: Array, faces: Array) -> None:
        self.points, self.faces = points, faces
        self.uv: Optional[Tuple[Array, Array]] = None
        self.normals: Optional[Tuple[Array, Array]] = None
        self.colors: Optional[Tuple[Array, float, bool]] = None
        self.has_alpha = False
        self.vertex_numbers: List[Tuple[str, Array, str]] = []


def read_mesh(path: str, welds: bool) -> Tuple[MeshFile, bool]:
    taken = dict(Bag(path=path, welds=welds).do("read_mesh"))
    return MeshFile(taken), bool(taken["is_split"][0])


def write_mesh(path: str, arrays: WrittenArrays, source: Optional[MeshFile], faces: Optional[Array]) -> str:
    bag = Bag(path=path, points=arrays.points, faces=arrays.faces)
    for name, corners in (("uv", arrays.uv), ("normals", arrays.normals)):
        if corners is not None:
            bag.put(name, corners[0])
            bag.put(f"{name}.indices", corners[1])
    if arrays.colors is not None:
        values, full, is_whole = arrays.colors
        bag.put("colors", values)
        bag.put("colors.unit", np.array([full, is_whole, arrays.has_alpha], np.float64))
    bag.put("vertex_numbers", [name for name, _, _ in arrays.vertex_numbers])
    bag.put("vertex_numbers.types", [dtype for _, _, dtype in arrays.vertex_numbers])
    for i, (_, values, _) in enumerate(arrays.vertex_numbers):
        bag.put(f"vertex_numbers.{i}", values)
    if source is not None and faces is not None:
        for name, array in source._source.items():
            bag.put(name, array.astype(np.uint64) if name.endswith(".ends") else np.ascontiguousarray(array))
        bag.put("source.faces", faces)
    return text_in(bag.do("write_mesh"), "losses")


def simplify_gltf(source: str, target: str, options: Options, seams: Any, labels: Any, stop: Any,
                  progress: Any) -> Tuple[Report, List[str]]:
    call = _Call()
    call.set_options(options)
    functions = _Functions(call.handle, progress, stop)
    bag = Bag(source=source, target=target, labels=sorted(labels), seams=None if seams is None else seams.value)
    taken = bag.do("simplify_gltf", call.handle, None, functions.caught)
    return Report(json.loads(text_in(taken, "report"))), texts_in(taken, "remarks")


# --- Measures


class Claims:
    distance: Optional[float] = None
    distance_both_ways: Optional[float] = None
    tolerances: Any = ()
    no_self_intersection = False
    solid = False
    normal_deviation: Optional[float] = None
    vertex_map: Any = ()


def surface_distance(a: Array, faces_a: Array, b: Array, faces_b: Array, samples: int, seed: int) -> Tuple[float, ...]:
    counts = np.array([samples, seed], np.uint64)
    return tuple(Bag(a=a, faces_a=faces_a, b=b, faces_b=faces_b, counts=counts)
                 .do("surface_distance")["distance"].tolist())


def verify(mesh: Array, faces: Array, result: Array, result_faces: Array, claims: Claims,
           progress: Any) -> Tuple[List[Any], bool]:
    bag = Bag(points=mesh, faces=faces, new_points=result, new_faces=result_faces, distance=claims.distance,
              distance_both_ways=claims.distance_both_ways, normal_deviation=claims.normal_deviation,
              no_self_intersection=claims.no_self_intersection, solid=claims.solid)
    if len(claims.tolerances) > 0:
        bag.put("tolerances", np.asarray(claims.tolerances, np.float64))
    if len(claims.vertex_map) > 0:
        bag.put("images", np.asarray(claims.vertex_map, np.uint64))
    caught: List[BaseException] = []
    asked = guarded(PART_FUNCTION, _at_times(_proceeds(progress)), -1, caught)
    taken = bag.do("verify", None, asked, caught)
    rows = [(name, *row[:3], row[3] != 0, None if math.isnan(row[4]) else row[4:])
            for name, row in zip(texts_in(taken, "claims"), taken["findings"].tolist())]
    return rows, bool(taken["is_cancelled"][0])


def _at_times(proceeds: Callable[[float], int]) -> Callable[[float], int]:
    """Asks up to 25 times a second, and at the end."""
    last = -math.inf

    def ask(part: float) -> int:
        nonlocal last
        now = time.monotonic()
        if now - last < 0.04 and part < 1:
            return 1
        last = now
        return proceeds(part)

    return ask


def hidden_faces(points: Array, faces: Array, directions: int, front_only: bool, threads: int, threshold: float,
                 progress: Any) -> Tuple[Array, List[Any], List[float]]:
    bag = Bag(points=points, faces=faces, directions=directions, front_only=front_only, threads=threads,
              threshold=threshold)
    taken = _do_with_progress(bag, "hidden_faces", progress)
    parts = np.split(taken["group_faces"], taken["group_ends"][:-1])
    groups = [(kind, part, *sizes) for kind, part, sizes in zip(texts_in(taken, "kinds"), parts, taken["sizes"].tolist())]
    return taken["is_hidden"].astype(bool), groups, taken["figures"].tolist()


def remove_hidden(points: Array, faces: Array, directions: int, front_only: bool, threads: int, threshold: float,
                  progress: Any) -> Tuple[Array, Array, Array, Array]:
    bag = Bag(points=points, faces=faces, directions=directions, front_only=front_only, threads=threads,
              threshold=threshold)
    taken = _do_with_progress(bag, "remove_hidden", progress)
    return taken["added"], taken["faces"], taken["sources"], taken["origins"]


def visibility(points: Array, faces: Array, directions: int, front_only: bool, threads: int, least: float,
               progress: Any) -> Tuple[Array, Array, Array]:
    bag = Bag(points=points, faces=faces, directions=directions, front_only=front_only, threads=threads, least=least)
    taken = _do_with_progress(bag, "visibility", progress)
    return taken["of_faces"], taken["of_points"], taken["importance"]


def _do_with_progress(bag: Bag, job: str, progress: Any) -> Mapping[str, Array]:
    caught: List[BaseException] = []
    return bag.do(job, None, guarded(PART_FUNCTION, _at_times(_proceeds(progress)), -1, caught), caught)


def curvature_importance(points: Array, faces: Array, strength: float) -> Array:
    return Bag(points=points, faces=faces, strength=strength).do("curvature_importance")["importance"]


def view_importance(points: Array, faces: Array, eye: Any, turned_away: float, outline: float) -> Array:
    place = np.asarray(eye, np.float64).reshape(1, 3)
    return Bag(points=points, faces=faces, eye=place, turned_away=turned_away,
               outline=outline).do("view_importance")["importance"]


def winding(faces: Array, points: int) -> Tuple[Array, int]:
    taken = Bag(faces=faces, points=points).do("winding")
    return taken["against"].astype(bool), int(taken["one_sided"][0])


# --- From a file to a file


class FileEstimate:
    """The resources that simplify_file() will need, estimated from the file sizes."""

    def __init__(self, faces: int, memory: int, scratch: int, output: int, seconds: float):
        self.faces, self.memory, self.scratch, self.output, self.seconds = faces, memory, scratch, output, seconds


class FileStatus(CFileStatus):
    """The progress of simplify_file()."""

    _NAMES = ("weld", "survey", "partition", "sample", "simplify", "regroup", "merge", "check")

    @property
    def stage(self) -> str:
        """'weld', 'survey', 'partition', 'sample', 'simplify', 'regroup' or 'merge'"""
        return self._NAMES[self._stage]

    @property
    def estimate(self) -> FileEstimate:
        return FileEstimate(self._estimated_faces, self._memory, self._scratch, self._output, self._seconds)

    def __repr__(self) -> str:
        return (f"<quadrille.FileStatus: {self.stage}, phase {self.phase} of {self.phases}, {self.chunks_done} of "
                f"{self.chunks} parts>")


class OutOfCore:
    scratch = ""
    memory = 4_000_000_000
    chunks_in_flight = 0
    restart = False
    chunk_faces = 0
    attribute_importance = 1.0
    keeps_tiles = False
    locks_boundary = False
    welds = False
    tolerance = ""
    positions_only = False


_FILE_PROGRESS = ctypes.CFUNCTYPE(c_int32, FileStatus)
_job_new = declare("quadrille_file_job_new", c_void_p, c_void_p, c_void_p, _FILE_PROGRESS, POINTER(c_int32))
_job_step = declare("quadrille_file_job_step", c_int32, c_void_p, c_char_p, c_void_p)
_FIGURES = ("phases", "chunks", "is_count_exact", "bytes_read", "bytes_written", "peak_memory", "welded_vertices",
            "fans", "short_faces", "unused_not_finite")


class FileJob:
    """quadrille_file_job"""

    def __init__(self, paths: List[str], options: Options, how: OutOfCore, progress: Any) -> None:
        self._handle: Optional[int] = None
        call = _Call()
        call.set_options(options)
        counts = np.array([how.memory, how.chunks_in_flight, how.chunk_faces], np.uint64)
        bag = Bag(paths=list(paths), scratch=how.scratch, counts=counts, tolerance=how.tolerance, restart=how.restart,
                  positions_only=how.positions_only, keeps_tiles=how.keeps_tiles, locks_boundary=how.locks_boundary,
                  welds=how.welds, attribute_importance=how.attribute_importance)
        self._caught: List[BaseException] = []
        self._progress = guarded(_FILE_PROGRESS, _proceeds(progress), -1, self._caught)
        code = c_int32()
        self._handle = _job_new(bag.handle, call.handle, self._progress, byref(code))
        bag.check(code.value, self._caught)

    def __del__(self) -> None:
        if self._handle:
            _job_delete(self._handle)

    def _step(self, name: str, **given: Any) -> Any:
        bag = Bag(**given)
        code = _job_step(self._handle, name.encode(), bag.handle)
        try:
            bag.check(code, self._caught)
        finally:
            self._caught.clear()  # an exception refers to this frame: the job must not refer to it, and so live on
        return bag.taken()

    @property
    def estimate(self) -> FileEstimate:
        taken = self._step("estimate")
        return FileEstimate(*taken["estimate"].tolist(), float(taken["seconds"][0]))

    def partition(self) -> int:
        return int(self._step("partition")["parts"][0])

    def join(self) -> int:
        return int(self._step("join")["parts"][0])

    def simplify(self, part: int) -> None:
        self._step("simplify", part=np.array([part], np.uint64))

    def close(self) -> int:
        return int(self._step("close")["parts"][0])

    def merge(self, output: str) -> Tuple[Report, Dict[str, Any]]:
        return self._reported(self._step("merge", output=output))

    def run(self, output: str) -> Tuple[Report, Dict[str, Any]]:
        return self._reported(self._step("run", output=output))

    @staticmethod
    def _reported(taken: Any) -> Tuple[Report, Dict[str, Any]]:
        figures: Dict[str, Any] = dict(zip(_FIGURES, taken["counts"].tolist()))
        figures["is_count_exact"] = bool(figures["is_count_exact"])
        figures["faces_of_phases"] = taken["faces_of_phases"].tolist()
        figures["diagonal"] = float(taken["diagonal"][0])
        figures["dropped"] = texts_in(taken, "dropped")
        return Report(json.loads(text_in(taken, "report"))), figures
