#!/usr/bin/env python3
# Textured assets by the program quadrille and by gltfpack, at the counts of faces that gltfpack comes to. Needs the Debian packages
# assimp-testmodels, python3-numpy, python3-pil, python3-vtk9 and nodejs, and gltfpack: `npm install gltfpack` in a folder of its own.
#   python3 benchmark/attributes/assets.py PROGRAM GLTFPACK MESHES FOLDER [--only MODEL...] [--ours OPTIONS]...
# MESHES is the folder data/meshes of libcgal-demo; files go to FOLDER, with assets.csv. Of the ten models six are taken from
# $QUADRILLE_DATA. --ours: rows of the program with other options than the default ones, of one word: --ours '--cost memoryless'.
import argparse
import csv
import os
import resource
import subprocess

import asset_models
from asset import read_glb, write_glb
from asset_measures import Surface, measured

RATIOS = (0.5, 0.25, 0.1, 0.03)
PEERS = ("", "-sv", "-sp", "-sv -sp")
# Without quantisation, limits of error, or dropping and merging what is not used: all of that costs it accuracy or count.
PEER_OPTIONS = ("-noq", "-kv", "-km", "-kn", "-se", "1")
COLUMNS = ("model", "part", "contender", "faces", "ms", "shape", "colour", "normal", "material", "torn")


def seconds_of(command):
    """Processor time of a child."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode > 1:
        raise SystemExit(f"{' '.join(command)}: {run.stdout}{run.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Bench:
    def __init__(self, given):
        self.given, self.original, self.ours = given, None, {}

    def row(self, contender, command, target):
        """Time is that of the whole run, with reading and writing."""
        spent = min(seconds_of(command) for _ in range(self.given.runs))
        result = read_glb(target)
        if not result:
            return None
        return {"contender": contender, "ms": 1000 * spent, **measured(self.original, Surface(result))}

    def peer(self, source, options, part):
        target = source[:-4] + f"_gltfpack{options.replace(' ', '')}_{part}.glb"
        command = [self.given.gltfpack, "-i", source, "-o", target, *PEER_OPTIONS, "-si", str(part), *options.split()]
        return self.row(f"gltfpack {options}".strip(), command, target)

    def our(self, source, options, faces):
        if (options, faces) not in self.ours:
            target = source[:-4] + f"_quadrille{options.replace(' ', '')}_{faces}.glb"
            command = [self.given.program, source, target, "--quiet", "--faces", str(faces), *options.split()]
            self.ours[options, faces] = self.row(f"quadrille {options}".strip(), command, target)
        return self.ours[options, faces]

    def rows(self, name, make):
        source = os.path.join(self.given.folder, name + ".glb")
        write_glb(source, make())
        self.original, self.ours = Surface(read_glb(source)), {}
        for part in self.given.parts:
            for options in PEERS:
                theirs = self.peer(source, options, part)
                if not theirs:  # nothing is left
                    continue
                yield {"model": name, "part": part, **theirs}
                for own in self.given.ours:
                    yield {"model": name, "part": part, **self.our(source, own, theirs["faces"])}


def main():
    parser = argparse.ArgumentParser()
    for name in ("program", "gltfpack", "meshes", "folder"):
        parser.add_argument(name)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--ours", action="append", default=[""])
    parser.add_argument("--parts", nargs="*", type=float, default=RATIOS)
    parser.add_argument("--runs", type=int, default=2)
    given = parser.parse_args()
    os.makedirs(given.folder, exist_ok=True)
    bench = Bench(given)
    with open(os.path.join(given.folder, "assets.csv"), "w") as file:
        table = csv.DictWriter(file, COLUMNS)
        table.writeheader()
        for name, make in asset_models.models(given.meshes, given.folder).items():
            if given.only and name not in given.only:
                continue
            for row in bench.rows(name, make):
                table.writerow({key: f"{x:.4g}" if isinstance(x, float) else x for key, x in row.items()})
                file.flush()
                print(*(f"{key} {row[key]:.4g}" if key not in ("model", "contender") else row[key] for key in COLUMNS), sep="  ", flush=True)


if __name__ == "__main__":
    main()
