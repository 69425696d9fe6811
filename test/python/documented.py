"""Runs the Python that the documents show: each block by itself, in a folder with a file statue.obj.
Where trimesh or PyVista is not here, classes that look alike stand in for it; what imports another
library that is not here is told and left out.

    python3 documented.py REPOSITORY
"""

import ast
import contextlib
import importlib.util
import io
import os
import pathlib
import sys
import tempfile
import types

import numpy as np

import lookalikes
from surfaces import torus, write_obj


def blocks(document):
    """Pairs of a line number and code, but for what is part of a file, which documented.sh looks at."""
    begin, lines, before = None, [], ""
    for number, line in enumerate(document.read_text().split("\n"), 1):
        if line == "```python" and not before.startswith(("<!-- file:", "<!-- part:")):
            begin, lines = number, []
        elif line == "```" and begin is not None:
            yield begin, "\n" * begin + "\n".join(lines)
            begin = None
        elif begin is not None:
            lines.append(line)
        before = line


def missing(code):
    """The libraries that a block imports and that are not here."""
    names = []
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names.append(node.module)
    return [name for name in (name.split(".")[0] for name in names)
            if name not in sys.modules and importlib.util.find_spec(name) is None]


def loaded(path, **options):
    """As trimesh loads it: vertices are split at the seams of the texture."""
    import quadrille
    mesh = quadrille.read_mesh(path)
    pairs, places = np.unique(np.stack([mesh.faces.ravel(), mesh.uv[1].ravel()], axis=1), axis=0, return_inverse=True)
    return lookalikes.Trimesh(mesh.points[pairs[:, 0]], places.reshape(-1, 3),
                              visual=lookalikes.TextureVisuals(mesh.uv[0][pairs[:, 1]], "wood"))


def sphere(theta_resolution, phi_resolution):
    points, faces, _ = torus(phi_resolution, theta_resolution)
    return lookalikes.PolyData(points, lookalikes.padded(faces))


def stand_in():
    """For trimesh and PyVista where they are missing."""
    for name, content in (("trimesh", {"Trimesh": lookalikes.Trimesh, "load": loaded}),
                          ("pyvista", {"PolyData": lookalikes.PolyData, "Sphere": sphere})):
        if importlib.util.find_spec(name) is None:
            print(f"{name} is not here, and classes that look alike stand in for it")
            sys.modules[name] = types.ModuleType(name)
            vars(sys.modules[name]).update(content)


def main(repository):
    import quadrille
    documents = [repository / "README.md", *sorted((repository / "doc").rglob("*.md"))]
    stand_in()
    run = 0
    for document in documents:
        for line, code in blocks(document):
            place = f"{document.relative_to(repository)}:{line}"
            if missing(code):
                print(f"{place}: left out, there is no {', '.join(missing(code))}")
                continue
            with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
                os.chdir(folder)
                write_obj("statue.obj", *torus(40))
                exec(compile(code, str(document), "exec"), {"__name__": place})
                if "write_mesh(\"small.obj" in code:
                    assert len(quadrille.read_mesh("small.obj").faces) <= 1000, place
                os.chdir(repository)
            run += 1
    print(f"{run} blocks run")
    return 0 if run > 0 else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
