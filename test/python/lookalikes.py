"""Classes that look to the Python module as those of trimesh, Open3D, PyVista and meshio do."""

import numpy as np


class TextureVisuals:
    def __init__(self, uv, material):
        self.uv, self.material = uv, material


class Trimesh:
    def __init__(self, vertices, faces, process=True, visual=None, vertex_colors=None, vertex_normals=None,
                 vertex_attributes=None, face_attributes=None):
        self.vertices, self.faces, self.process, self.visual = vertices, faces, process, visual
        self.vertex_colors, self.vertex_normals = vertex_colors, vertex_normals
        self.vertex_attributes, self.face_attributes = vertex_attributes or {}, face_attributes or {}


class Primitive(Trimesh):
    """A sphere, or a box, whatever it is made of."""

    def __init__(self, **arguments):
        super().__init__(np.eye(4)[:, :3], np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]))


class Vector:
    """Of Open3D: of one type, and only numpy can look into it."""

    def __init__(self, array=()):
        array = np.asarray(array)
        if array.size > 0 and (array.dtype, array.shape[1:]) != (self.dtype, self.row):
            raise TypeError(f"{type(self).__name__} of {array.dtype} and the shape {array.shape}")
        self._array = array.astype(self.dtype)

    def __array__(self, dtype=None):
        return self._array.astype(dtype or self.dtype)

    def __len__(self):
        return len(self._array)


class Vector3dVector(Vector):
    dtype, row = np.float64, (3,)


class Vector2dVector(Vector):
    dtype, row = np.float64, (2,)


class Vector3iVector(Vector):
    dtype, row = np.int32, (3,)


class IntVector(Vector):
    dtype, row = np.int32, ()


class TriangleMesh:
    def __init__(self, vertices=(), triangles=()):
        self.vertices, self.triangles = Vector3dVector(vertices), Vector3iVector(triangles)
        self.vertex_colors, self.vertex_normals = Vector3dVector(), Vector3dVector()
        self.triangle_uvs, self.textures, self.triangle_material_ids = Vector2dVector(), [], IntVector()


class PolyData:
    active_texture_coordinates = None

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        self.point_data, self.cell_data = {}, {}


class CellBlock:
    def __init__(self, kind, data):
        self.type, self.data = kind, data


class MeshioMesh:
    def __init__(self, points, cells, point_data=None, cell_data=None, field_data=None):
        self.points, self.cells = points, [CellBlock(kind, data) for kind, data in cells]
        self.point_data, self.cell_data = point_data or {}, cell_data or {}
        self.field_data = field_data or {}


def padded(faces):
    """As VTK has triangles."""
    return np.insert(faces.astype(np.int64), 0, 3, axis=1).ravel()
