"""The same bytes from Python, C, the program and the npm package, for ten models.

    same_bytes.py MODELS PROGRAM PROGRAM_OF_C [NODE]

QUADRILLE_WEB_PACKAGE is the folder of the built npm package; without it or without node, that part is left out.
"""

import json
import os
import subprocess
import sys
import tempfile

import numpy as np

import quadrille

# Each with other options, by their names in C and Python; those of the program are the same with dashes.
CASES = [
    ("cow", dict(ratio=0.1)),
    ("elephant", dict(ratio=0.1, cost="memoryless_quadric")),
    ("mushroom", dict(faces=100, cost="thin_feature_quadric")),
    ("triceratops", dict(ratio=0.2, cost="edge_length")),
    ("fandisk", dict(faces=400, crease_degrees=40)),
    ("head", dict(vertices=200, placement="endpoint")),
    ("knot1", dict(ratio=0.05, order="relaxed")),
    ("mesh_with_border", dict(ratio=0.2, boundary_weight=3)),
    ("boeing", dict(ratio=0.3, topology="free")),
    ("rotor_small", dict(ratio=0.3, line_weight=0.01)),
]


def packed(points, faces):
    rows = ((points, np.float64), (faces, np.uint32))
    return b"".join(len(array).to_bytes(8, "little") + np.ascontiguousarray(array, kind).tobytes() for array, kind in rows)


def by_python(mesh, options):
    return packed(*quadrille.simplify(mesh.points, mesh.faces, **options))


def by_c(program, mesh, options):
    words = [f"{name}={value}" for name, value in options.items()]
    return subprocess.run([program, *words], input=packed(*mesh), capture_output=True, check=True).stdout


def by_program(program, model, options, folder):
    target = os.path.join(folder, "out.off")
    words = [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]
    subprocess.run([program, model, target, *words], check=True, capture_output=True)
    return packed(*quadrille.read_mesh(target))


def by_node(node, package, mesh, options, folder):
    source, target = os.path.join(folder, "in"), os.path.join(folder, "out")
    with open(source, "wb") as file:
        file.write(packed(*mesh))
    camel = {name.split("_")[0] + "".join(map(str.title, name.split("_")[1:])): value for name, value in options.items()}
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "same_bytes.mjs")
    subprocess.run([node, script, package, source, target, json.dumps(camel)], check=True)
    with open(target, "rb") as file:
        return file.read()


def main(models, program, program_of_c, node=None):
    package = os.environ.get("QUADRILLE_WEB_PACKAGE")
    has_node = bool(node and package)
    if not has_node:
        print("the npm package is left out: " + ("QUADRILLE_WEB_PACKAGE is not set" if node else "there is no node"))
    differing = []
    for name, options in CASES:
        model = os.path.join(models, f"{name}.off")
        mesh = quadrille.read_mesh(model)
        expected = by_python(mesh, options)
        assert 0 < len(expected) < len(packed(*mesh))
        with tempfile.TemporaryDirectory() as folder:
            others = {"C": by_c(program_of_c, mesh, options), "the program": by_program(program, model, options, folder)}
            if has_node:
                others["node"] = by_node(node, package, mesh, options, folder)
        differing += [f"{name}: {who} differs from Python" for who, other in others.items() if other != expected]
    for line in differing:
        print(line)
    print(f"{len(CASES)} models, {4 if has_node else 3} ways, {len(differing)} differences")
    return 1 if differing else 0


sys.exit(main(*sys.argv[1:]))
