#!/usr/bin/env python3
# Makes the models of the gallery that are not in Debian's libcgal-demo. Needs python3-numpy and
# python3-pil.
#   models.py textured IN.off OUT.obj   six charts, one for each direction of a box, with OUT.mtl and
#                                       OUT.png: in each chart a grid of letters in a colour of its own
#   models.py regions IN.off OUT.ply [NAME]   eight regions as colours of faces, or as a property NAME
#   models.py tolerance IN.off OUT.ply        a scalar of vertices, and its colours
#   models.py painted IN.ply OUT.ply NAME     the property NAME of the faces as colours of these
#   models.py spiral OUT.off            a closed wall that winds around, four times as far from itself as it is thick
#   models.py crossing IN.off OUT.ply   with faces in red that pass through others; prints how many such pairs there are
#   models.py debris IN.off OUT.off     with 40 small balls around it
#   models.py sheet OUT.off             a dome with a wavy border
#   models.py houses OUT.off            cuboids on a plate, of voxels
import colorsys
import sys

import numpy as np
from PIL import Image, ImageDraw, ImageFont

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"


def read_off(path):
    with open(path) as file:
        words = [word for line in file for word in line.split("#")[0].split()]
    vertices, faces = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * vertices], float).reshape(-1, 3)
    triangles = np.array(words[4 + 3 * vertices:4 + 3 * vertices + 4 * faces], int).reshape(-1, 4)
    if not (triangles[:, 0] == 3).all():
        raise SystemExit(f"{path}: not a triangle mesh")
    return points, triangles[:, 1:]


def write_off(path, points, triangles):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        for p in points:
            file.write("%.9g %.9g %.9g\n" % tuple(p))
        for t in triangles:
            file.write("3 %d %d %d\n" % tuple(t))


def face_normals(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


def neighbours(triangles):
    """Of each face the faces behind its three edges, -1 where there is none."""
    sides = {}
    result = np.full(triangles.shape, -1)
    for f, triangle in enumerate(triangles):
        for i in range(3):
            v, w = int(triangle[i]), int(triangle[(i + 1) % 3])
            if (w, v) in sides:
                g, j = sides[w, v]
                result[f, i], result[g, j] = g, f
            sides[v, w] = f, i
    return result


def components(labels, beside):
    """The components of faces with one label: lists of faces."""
    seen = np.zeros(len(labels), bool)
    found = []
    for start in range(len(labels)):
        if seen[start]:
            continue
        seen[start] = True
        part = [start]
        for f in part:
            for g in beside[f]:
                if g >= 0 and not seen[g] and labels[g] == labels[f]:
                    seen[g] = True
                    part.append(g)
        found.append(part)
    return found


# --- Textured models -----------------------------------------------------------------------------

DIRECTIONS = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
HUES = [0.04, 0.04, 0.13, 0.13, 0.57, 0.57]


def chart_of_faces(points, triangles):
    """For each face a direction of the box that it does not look away from; few and large charts."""
    normals = face_normals(points, triangles)
    beside = neighbours(triangles)
    smooth = normals.copy()
    for _ in range(40):
        smooth = smooth + sum(np.where(beside[:, i:i + 1] >= 0, smooth[beside[:, i]], 0) for i in range(3))
        smooth /= np.maximum(np.linalg.norm(smooth, axis=1, keepdims=True), 1e-300)
    may_be = normals @ DIRECTIONS.T > 0.15
    charts = np.argmax(np.where(may_be, smooth @ DIRECTIONS.T, -9), axis=1)
    for least in (20, 60, 200, 500):
        for part in components(charts, beside):
            if len(part) >= least:
                continue
            around = [charts[g] for f in part for g in beside[f] if g >= 0 and charts[g] != charts[f]]
            for chart in sorted(set(around), key=around.count, reverse=True):
                if may_be[part, chart].all():
                    charts[part] = chart
                    break
    return charts


def place_in_atlas(points, charts_of_corners):
    """Texture coordinates: the points seen from each direction, in 3 x 2 cells with a margin."""
    low, size = points.min(axis=0), np.ptp(points, axis=0).max()
    unit = (points - low - np.ptp(points, axis=0) / 2) / size + 0.5
    uv = np.empty((len(points), 2))
    for chart in range(6):
        axis, flip = chart // 2, 1 if chart % 2 == 0 else -1
        right, up = {0: (2, 1), 1: (0, 2), 2: (0, 1)}[axis]
        is_of = charts_of_corners == chart
        u = unit[is_of, right]
        mirrored = (axis == 0) == (flip > 0) if axis != 1 else flip > 0
        uv[is_of, 0] = ((1 - u if mirrored else u) * 0.94 + 0.03 + chart % 3) / 3
        uv[is_of, 1] = (unit[is_of, up] * 0.94 + 0.03 + chart // 3) / 2
    return uv


def atlas(cell=768, squares=10):
    image = Image.new("RGB", (3 * cell, 2 * cell), "white")
    draw = ImageDraw.Draw(image)
    font = ImageFont.truetype(FONT, int(0.62 * cell / squares))
    for chart in range(6):
        left, top = chart % 3 * cell, (1 - chart // 3) * cell
        for row in range(squares):
            for column in range(squares):
                x, y = left + column * cell / squares, top + row * cell / squares
                odd = (row + column) % 2
                hue = (HUES[chart] + 0.06 * (column / squares - 0.5)) % 1
                fill, ink = (colorsys.hsv_to_rgb(hue, s, v) for s, v in
                             ([(0.48, 0.9), (0.1, 1)] if odd else [(0.12, 1), (0.7, 0.62)]))
                draw.rectangle([x, y, x + cell / squares, y + cell / squares],
                               tuple(int(255 * c) for c in fill))
                draw.text((x + cell / squares / 2, y + cell / squares / 2),
                          "ABCDEFGHIJ"[row] + str(column), tuple(int(255 * c) for c in ink), font, "mm")
    return image


def textured(source, target):
    points, triangles = read_off(source)
    charts = chart_of_faces(points, triangles)
    corners, inverse = np.unique(np.stack([triangles, np.repeat(charts[:, None], 3, 1)], -1).reshape(-1, 2),
                                 axis=0, return_inverse=True)
    uv = place_in_atlas(points[corners[:, 0]], corners[:, 1])
    inverse = inverse.reshape(-1, 3)
    name = target.rsplit("/", 1)[-1][:-4]
    with open(target, "w") as file:
        file.write(f"mtllib {name}.mtl\n")
        file.writelines("v %.9g %.9g %.9g\n" % tuple(p) for p in points)
        file.writelines("vt %.9g %.9g\n" % tuple(t) for t in uv)
        file.write("usemtl letters\n")
        file.writelines("f %d/%d %d/%d %d/%d\n" % (a + 1, i + 1, b + 1, j + 1, c + 1, k + 1)
                        for (a, b, c), (i, j, k) in zip(triangles, inverse))
    with open(target[:-4] + ".mtl", "w") as file:
        file.write(f"newmtl letters\nmap_Kd {name}.png\n")
    atlas().save(target[:-4] + ".png")


# --- Regions -------------------------------------------------------------------------------------

PALETTE = [(228, 120, 85), (120, 170, 215), (240, 200, 100), (130, 185, 130), (180, 145, 200), (235, 228, 212),
           (235, 165, 185), (120, 130, 140)]
PLY_HEADER = """ply
format ascii 1.0
element vertex %d
property double x
property double y
property double z
element face %d
property list uchar int vertex_indices
%send_header
"""


def write_ply(path, points, triangles, properties, values):
    """`properties` are lines of the header, `values` those of each face."""
    with open(path, "w") as file:
        file.write(PLY_HEADER % (len(points), len(triangles), properties))
        file.writelines("%.9g %.9g %.9g\n" % tuple(p) for p in points)
        file.writelines("3 %d %d %d %s\n" % (*t, value) for t, value in zip(triangles, values))


def write_painted(path, points, triangles, regions):
    write_ply(path, points, triangles, "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")),
              ["%d %d %d" % PALETTE[r] for r in regions])


def regions(source, target, name=None):
    points, triangles = read_off(source)
    middles = points[triangles].mean(axis=1)
    size = np.ptp(points, axis=0).max()
    middles += 0.05 * size * np.sin(22 / size * np.roll(middles, 1, axis=1))  # for wavy borders
    seeds = [0]
    near = np.linalg.norm(middles - middles[0], axis=1)
    while len(seeds) < len(PALETTE):  # each as far as can be from those before it
        seeds.append(int(near.argmax()))
        near = np.minimum(near, np.linalg.norm(middles - middles[seeds[-1]], axis=1))
    region = np.linalg.norm(middles[:, None] - middles[seeds][None], axis=2).argmin(axis=1)
    if name:
        write_ply(target, points, triangles, f"property int {name}\n", region)
    else:
        write_painted(target, points, triangles, region)


def painted(source, target, name):
    """Of a binary PLY file of points and triangles whose faces have the int NAME and nothing else."""
    with open(source, "rb") as file:
        data = file.read()
    end = data.index(b"end_header\n") + len("end_header\n")
    header = data[:end].decode().split("\n")
    if f"property int {name}" != header[-3]:
        raise SystemExit(f"{source}: {name} is not the last property of its faces")
    vertices, faces = (int(line.split()[2]) for line in header if line.startswith("element"))
    points = np.frombuffer(data, "<f8", 3 * vertices, end).reshape(-1, 3)
    rows = np.frombuffer(data, [("size", "u1"), ("corners", "<u4", 3), ("value", "<i4")], faces,
                         end + points.nbytes)
    write_painted(target, points, rows["corners"], rows["value"])


def tolerance(source, target):
    """Vertices with the tolerance `allowed`: 0.0002 of the size at the bunny's head, 0.02 behind, and as colours."""
    points, triangles = read_off(source)
    low, span = points.min(axis=0), np.ptp(points, axis=0)
    place = (points - low) / span
    part = np.clip(2 * (place[:, 0] - place[:, 1]) + 1, 0, 1)  # of the way from the head
    allowed = np.linalg.norm(span) * (0.0002 + part * (0.02 - 0.0002))
    strict, loose = np.array([205, 80, 60]), np.array([226, 220, 205])
    vertices = np.empty(len(points), [("p", "<f8", 3), ("colour", "u1", 3), ("allowed", "<f8")])
    vertices["p"], vertices["allowed"] = points, allowed
    vertices["colour"] = np.rint(strict + part[:, np.newaxis] * (loose - strict))
    faces = np.empty(len(triangles), [("size", "u1"), ("corners", "<u4", 3)])
    faces["size"], faces["corners"] = 3, triangles
    properties = [f"property double {c}" for c in "xyz"] + [f"property uchar {c}" for c in ("red", "green", "blue")]
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}", *properties,
              "property double allowed", f"element face {len(triangles)}", "property list uchar uint vertex_indices",
              "end_header", ""]
    with open(target, "wb") as file:
        file.write("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())


# --- Parts and borders ---------------------------------------------------------------------------

def ball(centre, radius):
    """20 faces."""
    g = (1 + 5 ** 0.5) / 2
    points = np.array([(0, a, b * g) for a in (-1, 1) for b in (-1, 1)], float)
    points = np.concatenate([np.roll(points, k, axis=1) for k in range(3)])
    near = [[j for j in range(12) if abs(np.linalg.norm(points[i] - points[j]) - 2) < 1e-9] for i in range(12)]
    triangles = [(i, j, k) for i in range(12) for j in near[i] for k in near[j]
                 if i < j and i < k and k in near[i] and np.linalg.det(points[[i, j, k]]) > 0]
    return centre + radius * points / np.linalg.norm(points[0]), np.array(triangles)


def debris(source, target):
    points, triangles = read_off(source)
    middle, size = (points.min(axis=0) + points.max(axis=0)) / 2, np.ptp(points, axis=0).max()
    random = np.random.RandomState(1997)
    for _ in range(40):
        direction = random.normal(size=3)
        centre = middle + direction / np.linalg.norm(direction) * size * (0.72 + 0.12 * random.rand())
        more, faces = ball(centre, size * (0.006 + 0.004 * random.rand()))
        triangles = np.concatenate([triangles, faces + len(points)])
        points = np.concatenate([points, more])
    write_off(target, points, triangles)


def sheet(target, rings=44, lobes=9):
    points, triangles = [(0, 0, 0.35)], []
    columns = 6 * lobes * 4
    for ring in range(1, rings + 1):
        for i in range(columns):
            angle, r = 2 * np.pi * (i + ring % 2 / 2) / columns, ring / rings
            radius = r * (1 + 0.16 * r ** 3 * np.cos(lobes * angle))
            points.append((radius * np.cos(angle), radius * np.sin(angle),
                           0.35 * (1 - r * r) + 0.05 * r * np.sin(5 * angle + 3 * r)))
    for i in range(columns):
        triangles.append((0, 1 + i, 1 + (i + 1) % columns))
    for ring in range(1, rings):
        first, second = 1 + (ring - 1) * columns, 1 + ring * columns
        for i in range(columns):
            n = (i + 1) % columns
            if ring % 2:
                triangles += [(first + i, second + i, first + n), (first + n, second + i, second + n)]
            else:
                triangles += [(first + i, second + i, second + n), (first + i, second + n, first + n)]
    write_off(target, points, triangles)


def spiral(target, turns=4, steps=400, height=16, thickness=0.02, pitch=0.1):
    """A wall around the origin, from one radius to a larger one, as a tube of `height` squares with closed ends."""
    ring = [(0, i) for i in range(height + 1)] + [(1, i) for i in range(height, -1, -1)]
    points, triangles, n = [], [], len(ring)
    for step in range(steps + 1):
        angle = 2 * np.pi * turns * step / steps
        for side, level in ring:
            radius = 0.4 + pitch * angle / (2 * np.pi) + thickness * side
            points.append((radius * np.cos(angle), radius * np.sin(angle), 0.4 * level / height))
    for step in range(steps):
        for i in range(n):
            a, b = step * n + i, step * n + (i + 1) % n
            triangles += [(a, a + n, b + n), (a, b + n, b)]
    for first, is_end in ((0, False), (steps * n, True)):
        for i in range(height):
            a, b, c, d = first + i, first + i + 1, first + n - 2 - i, first + n - 1 - i
            triangles += [(a, c, b), (a, d, c)] if is_end else [(a, b, c), (a, c, d)]
    write_off(target, points, triangles)


def crossing(source, target):
    points, triangles = read_off(source)
    corners = points[triangles]
    a, u, v = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    pairs, e = set(), 1e-9
    for i in range(3):  # do these sides of faces go through other faces?
        p, d = corners[:, i], corners[:, (i + 1) % 3] - corners[:, i]
        for face in range(len(triangles)):
            normal = np.cross(u[face], v[face])
            with np.errstate(all="ignore"):
                along = (a[face] - p) @ normal / (d @ normal)
                q = p + along[:, np.newaxis] * d - a[face]
                s, t = np.cross(q, v[face]) @ normal / (normal @ normal), np.cross(u[face], q) @ normal / (normal @ normal)
            for other in np.flatnonzero((along > e) & (along < 1 - e) & (s > e) & (t > e) & (s + t < 1 - e)):
                pairs.add((min(face, other), max(face, other)))
    colours = ["226 220 205"] * len(triangles)
    for face in {face for pair in pairs for face in pair}:
        colours[face] = "205 60 40"
    write_ply(target, points, triangles, "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")), colours)
    print(len(pairs))


def houses(target, size=56, count=34):
    random = np.random.default_rng(3)
    height = np.full((size, size), 3)
    height[[0, -1], :] = height[:, [0, -1]] = 0
    for _ in range(count):
        x, y = random.integers(2, size - 10, 2)
        u, v = random.integers(3, 9, 2)
        height[x:x + u, y:y + v] = random.integers(4, 15)
    solid = np.arange(height.max() + 2) < height[:, :, None]
    number, triangles = {}, []
    for cube in np.argwhere(solid):
        for axis in range(3):
            for side in (0, 1):
                beside = cube.copy()
                beside[axis] += 2 * side - 1
                if (beside >= 0).all() and (beside < solid.shape).all() and solid[tuple(beside)]:
                    continue
                corners = []
                for along, across in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = cube.copy()
                    p[axis] += side
                    p[(axis + 1) % 3] += along
                    p[(axis + 2) % 3] += across
                    corners.append(number.setdefault(tuple(p), len(number)))
                a, b, c, d = corners if side else reversed(corners)
                triangles += [(a, b, c), (a, c, d)]
    write_off(target, np.array(list(number), float), triangles)


if __name__ == "__main__":
    globals()[sys.argv[1]](*sys.argv[2:])
