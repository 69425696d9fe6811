#!/usr/bin/env python3
"""Looks for cliffs: targets near which the last faces cost far more than all others before.

    cliffs.py PROGRAM [--most FACES] [MODEL...] [-- OPTIONS]

runs the program over twelve targets, from a half of the faces to a thousandth, on each model: surfaces that are made,
Debian's libcgal-demo, those of $QUADRILLE_DATA, and files that are named; only these where there are any. Models of
more than 60,000 faces are left out, or of more than --most. For each result it prints faces, the root mean square of
the distance from IN to OUT and back, and the greatest, in % of IN's diagonal, then the same for a tenth more faces. A
step is steep if the greater of both is more than twice what it is at a tenth more faces, and 0.02 % beyond; then other
ways to come to as few faces are tried, and the best is told. It is a CLIFF if that has less than 0.7 of the error, so
that the faces need not cost as much. OPTIONS go to the program.

Distances are exact, from points on both surfaces, and measured by numpy and scipy alone. The exit status is 1 if there
is a cliff."""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

import shapes
from surfaces import Input, read

TARGETS = (50, 30, 20, 10, 7, 5, 3, 2, 1, .5, .2, .1)
OTHERS = (("--cost", "memoryless"), ("--error", "5%"), ("--drop-parts",), ("--keep-parts",), ("--topology", "free"))


class Run:
    """A result of the program: faces, RMS there and back, the greatest distance."""

    def __init__(self, program, model, path, options):
        suffix = ".ply" if path.suffix.lower() == ".obj" else path.suffix
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / ("out" + suffix)
            done = subprocess.run([program, path, out, *options], capture_output=True, text=True, timeout=600)
            self.is_done, self.words = out.exists(), done.stderr.strip()
            if self.is_done:
                self.faces, self.there, self.back, self.greatest = model.measure(out)

    def error(self):
        return max(self.there, self.back)

    def __str__(self):
        return f"{self.faces:7,} faces, RMS {self.there:6.3f} / {self.back:6.3f}, max {self.greatest:6.2f}"


def better(program, model, path, run, options):
    """Another way that comes to no more faces with less error, or nothing."""
    best = None
    for other in OTHERS:
        if "--drop-parts" in options and other[0] in ("--topology", "--keep-parts"):
            continue
        found = Run(program, model, path, ["--faces", str(run.faces), *options, *other])
        if found.is_done and found.faces <= 1.02 * run.faces and found.error() < (best or run).error():
            best, best.other = found, " ".join(other)
    return best


def look_at(program, path, options):
    """Prints what comes out at each target. Returns how many cliffs there are."""
    model, cliffs, last = Input(path), 0, None
    whole = len(model.surface)
    print(f"{path} ({whole:,} faces)", flush=True)
    for target in TARGETS:
        run = Run(program, model, path, ["--keep", f"{target}%", *options])
        if not run.is_done:
            print(f"  {target:5} %: {run.words}")
            break
        if run.faces == last:
            break
        last = run.faces
        above = Run(program, model, path, ["--faces", str(int(1.1 * run.faces) + 1), *options])
        is_steep = run.error() > 2 * above.error() + .02
        found = better(program, model, path, run, options) if is_steep else None
        is_cliff = found is not None and found.error() < .7 * run.error()
        cliffs += is_cliff
        print(f"  {target:5} %: {run}; {above}{'  CLIFF' if is_cliff else '  steep' if is_steep else ''}", flush=True)
        if is_steep:
            print(f"          {found.other}: {found}" if found else "          nothing that was tried is better", flush=True)
    return cliffs


def models(arguments, folder):
    if arguments.models:
        return [pathlib.Path(model) for model in arguments.models]
    found = shapes.make_all(folder)
    folders = [pathlib.Path("/usr/share/doc/libcgal-demo/data/meshes")]
    if "QUADRILLE_DATA" in os.environ:
        folders.append(pathlib.Path(os.environ["QUADRILLE_DATA"]))
    for place in folders:
        found += sorted(path for path in place.rglob("*") if path.suffix.lower() in (".off", ".obj", ".ply", ".stl", ".glb"))
    return found


def main():
    words = sys.argv[1:]
    options = words[words.index("--") + 1:] if "--" in words else []
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("models", nargs="*")
    parser.add_argument("--most", type=int, default=60_000)
    arguments = parser.parse_args(words[:len(words) - len(options) - ("--" in words)])
    cliffs = 0
    with tempfile.TemporaryDirectory() as folder:
        for path in models(arguments, pathlib.Path(folder)):
            try:
                if 100 <= len(read(path)) <= arguments.most:
                    cliffs += look_at(arguments.program, path, options)
            except Exception as error:  # a file that these readers cannot read is left out, and told
                print(f"{path}: left out: {error}", flush=True)
    print(f"{cliffs} cliffs")
    return 1 if cliffs else 0


if __name__ == "__main__":
    sys.exit(main())
