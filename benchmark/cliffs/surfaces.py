"""Reads surfaces from OFF, OBJ, PLY, STL and GLB, writes PLY and GLB, and measures how far two of them are apart. It
shares nothing with the library."""
import json
import struct

import numpy as np
from scipy.spatial import cKDTree


class Surface:
    """Points and triangles of these."""

    def __init__(self, points, triangles):
        self.points = np.asarray(points, float).reshape(-1, 3)
        self.triangles = np.asarray(triangles, int).reshape(-1, 3)

    def __len__(self):
        return len(self.triangles)

    def corners(self):
        return self.points[self.triangles]

    def diagonal(self):
        used = self.points[np.unique(self.triangles)]
        return np.linalg.norm(used.max(0) - used.min(0))


def fan(polygon):
    return [(polygon[0], polygon[i], polygon[i + 1]) for i in range(1, len(polygon) - 1)]


def read_off(path):
    words = [w for line in open(path) for w in line.split("#")[0].split()]
    points, faces, at = int(words[1]), int(words[2]), 4
    header = words[0]
    width = 3 + 3 * header.startswith("N") + 4 * header.startswith("C")
    coordinates = np.array(words[at:at + width * points], float).reshape(points, width)[:, :3]
    at += width * points
    if width == 3 and len(words) > at and not words[at].isdigit():
        raise ValueError(f"{path}: not read: vertices with further numbers")
    lines = [line.split("#")[0].split() for line in open(path)]
    lines = [line for line in lines if line][-faces:]
    triangles = [t for line in lines for t in fan([int(w) for w in line[1:1 + int(line[0])]])]
    return Surface(coordinates, triangles)


def read_obj(path):
    points, triangles = [], []
    for line in open(path, errors="replace"):
        if line.startswith("v "):
            points.append([float(w) for w in line.split()[1:4]])
        elif line.startswith("f "):
            polygon = [int(w.split("/")[0]) for w in line.split()[1:]]
            triangles += fan([i - 1 if i > 0 else len(points) + i for i in polygon])
    return Surface(points, triangles)


PLY_TYPES = {"double": "f8", "float": "f4", "int": "i4", "uint": "u4", "short": "i2", "ushort": "u2", "char": "i1",
             "uchar": "u1", "float64": "f8", "float32": "f4", "int32": "i4", "uint32": "u4", "int16": "i2",
             "uint16": "u2", "int8": "i1", "uint8": "u1"}


def table_of_triangles(data, order, properties, count, begin):
    """Items of one list, of three numbers each; or nothing if they are others."""
    kinds = []
    for p in properties:
        kinds += ([("count", order + PLY_TYPES[p[1]]), ("corners", order + PLY_TYPES[p[2]], 3)] if p[0] == "list" else
                  [(p[1], order + PLY_TYPES[p[0]])])
    if len(dict((k[0], k) for k in kinds)) < len(kinds) or begin + count * np.dtype(kinds).itemsize > len(data):
        return None
    table = np.frombuffer(data, kinds, count, begin)
    return table if (table["count"] == 3).all() else None


def read_ply(path):
    data = open(path, "rb").read()
    end = data.index(b"\n", data.index(b"end_header")) + 1
    elements, order = [], None
    for words in (line.split() for line in data[:end].decode(errors="replace").splitlines()):
        if words[:1] == ["format"]:
            order = {"ascii": None, "binary_little_endian": "<", "binary_big_endian": ">"}[words[1]]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
    numbers = iter(data[end:].split()) if order is None else None

    def take(name, kind):
        nonlocal end
        if order is None:
            return float(next(numbers))
        item = np.frombuffer(data, order + PLY_TYPES[kind], 1, end)
        end += item.nbytes
        return item[0]

    points, triangles = [], []
    for name, count, properties in elements:
        lists = [p for p in properties if p[0] == "list"]
        if order and not lists:
            table = np.frombuffer(data, [(p[1], order + PLY_TYPES[p[0]]) for p in properties], count, end)
            end += table.nbytes
            if name == "vertex":
                points = np.stack([table[c] for c in "xyz"], 1)
            continue
        table = order and table_of_triangles(data, order, properties, count, end)
        if table is not None and name == "face":
            end += table.nbytes
            triangles = table["corners"]
            continue
        for _ in range(count):
            item = {}
            for p in properties:
                if p[0] == "list":
                    item[p[3]] = [take(p[3], p[2]) for _ in range(int(take(p[3], p[1])))]
                else:
                    item[p[1]] = take(p[1], p[0])
            if name == "vertex":
                points.append([item[c] for c in "xyz"])
            for key in ("vertex_indices", "vertex_index"):
                if name == "face" and key in item:
                    triangles += fan([int(i) for i in item[key]])
    return Surface(points, triangles)


def read_stl(path):
    data = open(path, "rb").read()
    count = struct.unpack("<I", data[80:84])[0]
    facets = np.frombuffer(data, [("normal", "<f4", 3), ("corners", "<f4", 9), ("rest", "<u2")], count, 84)
    return Surface(facets["corners"].reshape(-1, 3), np.arange(3 * count).reshape(-1, 3))


class Glb:
    """A binary glTF document, and the meshes of its scene where its nodes put them."""

    def __init__(self, path):
        data = open(path, "rb").read()
        size = struct.unpack("<I", data[12:16])[0]
        self.json, self.bytes = json.loads(data[20:20 + size]), data[28 + size:]

    def accessor(self, number):
        accessor = self.json["accessors"][number]
        view = self.json["bufferViews"][accessor["bufferView"]]
        kind = np.dtype({5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
                        [accessor["componentType"]])
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]]
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", kind.itemsize * width)
        return np.ndarray((accessor["count"], width), kind, self.bytes, begin, (stride, kind.itemsize))

    @staticmethod
    def matrix(node):
        if "matrix" in node:
            return np.array(node["matrix"], float).reshape(4, 4).T
        x, y, z, w = node.get("rotation", (0, 0, 0, 1))
        turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
        result = np.eye(4)
        result[:3, :3] = turn * np.array(node.get("scale", (1, 1, 1)))
        result[:3, 3] = node.get("translation", (0, 0, 0))
        return result

    def surface(self):
        points, triangles = [np.zeros((0, 3))], [np.zeros((0, 3), int)]

        def visit(numbers, above):
            for number in numbers:
                node = self.json["nodes"][number]
                matrix = above @ self.matrix(node)
                for primitive in self.json["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
                    if primitive.get("mode", 4) != 4:
                        continue
                    first = sum(map(len, points))
                    own = self.accessor(primitive["attributes"]["POSITION"]).astype(float)
                    points.append(own @ matrix[:3, :3].T + matrix[:3, 3])
                    indices = (self.accessor(primitive["indices"]) if "indices" in primitive else np.arange(len(own)))
                    triangles.append(indices.astype(int).reshape(-1, 3) + first)
                visit(node.get("children", ()), matrix)

        visit(self.json["scenes"][self.json.get("scene", 0)]["nodes"], np.eye(4))
        return Surface(np.concatenate(points), np.concatenate(triangles))


def read(path):
    extension = str(path).rsplit(".", 1)[-1].lower()
    readers = {"off": read_off, "obj": read_obj, "ply": read_ply, "stl": read_stl, "glb": lambda p: Glb(p).surface()}
    surface = readers[extension](path)
    corners = surface.corners()
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return Surface(surface.points, surface.triangles[area > 0])


def write_ply(path, points, triangles, labels=None):
    table = np.zeros(len(triangles), [("n", "u1"), ("v", "<i4", 3)] + [("label", "<i4")] * (labels is not None))
    table["n"], table["v"] = 3, triangles
    if labels is not None:
        table["label"] = labels
    with open(path, "wb") as file:
        file.write(("ply\nformat binary_little_endian 1.0\n"
                    f"element vertex {len(points)}\nproperty double x\nproperty double y\nproperty double z\n"
                    f"element face {len(triangles)}\nproperty list uchar int vertex_indices\n"
                    + "property int label\n" * (labels is not None) + "end_header\n").encode())
        file.write(np.asarray(points, "<f8").tobytes() + table.tobytes())


def write_glb(path, meshes):
    """Meshes of (attributes by name, triangles): each has a material of its own."""
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(meshes)))}], "nodes": [],
                "meshes": [], "materials": [], "accessors": [], "bufferViews": []}
    data = bytearray()

    def add(values):
        kind = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}[values.shape[1]]
        document["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes})
        document["accessors"].append({"bufferView": len(document["bufferViews"]) - 1, "count": len(values), "type": kind,
                                      "componentType": 5126 if values.dtype.kind == "f" else 5125,
                                      "min": values.min(0).tolist(), "max": values.max(0).tolist()})
        data.extend(values.tobytes())
        return len(document["accessors"]) - 1

    for number, (attributes, triangles) in enumerate(meshes):
        named = {name: add(np.asarray(values, "<f4")) for name, values in attributes.items()}
        document["materials"].append({"name": str(number)})
        document["meshes"].append({"primitives": [{"attributes": named, "material": number, "indices":
                                                   add(np.asarray(triangles, "<u4").reshape(-1, 1))}]})
        document["nodes"].append({"mesh": number})
    document["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(data), 0x004E4942) + data)


def pieces_of(corners, longest):
    """Triangles cut at their longest edges until none is longer than that."""
    done = []
    while len(corners):
        lengths = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
        is_small = lengths.max(1) <= longest
        done.append(corners[is_small])
        corners, lengths = corners[~is_small], lengths[~is_small]
        order = (lengths.argmax(1)[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(corners, order[:, :, None], 1), 1, 0)
        middle = (a + b) / 2
        corners = np.concatenate([np.stack([a, middle, c], 1), np.stack([middle, b, c], 1)])
    return np.concatenate(done)


def distances_to_triangles(points, corners):
    """Of each point to the triangle of its row: to its plane where the foot is inside, else to its edges."""
    best = np.full(len(points), np.inf)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    is_inside = np.ones(len(points), bool)
    for i in range(3):
        start, way = corners[:, i], corners[:, (i + 1) % 3] - corners[:, i]
        off = points - start
        part = np.clip((off * way).sum(1) / np.maximum((way * way).sum(1), 1e-300), 0, 1)
        best = np.minimum(best, np.linalg.norm(off - part[:, None] * way, axis=1))
        is_inside &= (np.cross(way, off) * normal).sum(1) >= 0
    length = np.linalg.norm(normal, axis=1)
    height = np.abs(((points - corners[:, 0]) * normal).sum(1)) / np.maximum(length, 1e-300)
    return np.where(is_inside & (length > 0), np.minimum(best, height), best)


class Finder:
    """The exact distance of points to a surface, by trees of the centres of its pieces: one for each size of them."""

    def __init__(self, surface, longest):
        self.corners = pieces_of(surface.corners(), longest)
        self.centres = self.corners.mean(1)
        reach = np.linalg.norm(self.corners - self.centres[:, None], axis=2).max(1)
        size = np.floor(np.log2(np.maximum(reach, reach.max() / 256)))
        self.all = cKDTree(self.centres)
        self.sizes = [(np.flatnonzero(size == s), reach[size == s].max()) for s in np.unique(size)]
        self.trees = [cKDTree(self.centres[pieces]) for pieces, _ in self.sizes]

    def distances(self, points):
        _, nearest = self.all.query(points)
        best = distances_to_triangles(points, self.corners[nearest])
        for (pieces, reach), tree in zip(self.sizes, self.trees):
            for first in range(0, len(points), 1000):
                some = np.arange(first, min(first + 1000, len(points)))
                found = tree.query_ball_point(points[some], best[some] + reach)
                of_points = np.repeat(some, [len(f) for f in found])
                if len(of_points):
                    hits = pieces[np.concatenate(found).astype(int)]
                    np.minimum.at(best, of_points, distances_to_triangles(points[of_points], self.corners[hits]))
        return best


def samples(surface, count, seed=1):
    random = np.random.default_rng(seed)
    corners = surface.corners()
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    face = random.choice(len(corners), count, p=area / area.sum())
    root, part = np.sqrt(random.random(count)), random.random(count)
    weights = np.stack([1 - root, root * (1 - part), root * part], 1)
    return (weights[:, :, None] * corners[face]).sum(1)


class Input:
    """A surface from which others are measured, in % of its diagonal."""

    def __init__(self, path, count=5000):
        self.surface, self.count = read(path), count
        self.diagonal = self.surface.diagonal()
        self.finder = Finder(self.surface, self.diagonal / 10)
        self.samples = samples(self.surface, count)

    def measure(self, path):
        """RMS there and back, and the greatest distance."""
        result = read(path)
        there = Finder(result, self.diagonal / 10).distances(self.samples)
        back = self.finder.distances(samples(result, self.count))
        rms = [100 * np.sqrt((d * d).mean()) / self.diagonal for d in (there, back)]
        return len(result), *rms, 100 * max(there.max(), back.max()) / self.diagonal
