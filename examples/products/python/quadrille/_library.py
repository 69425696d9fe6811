"""The compiled part by ctypes: functions of C (quadrille.h and package.h), arrays in and out, errors as exceptions."""

from __future__ import annotations

import ctypes
import os
from ctypes import (CFUNCTYPE, POINTER, Structure, byref, c_char_p, c_double, c_int32, c_size_t, c_ssize_t, c_uint32,
                    c_uint64, c_void_p)
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence

import numpy as np

from ._forms import Array

_FOLDER = os.path.dirname(os.path.abspath(__file__))
library = ctypes.CDLL(os.path.join(_FOLDER, "libquadrille_python.so"))

_TYPES = [np.dtype(name) for name in ("f8", "f4", "u1", "u4", "i4", "u8", "i8")]
_TYPE_NUMBERS = {dtype: number for number, dtype in enumerate(_TYPES)}


class CArray(Structure):
    """quadrille_array"""

    _fields_ = [("data", c_void_p), ("rows", c_size_t), ("columns", c_size_t), ("row_stride", c_ssize_t),
                ("type", c_int32)]


class CStatus(Structure):
    """quadrille_status"""

    _fields_ = [("initial_faces", c_size_t), ("initial_vertices", c_size_t), ("faces", c_size_t),
                ("vertices", c_size_t), ("contractions", c_size_t), ("next_error", c_double), ("diagonal", c_double),
                ("progress", c_double), ("stage", c_int32)]


class CPair(Structure):
    """quadrille_pair"""

    _fields_ = [("first_index", c_size_t), ("second_index", c_size_t), ("_first", c_double * 3),
                ("_second", c_double * 3), ("_target", c_double * 3), ("quadric", c_double)]


class CContraction(Structure):
    """quadrille_contraction"""

    _fields_ = [("first", c_size_t), ("second", c_size_t), ("_target", c_double * 3), ("_faces", c_void_p),
                ("_face_count", c_size_t), ("_removed_faces", c_void_p), ("_removed_face_count", c_size_t),
                ("highest_degree", c_size_t)]


class CFileStatus(Structure):
    """quadrille_file_status"""

    _fields_ = [("_stage", c_int32), ("phase", c_uint32), ("phases", c_uint32), ("chunks", c_size_t),
                ("chunks_done", c_size_t), ("faces", c_uint64), ("progress", c_double), ("_estimated_faces", c_uint64),
                ("_memory", c_uint64), ("_scratch", c_uint64), ("_output", c_uint64), ("_seconds", c_double)]


class CLevelInfo(Structure):
    """quadrille_level_info"""

    _fields_ = [("faces", c_size_t), ("vertices", c_size_t), ("contractions", c_size_t), ("error", c_double),
                ("distance_bound", c_double), ("hausdorff_bound", c_double)]


def declare(name: str, result: Any, *arguments: Any) -> Callable[..., Any]:
    """A function of the library with its types."""
    function: Any = getattr(library, name)
    function.restype, function.argtypes = result, arguments
    return function


_ARRAY = POINTER(CArray)
bag_new = declare("quadrille_bag_new", c_void_p)
bag_delete = declare("quadrille_bag_delete", None, c_void_p)
_bag_error = declare("quadrille_bag_error", c_char_p, c_void_p)
_bag_put = declare("quadrille_bag_put", c_int32, c_void_p, c_char_p, _ARRAY)
_bag_count = declare("quadrille_bag_count", c_size_t, c_void_p)
_bag_take = declare("quadrille_bag_take", c_char_p, c_void_p, c_size_t, _ARRAY)
PART_FUNCTION = CFUNCTYPE(c_int32, c_double)
_do = declare("quadrille_do", c_int32, c_char_p, c_void_p, c_void_p, PART_FUNCTION)


def raise_error(code: int, message: str, caught: Sequence[BaseException] = ()) -> None:
    """Raises what a code means; if a function of Python has raised something, that."""
    if caught:
        raise caught[0]
    if code == 0:
        return
    kinds: Dict[int, Any] = {1: ValueError, 2: IndexError, 3: MemoryError}
    raise kinds.get(code, RuntimeError)(message)


def guarded(prototype: Any, answer_to: Callable[[Any], Any], failure: Any, caught: List[BaseException]) -> Any:
    """A function of C that answers by one of Python. What that raises is caught, and ends the call by `failure`.

    A generator answers, since what a signal raises before the first line of a function could not be caught in it.
    """

    def answers() -> Any:
        answer = failure
        while True:
            try:
                while True:
                    answer = answer_to((yield answer))
            except GeneratorExit:
                raise
            except BaseException as error:  # KeyboardInterrupt, too
                caught.append(error)
                answer = failure

    generator = answers()
    next(generator)
    return prototype(generator.send)


def view_of(array: Array) -> CArray:
    """An array in the order of C, which has to live as long."""
    rows = len(array)
    columns = 1 if array.ndim == 1 else array.shape[1]
    return CArray(array.__array_interface__["data"][0], rows, columns, 0, _TYPE_NUMBERS[array.dtype])


class _Memory:
    """Memory of the library as numpy takes it; its owner lives as long."""

    def __init__(self, view: CArray, owner: Any):
        shape = (view.rows, view.columns)
        self.owner = owner
        self.__array_interface__ = {"data": (view.data, False), "shape": shape, "typestr": _TYPES[view.type].str,
                                    "version": 3}


def array_of(view: CArray, owner: Any, is_flat: bool = False) -> Array:
    """The array that a view sees, without a copy."""
    if view.rows == 0:
        array: Array = np.empty((0, view.columns), _TYPES[view.type])
    else:
        array = np.asarray(_Memory(view, owner))
    return array[:, 0] if is_flat else array


class Bag:
    """quadrille_bag: arrays, numbers and texts by name, in and out."""

    def __init__(self, **given: Any):
        self.handle: Optional[int] = bag_new()
        if not self.handle:
            raise MemoryError
        self._kept: List[Any] = []
        for name, value in given.items():
            if value is not None:
                self.put(name, value)

    def __del__(self) -> None:
        bag_delete(self.handle)

    def put(self, name: str, value: Any) -> None:
        """A text, a list of texts, a number, or an array in the order of C."""
        if isinstance(value, list) and all(isinstance(text, (str, bytes)) for text in value):
            texts = [_bytes_of(text) for text in value]
            self.put(name, b"".join(texts))
            self.put(f"{name}.ends", np.cumsum([len(text) for text in texts], dtype=np.uint64))
            return
        if isinstance(value, (str, bytes)):
            value = np.frombuffer(_bytes_of(value), np.uint8)
        elif not isinstance(value, np.ndarray):
            value = np.atleast_1d(np.asarray(value, np.float64))
        self._kept.append(value)
        self.check(_bag_put(self.handle, name.encode(), byref(view_of(value))))

    def check(self, code: int, caught: Sequence[BaseException] = ()) -> None:
        if code != 0 or caught:
            raise_error(code, _text(_bag_error(self.handle)), caught)

    def do(self, name: str, call: Optional[int] = None, progress: Any = None,
           caught: Sequence[BaseException] = ()) -> Mapping[str, Array]:
        """Does what a name says, and returns what it gives."""
        self.check(_do(name.encode(), self.handle, call, progress or PART_FUNCTION()), caught)
        return self.taken()

    def taken(self) -> Dict[str, Array]:
        result: Dict[str, Array] = {}
        view = CArray()
        for index in range(_bag_count(self.handle)):
            name = _bag_take(self.handle, index, byref(view)).decode()
            result[name] = array_of(view, self, view.columns == 1)
        return result


def _bytes_of(text: Any) -> bytes:
    return text if isinstance(text, bytes) else os.fsencode(text)


def _text(text: Optional[bytes]) -> str:
    return os.fsdecode(text or b"")


def text_in(taken: Mapping[str, Array], name: str) -> str:
    return _text(taken[name].tobytes())


def texts_in(taken: Mapping[str, Array], name: str) -> List[str]:
    """Of several texts."""
    everything, begin = taken[name].tobytes(), 0
    texts = []
    for end in taken[f"{name}.ends"].tolist():
        texts.append(_text(everything[begin:end]))
        begin = end
    return texts


text_of = _text
