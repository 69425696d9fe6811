"""Meshes of trimesh, Open3D, PyVista and meshio, told by what they have: none of these is imported."""

from __future__ import annotations

from typing import Any, List, Optional, Protocol, Tuple, Union

import numpy as np


class _VerticesAndFaces(Protocol):
    """trimesh.Trimesh"""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class _VerticesAndTriangles(Protocol):
    """open3d.geometry.TriangleMesh"""

    @property
    def vertices(self) -> Any: ...
    @property
    def triangles(self) -> Any: ...


class _PointsAndFaces(Protocol):
    """pyvista.PolyData"""

    @property
    def points(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class _PointsAndCells(Protocol):
    """meshio.Mesh"""

    @property
    def points(self) -> Any: ...
    @property
    def cells(self) -> Any: ...


MeshLike = Union[_VerticesAndFaces, _VerticesAndTriangles, _PointsAndFaces, _PointsAndCells]


class _Trimesh:
    """`vertices` and `faces`."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.points, self.faces = np.asarray(mesh.vertices), np.asarray(mesh.faces)
        self.point_data = getattr(mesh, "vertex_attributes", {})

    def face_data(self):
        return dict(getattr(self.mesh, "face_attributes", {}))

    def like(self, points, faces, channels, face_data):
        values, lost = _at_points(channels)
        visual = getattr(self.mesh, "visual", None)
        arguments = {}
        if "uv" in values and hasattr(visual, "uv"):
            arguments["visual"] = type(visual)(uv=values.pop("uv"), material=visual.material)
        elif "colors" in values:
            arguments["vertex_colors"] = values.pop("colors")
        if "normals" in values:
            arguments["vertex_normals"] = values.pop("normals")
        for name in [name for name in ("uv", "colors") if name in values]:
            lost.append(name)
            del values[name]
        return type(self.mesh)(vertices=points, faces=faces, process=False, vertex_attributes=values,
                               face_attributes=face_data, **arguments), lost


class _Open3D:
    """`vertices` and `triangles`."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.points, self.faces = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
        self.point_data = {}

    def face_data(self):
        ids = np.asarray(getattr(self.mesh, "triangle_material_ids", ()))
        return {"triangle_material_ids": ids} if len(ids) > 0 else {}

    def like(self, points, faces, channels, face_data):
        result, lost = type(self.mesh)(), []
        self._set(result, "vertices", points.astype(np.float64))
        self._set(result, "triangles", faces.astype(np.int32))
        for name, (values, indices) in channels.items():
            if name == "uv":
                corners = values[faces if indices is None else indices].reshape(-1, 2)
                self._set(result, "triangle_uvs", corners.astype(np.float64))
                result.textures = self.mesh.textures
            elif name in ("colors", "normals") and indices is None and values.shape[1] == 3:
                if values.dtype.kind in "iu":
                    values = values / np.iinfo(values.dtype).max
                self._set(result, f"vertex_{name}", values.astype(np.float64))
            else:
                lost.append(name)
        for name, values in face_data.items():
            if name == "triangle_material_ids":
                self._set(result, name, values.astype(np.int32))
            else:
                lost.append(name)
        return result, lost

    def _set(self, result, name, array):
        """In the vectors of Open3D, whose types are taken from the mesh."""
        setattr(result, name, type(getattr(self.mesh, name))(np.ascontiguousarray(array)))


class _PyVista:
    """`points`, and `faces` as VTK has them (3, a, b, c, 3, ...) or `regular_faces`."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.points = np.asarray(mesh.points)
        if getattr(mesh, "n_strips", 0) > 0:
            raise ValueError(f"the {_name(mesh)} has strips of triangles: triangulate() it first")
        faces = np.asarray(mesh.faces if hasattr(mesh, "faces") else mesh.regular_faces)
        self._is_plain = hasattr(mesh, "faces") and faces.ndim == 2
        if faces.ndim == 1 and faces.size % 4 == 0 and (faces[::4] == 3).all():
            faces = faces.reshape(-1, 4)[:, 1:]
        if faces.ndim != 2 or faces.shape[1] != 3:
            raise ValueError(f"the {_name(mesh)} has faces of other than three corners: triangulate() "
                             "it first")
        self.faces = faces
        self.point_data = getattr(mesh, "point_data", {})

    def face_data(self):
        return dict(getattr(self.mesh, "cell_data", {}))

    def like(self, points, faces, channels, face_data):
        values, lost = _at_points(channels)
        if not self._is_plain:
            threes = np.full((len(faces), 1), 3, faces.dtype)
            faces = np.concatenate([threes, faces], axis=1).ravel()
        result = type(self.mesh)(points, faces=faces)
        if "uv" in values and hasattr(type(self.mesh), "active_texture_coordinates"):
            result.active_texture_coordinates = values.pop("uv")
        for name, array in values.items():
            result.point_data[name] = array
        for name, array in face_data.items():
            result.cell_data[name] = array
        return result, lost


class _Meshio:
    """`points` and `cells`, blocks of a type and data, or `cells_dict`."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.points = np.asarray(mesh.points)
        cells = mesh.cells if hasattr(mesh, "cells") else mesh.cells_dict
        blocks = list(cells.items()) if hasattr(cells, "items") else [_block(cell) for cell in cells]
        others = sorted({kind for kind, _ in blocks} - {"triangle", "vertex", "line"})
        if others:
            raise ValueError(f"the {_name(mesh)} has cells of the type {', '.join(others)}: only "
                             "triangles are simplified")
        self._is_triangles = [kind == "triangle" for kind, _ in blocks]
        self.faces = self._joined([data for _, data in blocks], np.empty((0, 3), np.int64))
        self.point_data = getattr(mesh, "point_data", {})

    def _joined(self, of_blocks, of_none=()):
        arrays = [np.asarray(a) for a, is_triangles in zip(of_blocks, self._is_triangles) if is_triangles]
        return arrays[0] if len(arrays) == 1 else np.concatenate(arrays) if arrays else np.asarray(of_none)

    def face_data(self):
        return {name: self._joined(arrays)
                for name, arrays in getattr(self.mesh, "cell_data", {}).items()}

    def like(self, points, faces, channels, face_data):
        values, lost = _at_points(channels)
        return type(self.mesh)(points, [("triangle", faces)], point_data=values,
                               cell_data={name: [array] for name, array in face_data.items()},
                               field_data=getattr(self.mesh, "field_data", {})), lost


def read_object(given: Any) -> Optional[Any]:
    """A mesh of another library, with its points, faces and point_data; None if it is not one."""
    def has(*names):
        return all(hasattr(given, name) for name in names)
    if has("celltypes"):  # grids of PyVista, which have cells of any kind
        return None
    if has("vertices", "triangles"):
        return _Open3D(given)
    if has("vertices", "faces"):
        return _Trimesh(given)
    if has("points", "faces") or has("points", "regular_faces"):
        return _PyVista(given)
    return _Meshio(given) if has("points", "cells") or has("points", "cells_dict") else None


def named_point_data(mesh: Any, names: List[str]) -> dict:
    for name in names:
        if name not in mesh.point_data.keys():
            there = ", ".join(repr(other) for other in mesh.point_data.keys())
            raise ValueError(f"attributes names {name!r}, but the point data of the {_name(mesh.mesh)} "
                             f"are: {there or 'none'}")
    return {name: np.asarray(mesh.point_data[name]) for name in names}


def like(mesh: Any, channels: dict, given: Any) -> Tuple[Any, List[str]]:
    """A mesh of the library of the one given, and what it has no place for."""
    form = read_object(given)
    if form is None:
        raise TypeError(f"a {_name(given)} is no mesh of triangles of trimesh, Open3D, PyVista or meshio")
    labels = {} if mesh.labels is None else {"labels": np.asarray(mesh.labels)}
    made, lost = form.like(np.asarray(mesh.points), np.asarray(mesh.faces), channels,
                           {**_face_data(form, getattr(mesh, "input_faces", None)), **labels})
    new = read_object(made)  # a primitive of trimesh heeds neither vertices nor faces
    if new is None or not np.array_equal(new.faces, mesh.faces):
        raise TypeError(f"a {_name(given)} cannot be made of points and faces: give its to_mesh()")
    return made, lost


def _face_data(form, input_faces):
    if input_faces is None:
        return {}
    result = {}
    for name, array in form.face_data().items():
        array = np.asarray(array)
        if len(array) != len(form.faces) or (len(input_faces) > 0 and input_faces.max() >= len(array)):
            raise ValueError(f"{name} of the {_name(form.mesh)} has {len(array)} values for "
                             f"{len(form.faces)} faces, or it is not the mesh that was simplified")
        result[name] = array[input_faces]
    return result


def _name(mesh):
    return type(mesh).__name__


def _block(cell):
    return (cell.type, cell.data) if hasattr(cell, "data") else tuple(cell)


def _at_points(channels):
    """The values of those that have one for each point, and the names of the others."""
    return ({name: values for name, (values, indices) in channels.items() if indices is None},
            [name for name, (_, indices) in channels.items() if indices is not None])
