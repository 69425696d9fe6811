# Textured assets as arrays of corners, from and to binary glTF. Needs python3-numpy and python3-pil.
import io
import json
import struct

import numpy as np
from PIL import Image

TYPES = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Asset:
    """Triangles with values at their corners: points, normals (f, 3, 3), uvs (f, 3, 2); the material of each,
    an index into names and images (RGB from 0 to 1, rows from the top, as glTF has them)."""

    def __init__(self, points, normals, uvs, materials, names, images):
        self.points, self.normals, self.uvs = (np.asarray(x, float) for x in (points, normals, uvs))
        self.materials, self.names, self.images = np.asarray(materials), names, images

    def colours(self, faces, weights):
        """What the texture shows at points of faces, given by barycentric coordinates: bilinear, repeated."""
        uvs = np.einsum("ni,nij->nj", weights, self.uvs[faces])
        colours = np.zeros((len(faces), 3))
        for m, image in enumerate(self.images):
            here = self.materials[faces] == m
            colours[here] = sampled(image, uvs[here])
        return colours

    def shading_normals(self, faces, weights):
        return unit(np.einsum("ni,nij->nj", weights, self.normals[faces]))


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def sampled(image, uvs):
    height, width = image.shape[:2]
    x, y = uvs[:, 0] * width - 0.5, uvs[:, 1] * height - 0.5
    left, top = np.floor(x).astype(int), np.floor(y).astype(int)
    s, t = (x - left)[:, None], (y - top)[:, None]
    texel = lambda i, j: image[j % height, i % width]
    return ((texel(left, top) * (1 - s) + texel(left + 1, top) * s) * (1 - t) +
            (texel(left, top + 1) * (1 - s) + texel(left + 1, top + 1) * s) * t)


def creased_normals(points, triangles, degrees):
    """At each corner the faces around its vertex that are turned from its own by less than that, by their angles."""
    p = points[triangles]
    faces = unit(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]))
    sides = unit(np.roll(p, -1, axis=1) - p)
    angles = np.arccos(np.clip(-np.einsum("fij,fij->fi", sides, np.roll(sides, 1, axis=1)), -1, 1)).ravel()
    vertices = triangles.ravel()
    order = np.argsort(vertices, kind="stable")
    first = np.searchsorted(vertices[order], np.arange(len(points) + 1))
    valences = np.diff(first)[vertices]
    mine = np.repeat(np.arange(len(vertices)), valences)
    begin = np.cumsum(valences) - valences
    other = order[first[vertices[mine]] + np.arange(len(mine)) - begin[mine]]
    close = np.einsum("ij,ij->i", faces[mine // 3], faces[other // 3]) > np.cos(np.radians(degrees))
    normals = np.zeros((len(vertices), 3))
    np.add.at(normals, mine[close], (angles[other, None] * faces[other // 3])[close])
    return unit(normals).reshape(-1, 3, 3)


# --- Files -----------------------------------------------------------------------------------------

def write_glb(path, asset):
    """One mesh with a primitive for each material; the vertices of one are split where its corners differ."""
    blob, views, accessors, primitives = bytearray(), [], [], []

    def add(data, target=None):
        blob.extend(b"\0" * (-len(blob) % 4))
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data), **({"target": target} if target else {})})
        blob.extend(data)
        return len(views) - 1

    def accessor(array, kind, target):
        accessors.append({"bufferView": add(array.tobytes(), target), "type": kind, "count": len(array),
                          "componentType": 5125 if array.dtype == np.uint32 else 5126})
        if target == 34962:
            accessors[-1].update(min=array.min(axis=0).tolist(), max=array.max(axis=0).tolist())
        return len(accessors) - 1

    corners = np.concatenate([asset.points, asset.normals, asset.uvs], axis=2).astype(np.float32) + np.float32(0)
    for m in range(len(asset.names)):
        here = corners[asset.materials == m].reshape(-1, 8)
        if not len(here):
            continue
        vertices, first, inverse = np.unique(here, axis=0, return_index=True, return_inverse=True)
        rank = np.argsort(np.argsort(first))
        vertices = vertices[np.argsort(first)]
        parts = [np.ascontiguousarray(vertices[:, a:b]) for a, b in ((0, 3), (3, 6), (6, 8))]
        primitives.append({"material": m, "indices": accessor(rank[inverse.ravel()].astype(np.uint32), "SCALAR", 34963),
                           "attributes": {"POSITION": accessor(parts[0], "VEC3", 34962), "NORMAL": accessor(parts[1], "VEC3", 34962),
                                          "TEXCOORD_0": accessor(parts[2], "VEC2", 34962)}})
    images = []
    for image in asset.images:
        file = io.BytesIO()
        Image.fromarray(np.round(image * 255).astype(np.uint8)).save(file, "PNG")
        images.append({"mimeType": "image/png", "bufferView": add(file.getvalue())})
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": primitives}], "images": images,
                "textures": [{"source": m} for m in range(len(images))],
                "materials": [{"name": name, "pbrMetallicRoughness": {"baseColorTexture": {"index": m}}}
                              for m, name in enumerate(asset.names)],
                "buffers": [{"byteLength": len(blob) + -len(blob) % 4}], "bufferViews": views, "accessors": accessors}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    blob.extend(b"\0" * (-len(blob) % 4))
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob)


def read_glb(path):
    """A file that write_glb or a simplifier has written, with the transforms of its nodes; images of KHR_texture_transform
    are not understood, so gltfpack has to run with -noq. None if it has no faces."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack("<I", data[12:16])[0]
    document, blob = json.loads(data[20:20 + length]), data[28 + length:]
    materials = document.get("materials", [])
    parts, images = [], [texture_of(document, blob, m) for m in materials]
    for node, transform in placed_nodes(document):
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            values = {name: array_of(document, blob, number) for name, number in primitive["attributes"].items()}
            indices = array_of(document, blob, primitive["indices"]).ravel().astype(int).reshape(-1, 3)
            points = values["POSITION"] @ transform[:3, :3].T + transform[:3, 3]
            normals = unit(values["NORMAL"] @ np.linalg.inv(transform[:3, :3]))
            parts.append((points[indices], normals[indices], values["TEXCOORD_0"][indices], np.full(len(indices), primitive["material"])))
    if not parts:
        return None
    return Asset(*(np.concatenate(part) for part in zip(*parts)), [m.get("name", "") for m in materials], images)


def array_of(document, blob, number):
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kind, components = np.dtype(TYPES[accessor["componentType"]]), COMPONENTS[accessor["type"]]
    stride = view.get("byteStride", kind.itemsize * components)
    begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return np.ndarray((accessor["count"], components), kind, blob, begin, (stride, kind.itemsize)).astype(
        float if kind == np.float32 else int)


def placed_nodes(document):
    def visit(number, above):
        node = document["nodes"][number]
        if any(name in node for name in ("matrix", "rotation")):
            raise ValueError("a node is turned, which is not understood here")
        here = np.diag([*node.get("scale", [1, 1, 1]), 1.0])
        here[:3, 3] = node.get("translation", [0, 0, 0])
        if "mesh" in node:
            yield node, above @ here
        for child in node.get("children", []):
            yield from visit(child, above @ here)
    for root in document.get("scenes", [{}])[document.get("scene", 0)].get("nodes", []):
        yield from visit(root, np.eye(4))


def texture_of(document, blob, material):
    texture = document["textures"][material["pbrMetallicRoughness"]["baseColorTexture"]["index"]]
    view = document["bufferViews"][document["images"][texture["source"]]["bufferView"]]
    begin = view.get("byteOffset", 0)
    return pixels(io.BytesIO(blob[begin:begin + view["byteLength"]]))


def pixels(file):
    return np.asarray(Image.open(file).convert("RGB"), float) / 255
