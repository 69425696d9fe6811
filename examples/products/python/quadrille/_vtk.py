"""Surfaces of PyVista, and those of VTK itself: pyvista.PolyData and vtkPolyData."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Tuple

import numpy as np

from ._forms import Array, Channels, at_points, name_of


class PyVistaForm:
    """`points`, and `faces` as VTK has them (3, a, b, c, 3, ...) or `regular_faces`."""

    def __init__(self, mesh: Any):
        self.mesh = mesh
        self.points: Array = np.asarray(mesh.points)
        _require_no_strips(mesh, getattr(mesh, "n_strips", 0))
        faces: Array = np.asarray(mesh.faces if hasattr(mesh, "faces") else mesh.regular_faces)
        self._is_plain = hasattr(mesh, "faces") and faces.ndim == 2
        if faces.ndim == 1 and faces.size % 4 == 0 and (faces[::4] == 3).all():
            faces = faces.reshape(-1, 4)[:, 1:]
        if faces.ndim != 2 or faces.shape[1] != 3:
            raise _not_triangles(mesh)
        self.faces: Array = faces
        self.point_data: Mapping[str, Any] = getattr(mesh, "point_data", {})

    def face_data(self) -> Dict[str, Array]:
        others = int(getattr(self.mesh, "n_verts", 0)) + int(getattr(self.mesh, "n_lines", 0))
        return _behind(others, len(self.faces), dict(getattr(self.mesh, "cell_data", {})))

    def like(self, points: Array, faces: Array, channels: Channels, face_data: Dict[str, Array],
             input_faces: Optional[Array]) -> Tuple[Any, List[str]]:
        values, lost = at_points(channels)
        if not self._is_plain:
            threes: Array = np.full((len(faces), 1), 3, faces.dtype)
            faces = np.concatenate([threes, faces], axis=1).ravel()
        result = type(self.mesh)(points, faces=faces)
        if "uv" in values and hasattr(type(self.mesh), "active_texture_coordinates"):
            result.active_texture_coordinates = values.pop("uv")
        for name, array in values.items():
            result.point_data[name] = array
        for name, array in face_data.items():
            result.cell_data[name] = array
        return result, lost


class VTKForm:
    """What GetPoints() and GetPolys() give, which numpy reads and writes by their buffers."""

    def __init__(self, mesh: Any):
        self.mesh = mesh
        _require_no_strips(mesh, mesh.GetNumberOfStrips())
        points, polys = mesh.GetPoints(), mesh.GetPolys()
        self.points: Array = np.empty((0, 3)) if points is None else np.asarray(points.GetData())
        ends: Array = np.asarray(polys.GetOffsetsArray())
        if len(ends) > 1 and (np.diff(ends) != 3).any():
            raise _not_triangles(mesh)
        self.faces: Array = np.asarray(polys.GetConnectivityArray()).reshape(-1, 3)
        self.point_data: Mapping[str, Any] = _arrays_of(mesh.GetPointData())

    def face_data(self) -> Dict[str, Array]:
        others = self.mesh.GetNumberOfVerts() + self.mesh.GetNumberOfLines()
        return _behind(others, len(self.faces), _arrays_of(self.mesh.GetCellData()))

    def like(self, points: Array, faces: Array, channels: Channels, face_data: Dict[str, Array],
             input_faces: Optional[Array]) -> Tuple[Any, List[str]]:
        values, lost = at_points(channels)
        result, old = type(self.mesh)(), self.mesh.GetPoints()
        vertices, polys = type(old)(), type(self.mesh.GetPolys())()
        vertices.SetData(self._filled(old.GetData(), points))
        result.SetPoints(vertices)
        polys.SetData(3, self._filled(self.mesh.GetPolys().GetConnectivityArray(), faces.reshape(-1, 1)))
        result.SetPolys(polys)
        self._add(values, self.mesh.GetPointData(), result.GetPointData())
        self._add(face_data, self.mesh.GetCellData(), result.GetCellData())
        return result, lost

    def _add(self, arrays: Dict[str, Array], old: Any, data: Any) -> None:
        """Texture coordinates and normals as what they are; types are those of the mesh, where it has them."""
        for name, array in arrays.items():
            like = old.GetArray(name)
            if like is None:
                is_real = array.dtype.kind == "f"
                like = self.mesh.GetPoints().GetData() if is_real else self.mesh.GetPolys().GetConnectivityArray()
            made = self._filled(like, array)
            made.SetName(name)
            {"uv": data.SetTCoords, "normals": data.SetNormals}.get(name, data.AddArray)(made)

    @staticmethod
    def _filled(old: Any, array: Array) -> Any:
        """An array of VTK of the type of another one."""
        made = old.NewInstance()
        made.SetNumberOfComponents(1 if array.ndim == 1 else array.shape[1])
        made.SetNumberOfTuples(len(array))
        if len(array) > 0:
            np.asarray(made).reshape(array.shape)[...] = array
        return made


def _arrays_of(data: Any) -> Dict[str, Array]:
    """Arrays of numbers that have a name."""
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): np.asarray(array) for array in arrays if array is not None and array.GetName()}


def _behind(others: int, faces: int, data: Dict[str, Any]) -> Dict[str, Array]:
    """Data of cells, in which those of vertices and lines come before those of the faces."""
    return {name: np.asarray(values)[others:] if len(values) == others + faces else np.asarray(values)
            for name, values in data.items()}


def _require_no_strips(mesh: Any, count: int) -> None:
    if count > 0:
        raise ValueError(f"the {name_of(mesh)} has triangle strips: {_remedy(mesh)} first")


def _not_triangles(mesh: Any) -> ValueError:
    return ValueError(f"the {name_of(mesh)} has faces that are not triangles: {_remedy(mesh)} first")


def _remedy(mesh: Any) -> str:
    return "triangulate() it" if hasattr(mesh, "points") else "apply vtkTriangleFilter"
