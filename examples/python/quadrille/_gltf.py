"""simplify_gltf()"""

from __future__ import annotations

import inspect
import os
import warnings
from typing import Any, Callable, Collection, Optional, Union

from . import _core
from ._mesh import _choice
from ._options import function_of, make_options

_OPTIONS = frozenset(inspect.signature(make_options).parameters)


def simplify_gltf(
    source: Union[str, os.PathLike],
    target: Union[str, os.PathLike],
    /,
    *,
    seams: Optional[str] = None,
    labels: Collection[str] = (),
    stop: Optional[Callable[[_core.Status], bool]] = None,
    progress: Optional[Callable[[_core.Status], Optional[bool]]] = None,
    **options: Any,
) -> _core.Report:
    """Simplifies a glTF document, .gltf or .glb, and writes it to another file, or over the same.

        report = quadrille.simplify_gltf("helmet.glb", "small.glb", ratio=0.25)

    All meshes are simplified at once, as they stand in the scene, so that the triangles that are left
    are where they are needed most. Texture coordinates, normals, tangents, colours, skins and morph
    targets go along; nodes, materials, images, animations and whatever else is in the document stay.

    seams    what becomes of the seams of textures: 'kept', 'held' (by default), 'priced' or 'free'; see
             Channel
    labels   names of attributes of integers, such as '_PART': regions of their values stay, as those of
             materials do. Other such attributes hold nothing: a corner has one of the values that there were
    stop, progress  functions, as simplify() has them; to return False from progress writes the result
             so far, and to raise writes nothing
    options  targets and how it is done, as simplify() has them by these names: faces, ratio, vertices,
             target_reduction, error, relative_error, both_ways, cost (by name), placement, order,
             threads, boundary_weight, topology, normal_flip, normal_deviation, no_self_intersection and
             so on; lengths are in the unit of the scene. Not those with a value for each point or face

    Returns the Report of the whole scene. A remark, such as one on images that are files in another
    folder, is a UserWarning.

    Raises OSError if a file can't be opened, and ValueError for what is wrong with the document or an
    option; TypeError for an option that it does not know. The target is written whole, or stays as it
    was.
    """
    if _gltf is None:
        raise NotImplementedError("this module was built without nlohmann_json, and knows no glTF")
    unknown = sorted(set(options) - _OPTIONS)
    if unknown:
        raise TypeError(f"simplify_gltf() has no argument {unknown[0]!r}")
    source, target = os.fspath(source), os.fspath(target)
    for path in (source, target):
        if os.path.splitext(path)[1].lower() not in (".gltf", ".glb"):
            raise ValueError(f"{path} is neither .gltf nor .glb")
    made = make_options(**options)
    seams_choice = None if seams is None else _choice("seams", seams, _core.Seams)
    with open(source, "rb"):
        pass
    try:
        report, remarks = _gltf(source, target, made, seams_choice, set(labels),
                                function_of("stop", stop), function_of("progress", progress))
    except RuntimeError as error:
        raise ValueError(str(error)) from None
    for remark in remarks:
        warnings.warn(remark, stacklevel=2)
    return report


_gltf = getattr(_core, "simplify_gltf", None)
