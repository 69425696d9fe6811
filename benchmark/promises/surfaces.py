"""Surfaces that anyone can make, as points and triangles, and files of them. Needs numpy."""
import numpy as np


def sheet(columns, rows, place):
    """A grid whose point at (u, v) in the unit square is place(u, v)."""
    u, v = np.meshgrid(np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1), indexing="ij")
    points = np.stack(place(u.ravel(), v.ravel()), 1)
    k = np.arange((columns + 1) * (rows + 1)).reshape(columns + 1, rows + 1)
    a, b, c, d = (x.ravel() for x in (k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]))
    return points, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def tube(columns, rows, place):
    """The same, closed in u."""
    points, triangles = sheet(columns, rows, place)
    triangles = np.where(triangles // (rows + 1) == columns, triangles - columns * (rows + 1), triangles)
    return points, triangles


def cubes(is_solid):
    """The faces between full and empty cells of a lattice, which need not be manifold."""
    full = np.pad(is_solid, 1)
    corners, triangles = {}, []

    def corner(p):
        return corners.setdefault(tuple(p), len(corners))
    for axis in range(3):
        step = np.eye(3, dtype=int)[axis]
        u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
        for cell in np.argwhere(full != np.roll(full, -1, axis)):
            base = cell + step
            a, b, c, d = (corner(base + w) for w in (0 * u, u, u + v, v))
            turned = not full[tuple(cell)]
            triangles += [(a, c, b), (a, d, c)] if turned else [(a, b, c), (a, c, d)]
    return np.array(list(corners), float), np.array(triangles)


def box(low, high, counts):
    """A closed box, its sides grids."""
    points, triangles = cubes(np.ones(counts, bool))
    return np.array(low) + (points - 1) * (np.array(high, float) - low) / counts, triangles


def ball(n, radius=1.0):
    """A closed ball of 12 n² triangles."""
    points, triangles = box((-1, -1, -1), (1, 1, 1), (n, n, n))
    return radius * points / np.linalg.norm(points, axis=1)[:, None], triangles


def mapped(surface, place):
    """With its points at place(x, y, z)."""
    return np.stack(np.broadcast_arrays(*place(*surface[0].T)), 1), surface[1]


def turned_over(surface):
    return surface[0], surface[1][:, ::-1]


def joined(surfaces):
    points, triangles, begin = [], [], 0
    for p, t in surfaces:
        points.append(p)
        triangles.append(t + begin)
        begin += len(p)
    return np.concatenate(points), np.concatenate(triangles)


def shells(radii, n, make=ball):
    """Closed surfaces in each other, turned in and out by turns, from the outer one on."""
    return joined(make(n, r) if i % 2 == 0 else turned_over(make(n, r)) for i, r in enumerate(radii))


def write_off(path, surface):
    points, triangles = surface
    with open(path, "w") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(triangles)))
        np.savetxt(file, points, "%.17g")
        np.savetxt(file, np.column_stack([np.full(len(triangles), 3), triangles]), "%d")
