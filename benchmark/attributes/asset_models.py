# Ten textured assets: of Debian's assimp-testmodels and libcgal-demo, of the folder $QUADRILLE_DATA, and made by formulas.
import os
import sys
import xml.etree.ElementTree as xml

import numpy as np
from asset import Asset, creased_normals, pixels

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../doc/gallery"))
import models as gallery  # noqa: E402

ASSIMP = "/usr/share/assimp/models/Collada/"


def welded(corners):
    """Points and triangles of points of triangles of places; those at one place are one."""
    points, triangles = np.unique(np.asarray(corners, float).reshape(-1, 3), axis=0, return_inverse=True)
    return points, triangles.reshape(-1, 3)


def asset_of(corners, uvs, materials, names, images, normals=None, crease=45):
    """Leaves out triangles without area; makes normals where there are none."""
    points, triangles = welded(corners)
    p = points[triangles]
    is_face = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) > 0
    if normals is None:
        normals = np.zeros(p.shape)
        normals[is_face] = creased_normals(points, triangles[is_face], crease)
    return Asset(*(x[is_face] for x in (p, normals, uvs, materials)), names, images)


# --- Files -----------------------------------------------------------------------------------------

def read_obj(path, images, crease=45):
    """Polygons as fans. `images`: one for each material, in the order in which they come."""
    lists = {"v": [], "vt": [], "vn": []}
    faces, materials, names, current = [], [], [], 0
    with open(path, errors="replace") as file:
        for line in file:
            key, *words = line.split() or ["#"]
            if key in lists:
                lists[key].append([float(x) for x in words[:2 if key == "vt" else 3]])
            elif key == "usemtl":
                names += [] if words[0] in names else [words[0]]
                current = names.index(words[0])
            elif key == "f":
                corners = [[index(x, len(lists[k])) for x, k in zip(word.split("/"), lists)] for word in words]
                faces += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
                materials += [current] * (len(corners) - 2)
    corners = np.array(faces)
    values = {key: np.array(rows)[corners[..., i]] for i, (key, rows) in enumerate(lists.items()) if rows}
    values["vt"][..., 1] = 1 - values["vt"][..., 1]
    return asset_of(values["v"], values["vt"], np.array(materials), names or ["only"], images, values.get("vn"), crease)


def index(word, count):
    return int(word) - 1 if int(word) > 0 else count + int(word)


def duck():
    space = {"c": "http://www.collada.org/2005/11/COLLADASchema"}
    mesh = xml.parse(ASSIMP + "duck.dae").find(".//c:mesh", space)

    def source(name, components):
        return np.array(mesh.find(f"c:source[@id='LOD3spShape-lib-{name}']/c:float_array", space).text.split(),
                        float).reshape(-1, components)

    polygons = mesh.find("c:polylist", space)
    corners = np.array(polygons.find("c:p", space).text.split(), int).reshape(-1, 3)
    faces, first = [], 0
    for count in map(int, polygons.find("c:vcount", space).text.split()):
        faces += [(first, first + i, first + i + 1) for i in range(1, count - 1)]
        first += count
    corners = corners[np.array(faces)]
    uvs = source("map1", 2)[corners[..., 2]] * [1, -1] + [0, 1]
    return asset_of(source("positions", 3)[corners[..., 0]], uvs, np.zeros(len(corners), int), ["duck"],
                    [pixels(ASSIMP + "duckCM.tga")], source("normals", 3)[corners[..., 1]])


def data(name, *images, crease=45):
    folder = os.path.join(os.environ["QUADRILLE_DATA"], "public/textured/")
    return read_obj(folder + name, [pixels(folder + image) if isinstance(image, str) else image for image in images], crease)


def armadillo(meshes, folder):
    """With a chart for each direction of a box, and letters in it."""
    target = os.path.join(folder, "armadillo.obj")
    if not os.path.exists(target):
        gallery.textured(os.path.join(meshes, "armadillo.off"), target)
    return read_obj(target, [pixels(target[:-4] + ".png")], crease=180)


# --- Made ------------------------------------------------------------------------------------------

def field(x, y):
    """A picture without seams: colours of places with period 1, checkered, with rings and slow hues."""
    phases = np.array([0, 2.1, 4.2])
    x, y = np.asarray(x)[..., None], np.asarray(y)[..., None]
    hues = 0.5 + 0.28 * np.sin(2 * np.pi * (2 * x + y) + phases) + 0.17 * np.cos(2 * np.pi * (3 * y - x) + 2 * phases)
    checks = 0.14 * np.tanh(6 * np.sin(2 * np.pi * 8 * x) * np.sin(2 * np.pi * 8 * y))
    return np.clip(hues + checks, 0, 1)


def picture(size=1024):
    texels = (np.arange(size) + 0.5) / size
    return field(*np.meshgrid(texels, texels))


def grid(x, y):
    """Two triangles for each cell of a grid of parameters: (f, 3) of each of x and y."""
    x, y = np.meshgrid(x, y)
    square = lambda a: np.stack([a[:-1, :-1], a[:-1, 1:], a[1:, 1:], a[:-1, :-1], a[1:, 1:], a[1:, :-1]], -1).reshape(-1, 3)
    return square(x), square(y)


class Atlas:
    """Charts that are cells of a picture, with gutters of 4 texels, and what lies between is grey."""
    GUTTER = 4

    def __init__(self, columns, rows, cell):
        self.columns, self.cell, self.used = columns, cell, 0
        self.image = np.full((rows * cell, columns * cell, 3), 0.5)

    def add(self, s, t, colours):
        """Coordinates of a chart in which (s, t) from 0 to 1 is shown, colours(s, t) drawn."""
        left, top = self.used % self.columns * self.cell, self.used // self.columns * self.cell
        self.used += 1
        margin, inner = 2 * self.GUTTER, self.cell - 4 * self.GUTTER
        texels = (np.arange(-self.GUTTER, inner + self.GUTTER) + 0.5) / inner
        x, y = (left + margin, top + margin)
        drawn = slice(y - self.GUTTER, y + inner + self.GUTTER), slice(x - self.GUTTER, x + inner + self.GUTTER)
        self.image[drawn] = colours(*np.meshgrid(texels, texels))
        return np.stack([x + s * inner, y + t * inner], -1) / self.image.shape[1::-1]


def torus(columns=12, rows=8, cells=9):
    """With bumps, 15,552 faces in an atlas of 96 charts; what it shows has no seam."""
    atlas, corners, uvs = Atlas(columns, rows, 96), [], []
    for i in range(columns):
        for j in range(rows):
            x, y = grid(np.arange(i * cells, (i + 1) * cells + 1), np.arange(j * cells, (j + 1) * cells + 1))
            a, b = (2 * np.pi * (n % (cells * count)) / (cells * count) for n, count in ((x, columns), (y, rows)))
            r = 0.4 + 0.04 * np.sin(5 * a) * np.sin(3 * b) + 0.015 * np.sin(11 * a + 2) * np.cos(7 * b)
            corners.append(np.stack([(1 + r * np.cos(b)) * np.cos(a), (1 + r * np.cos(b)) * np.sin(a), r * np.sin(b)], -1))
            uvs.append(atlas.add(x / cells - i, y / cells - j,
                                 lambda s, t, i=i, j=j: field((i + s) / columns, (j + t) / rows)))
    corners, uvs = np.concatenate(corners), np.concatenate(uvs)
    return asset_of(corners, uvs, np.zeros(len(corners), int), ["torus"], [atlas.image], crease=180)


class Parts:
    """A model of several materials, each with an atlas, made of patches of parameters from 0 to 1."""

    def __init__(self, **atlases):
        self.atlases, self.lists = atlases, ([], [], [])

    def add(self, material, place, across, along, tint, shift=0.0):
        s, t = grid(np.linspace(0, 1, across + 1), np.linspace(0, 1, along + 1))
        colours = lambda x, y: np.clip(np.array(tint) * (0.45 + 0.75 * field(x * 0.5 + shift, y * 0.5 + 0.3 * shift)), 0, 1)
        uvs = self.atlases[material].add(s, t, colours)
        number = np.full(len(s), list(self.atlases).index(material))
        for values, new in zip(self.lists, (np.round(np.stack(place(s, t), -1), 9) + 0.0, uvs, number)):
            values.append(new)

    def asset(self, crease):
        corners, uvs, materials = (np.concatenate(values) for values in self.lists)
        return asset_of(corners, uvs, materials, list(self.atlases), [a.image for a in self.atlases.values()], crease=crease)


def turned(radius, height, first=0.0, last=1.0):
    """A patch of a surface of revolution about z: radius and height of (t, angle)."""
    def place(s, t):
        angle = 2 * np.pi * np.where((s == 1) & (last == 1), 0, first + (last - first) * s)
        r = radius(t, angle)
        return r * np.cos(angle), r * np.sin(angle), height(t, angle)
    return place


def helmet():
    """A shell with a rim and ribs, a visor before it, two pods with hard edges, a padded ring: four materials."""
    parts = Parts(paint=Atlas(4, 2, 256), glass=Atlas(1, 1, 256), metal=Atlas(4, 3, 128), padding=Atlas(2, 2, 256))
    rib = lambda a: 1 + 0.02 * np.exp(-40 * np.sin(a) ** 2) + 0.008 * np.cos(6 * a)
    polar = lambda t: 0.5 * np.pi * (0.04 + 0.96 * t)
    dent = lambda t, a: 1 + 0.012 * np.sin(9 * polar(t)) * np.cos(4 * a)
    for quarter in range(4):
        ends = dict(first=quarter / 4, last=(quarter + 1) / 4)
        outer = turned(lambda t, a: np.sin(polar(t)) * rib(a) * dent(t, a), lambda t, a: 1.2 * np.cos(polar(t)) * dent(t, a), **ends)
        parts.add("paint", outer, 40, 44, (0.9, 0.55, 0.3), 0.25 * quarter)
        inner = turned(lambda t, a: 0.93 * np.sin(polar(1 - t)) * rib(a), lambda t, a: 1.12 * np.cos(polar(1 - t)), **ends)
        parts.add("paint", inner, 24, 20, (0.5, 0.5, 0.6), 0.25 * quarter + 0.1)
    for half in range(2):
        ring = turned(lambda t, a: 0.99 + 0.07 * np.cos(2 * np.pi * t) + 0.01 * np.sin(24 * a),
                      lambda t, a: -0.05 + 0.07 * np.sin(2 * np.pi * t), half / 2, (half + 1) / 2)
        parts.add("padding", ring, 80, 20, (0.7, 0.75, 0.8), 0.5 * half)
    visor = turned(lambda t, a: 1.06 * np.sin(0.5 * np.pi * (0.45 + 0.5 * t)) * (1 + 0.03 * np.cos(3 * a)),
                   lambda t, a: 1.15 * np.cos(0.5 * np.pi * (0.45 + 0.5 * t)), -0.2, 0.2)
    parts.add("glass", visor, 48, 24, (0.4, 0.7, 0.95))
    for side in (1, -1):
        steps = ((0, 0.1, 0.98), (0.22, 0.0, 0.98), (0.22, 0.0, 1.12), (0.16, 0.0, 1.12), (0.16, 0.0, 1.2), (0, 0.0, 1.2))
        for (r0, _, y0), (r1, _, y1) in zip(steps, steps[1:]):
            pod = lambda s, t, r0=r0, r1=r1, y0=y0, y1=y1: (
                (r0 + (r1 - r0) * t) * np.cos(2 * np.pi * (s % 1)), side * (y0 + (y1 - y0) * t),
                0.25 + side * (r0 + (r1 - r0) * t) * np.sin(2 * np.pi * (s % 1)))
            parts.add("metal", pod, 48, 8, (0.8, 0.8, 0.75), 0.1 * r1)
    return parts.asset(crease=40)


def models(meshes, folder):
    """Functions that make them, by name; those of $QUADRILLE_DATA where that is set."""
    found = {"duck": duck, "torus": torus, "helmet": helmet, "armadillo": lambda: armadillo(meshes, folder)}
    if "QUADRILLE_DATA" in os.environ:
        found.update(
            spot=lambda: data("spot_6k.obj", "spot_texture.png", crease=180),
            scissors=lambda: data("scissors_16k.obj", "ycb_scissors.png"),
            banana=lambda: data("banana_16k.obj", "ycb_banana.png"),
            bunny=lambda: data("bunny_textured_10k.obj", "TextureDouble_A.png", crease=180),
            steampunk=lambda: data("steampunk_24k.obj", *(f"steampunk_{part}.png" for part in ("Body", "L_Limbs", "R_Limbs"))),
            boat=lambda: data("boat_32k.obj", picture()))
    return found
