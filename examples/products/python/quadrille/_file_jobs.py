"""simplify_file() and FileJob"""

from __future__ import annotations

import dataclasses
import glob
import os
import re
import warnings
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Sequence, Tuple, TypedDict, Union

from . import _core
from ._missed import warn_if_missed
from ._options import function_of, make_options, read_count, read_number
from ._table import CostName, PlacementName, TopologyName
from ._words import in_our_words, in_words_of_python

if TYPE_CHECKING:
    from typing_extensions import Unpack

Path = Union[str, "os.PathLike[str]"]
Paths = Union[Path, Sequence[Path]]
Progress = Callable[[_core.FileStatus], Optional[bool]]

_HARDLY = 1 / 64  # numbers of vertices, beside a cost of positions that was asked for


class FileOptions(TypedDict, total=False):
    """The options of simplify_file() and FileJob."""

    faces: Optional[int]
    ratio: Optional[float]
    target_reduction: Optional[float]
    error: Optional[float]
    relative_error: Optional[float]
    both_ways: bool
    tolerance: Optional[str]
    cost: Optional[CostName]
    placement: Optional[PlacementName]
    topology: Optional[TopologyName]
    boundary_weight: float
    lock_boundary: bool
    attribute_importance: Optional[float]
    positions_only: bool
    keep_tiles: bool
    weld: bool
    memory: Union[int, str]
    threads: int
    chunk_faces: int
    restart: bool


@dataclasses.dataclass
class SimplifiedFile:
    """The result of simplify_file()."""

    output: str  #: the file, or the folder of tiles
    report: _core.Report  #: as of any simplification, but without figures on the topology
    phases: int  #: the number of phases
    chunks: int  #: the number of chunks of the first phase
    faces_of_phases: List[int]  #: the number of faces after each phase
    is_count_exact: bool  #: whether the target was met exactly, or as closely as faces allow
    bytes_read: int
    bytes_written: int
    diagonal: float  #: the diagonal of the bounding box of the vertices that faces use
    peak_memory: int  #: of the process so far, in bytes, as the operating system reports it
    welded_vertices: int  #: merged with another vertex at the same place, before anything else
    fans: int  #: polygons that were cut into fans, since they have no area or cross themselves
    short_faces: int  #: faces left out because they have fewer than three different corners
    remarks: List[str]  #: what was left out


def _made(*, faces: Optional[int] = None, ratio: Optional[float] = None, target_reduction: Optional[float] = None,
          error: Optional[float] = None, relative_error: Optional[float] = None, both_ways: bool = False,
          tolerance: Optional[str] = None, cost: Optional[CostName] = None,
          placement: Optional[PlacementName] = None, topology: Optional[TopologyName] = None,
          boundary_weight: float = 100.0, lock_boundary: bool = False,
          attribute_importance: Optional[float] = None, positions_only: bool = False, keep_tiles: bool = False,
          weld: bool = False,
          memory: Union[int, str] = 4_000_000_000, threads: int = 0, chunk_faces: int = 0, restart: bool = False,
          scratch: Path) -> Tuple[_core.Options, _core.OutOfCore]:
    if faces is not None and (ratio is not None or target_reduction is not None):
        raise ValueError("faces does not go with a fraction of the faces: both are targets")
    if error is not None and relative_error is not None:
        raise ValueError("error does not go with relative_error: both are limits")
    if tolerance is not None and not isinstance(tolerance, str):
        raise TypeError("tolerance has to be the name of a scalar property of vertices, not " + type(tolerance).__name__)
    if tolerance is not None and (error is not None or relative_error is not None):
        raise ValueError("tolerance does not go with error: put the smaller limit into the scalar property of the file")
    if tolerance == "":
        raise ValueError("tolerance is '', not the name of a scalar property of vertices")
    if cost == "edge_length" and placement == "optimal":
        raise ValueError("placement='optimal' does not go with cost='edge_length'")
    options = make_options(faces=faces, ratio=ratio, target_reduction=target_reduction, error=error,
                           relative_error=relative_error, both_ways=both_ways, cost=cost, placement=placement,
                           topology=topology, boundary_weight=boundary_weight)
    how = _core.OutOfCore()
    how.scratch = os.fspath(scratch)
    how.memory = read_bytes("memory", memory)
    how.chunks_in_flight = read_count("threads", threads)
    how.chunk_faces = read_count("chunk_faces", chunk_faces)
    how.tolerance = tolerance or ""
    how.restart, how.positions_only = bool(restart), bool(positions_only)
    how.keeps_tiles, how.locks_boundary, how.welds = bool(keep_tiles), bool(lock_boundary), bool(weld)
    how.attribute_importance = ((1 if cost is None else _HARDLY) if attribute_importance is None
                                else read_number("attribute_importance", attribute_importance))
    return options, how


_made.__name__ = "simplify_file"  # whose arguments they are
_made = in_our_words(_made)


class FileJob:
    """Simplifies a file in steps. Each step may run in any process that sees the files and the scratch folder, such
    as a process of a pool, of Dask or of Ray.

        job = quadrille.FileJob("in.ply", scratch="/scratch/a", faces=1_000_000)
        with multiprocessing.Pool() as pool:
            parts = job.partition()
            while parts > 0:
                pool.map(job.simplify, range(parts))
                parts = job.close()
        result = job.merge("out.ply")

    The arguments are those of simplify_file(), which runs all of these steps. A pickled job contains its arguments
    except progress=; in another process, simplify() works on the current phase. partition(), close() and merge()
    drive the job under a lock, so that only one process does so; after an interruption, a new job with restart=True
    resumes the work. If progress= returns False, these methods raise RuntimeError.
    """

    def __init__(self, source: Paths, /, *, scratch: Path, progress: Optional[Progress] = None,
                 **options: Unpack[FileOptions]) -> None:
        self._paths = _paths_of(source)
        self._given: Dict[str, Any] = {"scratch": scratch, **options}
        self._progress = function_of("progress", progress)
        self._options = _made(**self._given)[0]
        self._job = self._make()
        self._drives = False

    def __getstate__(self) -> Dict[str, Any]:
        return {"paths": self._paths, "given": self._given}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self._paths, self._given, self._progress = state["paths"], state["given"], None
        self._options = _made(**self._given)[0]
        self._drives = False
        self._job = self._make()

    @property
    def estimate(self) -> _core.FileEstimate:
        """The resources that the job will need, estimated from the file sizes."""
        return self._job.estimate

    def partition(self) -> int:
        """Cuts the file into chunks or, with restart=True, resumes the current phase. Returns the number of chunks."""
        self._drives = True
        return _step(self._paths, self._job.partition)

    def simplify(self, part: int) -> int:
        """Simplifies a chunk of the phase, counted from 0, unless that has been done. Any number of processes and
        threads may call it at the same time. Returns the number of the chunk."""
        job = self._job if self._drives else self._joined()
        _step(self._paths, job.simplify, read_count("part", part))
        return part

    def close(self) -> int:
        """Ends the phase, once all of its chunks are simplified. Returns the number of chunks of the next phase, or 0 if
        merge() can write the result."""
        return _step(self._paths, self._job.close)

    def merge(self, target: Path) -> SimplifiedFile:
        """Merges the chunks into the result, and empties the scratch folder."""
        result = _result(target, *_step(self._paths, self._job.merge, os.fspath(target)))
        self._drives = False
        return result

    def _make(self) -> _core.FileJob:
        return _step(self._paths, _core.FileJob, self._paths, *_made(**self._given), self._progress)

    def _joined(self) -> _core.FileJob:
        job = self._make()
        _step(self._paths, job.join)
        return job


def simplify_file(source: Paths, target: Path, /, *, scratch: Path, progress: Optional[Progress] = None,
                  **options: Unpack[FileOptions]) -> SimplifiedFile:
    """Simplifies a surface from file to file in chunks, within a limit of memory.

        result = quadrille.simplify_file("in.ply", "out.ply", faces=1_000_000, scratch="/scratch/a", memory="4G")

    source    PLY or binary STL; a list of files, or a pattern such as 'tiles/*.ply': tiles of one
              surface with coincident boundaries
    target    binary PLY; with keep_tiles a folder
    scratch   a folder for temporary files; at the end it is as it was
    memory    the most memory that the process should use, in bytes or as '4G', '500MB', '4GiB'; the result depends on it
    threads   the number of chunks at a time; 0: one for each processor, as far as memory allows
    restart   resume the interrupted job in the scratch folder
    chunk_faces  the approximate number of faces of a chunk; 0: as memory allows
    progress  called at each stage, and up to 25 times a second, with a FileStatus, which contains an estimate of time,
              memory and disk space; returning False or raising ends the run, and finished work stays in the scratch
              folder for restart

    faces, ratio, target_reduction, error, relative_error, both_ways, cost (by name), placement, topology, boundary_weight
              as in simplify(); half of the faces if there is no target
    tolerance  instead of an error, the name of a scalar property of the vertices of the PLY file: no triangle of the
              input is further from the result than the smallest value of its corners, in the unit of the positions
    lock_boundary  vertices at boundary edges stay in place
    keep_tiles  write each tile to a file of the same name in the target folder
    weld      merge vertices at exactly the same place, whatever their edges
    positions_only  keep only positions, faces, labels and tolerances; without this, attributes that cannot be kept
              raise an error
    attribute_importance  the weight of colours and other scalars of vertices, above 0: 1 by default, 1/64 if a cost is
              given

    Returns a SimplifiedFile with a report. A missed target, an inexact count and everything that was left out are
    reported as UserWarnings. Ctrl-C ends the call with a KeyboardInterrupt.

    Raises OSError if a file can't be opened or written, a disk is too small or full, or another job uses the folder;
    ValueError if the file or an option is wrong; TypeError for an unknown option.
    """
    job = FileJob(source, scratch=scratch, progress=progress, **options)
    result = _result(target, *_step(job._paths, job._job.run, os.fspath(target)))
    for remark in result.remarks:
        warnings.warn(remark, stacklevel=3)
    warn_if_missed(result.report, job._options, None, None, stacklevel=3,
                   has_tolerance=options.get("tolerance") is not None)
    return result


simplify_file.option_names = tuple(FileOptions.__annotations__)  # type: ignore[attr-defined]
simplify_file = in_our_words(simplify_file)


def _result(target: Path, report: _core.Report, figures: Dict[str, Any]) -> SimplifiedFile:
    remarks = ["left out: " + what for what in figures.pop("dropped")]
    unused = figures.pop("unused_not_finite")
    if unused > 0:
        remarks.append(f"isolated vertices left out (not finite): {unused}")
    if report.doubled_faces > 0:
        remarks.append("duplicate faces left out (same corners, same winding): "
                       f"{report.doubled_faces}")
    if not figures["is_count_exact"] and report.stop != "cancelled":
        remarks.append("the number of faces is not exact, since the whole result does not fit into memory: "
                       f"{report.faces_after}")
    return SimplifiedFile(output=os.fspath(target), report=report, remarks=remarks, **figures)


def _paths_of(source: Any) -> List[str]:
    """The named files; those of a pattern in the order of their names."""
    if not isinstance(source, (str, os.PathLike)):
        return [os.fspath(path) for path in source]
    path = os.fspath(source)
    if not glob.has_magic(path) or os.path.exists(path):
        return [path]
    found = sorted(glob.glob(path))
    if not found:
        raise FileNotFoundError(f"{path}: no file matches this pattern")
    return found


def _step(paths: Sequence[str], step: Callable[..., Any], *arguments: Any) -> Any:
    """Runs a step. Errors in an input file become ValueError, those of other files OSError."""
    for path in paths if step is _core.FileJob else ():
        with open(path, "rb"):
            pass
    try:
        return step(*arguments)
    except RuntimeError as error:
        message = str(error)
        if message.startswith(tuple(path + ": " for path in paths)):
            raise ValueError(message) from None
        if message.startswith("quadrille::"):  # a step that is not due
            raise RuntimeError(in_words_of_python(message)) from None
        if message.startswith("quadrille: "):
            raise RuntimeError("progress has ended the run; restart=True resumes it") from None
        raise OSError(message) from None


_UNITS = {"": 1, "k": 1, "m": 2, "g": 3, "t": 4}


def read_bytes(name: str, value: Any) -> int:
    """A number, or a text such as 4G, 500MB, 4GiB."""
    if not isinstance(value, str):
        return _count_of_bytes(name, value)
    found = re.fullmatch(r"\s*(\d+(?:\.\d*)?)\s*([kmgt]?)(i?)b?\s*", value.lower())
    if not found or (found[3] and not found[2]):
        raise ValueError(f"{name} is {value!r}, not a number of bytes, such as '4G' or '500M'")
    power = _UNITS[found[2]] if found[2] else 0
    return int(float(found[1]) * float(1024 if found[3] else 1000) ** power)


def _count_of_bytes(name: str, value: Any) -> int:
    number = read_number(name, value)
    if not 0 <= number < 1e18:
        raise ValueError(f"{name} is {value!r}, not a number of bytes")
    return int(number)
