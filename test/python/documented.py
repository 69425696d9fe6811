"""Runs the Python that the documents show: each block by itself, in a folder with a file statue.obj.
What imports a library that is not here is told and left out.

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

from surfaces import torus, write_obj


def blocks(document):
    """Pairs of a line number and code."""
    begin, lines = None, []
    for number, line in enumerate(document.read_text().split("\n"), 1):
        if line == "```python":
            begin, lines = number, []
        elif line == "```" and begin is not None:
            yield begin, "\n" * begin + "\n".join(lines)
            begin = None
        elif begin is not None:
            lines.append(line)


def missing(code):
    """The libraries that a block imports and that are not here."""
    names = [alias.name.split(".")[0] for node in ast.walk(ast.parse(code))
             if isinstance(node, ast.Import) for alias in node.names]
    return [name for name in names if importlib.util.find_spec(name) is None]


def main(repository):
    import quadrille
    documents = [repository / "README.md", *sorted((repository / "doc").rglob("*.md"))]
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
                if "write_mesh" in code:
                    assert len(quadrille.read_mesh("small.obj").faces) <= 1000, place
                os.chdir(repository)
            run += 1
    print(f"{run} blocks run")
    return 0 if run > 0 else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
