#!/usr/bin/env python3
# Draws meshes side by side into a small PNG. Needs the Debian packages python3-vtk9, python3-numpy,
# python3-pil, fonts-dejavu-core and xvfb:
#   xvfb-run -a python3 draw.py PICTURE.png [OPTION...] MESH[=TITLE[|SUBTITLE]]...
# Meshes are OFF files of triangles, PLY files (with colours of vertices or faces as they are) or OBJ files. All
# panels have the camera that fits the first mesh; {} in a title is the number of faces. Options:
#   --columns N      (all in one row)            --size W,H      of a panel, without its title (400,300)
#   --from X,Y,Z     the direction to look from (1,-2,1)     --up X,Y,Z  (0,0,1)
#   --zoom F         (1)                         --at X,Y        where the middle is, in panels (0,0)
#   --inside X,Y,Z,X,Y,Z,ANGLE   a camera, what it looks at, its angle of view
#   --cut X          to the right of it, in panels, textured meshes are shown by their edges instead
#   --texture FILE   of all OBJ files            --colours N     of the PNG, 0: all (64)
# and of the mesh before them, or of all where there is none:
#   --edges WIDTH    draws them                  --unlit         colours of vertices as they are
#   --with FILE      a second mesh in the same panel
#   --around FILE    the same, seen through
#   --lines FILE,R,G,B[,WIDTH]   the lines of an OBJ file
import sys

import numpy as np
import vtk
from PIL import Image, ImageDraw, ImageFont
from models import read_off
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

FONTS = "/usr/share/fonts/truetype/dejavu/DejaVuSans"
SCALE = 3  # pixels drawn for each one of the picture, along and across
GAP = 6  # white pixels at both sides of a panel


def off_mesh(path):
    points, triangles = read_off(path)
    cells = vtk.vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(3, triangle)
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(vtk.vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    mesh.SetPolys(cells)
    return mesh


def read(path):
    if path.endswith(".off"):
        return off_mesh(path)
    reader = vtk.vtkPLYReader() if path.endswith(".ply") else vtk.vtkOBJReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def actor_of(mesh, look, texture=None):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    style = actor.GetProperty()
    style.SetColor(*(c / 255 for c in look.get("colour", (226, 220, 205))))
    style.SetInterpolationToFlat()
    style.SetSpecular(0)
    style.SetAmbient(0.22)
    style.SetDiffuse(0.85)
    style.SetOpacity(look.get("opacity", 1))
    if look.get("unlit") and mesh.GetPointData().GetScalars():
        style.LightingOff()
    if texture:
        actor.SetTexture(texture)
    return actor


def edges_actor(mesh, width):
    """The edges, in front of the faces; below a width of 1 the lines are seen through."""
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(mesh)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -2)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    style = actor.GetProperty()
    style.SetColor(0.13, 0.13, 0.18)
    style.LightingOff()
    style.SetLineWidth(max(width, 0.34) * SCALE)
    style.SetOpacity(min(width, 1))
    return actor


def lines_actor(path, colour, width):
    actor = actor_of(read(path), {"colour": colour})
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetLineWidth(width * SCALE)
    return actor


def texture_of(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    texture = vtk.vtkTexture()
    texture.SetInputConnection(reader.GetOutputPort())
    texture.InterpolateOn()
    texture.MipmapOn()
    return texture


def numbers(text):
    return [float(x) for x in text.split(",")]


class Picture:
    """The options of a call, its panels, and how these are drawn."""

    def __init__(self, arguments):
        self.view, self.up, self.inside = (1, -2, 1), (0, 0, 1), None
        self.zoom, self.at, self.size, self.columns = 1, (0, 0), (400, 300), 0
        self.texture, self.cut, self.colours = None, 0, 64
        self.look, self.panels = {}, []
        while arguments:
            self.take(arguments.pop(0), arguments)
        self.camera = None

    def take(self, argument, rest):
        look = self.panels[-1]["look"] if self.panels else self.look
        if argument == "--from": self.view = numbers(rest.pop(0))
        elif argument == "--up": self.up = numbers(rest.pop(0))
        elif argument == "--zoom": self.zoom = float(rest.pop(0))
        elif argument == "--at": self.at = numbers(rest.pop(0))
        elif argument == "--columns": self.columns = int(rest.pop(0))
        elif argument == "--size": self.size = [int(x) for x in numbers(rest.pop(0))]
        elif argument == "--inside": self.inside = numbers(rest.pop(0))
        elif argument == "--cut": self.cut = float(rest.pop(0))
        elif argument == "--texture": self.texture = texture_of(rest.pop(0))
        elif argument == "--colours": self.colours = int(rest.pop(0))
        elif argument == "--unlit": look["unlit"] = True
        elif argument == "--edges": look["edges"] = float(rest.pop(0))
        elif argument == "--with": self.panels[-1]["others"].append((rest.pop(0), {"colour": (77, 175, 74)}))
        elif argument == "--around":
            self.panels[-1]["others"].append((rest.pop(0), {"colour": (77, 175, 74), "opacity": 0.3, "edges": 0.7}))
        elif argument == "--lines":
            path, *values = rest.pop(0).split(",")
            values = [float(x) for x in values]
            self.panels[-1]["lines"].append((path, values[:3], values[3] if len(values) > 3 else 1))
        elif argument.startswith("--"): raise SystemExit(f"draw.py: unknown option {argument}")
        else:
            path, _, title = argument.partition("=")
            self.panels.append({"path": path, "title": title, "look": dict(self.look), "others": [], "lines": []})

    def fit(self, mesh):
        """The camera and the half height of what it sees, in the mesh's unit: all points, and a margin."""
        back = np.array(self.view, float) / np.linalg.norm(self.view)
        right = np.cross(self.up, back)
        right /= np.linalg.norm(right)
        up = np.cross(back, right)
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        low, high = (np.array([f(points @ axis) for axis in (right, up, back)]) for f in (np.min, np.max))
        middle, half = (low + high) / 2, (high - low) / 2
        scale = max(half[1] * 1.06, half[0] * 1.1 * self.size[1] / self.size[0]) / self.zoom
        middle[0] += 2 * self.at[0] * scale * self.size[0] / self.size[1]
        middle[1] += 2 * self.at[1] * scale
        self.camera = right * middle[0] + up * middle[1] + back * middle[2], up, back, scale, np.linalg.norm(half)

    def aim(self, camera, renderer):
        if self.inside:
            camera.SetViewUp(self.up)
            camera.SetPosition(self.inside[0:3])
            camera.SetFocalPoint(self.inside[3:6])
            camera.SetViewAngle(self.inside[6])
        else:
            focus, up, back, scale, reach = self.camera
            camera.SetFocalPoint(focus)
            camera.SetPosition(focus + 10 * reach * back)
            camera.SetViewUp(up)
            camera.ParallelProjectionOn()
            camera.SetParallelScale(scale)
        renderer.ResetCameraClippingRange()

    def draw(self, panel):
        """The image of a panel, SCALE times as large; with --cut, what it shows to the left of a slanted line, and the edges to its right."""
        mesh = read(panel["path"])
        panel["faces"] = mesh.GetNumberOfPolys()
        if not self.camera:
            self.fit(mesh)
        if not self.cut:
            return self.render(panel, mesh, self.texture)
        left = self.render({**panel, "look": {**panel["look"], "edges": 0}}, mesh, self.texture)
        right = self.render(panel, mesh, None)
        width, height = left.size
        middle, slant = self.cut * width, 0.12 * height
        mask = Image.new("L", left.size)
        ImageDraw.Draw(mask).polygon([(0, 0), (middle + slant, 0), (middle - slant, height), (0, height)], 255)
        return Image.composite(left, right, mask)

    def render(self, panel, mesh, texture):
        renderer = vtk.vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        textured = texture if mesh.GetPointData().GetTCoords() else None
        actor = actor_of(mesh, panel["look"], textured)
        if textured:
            actor.GetProperty().SetColor(1, 1, 1)
        renderer.AddActor(actor)
        if panel["look"].get("edges"):
            renderer.AddActor(edges_actor(mesh, panel["look"]["edges"]))
        for path, look in panel["others"]:
            other = read(path)
            renderer.AddActor(actor_of(other, look))
            if look.get("edges"):
                renderer.AddActor(edges_actor(other, look["edges"]))
        for line in panel["lines"]:
            renderer.AddActor(lines_actor(*line))
        for x, y, z, strength in ((-0.5, 0.7, 1, 0.75), (0.9, 0.1, 0.8, 0.35), (0, -0.6, 0.6, 0.12)):
            light = vtk.vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetPosition(x, y, z)
            light.SetFocalPoint(0, 0, 0)
            light.SetIntensity(strength)
            renderer.AddLight(light)
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        window.SetSize(SCALE * self.size[0], SCALE * self.size[1])
        window.AddRenderer(renderer)
        if any("opacity" in look for _, look in panel["others"]):
            window.SetAlphaBitPlanes(1)
            renderer.SetUseDepthPeeling(1)
            renderer.SetMaximumNumberOfPeels(8)
        self.aim(renderer.GetActiveCamera(), renderer)
        window.Render()
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]
        return Image.fromarray(np.ascontiguousarray(pixels))

    def write(self, path):
        columns = self.columns or len(self.panels)
        rows = -(-len(self.panels) // columns)
        lines = max(panel["title"].count("|") + (panel["title"] != "") for panel in self.panels)
        width, height = self.size[0], self.size[1] + (8 + 20 * lines if lines else 0)
        page = Image.new("RGB", (width * columns, height * rows), "white")
        pen = ImageDraw.Draw(page)
        for i, panel in enumerate(self.panels):
            left, top = width * (i % columns), height * (i // columns)
            image = self.draw(panel).resize(self.size, Image.LANCZOS)
            page.paste(image.crop((GAP, 0, self.size[0] - GAP, self.size[1])), (left + GAP, top))
            for n, text in enumerate(panel["title"].replace("{}", f"{panel['faces']:,}").split("|")):
                font = ImageFont.truetype(FONTS + ("-Bold.ttf" if n == 0 else ".ttf"), 16 if n == 0 else 14)
                pen.text((left + width / 2, top + self.size[1] + 14 + 20 * n), text,
                         (25, 25, 30) if n == 0 else (90, 90, 100), font, "mm")
        if self.colours:
            page = page.quantize(self.colours, Image.MEDIANCUT, dither=Image.NONE)
        page.save(path, optimize=True)


Picture(sys.argv[2:]).write(sys.argv[1])
