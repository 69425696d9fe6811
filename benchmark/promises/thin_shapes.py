#!/usr/bin/env python3
"""python3 thin_shapes.py PROGRAM [OPTION...]

How far runs with --no-self-intersection come on twelve thin shapes, with the place of least cost and with endpoints, by two
costs: the faces that are left of a target of four, and the error at a fiftieth of the faces. Prints a table: faces, and RMS
distances both ways in parts of the diagonal; and where more than 1.5 times the faces of endpoints are left, or the error is above
theirs by a tenth. Fails if faces intersect. OPTION... goes to all runs. Needs python3 and numpy.
"""
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

from surfaces import ball, box, cubes, joined, mapped, shells, tube, turned_over, write_off

COSTS = ("quadric", "memoryless")


def bumpy(n, radius):
    surface = ball(n, 1)
    x, y, z = surface[0].T
    return surface[0] * (radius * (1 + 0.1 * np.sin(9 * x) * np.sin(8 * y + 1)))[:, None], surface[1]


def ring(n, thin, pleats=0, out=1.0):
    """A closed ring of 2 n · n triangles."""
    def place(u, v):
        a, b = 2 * np.pi * u, 2 * np.pi * v
        r = thin * (1 + 0.4 * np.sin(pleats * a)) if pleats else thin
        return (out + r * np.cos(b)) * np.cos(a), (out + r * np.cos(b)) * np.sin(a), r * np.sin(b)
    points, triangles = tube(2 * n, n, place)
    last = np.arange(len(points)) % (n + 1) == n
    triangles = np.where(last[triangles], triangles - n, triangles)
    used, numbers = np.unique(triangles, return_inverse=True)
    return points[used], numbers.reshape(triangles.shape)


def spiral_wall(steps, turns, wall):
    def place(x, y, z):
        a = 2 * np.pi * turns * x
        r = 0.3 + 0.1 * turns * x + wall * y
        return r * np.cos(a), r * np.sin(a), z
    return mapped(box((0, 0, 0), (1, 1, 0.6), (steps, 2, 8)), place)


def comb(teeth):
    x = np.arange(2 * teeth - 1)
    full = np.broadcast_to((x[:, None, None] % 2 == 0) | (np.arange(8)[None, :, None] == 0), (len(x), 8, 6))
    return mapped(cubes(full), lambda x, y, z: (np.floor((x - 0.5) / 2) + 0.8 * ((x + 1) % 2), 0.5 * y, 0.5 * z))


def foil(n, thick):
    return mapped(box((0, 0, 0), (1, 1, 1), (n, n, 1)), lambda x, y, z: (x, y, 0.05 * np.sin(9 * x) * np.cos(7 * y) + thick * z))


def hairs(count):
    random = np.random.default_rng(7)
    rod = box((0, 0, 0), (0.012, 0.012, 1), (1, 1, 20))
    return joined((rod[0] + [0.02 * (i % 8), 0.02 * (i // 8), random.uniform(0, 0.1)], rod[1]) for i in range(count))


def shapes():
    yield "three shells, 0.001 apart", shells((1, 0.999, 0.998), 20)
    yield "four shells, 0.02 apart", shells((1, 0.98, 0.96, 0.94), 16)
    yield "hollow ball, wall 0.005", shells((1, 0.995), 24)
    yield "bumpy shell, wall 0.01", shells((1, 0.99), 24, bumpy)
    yield "four plates, 0.003 apart", joined(box((0, 0, 0.053 * i), (1, 1, 0.053 * i + 0.05), (16, 16, 1)) for i in range(4))
    yield "spiral, wall 0.01", spiral_wall(200, 4, 0.01)
    yield "comb", comb(10)
    yield "foil, 0.002 thick", foil(40, 0.002)
    yield "hollow ring, wall 0.01", joined([ring(40, 0.3), turned_over(ring(40, 0.29))])
    yield "pleated hollow ring, wall 0.01", joined([ring(40, 0.3, 9), turned_over(ring(40, 0.29, 9))])
    yield "two rings in each other", joined([ring(36, 0.3), mapped(ring(36, 0.3), lambda x, y, z: (x + 1, z, y))])
    yield "hairs", hairs(40)


def run(program, folder, options):
    """Faces that are left, and the RMS distance in parts of the diagonal."""
    report = os.path.join(folder, "report.json")
    command = [program, os.path.join(folder, "in.off"), os.path.join(folder, "out.off"), "--force", "--quiet", "--no-self-intersection",
               "--measure", "--report", report, *options]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit("%s: %s" % (" ".join(command), done.stderr))
    with open(report) as file:
        result = json.load(file)["results"][0]
    if result["self_intersections"]["after"] > result["self_intersections"]["before"]:
        sys.exit("faces intersect: " + " ".join(command))
    return result["faces"]["after"], result["measured"]["rms"]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, options = sys.argv[1], sys.argv[2:]
    behind = []
    print("| | faces |" + "".join(" %s: of four | endpoints | RMS at 2 %% | endpoints |" % cost for cost in COSTS))
    print("|---|" + "--:|" * (1 + 4 * len(COSTS)))
    with tempfile.TemporaryDirectory() as folder:
        for name, surface in shapes():
            write_off(os.path.join(folder, "in.off"), surface)
            diagonal = np.linalg.norm(np.ptp(surface[0][np.unique(surface[1])], axis=0))
            row = "| %s | %d |" % (name, len(surface[1]))
            for cost in COSTS:
                of = {}
                for placement in ("optimal", "endpoint"):
                    how = ["--cost", cost, "--placement", placement, *options]
                    of[placement] = (run(program, folder, ["--faces", "4", *how])[0], run(program, folder, ["--keep", "2%", *how])[1] / diagonal)
                (faces, error), (faces_of_ends, error_of_ends) = of["optimal"], of["endpoint"]
                row += " %d | %d | %.2e | %.2e |" % (faces, faces_of_ends, error, error_of_ends)
                if faces > 1.5 * faces_of_ends or error > 1.1 * error_of_ends:
                    behind.append("%s, %s" % (name, cost))
            print(row, flush=True)
    print("\nBehind endpoints: " + ("; ".join(behind) or "none"))


if __name__ == "__main__":
    main()
