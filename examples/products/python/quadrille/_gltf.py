"""simplify_gltf()"""

from __future__ import annotations

import os
import warnings
from typing import TYPE_CHECKING, Any, Callable, Collection, Optional, TypedDict, Union

from . import _core
from ._choices import choice
from ._missed import warn_if_missed
from ._options import function_of, make_options, takes_options
from ._table import CostName, SeamsName, SharedOptions
from ._words import in_our_words

if TYPE_CHECKING:
    from typing_extensions import Unpack


class GltfOptions(SharedOptions, total=False):
    """The options of simplify() without those that have a value for each point or face."""

    cost: Optional[CostName]


@takes_options("cost", *SharedOptions.__annotations__)
def simplify_gltf(
    source: Union[str, os.PathLike[str]],
    target: Union[str, os.PathLike[str]],
    /,
    *,
    seams: Optional[SeamsName] = None,
    labels: Collection[str] = (),
    stop: Optional[Callable[[_core.Status], bool]] = None,
    progress: Optional[Callable[[_core.Status], Optional[bool]]] = None,
    target_reduction: Optional[float] = None,
    **options: Unpack[GltfOptions],
) -> _core.Report:
    """Simplifies a glTF document, .gltf or .glb, and writes it to another file or over the same one.

        report = quadrille.simplify_gltf("helmet.glb", "small.glb", ratio=0.25)

    All meshes of the scene are simplified together, so that the remaining triangles are where they are
    needed most. Texture coordinates, normals, tangents, colours, skins and morph targets are updated;
    nodes, materials, images, animations and everything else in the document stay.

    seams    whether texture seams may vanish: 'kept', 'soft' (the default), 'priced' or 'free'; see
             Channel
    labels   names of integer attributes, such as '_PART': the regions of their values stay, like those of
             materials. Other integer attributes have no effect: each corner gets one of the old values
    stop, progress  functions, as in simplify(); if progress returns False, the current result is written,
             and if it raises, nothing is
    target_reduction, options  targets and methods, as in simplify(), except those with a value for each point or
             face and functions; lengths are in the unit of the scene

    Returns the Report of the whole scene. Remarks, such as one on images that are files in another
    folder, and missed targets are reported as UserWarnings.

    Raises OSError if a file can't be opened, ValueError if the document or an option is wrong, and TypeError for
    an unknown option. The target is written completely, or stays as it was.
    """
    if _gltf is None:
        raise NotImplementedError("this module was built without nlohmann_json, which glTF needs")
    source, target = os.fspath(source), os.fspath(target)
    for path in (source, target):
        if os.path.splitext(path)[1].lower() not in (".gltf", ".glb"):
            raise ValueError(f"{path} is not .gltf or .glb")
    made = make_options(target_reduction, **options)
    seams_choice = None if seams is None else choice("seams", seams, _core.Seams.__members__)
    with open(source, "rb"):
        pass
    try:
        report, remarks = _gltf(source, target, made, seams_choice, set(labels),
                                function_of("stop", stop), function_of("progress", progress))
    except RuntimeError as error:
        raise ValueError(str(error)) from None
    for remark in remarks:
        warnings.warn(remark, stacklevel=3)
    warn_if_missed(report, made, None, stop, stacklevel=3)
    return report


simplify_gltf = in_our_words(simplify_gltf)
_gltf: Any = getattr(_core, "simplify_gltf", None)
