#!/usr/bin/env python3
"""python3 verify_times.py PROGRAM [--csv FILE]

How long --verify takes: twenty flat and twenty curved surfaces of about 10,000 faces are simplified to three limits of the
distance, both ways, with and without --verify. Prints a table, and fails if a promise is called broken or a look at it takes
longer than ten seconds. Needs python3 and numpy.
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

from surfaces import cubes, sheet, tube, write_off

LIMITS = ("0.1%", "0.5%", "1%")
MOST_SECONDS = 10


# Surfaces

def blob(seed, size=36):
    random = np.random.default_rng(seed)
    x = np.stack(np.meshgrid(*[np.linspace(-1, 1, size)] * 3, indexing="ij"))
    field = sum(np.sin(random.normal(0, 3, 3) @ x.reshape(3, -1) + random.uniform(0, 6)) for _ in range(4))
    return cubes((field.reshape(size, size, size) > 0.3) & ((x ** 2).sum(0) < 1))


def stairs(seed, size=72):
    heights = np.random.default_rng(seed).integers(1, 6, (size // 4, size // 4)).repeat(4, 0).repeat(4, 1)
    return cubes(np.arange(6)[None, None, :] < heights[:, :, None])


def flat_surfaces():
    random = np.random.default_rng(1)
    plane = lambda u, v: (u, v, 0 * u)
    yield "square", sheet(70, 70, plane)
    yield "strip", sheet(500, 10, lambda u, v: (50 * u, v, 0 * u))
    yield "tilted square", sheet(70, 70, lambda u, v: (0.36 * u - 0.48 * v, 0.8 * u + 0.6 * v, 0.48 * u - 0.64 * v + 7))
    yield "ruled grid", sheet(70, 70, lambda u, v: (u ** 3, v ** 3, 0 * u))
    points, triangles = sheet(70, 70, plane)
    points[:, :2] += random.uniform(-0.004, 0.004, (len(points), 2))
    yield "jagged square", (points, triangles)
    yield "pleats", sheet(70, 70, lambda u, v: (u, v, 0.1 * np.abs((7 * u) % 2 - 1)))
    yield "pyramid", sheet(70, 70, lambda u, v: (u, v, np.minimum(np.minimum(u, 1 - u), np.minimum(v, 1 - v))))
    yield "box", cubes(np.ones((20, 30, 40), bool))
    for seed in range(7):
        yield "blob of cubes %d" % seed, blob(seed)
    for seed in range(5):
        yield "stairs %d" % seed, stairs(seed)


def curved_surfaces():
    def ball(u, v, bump=0.0, waves=5):
        a, b = 2 * np.pi * u, np.pi * (0.001 + 0.998 * v)
        r = 1 + bump * np.sin(waves * a) * np.sin(waves * b)
        return r * np.sin(b) * np.cos(a), r * np.sin(b) * np.sin(a), r * np.cos(b)

    def ring(u, v, thin):
        a, b = 2 * np.pi * u, 2 * np.pi * v
        return (1 + thin * np.cos(b)) * np.cos(a), (1 + thin * np.cos(b)) * np.sin(a), thin * np.sin(b)
    for bump in (0, 0.02, 0.1, 0.3):
        yield "ball, bumps of %g" % bump, tube(70, 70, lambda u, v: ball(u, v, bump))
    for thin in (0.02, 0.1, 0.4, 0.8):
        yield "ring, thickness %g" % thin, tube(140, 36, lambda u, v: ring(u, v, thin))
    for waves in (1, 3, 9):
        yield "sheet, %d waves" % waves, sheet(70, 70, lambda u, v: (u, v, 0.1 * np.sin(6 * waves * u) * np.cos(5 * waves * v)))
    yield "saddle", sheet(70, 70, lambda u, v: (u, v, (u - 0.5) ** 2 - (v - 0.5) ** 2))
    yield "bent square", sheet(70, 70, lambda u, v: (np.sin(2 * u), v, np.cos(2 * u)))
    yield "roll", sheet(140, 36, lambda u, v: (u * np.cos(20 * u), u * np.sin(20 * u), v))
    yield "spring", tube(36, 140, lambda u, v: ((1 + 0.2 * np.cos(2 * np.pi * u)) * np.cos(25 * v), (1 + 0.2 * np.cos(2 * np.pi * u)) * np.sin(25 * v),
                                                0.2 * np.sin(2 * np.pi * u) + 2 * v))
    for seed, rough in ((1, 1e-4), (2, 1e-3), (3, 1e-2)):
        points, triangles = tube(70, 70, ball)
        yield "rough ball, %g" % rough, (points + np.random.default_rng(seed).normal(0, rough, points.shape), triangles)
    for seed, rough in ((4, 1e-3), (5, 1e-2)):
        points, triangles = sheet(70, 70, lambda u, v: (u, v, 0.1 * np.sin(9 * u) * np.sin(8 * v)))
        yield "rough sheet, %g" % rough, (points + np.random.default_rng(seed).normal(0, rough, points.shape), triangles)


# Runs

def seconds_of(command):
    begin = time.perf_counter()
    done = subprocess.run(command, capture_output=True, text=True)
    return time.perf_counter() - begin, done.returncode, done.stderr


def measured(program, folder, surface, limit):
    """The faces that are left, and the seconds that --verify adds; or the words of what failed."""
    source, target = os.path.join(folder, "in.off"), os.path.join(folder, "out.off")
    write_off(source, surface)
    command = [program, source, target, "--force", "--error", limit, "--both-ways"]
    without, status, words = seconds_of(command)
    if status == 0:
        with_it, status, words = seconds_of(command + ["--verify"])
    if status != 0:
        return None, None, words
    with open(target) as file:
        return int(file.read(200).split()[2]), max(0.0, with_it - without), ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[1])
    parser.add_argument("program")
    parser.add_argument("--csv", help="a file for all figures")
    arguments = parser.parse_args()
    rows, failures = [], []
    with tempfile.TemporaryDirectory() as folder:
        for kind, surfaces in (("flat", flat_surfaces()), ("curved", curved_surfaces())):
            for name, surface in surfaces:
                for limit in LIMITS:
                    left, seconds, words = measured(arguments.program, folder, surface, limit)
                    rows.append((kind, name, len(surface[1]), limit, left, seconds))
                    if seconds is None or seconds > MOST_SECONDS:
                        failures.append("%s, %s: %s" % (name, limit, words.strip() or "%.1f s" % seconds))
                print("%s, %s, %d faces: " % (kind, name, len(surface[1])) + ", ".join(
                    "%s of %s s" % (row[4], "?" if row[5] is None else "%.2f" % row[5]) for row in rows[-len(LIMITS):]), flush=True)
    print("\n| | %s |\n|---|%s" % (" | ".join(LIMITS), "--:|" * len(LIMITS)))
    for kind in ("flat", "curved"):
        times = [sorted(row[5] or 0 for row in rows if row[0] == kind and row[3] == limit) for limit in LIMITS]
        print("| %s | %s |" % (kind, " | ".join("%.2f, at most %.2f s" % (np.median(t), t[-1]) for t in times)))
    if arguments.csv:
        with open(arguments.csv, "w") as file:
            file.write("kind,name,faces,limit,left,seconds\n")
            file.writelines('%s,"%s",%d,%s,%s,%s\n' % row for row in rows)
    for failure in failures:
        print("FAILED: " + failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
