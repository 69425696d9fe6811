"""Functions of other libraries, objects of DLPack, and the table of options of the Python module quadrille."""

import ctypes
import inspect
import unittest

import numpy as np

import quadrille
from quadrille import _core, _library
from quadrille.drop_in import fast_simplification, pyfqmr
from quadrille.drop_in.trimesh import simplify_quadric_decimation
from surfaces import sheet, torus


class FastSimplification(unittest.TestCase):
    def test_points_and_triangles(self):
        points, faces, _ = torus(16)
        for dtype in (np.float32, np.float64):
            for index in (np.int32, np.int64):
                new_points, new_faces = fast_simplification.simplify(
                    points.astype(dtype), faces.astype(index), 0.75, agg=5)
                self.assertEqual((len(new_faces), new_points.dtype, new_faces.dtype), (128, dtype, np.int32))
        self.assertEqual(len(fast_simplification.simplify(points.tolist(), faces.tolist(), target_count=100)[1]), 100)

    def test_what_is_wrong(self):
        points, faces, _ = torus(8)
        for call, message in ((dict(), "neither"), (dict(target_reduction=0.5, target_count=9), "two targets"),
                              (dict(target_reduction=2), "not in"), (dict(target_count=9999), "number of faces")):
            with self.assertRaisesRegex(ValueError, message):
                fast_simplification.simplify(points, faces, **call)
        with self.assertRaises(NotImplementedError):
            fast_simplification.simplify(points, faces, 0.5, return_collapses=True)

    def test_lossless(self):
        points, faces, _ = sheet(10)
        flat = points * [1, 1, 0]
        self.assertLess(len(fast_simplification.simplify(flat, faces, 0.5, lossless=True)[1]), 30)


class Pyfqmr(unittest.TestCase):
    def test_a_mesh_in_and_out(self):
        points, faces, _ = sheet(12)
        simplifier = pyfqmr.Simplify()
        with self.assertRaisesRegex(ValueError, "setMesh"):
            simplifier.getMesh()
        simplifier.setMesh(points, faces)
        simplifier.simplify_mesh(target_count=100, aggressiveness=7, preserve_border=True, verbose=False)
        new_points, new_faces, normals = simplifier.getMesh()
        self.assertLessEqual(len(new_faces), 110)
        self.assertEqual(normals.shape, new_faces.shape)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1)
        border = points[(points[:, :2] == points[:, :2].min(axis=0)).any(axis=1)]
        self.assertTrue({tuple(p) for p in border} <= {tuple(p) for p in new_points})


class Trimesh(unittest.TestCase):
    class Mesh:
        def __init__(self, vertices, faces, process=False, **_):
            self.vertices, self.faces = vertices, faces

    def test_a_mesh_of_its_class(self):
        points, faces, _ = torus(16)
        for call in (dict(percent=0.5), dict(face_count=256, aggression=3)):
            small = simplify_quadric_decimation(self.Mesh(points, faces), **call)
            self.assertIsInstance(small, self.Mesh)
            self.assertEqual(len(small.faces), 256)


class DLPack(unittest.TestCase):
    class Tensor:
        def __init__(self, array):
            self.array = array

        def __dlpack__(self, **options):
            return self.array.__dlpack__(**options)

        def __dlpack_device__(self):
            return self.array.__dlpack_device__()

    def test_in_and_out(self):
        points, faces, uv = torus(12)
        expected = quadrille.simplify(points, faces, uv=uv, fixed=np.arange(4))
        result = quadrille.simplify(self.Tensor(points), self.Tensor(faces.astype(np.int64)),
                                    uv=(self.Tensor(uv[0]), self.Tensor(uv[1])), fixed=self.Tensor(np.arange(4)))
        self.assertTrue((result.points == expected.points).all())
        self.assertTrue((result.uv[0] == expected.uv[0]).all())
        self.assertTrue((np.from_dlpack(result.points) == result.points).all())


class Table(unittest.TestCase):
    """The options of the module are those of the table of the library."""

    class Row(ctypes.Structure):
        _fields_ = [(name, ctypes.c_char_p) for name in
                    ("name", "kind", "range", "fallback", "unit", "places", "short_form", "sentence")]

    def rows(self, of_channels):
        at = _library.declare("quadrille_option_at", ctypes.POINTER(self.Row), ctypes.c_int32, ctypes.c_size_t)
        index = 0
        while at(of_channels, index):
            row = at(of_channels, index).contents
            yield {name: getattr(row, name).decode() for name, _ in self.Row._fields_}
            index += 1

    def words(self, of_channels, option):
        class Word(ctypes.Structure):
            _fields_ = [("word", ctypes.c_char_p), ("sentence", ctypes.c_char_p)]
        at = _library.declare("quadrille_word_at", ctypes.POINTER(Word), ctypes.c_int32, ctypes.c_char_p,
                              ctypes.c_size_t)
        index = 0
        while at(of_channels, option.encode(), index):
            yield at(of_channels, option.encode(), index).contents.word.decode()
            index += 1

    def test_names_and_defaults(self):
        known = inspect.signature(quadrille.simplify).parameters
        for row in self.rows(0):
            with self.subTest(row["name"]):
                self.assertEqual(row["name"] in known, "Python" in row["places"])
                default = known[row["name"]].default if row["name"] in known else None
                if default is not None:
                    text = str(default).lower() if isinstance(default, bool) else default
                    self.assertEqual(type(text)(row["fallback"]), text)

    def test_an_option_has_its_row_in_the_documentation(self):
        for name, text in (("line_weight", "much better ones at a larger one (default: 0)"),
                           ("normal_flip", "in degrees; in (0, 180] (default: 90)"),
                           ("selected", "booleans for each triangle, or indices")):
            lines = quadrille.simplify.__doc__.split("\n    " + name.ljust(18))[1]
            self.assertIn(text, " ".join(lines.split("\n    ")[0].split()) + " ".join(lines.split())[:400])
        self.assertNotIn("<", quadrille.simplify.__doc__.split("Returns")[0])

    def test_words(self):
        for of_channels, option, members in (
                (0, "cost", _core.Cost), (0, "placement", _core.Placement), (0, "order", _core.Order),
                (0, "topology", _core.Topology), (0, "weighting", _core.Weighting), (1, "seams", _core.Seams),
                (1, "new_values", _core.NewValues)):
            self.assertEqual(list(self.words(of_channels, option)), list(members.__members__))


if __name__ == "__main__":
    unittest.main()
