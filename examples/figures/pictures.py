#!/usr/bin/env python3
# Draws meshes side by side. Needs the Debian packages python3-vtk9 and xvfb:
#   xvfb-run -a python3 pictures.py PICTURE.png [OPTION...] MESH[=TITLE]...
# Meshes are PLY (with vertex colours drawn as they are) or OFF files. Options:
#   --from X,Y,Z    the direction to look from (1,-2,1)     --up X,Y,Z  (0,0,1)
#   --zoom F        (1)          --edges  draw them          --columns N
#   --inside X,Y,Z,X,Y,Z,ANGLE   a camera, what it looks at, its angle of view
#   --with FILE     a second mesh in the same panel as the mesh before it, in green
#   --around FILE   the same, seen through
import sys
import vtk


def read_off(path):
    words = (word for line in open(path) for word in line.split("#")[0].split())
    next(words)
    vertices, faces, _ = int(next(words)), int(next(words)), next(words)
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    for _ in range(vertices):
        points.InsertNextPoint(*(float(next(words)) for _ in range(3)))
    for _ in range(faces):
        corners = [int(next(words)) for _ in range(int(next(words)))]
        cells.InsertNextCell(len(corners), corners)
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def read(path):
    if path.endswith(".off"):
        return read_off(path)
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def actor(mesh, edges, color=(0.87, 0.85, 0.8)):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    look = result.GetProperty()
    look.SetColor(color)
    look.SetInterpolationToFlat()
    look.SetSpecular(0)
    look.SetAmbient(0.25)
    look.SetDiffuse(0.85)
    if mesh.GetPointData().GetScalars():
        look.LightingOff()
    if edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(0.15, 0.15, 0.2)
        look.SetLineWidth(1)
    return result


def numbers(text):
    return [float(x) for x in text.split(",")]


def main():
    args = sys.argv[1:]
    output, view, up, zoom, edges, columns, inside = args.pop(0), (1, -2, 1), (0, 0, 1), 1, False, 0, None
    size = [520, 430]
    panels = []
    while args:
        arg = args.pop(0)
        if arg == "--from": view = numbers(args.pop(0))
        elif arg == "--up": up = numbers(args.pop(0))
        elif arg == "--zoom": zoom = float(args.pop(0))
        elif arg == "--edges": edges = True
        elif arg == "--columns": columns = int(args.pop(0))
        elif arg == "--size": size = [int(x) for x in numbers(args.pop(0))]
        elif arg == "--inside": inside = numbers(args.pop(0))
        elif arg == "--with": panels[-1][2].append((args.pop(0), 1))
        elif arg == "--around": panels[-1][2].append((args.pop(0), 0.25))
        else:
            path, _, title = arg.partition("=")
            panels.append((path, title, []))
    columns = columns or len(panels)
    rows = -(-len(panels) // columns)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(size[0] * columns, size[1] * rows)
    for i, (path, title, others) in enumerate(panels):
        column, row = i % columns, rows - 1 - i // columns
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(column / columns, row / rows, (column + 1) / columns, (row + 1) / rows)
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(actor(read(path), edges))
        for other, opacity in others:
            second = actor(read(other), opacity < 1, (0.3, 0.75, 0.3))
            second.GetProperty().SetOpacity(opacity)
            renderer.AddActor(second)
        text = vtk.vtkTextActor()
        text.SetInput(title)
        text.GetTextProperty().SetColor(0, 0, 0)
        text.GetTextProperty().SetFontSize(17)
        text.SetPosition(8, 8)
        renderer.AddActor2D(text)
        window.AddRenderer(renderer)
        if i and not inside:
            renderer.SetActiveCamera(first)
            continue
        camera = first = renderer.GetActiveCamera()
        camera.SetViewUp(up)
        if inside:
            camera.SetPosition(inside[0:3])
            camera.SetFocalPoint(inside[3:6])
            camera.SetViewAngle(inside[6])
            renderer.ResetCameraClippingRange()
        else:
            camera.SetFocalPoint(0, 0, 0)
            camera.SetPosition(view)
            camera.ParallelProjectionOn()
            renderer.ResetCamera()
            camera.Zoom(1.35 * zoom)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(output)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


main()
