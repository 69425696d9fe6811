#!/usr/bin/env python3
# Draws three textured and three coloured models to 10 and 2 % of their faces, ours and those of meshoptimizer side by side, as
# OUT-textured.png and OUT-coloured.png. Needs what assets.py and front.py need, xvfb and fonts-dejavu-core:
#   PYTHONPATH=BUILD/examples/products/python NODE_MODULES=... xvfb-run -a python3 benchmark/attributes/pictures.py PROGRAM GLTFPACK MESHES FOLDER OUT
# Nothing but meshes of Debian's libcgal-demo, which are painted, and what is made by formulas is drawn.
import os
import subprocess
import sys

import numpy as np
import vtk
from PIL import Image, ImageDraw, ImageFont
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

sys.path.insert(0, os.path.dirname(__file__))
import asset_models  # noqa: E402
import coloured_models  # noqa: E402
from asset import read_glb, write_glb  # noqa: E402
from assets import PEER_OPTIONS  # noqa: E402
from coloured_models import Coloured  # noqa: E402
from front import ours, theirs  # noqa: E402

FONTS = "/usr/share/fonts/truetype/dejavu/DejaVuSans"
WIDTH, HEIGHT, SCALE = 236, 190, 3
BEST_WEIGHT = 0.2  # of meshoptimizer on these models: see doc/benchmarks.md
VIEWS = {"torus": ((0.3, -1, 1.1), (0, 0, 1), 1.08), "helmet": ((1.2, -0.9, 0.35), (0, 0, 1), 1.12), "armadillo": ((0.2, 0.15, -1), (0, 1, 0), 1),
         "bunny, waves": ((-0.3, 0.12, 1), (0, 1, 0), 1), "elephant, stripes": ((-1, 0.3, 0.7), (0, 1, 0), 1),
         "lion-head, spots": ((0.2, 0.1, 1), (0, 1, 0), 1)}


# --- Drawing ---------------------------------------------------------------------------------------

def mesh_of(asset, chosen):
    """The corners of faces as points, with normals, and with texture coordinates or colours."""
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(vtk.vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(asset.points[chosen].reshape(-1, 3), deep=True))
    cells = vtk.vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.arange(3 * chosen.sum(), dtype=np.int64), deep=True))
    mesh.SetPolys(cells)
    data = mesh.GetPointData()
    if isinstance(asset, Coloured):
        data.SetScalars(numpy_to_vtk(np.round(255 * asset.corner_colours[chosen]).astype(np.uint8).reshape(-1, 3), deep=True))
    else:
        data.SetNormals(numpy_to_vtk(asset.normals[chosen].reshape(-1, 3), deep=True))
        data.SetTCoords(numpy_to_vtk((asset.uvs[chosen] * [1, -1] + [0, 1]).reshape(-1, 2), deep=True))
    return mesh


def texture_of(image):
    pixels = np.round(255 * image[::-1]).astype(np.uint8)
    picture = vtk.vtkImageData()
    picture.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    picture.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    texture = vtk.vtkTexture()
    texture.SetInputData(picture)
    texture.InterpolateOn()
    return texture


def actors_of(asset):
    for m in range(len(asset.names)):
        if not (asset.materials == m).any():
            continue
        actor = vtk.vtkActor()
        actor.SetMapper(vtk.vtkPolyDataMapper())
        actor.GetMapper().SetInputData(mesh_of(asset, asset.materials == m))
        style = actor.GetProperty()
        style.SetAmbient(0.35)
        style.SetDiffuse(0.75)
        if isinstance(asset, Coloured):
            style.SetInterpolationToFlat()
        else:
            actor.SetTexture(texture_of(asset.images[m]))
        yield actor


def drawn(asset, view, box):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors_of(asset):
        renderer.AddActor(actor)
    for x, y, z, strength in ((-0.5, 0.7, 1, 0.8), (0.9, 0.1, 0.8, 0.35)):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(x, y, z)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    (low, high), (away, up, zoom) = box, view
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint((low + high) / 2)
    camera.SetPosition((low + high) / 2 + 5 * np.linalg.norm(high - low) * np.array(away) / np.linalg.norm(away))
    camera.SetViewUp(up)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(extent(low, high, away, up) / zoom)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(SCALE * WIDTH, SCALE * HEIGHT)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(SCALE * HEIGHT, SCALE * WIDTH, -1)[::-1, :, :3]
    image = Image.fromarray(np.ascontiguousarray(pixels))
    window.Finalize()  # a server has so many connections
    return image.resize((WIDTH, HEIGHT), Image.LANCZOS)


def extent(low, high, away, up):
    """Half of the height of what a camera has to see of a box."""
    back = np.array(away) / np.linalg.norm(away)
    right = np.cross(up, back) / np.linalg.norm(np.cross(up, back))
    half = (high - low) / 2
    return max(abs(np.cross(back, right)) @ half, abs(right) @ half * HEIGHT / WIDTH) * 0.9


def sheet(path, rows):
    """rows: a view, and panels of (title, asset), the first of which is the input."""
    head = 22
    page = Image.new("RGB", (WIDTH * len(rows[0][1]), (HEIGHT + head) * len(rows)), "white")
    pen, font = ImageDraw.Draw(page), ImageFont.truetype(FONTS + ".ttf", 13)
    for i, (view, panels) in enumerate(rows):
        corners = panels[0][1].points.reshape(-1, 3)
        box = corners.min(axis=0), corners.max(axis=0)
        for j, (title, asset) in enumerate(panels):
            page.paste(drawn(asset, view, box), (j * WIDTH, i * (HEIGHT + head)))
            pen.text(((j + 0.5) * WIDTH, (i + 1) * (HEIGHT + head) - head / 2), title, (40, 40, 50), font, "mm")
    page.quantize(96, Image.MEDIANCUT, dither=Image.NONE).save(path, optimize=True)


# --- What is drawn ---------------------------------------------------------------------------------

def textured_row(name, program, gltfpack, meshes, folder):
    source = os.path.join(folder, name + ".glb")
    write_glb(source, asset_models.models(meshes, folder)[name]())
    panels = [(lambda a: (f"{len(a.points):,} faces", a))(read_glb(source))]
    for part in (0.1, 0.02):
        target = os.path.join(folder, "drawn.glb")
        subprocess.run([gltfpack, "-i", source, "-o", target, *PEER_OPTIONS, "-sv", "-sp", "-si", str(part)], check=True, capture_output=True)
        peer = read_glb(target)
        subprocess.run([program, source, target, "--quiet", "--faces", str(len(peer.points))], check=True)
        own = read_glb(target)
        panels += [(f"Quadrille, {len(own.points):,}", own), (f"gltfpack -sv -sp, {len(peer.points):,}", peer)]
    return VIEWS[name], panels


def coloured_row(name, meshes):
    model = coloured_models.models(meshes)[name]()
    panels = [(f"{len(model[1]):,} faces", Coloured(*model))]
    for part in (0.1, 0.02):
        peer = theirs(model, int(part * len(model[1])), BEST_WEIGHT, True)[1]
        own = ours(model, len(peer.points), 1, {})[1]
        panels += [(f"Quadrille, {len(own.points):,}", own), (f"meshoptimizer, {len(peer.points):,}", peer)]
    return VIEWS[name], panels


def main():
    program, gltfpack, meshes, folder, out = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    sheet(out + "-textured.png", [textured_row(name, program, gltfpack, meshes, folder) for name in ("torus", "helmet", "armadillo")])
    sheet(out + "-coloured.png", [coloured_row(name, meshes) for name in VIEWS if "," in name])


if __name__ == "__main__":
    main()
