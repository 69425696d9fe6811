"""Meshes of trimesh, Open3D, PyVista, VTK and meshio, recognised by their attributes: none of these is imported."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Protocol, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._forms import Array, Channels, at_points, name_of
from ._vtk import PyVistaForm, VTKForm


class _Trimeshes(Protocol):
    """trimesh.Trimesh"""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class _Open3Ds(Protocol):
    """open3d.geometry.TriangleMesh"""

    @property
    def vertices(self) -> Any: ...
    @property
    def triangles(self) -> Any: ...


class _PyVistas(Protocol):
    """pyvista.PolyData"""

    @property
    def points(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class _Meshios(Protocol):
    """meshio.Mesh"""

    @property
    def points(self) -> Any: ...
    @property
    def cells(self) -> Any: ...


class _VTKs(Protocol):
    """vtkPolyData"""

    def GetPoints(self) -> Any: ...  # noqa: N802
    def GetPolys(self) -> Any: ...  # noqa: N802


MeshLike = Union[_Trimeshes, _Open3Ds, _PyVistas, _Meshios, _VTKs]


class _TrimeshForm:
    """`vertices` and `faces`. Its `triangles` are coordinates, of the shape (m, 3, 3)."""

    def __init__(self, mesh: Any):
        self.mesh = mesh
        self.points: Array = np.asarray(mesh.vertices)
        self.faces: Array = np.asarray(mesh.faces)
        self.point_data: Mapping[str, Any] = getattr(mesh, "vertex_attributes", {})

    def face_data(self) -> Dict[str, Any]:
        return dict(getattr(self.mesh, "face_attributes", {}))

    def like(self, points: Array, faces: Array, channels: Channels, face_data: Dict[str, Array],
             input_faces: Optional[Array]) -> Tuple[Any, List[str]]:
        values, lost = at_points(channels)
        visual: Any = getattr(self.mesh, "visual", None)
        arguments: Dict[str, Any] = {}
        if "uv" in values and hasattr(visual, "uv"):
            arguments["visual"] = type(visual)(uv=values.pop("uv"), material=visual.material)
        elif "colors" in values:
            arguments["vertex_colors"] = values.pop("colors")
        elif input_faces is not None and getattr(visual, "kind", None) == "face":
            arguments["face_colors"] = np.asarray(visual.face_colors)[input_faces]
        if "normals" in values:
            arguments["vertex_normals"] = values.pop("normals")
        if hasattr(self.mesh, "metadata"):
            arguments["metadata"] = dict(self.mesh.metadata)
        for name in [name for name in ("uv", "colors") if name in values]:
            lost.append(name)
            del values[name]
        return type(self.mesh)(vertices=points, faces=faces, process=False, vertex_attributes=values,
                               face_attributes=face_data, **arguments), lost


class _Open3DForm:
    """`vertices` and `triangles`."""

    def __init__(self, mesh: Any):
        self.mesh = mesh
        self.points: Array = np.asarray(mesh.vertices)
        self.faces: Array = np.asarray(mesh.triangles)
        self.point_data: Mapping[str, Any] = {}

    def face_data(self) -> Dict[str, Any]:
        ids = np.asarray(getattr(self.mesh, "triangle_material_ids", ()))
        return {"triangle_material_ids": ids} if len(ids) > 0 else {}

    def like(self, points: Array, faces: Array, channels: Channels, face_data: Dict[str, Array],
             input_faces: Optional[Array]) -> Tuple[Any, List[str]]:
        lost: List[str] = []
        result = type(self.mesh)()
        self._set(result, "vertices", points.astype(np.float64))
        self._set(result, "triangles", faces.astype(np.int32))
        for name, (values, indices) in channels.items():
            if name == "uv":
                corners: Array = values[faces if indices is None else indices].reshape(-1, 2)
                self._set(result, "triangle_uvs", corners.astype(np.float64))
                result.textures = self.mesh.textures
            elif name in ("colors", "normals") and indices is None and values.shape[1] == 3:
                if values.dtype.kind in "iu":
                    values = values / np.iinfo(values.dtype).max
                self._set(result, f"vertex_{name}", values.astype(np.float64))
            else:
                lost.append(name)
        for name, numbers in face_data.items():
            if name == "triangle_material_ids":
                self._set(result, name, numbers.astype(np.int32))
            else:
                lost.append(name)
        return result, lost

    def _set(self, result: Any, name: str, array: Array) -> None:
        """In the vectors of Open3D, whose types are taken from the mesh."""
        setattr(result, name, type(getattr(self.mesh, name))(np.ascontiguousarray(array)))


class _MeshioForm:
    """`points` and `cells`, blocks of a type and data, or `cells_dict`."""

    def __init__(self, mesh: Any):
        self.mesh = mesh
        self.points: Array = np.asarray(mesh.points)
        blocks = _blocks(mesh)
        others = sorted({kind for kind, _ in blocks} - {"triangle", "vertex", "line"})
        if others:
            raise ValueError(f"the {name_of(mesh)} has cells of the type {', '.join(others)}: only "
                             "triangles can be simplified")
        self._is_triangles = [kind == "triangle" for kind, _ in blocks]
        self.faces: Array = self._joined([data for _, data in blocks], np.empty((0, 3), np.int64))
        self.point_data: Mapping[str, Any] = getattr(mesh, "point_data", {})

    def _joined(self, of_blocks: Sequence[Any], of_none: Any = ()) -> Array:
        arrays = [np.asarray(a) for a, is_triangles in zip(of_blocks, self._is_triangles) if is_triangles]
        return arrays[0] if len(arrays) == 1 else np.concatenate(arrays) if arrays else np.asarray(of_none)

    def face_data(self) -> Dict[str, Any]:
        return {name: self._joined(arrays)
                for name, arrays in getattr(self.mesh, "cell_data", {}).items()}

    def like(self, points: Array, faces: Array, channels: Channels, face_data: Dict[str, Array],
             input_faces: Optional[Array]) -> Tuple[Any, List[str]]:
        values, lost = at_points(channels)
        lost += [name for name in ("point_sets", "cell_sets") if getattr(self.mesh, name, None)]
        return type(self.mesh)(points, [("triangle", faces)], point_data=values,
                               cell_data={name: [array] for name, array in face_data.items()},
                               field_data=getattr(self.mesh, "field_data", {})), lost


Form = Union[_TrimeshForm, _Open3DForm, PyVistaForm, _MeshioForm, VTKForm]


def read_object(given: Any) -> Optional[Form]:
    """A mesh of another library, with its points, faces and point_data; None if it is not one."""
    if type(given) is np.ndarray:  # at once, since each call asks
        return None

    def has(*names: str) -> bool:
        return all(hasattr(given, name) and not callable(getattr(given, name)) for name in names)
    if has("vertices", "faces"):
        return _TrimeshForm(given)
    if has("vertices", "triangles"):
        return _Open3DForm(given)
    if has("celltypes"):  # grids of PyVista, which have cells of any kind
        return None
    if has("points", "faces") or has("points", "regular_faces"):
        return PyVistaForm(given)
    if hasattr(given, "GetPoints") and hasattr(given, "GetPolys"):
        return VTKForm(given)
    is_meshio = has("points", "cells") or has("points", "cells_dict")
    return _MeshioForm(given) if is_meshio and _blocks(given) is not None else None


def named_point_data(form: Form, names: Sequence[str]) -> Dict[str, Array]:
    for name in names:
        if name not in form.point_data.keys():
            there = ", ".join(repr(other) for other in form.point_data.keys())
            raise ValueError(f"attributes contains {name!r}, but the point data of the {name_of(form.mesh)} "
                             f"are: {there or 'none'}")
    return {name: np.asarray(form.point_data[name]) for name in names}


def like(mesh: Any, channels: Channels, given: Any) -> Tuple[Any, List[str]]:
    """A mesh of the library of the one given, and what it has no place for."""
    form = read_object(given)
    if form is None:
        raise TypeError(f"a {name_of(given)} is not a triangle mesh of trimesh, Open3D, PyVista, VTK or meshio")
    labels = {} if mesh.labels is None else {"labels": np.asarray(mesh.labels)}
    input_faces = _input_faces(form, getattr(mesh, "input_faces", None))
    face_data = {} if input_faces is None else _face_data(form, input_faces)
    try:
        made, lost = form.like(np.asarray(mesh.points), np.asarray(mesh.faces), channels,
                               {**face_data, **labels}, input_faces)
        new = read_object(made)
    except TypeError as error:  # a primitive of trimesh takes no vertices
        raise _cannot_be_made(given) from error
    if new is None or not np.array_equal(new.faces, mesh.faces):
        raise _cannot_be_made(given)
    return made, lost


def _cannot_be_made(given: Any) -> TypeError:
    return TypeError(f"a {name_of(given)} cannot be made from points and faces: pass its to_mesh()")


def _input_faces(form: Form, input_faces: Optional[NDArray[Any]]) -> Optional[NDArray[Any]]:
    """None where the result does not know, or the mesh given has not so many faces and nothing on them."""
    if input_faces is None or len(input_faces) == 0 or int(input_faces.max()) < len(form.faces):
        return input_faces
    if form.face_data():
        raise ValueError(f"the {name_of(form.mesh)} has {len(form.faces)} faces and face data: it is not the "
                         "mesh that was simplified")
    return None


def _face_data(form: Form, input_faces: NDArray[Any]) -> Dict[str, Array]:
    result: Dict[str, Array] = {}
    for name, values in form.face_data().items():
        array: Array = np.asarray(values)
        if len(array) != len(form.faces):
            raise ValueError(f"{name} of the {name_of(form.mesh)} has {len(array)} values for "
                             f"{len(form.faces)} faces")
        result[name] = array[input_faces]
    return result


def _blocks(mesh: Any) -> Any:
    """Pairs of a type of cells and data; None where it has others."""
    cells = mesh.cells if hasattr(mesh, "cells") else mesh.cells_dict
    if hasattr(cells, "items"):
        return list(cells.items())
    blocks = [(cell.type, cell.data) if hasattr(cell, "data") and hasattr(cell, "type") else cell for cell in cells]
    are_blocks = all(isinstance(block, (tuple, list)) and len(block) == 2 and isinstance(block[0], str)
                     for block in blocks)
    return blocks if are_blocks else None
