"""Sparse maps between points, and levels as vertex splits: what a user makes of them with numpy and scipy."""

import copy
import pickle
import unittest

import numpy as np

import quadrille
from surfaces import sheet, torus

try:
    import scipy.sparse as sparse
except ImportError:
    sparse = None


def rows_of(matrix):
    """For each row its number of entries and the sum of its weights."""
    sums = np.zeros(matrix.shape[0])
    np.add.at(sums, np.repeat(np.arange(matrix.shape[0]), np.diff(matrix.indptr)), matrix.weights)
    return np.diff(matrix.indptr), sums


def farthest(a, b):
    return np.sqrt(((a - b) ** 2).sum(axis=1)).max()


class Maps(unittest.TestCase):
    def check(self, matrix, rows, columns):
        """Returns which rows are empty."""
        self.assertEqual(matrix.shape, (rows, columns))
        self.assertEqual((matrix.indptr.dtype, matrix.indices.dtype), (np.int64, np.int64))
        self.assertEqual((matrix.indptr[0], matrix.indptr[-1]), (0, len(matrix.indices)))
        counts, sums = rows_of(matrix)
        self.assertTrue(((counts >= 0) & (counts <= 3)).all())
        self.assertTrue((matrix.weights > 0).all())
        self.assertTrue(((matrix.indices >= 0) & (matrix.indices < columns)).all())
        np.testing.assert_allclose(sums[counts > 0], 1, rtol=0, atol=1e-15)
        return counts == 0

    def test_places_are_within_the_bound(self):
        for (points, faces, _), error in ((torus(30), 0.2), (sheet(30), 0.02)):
            result = quadrille.simplify(points, faces, error=error, both_ways=True, maps=True)
            self.assertLess(len(result.points), len(points) / 3)
            self.assertFalse(self.check(result.old_to_new, len(points), len(result.points)).any())
            self.assertFalse(self.check(result.new_to_old, len(result.points), len(points)).any())
            self.assertLessEqual(farthest(result.old_to_new @ result.points, points), result.report.hausdorff_bound)
            self.assertLessEqual(farthest(result.new_to_old @ points, result.points), result.report.hausdorff_bound)

    def test_fields_on_a_plane_are_reproduced(self):
        points, faces, _ = sheet(30)
        points[:, 2] = 0.3 * points[:, 0] - 0.5 * points[:, 1] + 0.1
        result = quadrille.simplify(points, faces, faces=8, error=1e-9, maps=True)
        self.assertLess(len(result.points), 20)
        linear = lambda p: p @ [1., 2., -3.] + 4
        np.testing.assert_allclose(result.old_to_new @ linear(result.points), linear(points), atol=1e-12)
        np.testing.assert_allclose(result.new_to_old @ linear(points), linear(result.points), atol=1e-12)
        np.testing.assert_allclose(result.old_to_new @ np.ones(len(result.points)), 1, atol=1e-15)

    @unittest.skipUnless(sparse, "scipy is not installed")
    def test_scipy_takes_them(self):
        points, faces, _ = torus(20)
        result = quadrille.simplify(points, faces, faces=200, maps=True)
        for rows, values in ((result.old_to_new, result.points), (result.new_to_old, points)):
            matrix = sparse.csr_matrix(rows.csr, rows.shape)
            self.assertTrue(matrix.has_canonical_format)
            np.testing.assert_allclose(matrix @ values, rows @ values, rtol=1e-15, atol=1e-15)
            np.testing.assert_allclose(matrix @ values[:, 2], rows @ values[:, 2], rtol=1e-15, atol=1e-15)

    def test_nothing_contracted_is_the_identity(self):
        points, faces, _ = torus(8)
        result = quadrille.simplify(points, faces, ratio=1, maps=True)
        for matrix in (result.old_to_new, result.new_to_old):
            self.assertEqual(matrix.indices.tolist(), list(range(len(points))))
            self.assertTrue((matrix.weights == 1).all())

    def test_rows_of_what_vanishes_are_empty(self):
        points, faces, _ = torus(24)
        speck = 0.001 * points[:3] + [5, 0, 0]
        points = np.concatenate([points, speck, [[9, 9, 9]]])
        faces = np.concatenate([faces, [[len(points) - 4, len(points) - 3, len(points) - 2]]])
        result = quadrille.simplify(points, faces, faces=100, topology="components_may_vanish", maps=True)
        self.assertEqual(result.report.vanished_components, 1)
        empty = self.check(result.old_to_new, len(points), len(result.points))
        self.assertEqual(np.flatnonzero(empty).tolist(), list(range(len(points) - 4, len(points))))
        self.assertTrue(((result.old_to_new @ result.points)[empty] == 0).all())
        self.assertFalse(self.check(result.new_to_old, len(result.points), len(points)).any())

    def test_points_at_one_place(self):
        points, faces, _ = torus(20)
        split = points[faces].reshape(-1, 3)
        result = quadrille.simplify(split, np.arange(len(split)).reshape(-1, 3), faces=100, split_vertices=True,
                                    maps=True)
        self.assertFalse(self.check(result.old_to_new, len(split), len(result.points)).any())
        whole = quadrille.simplify(points, faces, faces=100, maps=True)
        of_whole = (whole.old_to_new @ whole.points)[faces].reshape(-1, 3)
        self.assertLess(farthest(result.old_to_new @ result.points, split), 2 * farthest(of_whole, split))

        last = len(split) - 1  # a point of nothing but a triangle that is degenerate once points are joined
        twice = np.concatenate([split, split[last:], split[:1]])
        triangles = np.concatenate([np.arange(len(split)), [last, last + 1, last + 2]]).reshape(-1, 3)
        result = quadrille.simplify(twice, triangles, faces=100, split_vertices=True, maps=True)
        self.assertFalse(self.check(result.old_to_new, len(twice), len(result.points)).any())
        self.assertEqual((result.old_to_new @ result.points)[last].tolist(),
                         (result.old_to_new @ result.points)[last + 1].tolist())

    def test_surfaces_that_are_not_wound_alike(self):
        points, faces, _ = torus(24)
        faces[::2] = faces[::2, ::-1]
        result = quadrille.simplify(points, faces, error=0.2, both_ways=True, maps=True)
        self.assertLess(len(result.points), len(points))
        self.assertLessEqual(farthest(result.old_to_new @ result.points, points), result.report.hausdorff_bound)
        self.assertLessEqual(farthest(result.new_to_old @ points, result.points), result.report.hausdorff_bound)

    def test_with_levels_and_functions_and_hulls(self):
        points, faces, _ = torus(16)
        levels = quadrille.Levels()
        plain = quadrille.simplify(points, faces, faces=100, maps=True)
        recorded = quadrille.simplify(points, faces, faces=100, maps=True, levels=levels)
        self.assertTrue((plain.old_to_new.weights == recorded.old_to_new.weights).all())
        self.assertEqual(levels.coarsest["faces"], 100)
        for options in (dict(hull="outer"), dict(keep_volume=True), dict(cost=lambda pair: pair.quadric),
                        dict(order="relaxed"), dict(cost="edge_length")):
            result = quadrille.simplify(points, faces, faces=100, maps=True, **options)
            self.assertFalse(self.check(result.old_to_new, len(points), len(result.points)).any())
        with self.assertRaisesRegex(ValueError, "^calibrated does not go with maps"):
            quadrille.simplify(points, faces, error=0.1, both_ways=True, calibrated=True, maps=True)

    def test_only_where_asked_for(self):
        result = quadrille.simplify(*torus(8)[:2])
        for name in ("old_to_new", "new_to_old"):
            with self.assertRaisesRegex(ValueError, "pass maps=True"):
                getattr(result, name)

    def test_products_and_copies(self):
        points, faces, _ = torus(12)
        result = quadrille.simplify(points, faces, faces=100, maps=True)
        matrix = result.old_to_new
        with self.assertRaisesRegex(ValueError, r"the values have the shape \(7,\)"):
            matrix @ np.zeros(7)
        self.assertEqual(repr(matrix), f"<quadrille.SparseMap: 144 x {len(result.points)}, {len(matrix.indices)} entries>")
        for other in (copy.deepcopy(result), pickle.loads(pickle.dumps(result))):
            self.assertTrue((other.old_to_new.weights == matrix.weights).all())
        empty = quadrille.simplify(np.zeros((3, 3)), np.zeros((0, 3), int), maps=True)
        self.assertEqual(empty.old_to_new.shape, (3, 0))
        self.assertEqual((empty.old_to_new @ np.zeros((0, 2))).shape, (3, 2))
        self.assertEqual(empty.new_to_old.shape, (0, 3))


class Splits(unittest.TestCase):
    def replayed(self, splits):
        """The points and faces of each level, by nothing but numpy."""
        points = splits.points[:splits.point_counts[0]].copy()
        faces = splits.faces[:splits.face_counts[0]].copy()
        yield points, faces
        for s in range(len(splits.parents)):
            faces.reshape(-1)[splits.corners[splits.corner_begins[s]:splits.corner_begins[s + 1]]] = splits.children[s]
            points = np.concatenate([points, splits.points[len(points):splits.point_counts[s + 1]]])
            faces = np.concatenate([faces, splits.faces[len(faces):splits.face_counts[s + 1]]])
            if splits.parents[s] >= 0:
                points[splits.parents[s]] = splits.parent_points[s]
            yield points, faces

    def check(self, levels):
        splits = levels.export_splits()
        self.assertEqual(len(splits.parents), levels.coarsest["contractions"])
        for s, (points, faces) in enumerate(self.replayed(splits)):
            level = levels.at(contractions=len(splits.parents) - s)
            by_points = np.argsort(splits.input_points[:len(points)])
            by_faces = np.argsort(splits.input_faces[:len(faces)])
            numbers = np.empty(len(points), np.int64)
            numbers[by_points] = np.arange(len(points))
            self.assertEqual(points[by_points].tobytes(), level.points.tobytes())
            self.assertEqual(numbers[faces[by_faces]].astype(np.uint32).tobytes(), level.faces.tobytes())
            self.assertEqual(splits.errors[s], level.error)
        return splits

    def test_splits_give_the_bytes_of_each_level(self):
        points, faces, _ = torus(10)
        small = np.concatenate([points, 0.01 * points + [7, 0, 0]])
        twice = np.concatenate([faces, faces + len(points)])
        for surface, options in (((points, faces), {}), ((small, twice), dict(topology="components_may_vanish")),
                                 ((small, twice), dict(topology="free", pairs_closer_than=0.5)),
                                 ((points, faces), dict(order="relaxed", placement="endpoint"))):
            levels = quadrille.Levels()
            quadrille.simplify(*surface, faces=40, levels=levels, **options)
            splits = self.check(levels)
            self.assertEqual((splits.parents < 0).any(), options.get("topology") == "components_may_vanish")

    def test_nothing_recorded(self):
        with self.assertRaisesRegex(ValueError, "nothing has been recorded"):
            quadrille.Levels().export_splits()


if __name__ == "__main__":
    unittest.main()
