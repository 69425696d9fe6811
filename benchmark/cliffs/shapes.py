"""Surfaces of which something is held: assemblies, foliage, scenes, networks, labels, mirrored textures, rings."""
import numpy as np

from surfaces import write_glb, write_ply


def grid(columns, rows, is_closed=False):
    """Triangles between (columns + 1) by rows points, or columns by rows of which the last column meets the first."""
    i, j = np.meshgrid(np.arange(columns), np.arange(rows - 1), indexing="ij")
    width = columns if is_closed else columns + 1
    a, b = i + j * width, (i + 1) % width + j * width
    return np.concatenate([np.stack([a, b, b + width], -1), np.stack([a, b + width, a + width], -1)]).reshape(-1, 3)


def together(parts):
    first = np.cumsum([0] + [len(points) for points, _ in parts])
    return np.concatenate([p for p, _ in parts]), np.concatenate([t + n for (_, t), n in zip(parts, first)])


def prism(sides, radius, height, centre):
    """A closed one, with points in the middle of its ends."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = [np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(sides, z)], 1) for z in (0., height)]
    points = np.concatenate(ring + [[[0, 0, 0], [0, 0, height]]]) + centre
    i, n = np.arange(sides), (np.arange(sides) + 1) % sides
    return points, np.concatenate([np.stack(x, 1) for x in (
        (i, n, n + sides), (i, n + sides, i + sides), (n, i, 0 * i + 2 * sides), (i + sides, n + sides, 0 * i + 2 * sides + 1))])


def normals(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    sums = np.zeros_like(points)
    for i in range(3):
        np.add.at(sums, triangles[:, i], np.cross(b - a, c - a))
    return sums / np.maximum(np.linalg.norm(sums, axis=1), 1e-30)[:, None]


def pipes(random, count):
    """An assembly: long pipes of many sides, open at both ends and with a wall, and bolts."""
    parts = []
    for k in range(count):
        u, t = np.arange(64) * 2 * np.pi / 64, np.linspace(0, 10, 8)
        tube = [np.stack([r * np.cos(u)[None] + 0 * t[:, None], r * np.sin(u)[None] + 0 * t[:, None],
                          t[:, None] + 0 * u[None]], -1).reshape(-1, 3) for r in (1., .9)]
        wall = grid(64, 8, True)
        ends = np.concatenate([np.stack([wall[:64, 0], wall[:64, 0] + 512, wall[:64, 1]], 1)])
        points = np.concatenate(tube) + [2.5 * k, 0, 0]
        parts.append((points, np.concatenate([wall, wall[:, ::-1] + 512, ends])))
        parts += [prism(6, .1, .2, [2.5 * k + 1.1 * np.cos(a), 1.1 * np.sin(a), random.uniform(0, 9)])
                  for a in random.uniform(0, 6.28, 20)]
    return together(parts)


def perforated(holes):
    """A plate with rows of square holes, and small cubes beside it."""
    cells = np.ones((2 * holes + 1, 2 * 6 + 1, 1), int)
    cells[1::2, 1::2] = 0
    points, triangles, _ = walls(np.kron(cells, np.ones((3, 3, 2), int)))
    cubes = [prism(4, .5, .7, [4. * (i % 12), 45 + 2. * (i // 12), 0]) for i in range(30)]
    return together([(points, triangles)] + cubes)


def walls(labels):
    """The walls between voxels of different labels, in two triangles each, and the label inside of each."""
    labels = np.pad(labels, 1)
    shape = np.array(labels.shape) + 1
    quads, inside = [], []
    for axis in range(3):
        low, high = np.delete(labels, -1, axis), np.delete(labels, 0, axis)
        place = np.argwhere(low != high)
        one, other = low[tuple(place.T)], high[tuple(place.T)]
        place[:, axis] += 1
        u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
        corners = np.stack([np.ravel_multi_index((place + o).T, shape) for o in (0 * u, u, u + v, v)], 1)
        corners[one < other] = corners[one < other][:, ::-1]
        quads.append(corners)
        inside.append(256 * np.maximum(one, other) + np.minimum(one, other))
    quads, inside = np.concatenate(quads), np.concatenate(inside)
    used, numbers = np.unique(np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]), return_inverse=True)
    return np.stack(np.unravel_index(used, shape), 1) - 1., numbers.reshape(-1, 3), np.tile(inside, 2)


def neuron(random, steps):
    """Voxels of a walk that branches: tubes that touch along edges."""
    cells, heads = np.zeros((36, 36, 36), int), [np.array([18, 18, 18])]
    for _ in range(steps):
        k = random.integers(len(heads))
        way = np.eye(3, dtype=int)[random.integers(3)] * random.choice([-1, 1])
        for _ in range(random.integers(3, 9)):
            heads[k] = np.clip(heads[k] + way, 2, 33)
            cells[tuple(heads[k])] = 1
            if random.random() < .3:
                cells[tuple(np.clip(heads[k] + random.integers(-1, 2, 3), 1, 34))] = 1
        if random.random() < .3:
            heads.append(heads[k].copy())
    points, triangles, _ = walls(np.kron(cells, np.ones((2, 2, 2), int)))
    return smoothed(points, triangles, 5), triangles


def smoothed(points, triangles, rounds):
    edges = np.unique(np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), 1), axis=0)
    for _ in range(rounds):
        sums, count = np.zeros_like(points), np.zeros(len(points))
        for a, b in (edges.T, edges.T[::-1]):
            np.add.at(sums, a, points[b])
            np.add.at(count, a, 1)
        points = .5 * points + .5 * sums / count[:, None]
    return points


def organs(random, size, count):
    """A body of labels: balls of many sizes in a ball, with their walls shared."""
    x = np.stack(np.meshgrid(*[np.arange(size)] * 3, indexing="ij"), -1)
    away = np.linalg.norm((x - size / 2) / [.46 * size, .4 * size, .32 * size], axis=-1)
    labels = (away < 1).astype(int) + (away < .9)
    for k in range(count):
        centre, radius = size * random.uniform(.3, .7, 3), random.choice([1.5, 2.2, .1 * size, .16 * size])
        labels[(np.linalg.norm(x - centre, axis=-1) < radius) & (away < .85)] = 3 + k
    return walls(labels)


def ring(u, v):
    a, b = np.meshgrid(2 * np.pi * np.arange(u) / u, 2 * np.pi * np.arange(v) / v)
    points = np.stack([(8 + np.cos(b)) * np.cos(a), (8 + np.cos(b)) * np.sin(a), np.sin(b)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(u), np.arange(v))
    at = lambda i, j: (i % u) + (j % v) * u
    return points, np.concatenate([np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], -1),
                                   np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], -1)]).reshape(-1, 3)


def foliage(random, leaves):
    """A bent trunk and leaf cards of two faces, as meshes of a document."""
    u, v = np.meshgrid(np.linspace(0, 1, 29), np.linspace(0, 1, 40))
    bend, radius = .2 * np.sin(3 * v), .1 * (1.3 - v)
    trunk = np.stack([bend + radius * np.cos(2 * np.pi * u), 2 * v, radius * np.sin(2 * np.pi * u)], -1).reshape(-1, 3)
    trunk[28::29] = trunk[::29]
    bark = grid(28, 40)[:, ::-1]
    centre = random.normal(size=(leaves, 3)) * .45 + [0, 2, 0]
    a, b = random.normal(size=(2, leaves, 3))
    a /= np.linalg.norm(a, axis=1)[:, None]
    b = np.cross(a, b)
    b /= np.linalg.norm(b, axis=1)[:, None]
    cards = np.stack([centre + .04 * (s * a + t * b) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))], 1).reshape(-1, 3)
    first = 4 * np.arange(leaves)[:, None]
    leaf = np.concatenate([first + [0, 1, 2], first + [0, 2, 3]])
    texture = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (leaves, 1))
    return [({"POSITION": trunk, "NORMAL": normals(trunk, bark), "TEXCOORD_0": np.stack([u, v], -1).reshape(-1, 2)}, bark),
            ({"POSITION": cards, "NORMAL": normals(cards, leaf), "TEXCOORD_0": texture}, leaf)]


def scene(random, props):
    """A ground with a lake, and small props on it."""
    u, v = np.meshgrid(np.linspace(0, 1, 26), np.linspace(0, 1, 26))
    height = .2 * np.sin(6 * u) * np.sin(5 * v + 1) - .4 * np.exp(-((u - .35) ** 2 + (v - .6) ** 2) / .02)
    ground = np.stack([4 * u, 4 * v, height], -1).reshape(-1, 3)
    parts = []
    for _ in range(props):
        size = random.uniform(.03, .07)
        parts.append(prism(random.integers(4, 11), .5 * size, size, ground[random.integers(len(ground))]))
    points, triangles = together(parts)
    return [({"POSITION": ground, "NORMAL": normals(ground, grid(25, 26))}, grid(25, 26)),
            ({"POSITION": points, "NORMAL": normals(points, triangles)}, triangles)]


def mirrored(random, patches):
    """A ball, the sign of whose tangents turns in patches with ragged borders."""
    u, v = np.meshgrid(np.linspace(0, 1, 81), np.linspace(0, 1, 55))
    a, b = 2 * np.pi * u, np.pi * v
    ball = np.stack([np.cos(a) * np.sin(b), np.sin(a) * np.sin(b), np.cos(b)], -1)
    ball[0], ball[-1], ball[:, -1] = [0, 0, 1], [0, 0, -1], ball[:, 0]
    sign = np.where(np.sin(patches * a) + .3 * random.normal(size=a.shape) > 0, 1., -1.)
    tangent = np.stack([-np.sin(a), np.cos(a), 0 * a, sign], -1).reshape(-1, 4)
    texture = np.stack([np.abs(patches * u % 2 - 1), v], -1).reshape(-1, 2)
    ball = ball.reshape(-1, 3)
    triangles = grid(80, 55)[:, ::-1]
    lengths = np.linalg.norm(np.cross(ball[triangles[:, 1]] - ball[triangles[:, 0]],
                                      ball[triangles[:, 2]] - ball[triangles[:, 0]]), axis=1)
    return [({"POSITION": ball, "NORMAL": ball, "TEXCOORD_0": texture, "TANGENT": tangent}, triangles[lengths > 1e-9])]


def make_all(folder, seed=1):
    """The paths of all of them."""
    def random():
        return np.random.default_rng(seed)

    paths = []
    for name, meshes in (("foliage", foliage(random(), 1200)), ("scene", scene(random(), 80)),
                         ("mirrored", mirrored(random(), 3))):
        paths.append(folder / f"{name}.glb")
        write_glb(paths[-1], meshes)
    for name, surface in (("pipes", pipes(random(), 4)), ("perforated", perforated(9)), ("neuron", neuron(random(), 50)),
                          ("organs", organs(random(), 36, 12)), ("ring", ring(120, 24))):
        paths.append(folder / f"{name}.ply")
        write_ply(paths[-1], *surface)
    return paths
