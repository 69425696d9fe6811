"""The Python module quadrille with meshes of trimesh, Open3D, PyVista, VTK and meshio: with classes that look like
theirs, and with the real ones of Open3D, VTK and meshio where these are installed."""

import importlib.util
import os
import types
import unittest
import warnings

import numpy as np

import quadrille
from lookalikes import (ColorVisuals, IntVector, MeshioMesh, PolyData, Primitive, StubbornPrimitive, TextureVisuals,
                        TriangleMesh, Trimesh, Vector2dVector, Vector3dVector, padded)
from surfaces import Folder, sheet, torus


class OtherLibraries(Folder):
    """By classes that look alike."""

    def setUp(self):
        super().setUp()
        self.points, self.faces, self.uv = sheet(12)
        self.heat, self.rgb = self.points[:, 2], np.tile(np.uint8([9, 99, 199]), (144, 1))
        self.data = {"heat": self.heat, "rgb": self.rgb, "left": self.heat}
        self.places = np.arange(len(self.faces))
        self.small = quadrille.simplify(self.points, self.faces, ratio=0.25)
        self.warm = quadrille.simplify(self.points, self.faces, ratio=0.25, attributes={
            "heat": self.heat, "rgb": quadrille.Channel(self.rgb, kind="colors")})

    def same(self, points, faces, expected):
        self.assertTrue(np.array_equal(points, expected.points))
        self.assertTrue(np.array_equal(faces, expected.faces))

    def same_data(self, data, expected):
        self.assertEqual(sorted(data), ["heat", "rgb"])
        self.assertTrue(np.array_equal(data["heat"], expected.attributes["heat"]))
        self.assertEqual(data["rgb"].dtype, np.uint8)
        self.assertTrue((data["rgb"] == self.rgb[0]).all())

    def test_trimesh(self):
        mesh = Trimesh(self.points, self.faces.astype(np.int64), vertex_attributes=self.data,
                       face_attributes={"place": self.places}, metadata={"file": "a.obj"})
        result = quadrille.simplify(mesh, ratio=0.25, attributes=["heat", "rgb"])
        self.assertEqual(result.attributes["rgb"].kind, "colors")
        like = result.to_like(mesh)
        self.same(like.vertices, like.faces, self.warm)
        self.assertEqual((like.faces.dtype, like.is_processed, like.visual.defined), (np.int64, False, False))
        self.assertEqual(like.metadata, {"file": "a.obj"})
        self.same_data(like.vertex_attributes, self.warm)
        self.assertTrue(np.array_equal(like.face_attributes["place"], result.input_faces))
        mesh.visual = ColorVisuals(mesh, face_colors=np.stack([self.places] * 4, axis=1).astype(np.uint8))
        like = self.small.to_like(mesh)
        self.assertTrue(np.array_equal(like.visual.face_colors[:, 0], self.small.input_faces.astype(np.uint8)))
        mesh.visual = TextureVisuals(self.uv, "skin")
        textured = quadrille.simplify(mesh, uv=self.uv, normals=self.points).to_like(mesh)
        self.assertEqual((textured.visual.uv.shape[1], textured.visual.material), (2, "skin"))
        self.assertEqual(textured.vertex_normals.shape, textured.vertices.shape)
        colored = quadrille.simplify(mesh, colors=self.rgb)
        plain = Trimesh(self.points, self.faces)
        self.assertTrue((colored.to_like(plain).visual.vertex_colors == self.rgb[0]).all())
        colored.uv = colored.points[:, :2]
        with self.assertWarnsRegex(UserWarning, "^Trimesh: not kept: colors$"):
            colored.to_like(mesh)

    def test_whatever_takes_a_mesh_takes_one_of_trimesh(self):
        mesh = Trimesh(self.points, self.faces)
        small = quadrille.simplify(mesh, ratio=0.25)
        self.same(*small, self.small)
        quadrille.write_mesh(self.path("a.ply"), mesh)
        self.assertEqual(len(quadrille.read_mesh(self.path("a.ply")).faces), len(self.faces))
        self.assertLess(quadrille.surface_distance(mesh, mesh, samples=100).hausdorff, 1e-9)
        self.assertTrue(quadrille.verify(mesh, small, distance=9.0))
        seen = quadrille.view_importance(mesh, eye=[3, 3, 3])
        self.assertEqual((seen.shape, len(quadrille.curvature_importance(mesh))), ((144,), 144))
        again = quadrille.simplify(self.points, self.faces, ratio=0.25).to_like(mesh)
        self.assertIs(type(again), Trimesh)
        self.same(again.vertices, again.faces, self.small)

    def test_pairs_are_meshes(self):
        for pair in ((self.points, self.faces), [self.points.tolist(), self.faces.tolist()]):
            small = quadrille.simplify(pair, ratio=0.25)
            self.same(*small, self.small)
            like = small.to_like(pair)
            self.assertIs(type(like), type(pair))
            self.same(*like, self.small)
            self.assertEqual(len(quadrille.curvature_importance(pair)), 144)
        with self.assertWarnsRegex(UserWarning, "^tuple: not kept: heat$"):
            self.warm.attributes.pop("rgb")
            self.warm.to_like((self.points, self.faces))
        with self.assertRaisesRegex(TypeError, r"is a str, .*: read_mesh\(\) reads a file"):
            quadrille.simplify("statue.obj")
        for given in ((self.points,), (self.points, self.faces, self.points), [[0, 0, 0], [1, 0, 0]], []):
            with self.assertRaisesRegex((TypeError, ValueError), "not a Mesh, a pair|the triangles are missing"):
                quadrille.simplify(given)

    def test_open3d(self):
        mesh = TriangleMesh(self.points, self.faces.astype(np.int32))
        like = quadrille.simplify(mesh, ratio=0.25).to_like(mesh)
        self.assertIsInstance(like.vertices, Vector3dVector)
        self.same(np.asarray(like.vertices), np.asarray(like.triangles), self.small)
        mesh.textures = ["wood"]
        corners = Vector2dVector(self.uv[self.faces].reshape(-1, 2))
        result = quadrille.simplify(mesh, colors=Vector3dVector(self.rgb / 255), normals=self.points,
                                    uv=(corners, np.arange(len(corners)).reshape(-1, 3)))
        like = result.to_like(mesh)
        self.assertTrue(np.array_equal(like.triangle_uvs, result.uv[0][result.uv[1]].reshape(-1, 2)))
        self.assertTrue(np.allclose(like.vertex_colors, self.rgb[0] / 255))
        self.assertEqual((len(like.vertex_normals), like.textures), (len(result.points), ["wood"]))
        result.colors, result.uv = np.tile(self.rgb[0], (len(result.points), 1)), result.points[:, :2]
        mesh.triangle_material_ids = IntVector(self.places.astype(np.int32))
        like = result.to_like(mesh)
        self.assertTrue(np.allclose(like.vertex_colors, self.rgb[0] / 255))
        self.assertTrue(np.array_equal(like.triangle_uvs, result.uv[result.faces].reshape(-1, 2)))
        self.assertTrue(np.array_equal(like.triangle_material_ids, result.input_faces))
        like = self.small.to_like(mesh)
        self.same(np.asarray(like.vertices), np.asarray(like.triangles), self.small)
        result.attributes["heat"], result.labels = result.points[:, 2], result.input_faces
        with self.assertWarnsRegex(UserWarning, "^TriangleMesh: not kept: heat, labels$"):
            result.to_like(mesh)

    def test_pyvista(self):
        mesh = PolyData(self.points.astype(np.float32), padded(self.faces))
        mesh.point_data, mesh.cell_data = self.data, {"place": self.places}
        result = quadrille.simplify(mesh, ratio=0.25, attributes=["heat", "rgb"], uv=self.uv,
                                    labels=self.places > 99)
        like = result.to_like(mesh)
        self.assertEqual((like.points.dtype, like.faces.dtype), (np.float32, np.int64))
        self.assertTrue(np.array_equal(like.faces, padded(result.faces)))
        self.same_data(like.point_data, result)
        self.assertIs(like.active_texture_coordinates, result.uv)
        self.assertTrue(np.array_equal(like.cell_data["place"], result.input_faces))
        self.assertTrue(np.array_equal(like.cell_data["labels"], result.input_faces > 99))
        levels = quadrille.Levels()
        quadrille.simplify(mesh, faces=60, levels=levels)
        level = levels.at(faces=100)
        self.assertTrue(np.array_equal(level.to_like(mesh).cell_data["place"], level.input_faces))
        plain = PolyData(self.points, self.faces)
        like = self.small.to_like(plain)
        self.same(like.points, like.faces, self.small)
        mesh.n_verts, mesh.n_lines = 2, 1  # their data come first
        mesh.cell_data = {"place": np.append([-1, -2, -3], self.places)}
        self.assertTrue(np.array_equal(result.to_like(mesh).cell_data["place"], result.input_faces))
        regular = types.SimpleNamespace(points=self.points, regular_faces=self.faces)
        self.same(*quadrille.simplify(regular, ratio=0.25), self.small)
        for bad in (np.insert(self.faces[:, [0, 0, 1, 2]], 0, 4, axis=1).ravel(), padded(self.faces)[:-1],
                    np.append(padded(self.faces), [4, 0, 1, 2, 3, 3, 0, 1]), self.faces[:, [0, 0, 1, 2]]):
            with self.assertRaisesRegex(ValueError, r"^the PolyData has faces that are not triangles: triangulate\(\)"):
                quadrille.simplify(PolyData(self.points, bad))

    def test_meshio(self):
        cells = [("line", self.faces[:2, :2]), ("triangle", self.faces[:90]),
                 ("triangle", self.faces[90:])]
        mesh = MeshioMesh(self.points, cells, self.data,
                          {"place": [np.zeros(2), self.places[:90], self.places[90:]]}, {"skin": [1, 2]})
        result = quadrille.simplify(mesh, ratio=0.25, attributes=("heat", "rgb"))
        like = result.to_like(mesh)
        self.same(like.points, like.cells[0].data, self.warm)
        self.assertEqual((len(like.cells), like.cells[0].type), (1, "triangle"))
        self.same_data(like.point_data, self.warm)
        self.assertTrue(np.array_equal(like.cell_data["place"][0], result.input_faces))
        self.assertEqual(like.field_data, {"skin": [1, 2]})
        mesh.cells.append(("quad", self.faces[:, [0, 0, 1, 2]]))
        with self.assertRaisesRegex(ValueError, "^the Mesh.* has cells of the type quad: only triangles"):
            quadrille.simplify(mesh)
        del mesh.cells
        mesh.cells_dict = {"triangle": self.faces}
        self.same(*quadrille.simplify(mesh, ratio=0.25), self.small)

    def test_whatever_takes_a_mesh_takes_theirs(self):
        mesh = Trimesh(self.points, self.faces)
        self.assertTrue(np.array_equal(quadrille.curvature_importance(mesh),
                                       quadrille.curvature_importance(self.points, self.faces)))
        for number, given in enumerate((mesh, (self.points, self.faces), [self.points, self.faces])):
            quadrille.write_mesh(self.path(f"{number}.obj"), given)
            self.same(*quadrille.read_mesh(self.path(f"{number}.obj")), quadrille.Mesh(*given)
                      if number else quadrille.Mesh(self.points, self.faces))

    def test_target_reduction(self):
        points, faces, _ = torus(20)
        fifth = quadrille.simplify(points, faces, target_reduction=0.8)
        self.assertEqual(len(fifth.faces), 160)
        self.same(*fifth, quadrille.simplify(points, faces, ratio=0.2))
        for wrong in (0, 1, -0.5, 90, float("nan")):
            with self.assertRaisesRegex(ValueError, r"^target_reduction is .*, not in \(0, 1\)"):
                quadrille.simplify(points, faces, target_reduction=wrong)
        for other in (dict(faces=9), dict(ratio=0.1), dict(vertices=9), dict(error=1),
                      dict(relative_error=1), dict(tolerance=np.ones(len(points)))):
            with self.assertRaisesRegex(ValueError, f"^target_reduction and {list(other)[0]} do not go together"):
                quadrille.simplify(points, faces, target_reduction=0.9, **other)

    def test_errors(self):
        mesh = PolyData(self.points, padded(self.faces))
        mesh.point_data, mesh.cell_data = self.data, {"place": self.places}
        with self.assertRaisesRegex(ValueError, "contains 'cold', but the .* PolyData are: 'heat', 'rgb', 'l"):
            quadrille.simplify(mesh, attributes=["cold"])
        with self.assertRaisesRegex(TypeError, "is a str, not a dict .* or a list of names .* PolyData$"):
            quadrille.simplify(mesh, attributes="heat")
        with self.assertRaisesRegex(ValueError, "^triangles are given in addition to a PolyData, which has its own$"):
            quadrille.simplify(mesh, self.faces)
        with self.assertRaisesRegex(TypeError, "^a Vector3dVector is not a triangle mesh of trimesh"):
            self.small.to_like(Vector3dVector(self.points))
        for primitive in (Primitive(), StubbornPrimitive()):
            with self.assertRaisesRegex(TypeError, r"Primitive cannot be made from .*: pass its to_mesh\(\)$"):
                self.small.to_like(primitive)
        with self.assertRaisesRegex(TypeError, "^a Simplified is already a mesh of this library"):
            self.small.to_like(self.small)
        with self.assertRaisesRegex(TypeError, "^levels is a list, not a Levels"):
            quadrille.simplify(self.points, self.faces, levels=[])
        with self.assertRaisesRegex(TypeError, "^attributes has the name 3, which is a int, not a str"):
            quadrille.simplify(self.points, self.faces, attributes={3: self.heat})
        with self.assertRaisesRegex(TypeError, "os.PathLike"):
            quadrille.read_mesh(10**9)
        with self.assertRaisesRegex(TypeError, "^the first argument is a Folder, not a Mesh, a pair .* or a triangle mesh of trimesh"):
            quadrille.simplify(Folder(), ratio=0.1)
        mesh.celltypes = [10]
        with self.assertRaisesRegex(TypeError, "extract_surface"):
            quadrille.simplify(mesh, ratio=0.1)
        del mesh.celltypes
        mesh.n_strips = 1
        with self.assertRaisesRegex(ValueError, r"^the PolyData has triangle strips: triangulate\(\)"):
            quadrille.simplify(mesh, ratio=0.1)
        mesh.n_strips = 0
        for places in (np.arange(243), self.places[:200]):
            mesh.cell_data["place"] = places
            with self.assertRaisesRegex(ValueError, rf"^place .* PolyData has {len(places)} values for 242"):
                self.small.to_like(mesh)
        other = PolyData(self.points, padded(self.faces[:200]))
        other.cell_data = {"place": self.places[:200]}
        with self.assertRaisesRegex(ValueError, "has 200 faces and face data: it is not the mesh that was simplified$"):
            self.small.to_like(other)
        for given in (None, 3.5, self.points, (self.points,)):
            with self.assertRaisesRegex(TypeError, "^mesh is a .*, not a Mesh, a pair"):
                quadrille.write_mesh(self.path("x.obj"), given)
        for given in ([1], self.heat, "heat"):
            mesh = quadrille.Mesh(self.points, self.faces, attributes=given)
            for call in (lambda: quadrille.simplify(self.points, self.faces, attributes=given),
                         lambda: quadrille.simplify(mesh),
                         lambda: quadrille.write_mesh(self.path("x.obj"), mesh)):
                with self.assertRaisesRegex(TypeError, f"^attributes is an? {type(given).__name__}, not a"):
                    call()
        self.assertEqual(os.listdir(self.folder), [])


class RealLibraries(Folder):
    """A mesh goes in with values at its points and faces, and one of the same class comes out."""

    def setUp(self):
        super().setUp()
        self.points, self.faces, (self.uv, self.corners) = torus(16)
        self.small = quadrille.simplify(self.points, self.faces, ratio=0.25)

    def same(self, points, faces, expected):
        self.assertTrue(np.array_equal(points, expected.points))
        self.assertTrue(np.array_equal(faces, expected.faces))

    def taken_everywhere(self, mesh, small):
        quadrille.write_mesh(self.path("a.ply"), mesh)
        self.assertEqual(len(quadrille.read_mesh(self.path("a.ply")).faces), len(self.faces))
        self.assertLess(quadrille.surface_distance(mesh, mesh, samples=100).hausdorff, 1e-6)
        self.assertTrue(quadrille.verify(mesh, small, distance=9.0))
        self.assertEqual(len(quadrille.curvature_importance(mesh)), len(self.points))

    @unittest.skipUnless(importlib.util.find_spec("open3d"), "Open3D is not installed")
    def test_open3d(self):
        import open3d
        vector = open3d.utility
        mesh = open3d.geometry.TriangleMesh(vector.Vector3dVector(self.points),
                                            vector.Vector3iVector(self.faces.astype(np.int32)))
        mesh.compute_vertex_normals()
        mesh.triangle_uvs = vector.Vector2dVector(self.uv[self.corners].reshape(-1, 2))
        mesh.triangle_material_ids = vector.IntVector(np.arange(len(self.faces), dtype=np.int32))
        mesh.vertex_colors = vector.Vector3dVector(np.tile([0.25, 0.5, 1.0], (len(self.points), 1)))
        uv = np.asarray(mesh.triangle_uvs)
        result = quadrille.simplify(mesh, ratio=0.25, normals=mesh.vertex_normals, colors=mesh.vertex_colors,
                                    uv=(uv, np.arange(len(uv)).reshape(-1, 3)), split_vertices=False)
        like = result.to_like(mesh)
        self.assertIs(type(like), open3d.geometry.TriangleMesh)
        self.same(np.asarray(like.vertices), np.asarray(like.triangles), result)
        self.assertTrue(like.has_vertex_normals() and like.has_vertex_colors() and like.has_triangle_uvs())
        self.assertTrue(np.array_equal(np.asarray(like.triangle_material_ids), result.input_faces))
        self.assertTrue(np.allclose(np.asarray(like.vertex_colors), [0.25, 0.5, 1.0]))
        self.same(*quadrille.simplify(mesh, ratio=0.25), self.small)
        self.taken_everywhere(mesh, like)
        with self.assertRaisesRegex(TypeError, r"pass its to_legacy\(\)"):
            quadrille.simplify(open3d.t.geometry.TriangleMesh.from_legacy(mesh))

    @unittest.skipUnless(importlib.util.find_spec("meshio"), "meshio is not installed")
    def test_meshio(self):
        import meshio
        places = np.arange(len(self.faces))
        mesh = meshio.Mesh(self.points, [("line", self.faces[:2, :2]), ("triangle", self.faces[:99]),
                                         ("triangle", self.faces[99:])], point_data={"heat": self.points[:, 2]},
                           cell_data={"place": [np.zeros(2), places[:99], places[99:]]})
        result = quadrille.simplify(mesh, ratio=0.25, attributes=["heat"])
        like = result.to_like(mesh)
        self.assertIs(type(like), meshio.Mesh)
        self.same(like.points, like.cells_dict["triangle"], result)
        self.assertTrue(np.array_equal(like.point_data["heat"], result.attributes["heat"]))
        self.assertTrue(np.array_equal(like.cell_data["place"][0], result.input_faces))
        self.same(*quadrille.simplify(mesh, ratio=0.25), self.small)
        self.taken_everywhere(mesh, like)
        mesh.point_sets = {"rim": np.arange(3)}
        with self.assertWarnsRegex(UserWarning, "^Mesh: not kept: point_sets$"):
            self.small.to_like(mesh)
        tetrahedra = meshio.Mesh(self.points, [("tetra", self.faces[:, [0, 1, 2, 0]])])
        with self.assertRaisesRegex(ValueError, "^the Mesh has cells of the type tetra: only triangles"):
            quadrille.simplify(tetrahedra)

    @unittest.skipUnless(importlib.util.find_spec("vtkmodules"), "VTK is not installed")
    def test_vtk(self):
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        mesh, vertices, polys, lines = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkCellArray()
        vertices.SetData(numpy_to_vtk(self.points, deep=True))
        polys.SetData(3, numpy_to_vtkIdTypeArray(self.faces.astype(np.int64).ravel(), deep=True))
        lines.InsertNextCell(2, [0, 1])
        mesh.SetPoints(vertices)
        mesh.SetPolys(polys)
        mesh.SetLines(lines)
        for name, array, data in (("heat", self.points[:, 2].astype(np.float32), mesh.GetPointData()),
                                  ("place", np.append([-1], np.arange(len(self.faces))), mesh.GetCellData())):
            made = numpy_to_vtk(np.ascontiguousarray(array), deep=True)
            made.SetName(name)
            data.AddArray(made)
        result = quadrille.simplify(mesh, ratio=0.25, attributes=["heat"], normals=self.points)
        like = result.to_like(mesh)
        self.assertIs(type(like), vtkPolyData)
        self.assertEqual((like.GetNumberOfPolys(), like.GetNumberOfCells()), (len(result.faces),) * 2)
        self.same(vtk_to_numpy(like.GetPoints().GetData()),
                  vtk_to_numpy(like.GetPolys().GetConnectivityArray()).reshape(-1, 3), result)
        heat = vtk_to_numpy(like.GetPointData().GetArray("heat"))
        self.assertEqual(heat.dtype, np.float32)
        self.assertTrue(np.array_equal(heat, result.attributes["heat"]))
        self.assertTrue(np.array_equal(vtk_to_numpy(like.GetPointData().GetNormals()), result.normals))
        self.assertTrue(np.array_equal(vtk_to_numpy(like.GetCellData().GetArray("place")), result.input_faces))
        self.same(*quadrille.simplify(mesh, ratio=0.25), self.small)
        self.taken_everywhere(mesh, like)
        polys.InsertNextCell(4, [0, 1, 2, 3])
        with self.assertRaisesRegex(ValueError, "^the vtkPolyData has faces .* apply vtkTriangleFilter first"):
            quadrille.simplify(mesh)

    @unittest.skipUnless(importlib.util.find_spec("trimesh"), "trimesh is not installed")
    def test_trimesh(self):
        import trimesh
        mesh = trimesh.Trimesh(self.points, self.faces, process=False, metadata={"file": "a.obj"},
                               vertex_attributes={"heat": self.points[:, 2].copy()})
        result = quadrille.simplify(mesh, ratio=0.25, attributes=["heat"])
        like = result.to_like(mesh)
        self.assertIs(type(like), trimesh.Trimesh)
        self.same(like.vertices, like.faces, result)
        self.assertTrue(np.array_equal(like.vertex_attributes["heat"], result.attributes["heat"]))
        self.assertEqual(like.metadata["file"], "a.obj")
        self.same(*quadrille.simplify(mesh, ratio=0.25), self.small)
        self.taken_everywhere(mesh, like)
        with self.assertRaisesRegex(TypeError, r"pass its to_mesh\(\)"):
            self.small.to_like(trimesh.primitives.Box())


if __name__ == "__main__":
    unittest.main()
