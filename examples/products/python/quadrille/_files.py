"""Files of meshes."""

from __future__ import annotations

import os
import warnings
from typing import List, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core, _objects
from ._forms import Array
from ._mesh import Channel, Mesh, ReadChannel, as_mesh, read_channels
from ._words import in_our_words

_HARDLY = 1 / 64  # numbers of vertices may be noise


@in_our_words
def read_mesh(path: Union[str, os.PathLike[str]], *, weld: bool = False) -> Mesh:
    """Reads a Mesh from a file. The extension selects the format: OFF, OBJ, PLY, STL or GOCAD (.ts); from glTF
    (.gltf, .glb), the geometry of the scene is read, each mesh in its place (simplify_gltf keeps whole documents).

    Polygons are cut into triangles. For OBJ and PLY, uv and normals are pairs (values, indices) at
    corners; materials, groups and objects of OBJ, and integers at the faces of PLY, become labels, and
    write_mesh() writes them with their names. Other scalars at the vertices of PLY become
    attributes. Points at exactly the same place are merged where edges of faces coincide; weld merges
    all of them. Where colours or attributes differ at a place, there is a point for each side, and
    simplify() treats these as one.

    Raises OSError if the file can't be opened, and ValueError, which names file and line, if it is
    damaged. mesh.remarks says what was left out or assumed.
    """
    path = os.fspath(path)
    with open(path, "rb"):
        pass
    try:
        file, is_split = _core.read_mesh(path, bool(weld))
    except RuntimeError as error:
        raise ValueError(str(error)) from None
    mesh = Mesh(file.points, file.faces, uv=file.uv, normals=file.normals, labels=file.labels,
                remarks=file.remarks, _is_split=is_split, _source=file,
                _source_faces=np.arange(len(file.faces), dtype=np.uint32))
    if len(file.vertex_uv) > 0:
        mesh.uv = file.vertex_uv
    if file.colors is not None:
        values, full, is_whole = file.colors
        mesh.colors = values if not is_whole else values.astype(np.uint8 if full == 255 else np.uint16)
    for name, values, dtype in file.vertex_numbers:
        new_values = "optimal" if dtype[0] == "f" else "existing"
        if np.isfinite(values).all():
            mesh.attributes[name] = Channel(values.astype(dtype), importance=_HARDLY,
                                            new_values=new_values)
        else:
            mesh.remarks.append(f"not kept: {name}, which has values that are not finite")
    return mesh


@in_our_words
def write_mesh(path: Union[str, os.PathLike[str]],
               mesh: Union[Mesh, Tuple[ArrayLike, ArrayLike], _objects.MeshLike]) -> None:
    """Writes a Mesh to a file. The extension selects the format: OFF, OBJ, PLY, STL, GOCAD (.ts) or glTF (.gltf, .glb).
    A pair (points, faces), and a mesh of trimesh, Open3D, PyVista, VTK or meshio, can be written as well.

    An existing file is replaced only if everything succeeds. A mesh from read_mesh(), also after simplify(),
    keeps its materials, groups and other properties of faces; `mtllib` lines are written as they were read, so
    write the file to the same folder. uv is written to OBJ, PLY and OFF, normals to OBJ and PLY, colours to these
    three, attributes with one component per point to PLY. A UserWarning lists what the format cannot hold.

    Raises OSError if the file can't be written, ValueError if the mesh is invalid, and TypeError if it is not a
    mesh.
    """
    mesh = as_mesh(mesh)
    points = _arrays.real_rows("points", mesh.points, 3)
    faces = _arrays.index_triples("faces", mesh.faces, len(points), "points")
    arrays = _core.WrittenArrays(points, faces)
    lost: List[str] = []
    for channel in read_channels(mesh):
        _add(arrays, channel, faces, lost)
    if mesh.labels is not None and mesh._source is None:
        lost.append("labels")
    try:
        losses = _core.write_mesh(os.fspath(path), arrays, mesh._source, mesh._source_faces)
    except RuntimeError as error:
        raise OSError(str(error)) from None
    lost += [losses] if losses else []
    if lost:
        warnings.warn(f"{os.fspath(path)}: not kept: {', '.join(lost)}", stacklevel=3)


def _add(arrays: _core.WrittenArrays, channel: ReadChannel, faces: Array, lost: List[str]) -> None:
    indices = faces if channel.indices is None else channel.indices
    if channel.name == "uv":
        arrays.uv = (channel.values, indices)
    elif channel.name == "normals":
        arrays.normals = (channel.values, indices)
    elif channel.name == "colors" and channel.indices is None:
        count, components = channel.values.shape
        colors = np.ones((count, 4))
        colors[:, :components] = channel.values
        arrays.colors = (colors * channel.whole, float(channel.whole), channel.whole != 1)
        arrays.has_alpha = components == 4
    elif channel.indices is None and channel.values.shape[1] == 1:
        dtype = channel.type.str[1:] if channel.type.str[1:] in _PLY_TYPES else "f8"
        arrays.vertex_numbers = [*arrays.vertex_numbers,
                                 (channel.name, np.ascontiguousarray(channel.values[:, 0]), dtype)]
    else:
        lost.append(channel.name)


_PLY_TYPES = ("i1", "i2", "i4", "u1", "u2", "u4", "f4", "f8")
