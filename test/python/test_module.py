"""The Python module quadrille."""

import copy
import inspect
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import unittest
import warnings

import numpy as np

import quadrille
from quadrille import _arrays
from surfaces import Folder, sheet, torus, write_obj


class Results(Folder):
    def same(self, a, b):
        self.assertEqual(a.shape, b.shape)
        self.assertTrue((a == b).all())

    def by_the_facade(self, arrays, options):
        """What the compiled library gives without Python."""
        with open(self.path("in"), "wb") as file:
            for array in arrays:
                file.write(len(array).to_bytes(8, sys.byteorder) + array.tobytes())
        with open(self.path("in"), "rb") as file:
            subprocess.run([os.environ["QUADRILLE_FACADE"], self.path("out"),
                            *(f"{key}={value}" for key, value in options.items())],
                           check=True, stdin=file)
        with open(self.path("out"), "rb") as file:
            for dtype, columns in ((float, 3), (np.uint32, 3), (float, 1), (np.uint32, 3)):
                count = int.from_bytes(file.read(8), sys.byteorder)
                row = columns * np.dtype(dtype).itemsize
                yield np.frombuffer(file.read(count * row), dtype).reshape(count, columns)

    @unittest.skipUnless(os.environ.get("QUADRILLE_FACADE"), "QUADRILLE_FACADE names no program")
    def test_bits_are_those_of_the_compiled_library(self):
        points, faces, uv = torus(20)
        for options in (dict(faces=101), dict(ratio=0.2, cost="memoryless_quadric"),
                        dict(vertices=50, placement="endpoint"), dict(cost="edge_length"),
                        dict(error=0.05, cost="thin_feature_quadric"), dict(order="relaxed"),
                        dict(boundary_weight=3, pairs_closer_than=0.3)):
            for channel in (None, uv):
                with self.subTest(options, has_uv=channel is not None):
                    values, triples = uv if channel else (np.empty((0, 2)), np.empty((0, 3), np.uint32))
                    expected = list(self.by_the_facade((points, faces, values, triples), options))
                    result = quadrille.simplify(points, faces, uv=channel, **options)
                    self.same(result.points, expected[0])
                    self.same(result.faces, expected[1])
                    self.assertLess(len(result.faces), 700)
                    if channel:
                        self.same(result.uv[0], expected[2].reshape(-1, 2))
                        self.same(result.uv[1], expected[3])

    @unittest.skipUnless(os.environ.get("QUADRILLE_FACADE"), "QUADRILLE_FACADE names no program")
    def test_weights_of_borders_are_those_of_the_compiled_library(self):
        points, faces, uv = sheet(12)
        nothing = np.empty((0, 2)), np.empty((0, 3), np.uint32)
        results = []
        for weight in (0.5, 3000):
            options = dict(faces=60, boundary_weight=weight)
            expected = list(self.by_the_facade((points, faces, *nothing), options))
            results.append(quadrille.simplify(points, faces, **options).points)
            self.same(results[-1], expected[0])
        self.assertFalse(np.array_equal(*results))

    def test_half_of_the_faces_by_default_and_two_arrays(self):
        points, faces, _ = torus(20)
        new_points, new_faces = quadrille.simplify(points, faces)
        self.assertEqual(new_faces.shape, (400, 3))
        self.assertEqual(new_points.shape, (200, 3))
        self.assertLess(new_faces.max(), 200)

    def test_report(self):
        points, faces, _ = torus(20)
        report = quadrille.simplify(points, faces, faces=100).report
        self.assertEqual((report.faces_before, report.faces_after), (800, 100))
        self.assertEqual(report.stop, "target met")
        self.assertTrue(report.is_target_reached)
        self.assertEqual(report.distance_bound, float("inf"))
        self.assertGreater(report.error, 0)
        self.assertTrue(str(report).startswith("800 -> 100 faces"))
        self.assertIsInstance(report.rejections, dict)
        self.assertIsNone(report.normal_bound_degrees)
        solid = quadrille.simplify(points, faces, ratio=0.5, keep_solid=True, normal_deviation=60).report
        self.assertEqual(list(solid.self_intersections), [0, 0])
        self.assertTrue(0 < solid.normal_bound_degrees <= 60)
        near = quadrille.simplify(points, faces, relative_error=0.01)
        self.assertLessEqual(near.report.distance_bound, 0.01 * np.linalg.norm(np.ptp(points, axis=0)))
        self.assertGreater(near.report.contractions, 100)
        self.assertEqual(near.report.hausdorff_bound, float("inf"))
        both = quadrille.simplify(points, faces, relative_error=0.01, both_ways=True).report
        self.assertGreaterEqual(both.hausdorff_bound, both.distance_bound)
        self.assertLessEqual(both.hausdorff_bound, 0.01 * np.linalg.norm(np.ptp(points, axis=0)))
        self.assertEqual(pickle.loads(pickle.dumps(both)).hausdorff_bound, both.hausdorff_bound)
        tolerance = np.where(points[:, 0] < 0, 0.0, 0.1)
        field = quadrille.simplify(points, faces, tolerance=tolerance)
        part, place = field.report.used_tolerance
        self.assertTrue(0 < part <= 1)
        self.assertEqual(len(place), 3)
        self.assertEqual(pickle.loads(pickle.dumps(field.report)).used_tolerance, (part, place))
        self.assertIsNone(both.used_tolerance)
        for wrong in (tolerance[1:], -1 - tolerance):
            with self.assertRaisesRegex(ValueError, "tolerance"):
                quadrille.simplify(points, faces, tolerance=wrong)
        with self.assertRaisesRegex(ValueError, "the smaller of both"):
            quadrille.simplify(points, faces, tolerance=tolerance, error=1.0)
        with self.assertWarns(UserWarning):
            few = quadrille.simplify(points, faces, faces=0)
        self.assertFalse(few.report.is_target_reached)

    def test_calibrated_limits_are_kept_and_go_further(self):
        points, faces, uv = torus(16)
        limit = 0.02 * np.linalg.norm(np.ptp(points, axis=0))
        told = []
        options = dict(relative_error=0.02, both_ways=True)
        plain = quadrille.simplify(points, faces, uv=uv, **options)
        result = quadrille.simplify(points, faces, uv=uv, calibrated=True, progress=told.append, **options)
        self.assertLess(len(result.faces), 0.8 * len(plain.faces))
        self.assertTrue(0 < result.report.hausdorff_bound <= limit)
        self.assertEqual(result.uv[1].shape, result.faces.shape)
        self.assertGreater(sum(status.progress == 1 for status in told), 2)
        weights = np.array([(i, j, 20 - i - j) for i in range(21) for j in range(21 - i)]) / 20
        samples = np.einsum("sk,fkx->fsx", weights, result.points[result.faces]).reshape(-1, 3)
        far = max(np.linalg.norm(samples - point, axis=1).min() for point in points)
        self.assertTrue(0.3 * limit < far < 1.1 * limit)

    def test_calibration_is_ended_with_what_there_is(self):
        points, faces, _ = torus(16)
        options = dict(relative_error=0.02, both_ways=True)
        plain = quadrille.simplify(points, faces, **options)
        told = []

        def until_the_second_run(status):
            told.append(status.progress)
            time.sleep(0.05)  # so that the next run asks at once
            return told[-1] == 1 or 1 not in told

        ended = quadrille.simplify(points, faces, calibrated=True, progress=until_the_second_run, **options)
        self.same(ended.faces, plain.faces)
        self.assertEqual(ended.report.stop, "target met")
        self.assertLess(told[-1], 1)
        self.assertEqual(told.index(1), len(told) - 2)  # no further run is begun
        never = quadrille.simplify(points, faces, calibrated=True, progress=lambda status: False, **options)
        self.assertEqual((len(never.faces), never.report.stop), (len(faces), "cancelled"))

    def test_both_sides_of_a_sheet_stay(self):
        points, faces, _ = sheet(12)
        both = np.concatenate([faces, faces[:, ::-1], faces[:7]])
        result = quadrille.simplify(points, both, ratio=0.25)
        report = result.report
        self.assertEqual((report.faces_before, report.counted_faces, report.doubled_faces),
                         (len(both), 2 * len(faces), 7))
        is_reverse = result.input_faces >= len(faces)
        self.assertEqual(2 * is_reverse.sum(), len(result.faces))
        self.assertLess(abs(len(result.faces) - 0.5 * len(faces)), 4)
        around = lambda triangles: {tuple(np.roll(t, -t.argmin())) for t in triangles}
        self.assertEqual(around(result.faces[~is_reverse]), around(result.faces[is_reverse][:, ::-1]))
        self.assertTrue(is_reverse.any())

    def test_vertex_map_and_input_faces(self):
        points, faces, _ = sheet(12)
        result = quadrille.simplify(points, faces, faces=60, placement="endpoint")
        self.assertEqual(result.vertex_map.shape, (144,))
        self.assertEqual(set(result.vertex_map.tolist()) - {-1}, set(range(len(result.points))))
        self.same(result.vertex_map[faces[result.input_faces]], result.faces.astype(np.int64))

    def test_fixed_by_mask_and_by_index(self):
        points, faces, _ = sheet(12)
        mask = np.zeros(144, bool)
        mask[[65, 66]] = True
        by_mask = quadrille.simplify(points, faces, faces=20, fixed=mask)
        by_index = quadrille.simplify(points, faces, faces=20, fixed=[65, 66])
        self.same(by_mask.points, by_index.points)
        for i in (65, 66):
            self.same(by_mask.points[by_mask.vertex_map[i]], points[i])
        self.assertFalse((quadrille.simplify(points, faces, faces=20).points == points[65]).all(1).any())

    def test_selected_by_mask_and_by_index(self):
        points, faces, _ = sheet(12)
        mask = points[faces].mean(1)[:, 0] > 0.5
        by_mask = quadrille.simplify(points, faces, faces=40, selected=mask)
        by_index = quadrille.simplify(points, faces, faces=40, selected=np.flatnonzero(mask))
        self.same(by_mask.points, by_index.points)
        self.assertEqual(len(by_mask.faces), 40 + np.count_nonzero(~mask))
        corners = {p.tobytes() for p in by_mask.points[by_mask.faces]}
        self.assertTrue({p.tobytes() for p in points[faces[~mask]]} <= corners)

    def test_importance_leaves_more_faces(self):
        points, faces, _ = sheet(40)
        right = lambda result: np.mean(result.points[result.faces].mean(1)[:, 1] > 0.5)
        importance = np.where(points[:, 1] > 0.5, 64, 1)
        result = quadrille.simplify(points, faces, ratio=0.2, importance=importance)
        self.assertGreater(right(result), 0.7)
        alike = quadrille.simplify(points, faces, ratio=0.2)
        self.same(quadrille.simplify(points, faces, ratio=0.2, importance=np.full(1600, 0.3)).points,
                  alike.points)
        refused = lambda message, values: self.assertRaisesRegex(
            ValueError, message, quadrille.simplify, points, faces, importance=values)
        refused(r"^importance has the shape \(3,\), not \(1600,\)", [1, 2, 3])
        importance[7] = -1
        refused(r"^importance\[7\] is -1: negative or not finite", importance)

    def test_distances(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
        faces = np.array([[0, 1, 2], [0, 2, 3]])
        d = quadrille.surface_distance((points, faces), (points + [0, 0, 0.25], faces), samples=1000)
        for number in d:
            self.assertAlmostEqual(number, 0.25)
        half = quadrille.surface_distance((points, faces), (points, faces[:1]))  # the other half is missing
        self.assertEqual((half.rms_b_to_a, half.hausdorff_b_to_a), (0, 0))
        self.assertAlmostEqual(half.hausdorff_a_to_b, 0.5 ** 0.5)
        self.assertAlmostEqual(half.rms_a_to_b, (1 / 24) ** 0.5, delta=0.002)  # of x / sqrt(2), over all of it
        self.assertEqual(half.hausdorff, half.hausdorff_a_to_b)
        self.assertAlmostEqual(half.rms, half.rms_a_to_b / 2 ** 0.5)
        self.assertNotEqual(half, quadrille.surface_distance((points, faces), (points, faces[:1]), seed=1))
        refused = lambda message, *args, **options: self.assertRaisesRegex(
            ValueError, message, quadrille.surface_distance, *args, **options)
        refused("^samples is -1", (points, faces), (points, faces), samples=-1)
        refused("^the points of b has the shape", (points, faces), (points[:, :2], faces))
        refused(r"^the faces of a\[1\] is \[0, 2, 3\], but there are 3 points", (points[:3], faces), (points, faces))
        refused("a surface without faces", (points, faces), (points, faces[:0]))

    def test_claims(self):
        points, faces, _ = torus(30)
        small = quadrille.simplify(points, faces, error=0.01, both_ways=True, normal_deviation=60)
        bound, degrees = small.report.hausdorff_bound, small.report.normal_bound_degrees
        verdict = quadrille.verify((points, faces), small, distance=small.report.distance_bound, distance_both_ways=bound,
                                   normal_deviation=degrees, no_self_intersection=True, solid=True,
                                   tolerance=np.full(len(points), bound))
        self.assertTrue(verdict)
        self.assertGreater(len(verdict.findings), 8)
        self.assertGreater(verdict.findings[0].measured, bound / 20)
        self.assertFalse(quadrille.verify((points, faces), small, distance=bound / 20))
        self.assertFalse(quadrille.verify((points, faces), small, normal_deviation=1))
        self.assertFalse(quadrille.verify((points, faces), small, tolerance=np.full(len(points), bound / 20)))
        self.assertFalse(quadrille.verify((points, faces), (small.points, small.faces[1:]), solid=True))
        crossing = (np.concatenate([small.points, small.points + 0.05]),
                    np.concatenate([small.faces, small.faces + len(small.points)]))
        broken = quadrille.verify((points, faces), crossing, no_self_intersection=True)
        self.assertFalse(broken)
        self.assertRegex(repr(broken), r"^Verdict\(intersecting pairs of faces: 0 promised, \d+ measured, BROKEN near \(.*\)\)$")
        self.assertEqual(len(broken.findings[0].place), 3)
        told = []
        self.assertTrue(quadrille.verify((points, faces), small, distance_both_ways=bound, progress=told.append))
        self.assertTrue(told == sorted(told) and 0 <= told[0] and told[-1] <= 1)
        cancelled = quadrille.verify((points, faces), small, distance_both_ways=bound, progress=lambda part: False)
        self.assertTrue(cancelled.is_cancelled and not cancelled)
        self.assertRegex(repr(cancelled), "cancelled before everything was measured")
        self.assertTrue(quadrille.verify((points, faces), (small.points, small.faces), normal_deviation=degrees,
                                         vertex_map=small.vertex_map))
        refused = lambda message, **options: self.assertRaisesRegex(
            ValueError, message, quadrille.verify, (points, faces), (small.points, small.faces), **options)
        refused("^normal_deviation needs vertex_map", normal_deviation=60)
        refused("^vertex_map has numbers from 0 to 9999", normal_deviation=60, vertex_map=np.append(small.vertex_map[1:].clip(0), 9999))
        refused("negative or not a number", distance=-1.0)
        refused(r"^tolerance has the shape \(2,\)", tolerance=[1, 2])

    def test_maps_of_importance(self):
        points, faces, _ = sheet(12)
        mesh = quadrille.Mesh(points, faces)
        flat = mesh.points * np.array([1, 1, 0])
        self.assertTrue(np.allclose(quadrille.curvature_importance(flat, faces, strength=2), 1))
        self.same(quadrille.curvature_importance(mesh), quadrille.curvature_importance(points, faces))
        eye = np.array([3.0, 0.5, 2.0])
        seen = quadrille.view_importance(flat, faces, eye=eye, turned_away=1, outline=1)
        distance = np.linalg.norm(flat - eye, axis=1)
        self.assertTrue(np.allclose(seen, (distance.max() / distance) ** 3))
        with self.assertRaisesRegex(ValueError, r"^eye has the shape \(2,\), not \(3,\)"):
            quadrille.view_importance(flat, faces, eye=[1, 2])

    def test_hidden_faces_are_found_and_removed(self):
        points, faces, _ = torus(24)
        count = len(faces)
        corners = np.arange(8)  # of a cube around the torus
        shell = 9.0 * np.stack([corners % 2, corners // 2 % 2, corners // 4], axis=-1) - 4.5
        shell_faces = np.array([[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7],
                                [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]], np.uint32)
        mesh = quadrille.Mesh(np.concatenate([points, shell]), np.concatenate([faces, shell_faces + len(points)]),
                              labels=np.arange(count + len(shell_faces)))
        found = quadrille.hidden_faces(mesh)
        self.assertEqual((found.is_hidden[:count].all(), found.is_hidden[count:].any()), (True, False))
        self.assertEqual([len(group.faces) for group in found.groups], [count])
        self.assertIn(found.groups[0].kind, ("inner component", "cavity"))
        self.assertGreater(found.groups[0].volume, 0)
        self.assertRegex(repr(found), f"{count} of {len(mesh.faces)} faces hidden")
        seen = quadrille.remove_hidden(mesh)
        self.same(seen.faces, shell_faces + len(points))
        self.same(seen.labels, np.arange(count, count + len(shell_faces)))
        fractions = quadrille.visibility(mesh, directions=32)
        self.assertTrue((fractions.faces[count:] == 1).all() and (fractions.points[:len(points)] == 0).all())
        self.assertEqual(fractions.importance.min(), 1 / 512)
        self.assertTrue(quadrille.hidden_faces(mesh, progress=lambda fraction: False).is_cancelled)
        with self.assertRaisesRegex(ValueError, "8 directions are not between 16 and 1048576"):
            quadrille.hidden_faces(mesh, directions=8)

    def test_lines_and_noise_are_options(self):
        points, faces, _ = torus(24)
        plain = quadrille.simplify(points, faces, ratio=0.2)
        for options in (dict(line_weight=0.1), dict(normal_noise=0.3), dict(position_noise=0.2),
                        dict(weighting="by_squared_area")):
            result = quadrille.simplify(points, faces, ratio=0.2, **options)
            self.assertFalse(result.points.shape == plain.points.shape
                             and (result.points == plain.points).all(), options)

    def test_labels_of_any_kind_stay(self):
        points, faces, _ = sheet(12)
        for labels in (np.array(["a", "b"])[(points[faces[:, 0], 0] > 0.5).astype(int)],
                       np.where(points[faces[:, 0], 0] > 0.5, -7, 2**40)):
            result = quadrille.simplify(points, faces, faces=40, labels=labels)
            self.assertEqual(result.labels.dtype, labels.dtype)
            self.same(result.labels, labels[result.input_faces])
            self.assertEqual(len(set(result.labels.tolist())), 2)

    @unittest.skipUnless(quadrille._core.has_threads, "built without oneTBB")
    def test_threads_do_not_show(self):
        points, faces, _ = torus(60)
        one = quadrille.simplify(points, faces, faces=500, order="relaxed")
        two = quadrille.simplify(points, faces, faces=500, order="relaxed", threads=2)
        self.same(one.points, two.points)
        self.same(one.faces, two.faces)
        greedy = quadrille.simplify(points, faces, faces=500)
        self.assertFalse(one.points.shape == greedy.points.shape and (one.points == greedy.points).all())

    def test_topology_and_creases_are_options(self):
        points, faces, _ = torus(12)
        apart = np.concatenate([points, points * 0.01 + 9]), np.concatenate([faces, faces + 144])
        kept = quadrille.simplify(*apart, faces=100)
        parts = quadrille.simplify(*apart, faces=100, topology="components_may_vanish")
        self.assertEqual((kept.report.components_after, parts.report.vanished_components), (2, 1))
        creases = quadrille.simplify(points, faces, faces=100, crease_degrees=20, crease_weight=50)
        self.assertFalse((creases.points == quadrille.simplify(points, faces, faces=100).points).all())


class Channels(unittest.TestCase):
    def test_texture_at_corners(self):
        points, faces, (values, triples) = torus(24)
        result = quadrille.simplify(points, faces, faces=300, uv=(values, triples))
        new_values, new_triples = result.uv
        self.assertEqual(new_triples.shape, result.faces.shape)
        self.assertEqual(new_triples.dtype, np.uint32)
        self.assertEqual(new_triples.max() + 1, len(new_values))
        # The seam is there still: some points have several values, of which some differ by 1.
        at_seam = new_values[new_triples.ravel()][np.argsort(result.faces.ravel(), kind="stable")]
        self.assertGreater(len(new_values), len(result.points))
        self.assertAlmostEqual(at_seam.min(), 0, places=3)
        self.assertAlmostEqual(at_seam.max(), 1, places=3)
        again = quadrille.simplify(result, faces=200)
        self.assertEqual(again.uv[1].shape, again.faces.shape)

    def test_forms_and_types_come_back(self):
        points, faces, uv = sheet(12)
        n = len(points)
        colors = np.random.default_rng(1).integers(0, 256, (n, 4), np.uint8)
        given = dict(uv=uv.astype(np.float32), colors=colors,
                     normals=quadrille.Channel(np.tile([0, 0, 1.0], (n, 1)), new_values="recomputed"),
                     attributes={"heat": points[:, 0], "kind": np.arange(n) % 3,
                                 "skin": quadrille.Channel(np.eye(4)[np.arange(n) % 4], new_values="weights"),
                                 "uv2": quadrille.Channel(uv, faces.astype(np.int64), kind="texture")})
        result = quadrille.simplify(points, faces, faces=100, **given)
        n = len(result.points)
        self.assertEqual((result.uv.dtype, result.uv.shape), (np.float32, (n, 2)))
        self.assertEqual((result.colors.dtype, result.colors.shape), (np.uint8, (n, 4)))
        self.assertEqual(result.attributes["heat"].shape, (n,))
        self.assertEqual(result.attributes["kind"].dtype, np.arange(1).dtype)
        self.assertEqual(result.attributes["uv2"].indices.dtype, np.int64)
        self.assertEqual(result.normals.new_values, "recomputed")
        lengths = np.linalg.norm(result.normals.values, axis=1)
        self.assertTrue(np.allclose(lengths, 1))
        self.assertFalse((result.normals.values[:, 2] == 1).all())
        self.assertTrue(np.allclose(result.attributes["skin"].values.sum(axis=1), 1))
        # What is linear on the surface stays what it was.
        self.assertTrue(np.allclose(result.attributes["heat"], result.points[:, 0], atol=0.01))
        self.assertTrue(np.allclose(result.uv, result.points[:, :2], atol=0.01))

    def test_integers_are_rounded(self):
        points, faces, _ = sheet(12)
        whole = np.rint(100 * points[:, 2]).astype(np.int16)
        floats = quadrille.simplify(points, faces, faces=100, attributes={"h": whole.astype(float)})
        result = quadrille.simplify(points, faces, faces=100, attributes={"h": whole})
        self.assertEqual(result.attributes["h"].dtype, np.int16)
        self.assertTrue((result.attributes["h"] == np.rint(floats.attributes["h"])).all())
        self.assertFalse((result.attributes["h"] == floats.attributes["h"].astype(int)).all())

    def test_options_count(self):
        points, faces, uv = sheet(12)
        noise = np.random.default_rng(2).random(len(points))
        by_default = quadrille.simplify(points, faces, faces=100, attributes={"noise": noise})
        more = quadrille.simplify(points, faces, faces=100,
                                  attributes={"noise": quadrille.Channel(noise, importance=50)})
        self.assertFalse(by_default.points.shape == more.points.shape and
                         (by_default.points == more.points).all())
        existing = quadrille.simplify(points, faces, faces=100,
                                      attributes={"noise": quadrille.Channel(noise, new_values="existing")})
        self.assertTrue(np.isin(existing.attributes["noise"].values, noise).all())
        self.assertFalse(np.isin(by_default.attributes["noise"], noise).all())

    def test_split_vertices(self):
        points, faces, (values, triples) = torus(16)
        pairs, split = np.unique(np.stack([faces.ravel(), triples.ravel()], 1), axis=0, return_inverse=True)
        split_points, split_faces = points[pairs[:, 0]], split.reshape(-1, 3)
        result = quadrille.simplify(split_points, split_faces, faces=200, uv=values[pairs[:, 1]],
                                    split_vertices=True)
        self.assertIsNone(result.vertex_map)
        self.assertEqual(len(result.uv), len(result.points))
        self.assertEqual(result.report.components_after, 1)
        welded = np.unique(result.points, axis=0)
        self.assertLess(len(welded), len(result.points))
        self.assertEqual(len(welded) - 200 / 2, 0)  # closed, of the genus of a torus


class Arrays(unittest.TestCase):
    def test_what_fits_is_not_copied(self):
        points, faces, _ = sheet(5)
        self.assertIs(_arrays.real_rows("points", points, 3), points)
        self.assertIs(_arrays.index_triples("faces", faces, 25, "points"), faces)
        signed = faces.astype(np.int32)
        self.assertTrue(np.shares_memory(_arrays.index_triples("faces", signed, 25, "points"), signed))

    @unittest.skipUnless(sys.platform == "linux", "asks for memory as Linux tells it")
    def test_the_engine_reads_where_they_are(self):
        points, faces, _ = sheet(1200)

        def size():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")

        before = size()
        grown = []

        def stop(status):
            grown.append(size() - before)
            return False

        quadrille.simplify(points, faces, progress=stop)  # is asked when the surface has been read
        bare = grown[0]
        grown.clear()
        before = size()
        quadrille.simplify(points.astype(np.float32), faces.astype(np.int64), progress=stop)
        self.assertGreater(grown[0] - bare, 0.5 * (points.nbytes + faces.nbytes))

    def test_types_and_orders_give_the_same(self):
        points, faces, _ = sheet(12)
        points = points.astype(np.float32).astype(np.float64)
        expected = quadrille.simplify(points, faces, faces=100)
        for p, f in ((points.astype(np.float32), faces.astype(np.int64)),
                     (np.asfortranarray(points), faces.astype(np.uint8)),
                     (np.repeat(points, 2, axis=0)[::2], faces.astype(np.int32)),
                     (np.hstack([points, points])[:, :3], np.hstack([faces, faces])[:, :3]),
                     (points.tolist(), faces.tolist())):
            result = quadrille.simplify(p, f, faces=100)
            self.assertEqual(result.points.dtype, getattr(p, "dtype", np.float64))
            self.assertEqual(result.faces.dtype, getattr(f, "dtype", np.int64))
            self.assertTrue((result.points == expected.points.astype(result.points.dtype)).all())
            self.assertTrue((result.faces == expected.faces).all())

    def test_read_only_arrays_stay_as_they_are(self):
        points, faces, uv = torus(12)
        arrays = [points, faces, *uv]
        before = [array.copy() for array in arrays]
        for array in arrays:
            array.flags.writeable = False
        result = quadrille.simplify(points, faces, faces=100, uv=uv)
        for array, old in zip(arrays, before):
            self.assertTrue((array == old).all())
        result.points[0] = 7  # those of the result are its own
        result.faces[0] = 0

    def test_nothing_gives_nothing(self):
        for points, faces in ((np.empty((0, 3)), np.empty((0, 3), int)), ([], []),
                              (np.zeros((3, 3)), np.empty((0, 3), int))):
            result = quadrille.simplify(points, faces, faces=10)
            self.assertEqual((result.points.shape, result.faces.shape), ((0, 3), (0, 3)))


class Errors(unittest.TestCase):
    def setUp(self):
        self.points, self.faces, self.uv = sheet(6)

    def refused(self, message, *surface, **options):
        points, faces = surface or (self.points, self.faces)
        with self.assertRaisesRegex(ValueError, message):
            quadrille.simplify(points, faces, **options)

    def test_surfaces(self):
        p, f = self.points, self.faces
        self.refused(r"^points has the shape \(36, 2\), not \(n, 3\)", p[:, :2], f)
        self.refused(r"^points has the shape \(108,\), not \(n, 3\)", p.ravel(), f)
        self.refused("^points has the type complex128", p.astype(complex), f)
        self.refused("^points has the type object", np.array([[None] * 3]), f)
        self.refused(r"^faces has the shape \(50, 2\), not \(n, 3\): it takes triangles", p, f[:, :2])
        self.refused("^faces has the type float64", p, f.astype(float))
        self.refused("^the triangles are missing", p, None)
        bad = p.copy()
        bad[7, 1] = np.nan
        self.refused(r"^points\[7\] is not finite: \[", bad, f)
        for number, message in ((36, r"^faces\[9\] is \[36, .*\], but there are 36 points"),
                                (-1, r"^faces has a negative number, -1, at \(9, 0\)"),
                                (2**33, "^faces has a number beyond 32 bits, 8589934592")):
            bad = f.astype(np.int64)
            bad[9, 0] = number
            self.refused(message, p, bad)

    def test_options(self):
        self.refused("^triangles are given in addition to a Mesh", quadrille.Mesh(self.points, self.faces), self.faces)
        self.refused("^faces is 2.5, not an integer", faces=2.5)
        self.refused("^faces is -1, not in", faces=-1)
        self.refused("^ratio is 'half', not a number", ratio="half")
        self.refused(r"^ratio is 2, not in \[0, 1\]", ratio=2)
        self.refused("limit -1 is not a distance", error=-1)
        self.refused("^cost is 'qem', not one of quadric, memoryless_quadric, thin_feature", cost="qem")
        self.refused("^placement is 3, not one of optimal", placement=3)
        self.refused("no optimal placement", cost="edge_length", placement="optimal")
        self.refused("^order is 'fast', not one of greedy, relaxed", order="fast")
        self.refused("^topology is", topology="kept?")
        self.refused("boundary_weight -1", boundary_weight=-1)
        self.refused("not in \\(0, 180\\]", normal_flip=0)
        self.refused("^no_self_intersection=True needs order='greedy'", no_self_intersection=True, order="relaxed")
        self.refused("0 degrees are not in", normal_deviation=0)
        self.refused("keep_solid keeps the topology", keep_solid=True, topology="free")
        self.refused("^more than one thread needs order='relaxed' or simplified_topology", threads=2)
        self.refused("0 threads are not from 1 to 1024", threads=0, order="relaxed")
        self.refused("^crease_degrees needs cost='quadric'", cost="edge_length", crease_degrees=20)
        self.refused("^weighting is 'by_hand', not one of by_area", weighting="by_hand")
        self.refused("line_weight -1 is negative", line_weight=-1)
        self.refused("need cost='quadric'", line_weight=1, cost="memoryless_quadric")
        self.refused("share 0 is not in", share=0, order="relaxed")
        self.refused("^progress is 3, which is not a function", progress=3)
        for wrong in (dict(), dict(error=1), dict(both_ways=True, tolerance=np.ones(36)),
                      dict(both_ways=True, error=1, relative_error=1)):
            self.refused("^calibrated needs either error or relative_error, with", calibrated=True, **wrong)
        limit = dict(calibrated=True, both_ways=True)
        self.refused("does not go with a tolerance", error=1, tolerance=np.ones(36), **limit)
        self.refused("does not go with levels", error=1, levels=quadrille.Levels(), **limit)
        self.refused("limit -1 is not a distance", error=-1, **limit)
        with self.assertRaises(TypeError):
            quadrille.simplify(self.points, self.faces, face=3)

    def test_what_goes_along(self):
        self.refused(r"^fixed has the shape \(3,\), not \(36,\)", fixed=[True] * 3)
        self.refused("^fixed contains point 36, but there are 36 points", fixed=[36])
        self.refused("^selected contains triangle 50, but there are 50 triangles", selected=[50])
        self.refused(r"^labels has the shape \(3,\), not \(50,\)", labels=[1, 2, 3])
        self.refused(r"^uv has the shape \(36, 3\), not \(n, 2\)", uv=self.points)
        self.refused("^uv has 35 values for 36 points", uv=self.uv[1:])
        self.refused("^uv has 3 index triples for 50 faces", uv=(self.uv, self.faces[:3]))
        self.refused(r"^the indices of uv\[0\] is \[0, 6, 7\], but there are 5 values",
                     uv=(self.uv[:5], self.faces))
        self.refused("^uv is a tuple of 3", uv=(self.uv, self.faces, 1))
        self.refused(r"^colors has the shape \(36, 2\), not \(n, 3\) or \(n, 4\)", colors=self.uv)
        bad = self.points.copy()
        bad[3, 0] = np.inf
        self.refused(r"^heat\[3\] is not finite", attributes={"heat": bad})
        channel = quadrille.Channel
        self.refused("^the seams of uv is 'torn', not one of kept", uv=channel(self.uv, seams="torn"))
        self.refused("^new_values of uv is 'any', not one of", uv=channel(self.uv, new_values="any"))
        self.refused("would tear", uv=channel(self.uv, new_values="existing"))
        self.refused("importance 0 is not above 0", uv=channel(self.uv, importance=0))
        self.refused("has 2 components and 1 weights", uv=channel(self.uv, weights=[1]))
        self.refused("^the kind of a is 'b', not one of", attributes={"a": channel(self.uv, kind="b")})


class Watching(unittest.TestCase):
    def test_progress(self):
        points, faces, _ = torus(100)
        seen = []
        result = quadrille.simplify(points, faces, faces=100, progress=lambda s: seen.append(
            (s.progress, s.faces, s.initial_faces)))
        self.assertEqual(seen[0], (0, 20000, 20000))
        self.assertEqual(seen[-1], (1, 100, 20000))
        self.assertEqual(seen, sorted(seen, key=lambda s: (s[0], -s[1])))
        self.assertEqual(len(result.faces), 100)

    def test_false_ends_it_with_what_there_is(self):
        points, faces, uv = torus(400)
        result = quadrille.simplify(points, faces, faces=100, progress=lambda s: s.contractions == 0)
        self.assertEqual(result.report.stop, "cancelled")
        self.assertGreater(len(result.faces), 100)
        self.assertLess(len(result.faces), 320000)
        at_once = quadrille.simplify(points, faces, uv=uv, progress=lambda s: False)
        self.assertTrue((at_once.points == points).all() and (at_once.uv[1] == uv[1]).all())

    def test_what_it_raises_comes_out(self):
        points, faces, _ = torus(30)

        def fail(status):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            quadrille.simplify(points, faces, progress=fail)

    def test_control_c(self):
        points, faces, uv = torus(500)
        before = points.copy()
        sent = []

        def interrupt():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        for options in (dict(), dict(uv=uv), dict(order="relaxed")):
            with self.subTest(options.keys()):
                threading.Timer(0.1, interrupt).start()
                with self.assertRaises(KeyboardInterrupt):
                    quadrille.simplify(points, faces, faces=100, **options)
                self.assertLess(time.monotonic() - sent[-1], 3)
        self.assertEqual(len(sent), 3)
        self.assertTrue((points == before).all())

    def test_other_threads_run_on(self):
        points, faces, _ = torus(300)
        count, done = [0], threading.Event()

        def work():
            while not done.is_set():
                count[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=work)
        thread.start()
        start = time.monotonic()
        quadrille.simplify(points, faces, faces=100)
        seconds = time.monotonic() - start
        done.set()
        thread.join()
        self.assertGreater(count[0], 5 * seconds)


class Levels(Folder):
    def test_levels_are_what_simplify_gives(self):
        points, faces, uv = torus(24)
        levels = quadrille.Levels()
        self.assertFalse(levels)
        last = quadrille.simplify(points, faces, faces=100, uv=uv, levels=levels,
                                  attributes={"heat": points[:, 2]})
        self.assertTrue(levels)
        self.assertEqual(levels.finest["faces"], 1152)
        self.assertEqual(levels.coarsest["faces"], 100)
        for count in (1152, 600, 100):
            level = levels.at(faces=count)
            expected = quadrille.simplify(points, faces, faces=count, uv=uv,
                                          attributes={"heat": points[:, 2]})
            self.assertTrue((level.points == expected.points).all())
            self.assertTrue((level.faces == expected.faces).all())
            self.assertTrue((level.uv[0][level.uv[1]] == expected.uv[0][expected.uv[1]]).all())
            self.assertTrue((level.attributes["heat"][:, 0] == expected.attributes["heat"]).all())
            self.assertTrue((level.input_faces == expected.input_faces).all())
        self.assertEqual(levels.info(faces=100)["contractions"], last.report.contractions)
        self.assertLessEqual(levels.at(error=0.01).error, 0.01)
        self.assertEqual(levels.at(contractions=10).contractions, 10)
        self.assertLessEqual(len(levels.at(vertices=80).points), 80)

    def test_files(self):
        points, faces, uv = torus(24)
        levels = quadrille.Levels()
        quadrille.simplify(points, faces, faces=100, error=0.5, uv=uv, levels=levels)
        levels.save(self.path("torus.qlv"))
        loaded = quadrille.Levels.load(self.path("torus.qlv"))
        for stop in (dict(faces=300), dict(distance=0.05)):
            a, b = levels.at(**stop), loaded.at(**stop)
            self.assertTrue((a.points == b.points).all() and (a.uv[0] == b.uv[0]).all())
            self.assertLess(b.distance_bound, 0.5)
        with self.assertRaises(FileNotFoundError):
            quadrille.Levels.load(self.path("none.qlv"))
        with self.assertRaises(OSError):
            levels.save(self.path("no/folder.qlv"))
        with open(self.path("broken.qlv"), "wb") as file:
            file.write(b"no levels")
        with self.assertRaisesRegex(ValueError, "broken.qlv: not a file of levels"):
            quadrille.Levels.load(self.path("broken.qlv"))

    def test_errors(self):
        levels = quadrille.Levels()
        for ask in (lambda: levels.at(faces=3), lambda: levels.finest, lambda: levels.coarsest,
                    lambda: levels.save(self.path("x.qlv"))):
            with self.assertRaisesRegex(ValueError, "nothing has been recorded"):
                ask()
        quadrille.simplify(*torus(6)[:2], levels=levels)
        with self.assertRaisesRegex(ValueError, "^pass exactly one of faces, .*, not 0"):
            levels.at()
        with self.assertRaisesRegex(ValueError, "^pass exactly one of faces, .*, not 2"):
            levels.at(faces=3, error=1)
        with self.assertRaisesRegex(ValueError, "^faces is -3, not at least 0"):
            levels.at(faces=-3)
        with self.assertRaisesRegex(ValueError, "[Dd]istance"):
            levels.at(distance=3)


class Files(Folder):
    def test_textured_obj(self):
        points, faces, uv = torus(24)
        write_obj(self.path("in.obj"), points, faces, uv)
        mesh = quadrille.read_mesh(self.path("in.obj"))
        self.assertTrue((mesh.points == points).all() and (mesh.faces == faces).all())
        self.assertTrue((mesh.uv[0][mesh.uv[1]] == uv[0][uv[1]]).all())
        self.assertEqual(len(set(mesh.labels.tolist())), 2)
        small = quadrille.simplify(mesh, faces=300)
        self.assertLessEqual(len(small.faces), 320)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            quadrille.write_mesh(self.path("out.obj"), small)
        with open(self.path("out.obj")) as file:
            lines = file.read().split("\n")
        self.assertIn("mtllib statue.mtl", lines)
        self.assertIn("usemtl skin", lines)
        self.assertIn("usemtl cloth", lines)
        again = quadrille.read_mesh(self.path("out.obj"))
        self.assertTrue((again.points == small.points).all() and (again.faces == small.faces).all())
        self.assertTrue((again.uv[0][again.uv[1]] == small.uv[0][small.uv[1]]).all())
        self.assertTrue(((again.labels == again.labels[0]) == (small.labels == small.labels[0])).all())
        # As it was read, it is written.
        quadrille.write_mesh(self.path("same.obj"), mesh)
        same = quadrille.read_mesh(self.path("same.obj"))
        self.assertTrue((same.faces == mesh.faces).all() and (same.uv[1] == mesh.uv[1]).all())

    def test_arrays_become_files(self):
        points, faces, uv = sheet(8)
        colors = np.linspace(0, 255, 4 * 64).reshape(-1, 4).astype(np.uint8)
        mesh = quadrille.Mesh(points, faces, uv=uv, colors=colors, normals=np.tile([0, 0, 1.0], (64, 1)),
                              attributes={"heat": points[:, 2], "kind": np.arange(64, dtype=np.int32)})
        quadrille.write_mesh(self.path("a.ply"), mesh)
        read = quadrille.read_mesh(self.path("a.ply"))
        self.assertTrue((read.points == points).all() and (read.faces == faces).all())
        self.assertTrue((read.colors == colors).all())
        self.assertEqual(read.colors.dtype, np.uint8)
        self.assertTrue((read.uv[0][read.uv[1]] == uv[faces].astype(np.float32)).all())
        self.assertTrue((read.normals[0] == [0, 0, 1]).all())
        self.assertTrue((read.attributes["heat"].values == points[:, 2]).all())
        self.assertEqual(read.attributes["kind"].values.dtype, np.int32)
        self.assertEqual(read.attributes["kind"].new_values, "existing")
        small = quadrille.simplify(read, faces=40)
        self.assertTrue(np.isin(small.attributes["kind"].values, np.arange(64)).all())
        with self.assertWarnsRegex(UserWarning, "not kept: .*texture coordinates"):
            quadrille.write_mesh(self.path("a.stl"), mesh)
        with self.assertWarnsRegex(UserWarning, "not kept: labels"):
            quadrille.write_mesh(self.path("b.obj"), quadrille.Mesh(points, faces, labels=faces[:, 0]))

    def test_errors(self):
        with self.assertRaises(FileNotFoundError):
            quadrille.read_mesh(self.path("none.obj"))
        with open(self.path("bad.obj"), "w") as file:
            file.write("v 0 0 0\nf 1 2 3\n")
        with self.assertRaisesRegex(ValueError, "bad.obj"):
            quadrille.read_mesh(self.path("bad.obj"))
        points, faces, _ = sheet(4)
        mesh = quadrille.Mesh(points, faces)
        with self.assertRaisesRegex(OSError, "extension"):
            quadrille.write_mesh(self.path("x.doc"), mesh)
        with self.assertRaises(OSError):
            quadrille.write_mesh(self.path("no/x.obj"), mesh)
        with self.assertRaisesRegex(ValueError, r"^faces\["):
            quadrille.write_mesh(self.path("x.obj"), quadrille.Mesh(points[:3], faces))


    def test_colours_that_differ_at_points_are_seams(self):
        points, faces, _ = torus(24)
        is_red = (points[faces].mean(axis=1)[:, 0] > 0).astype(int)  # of each face
        numbers, places, lines = {}, [], []
        for face, red in zip(faces.tolist(), is_red.tolist()):
            for v in face:
                if (v, red) not in numbers:
                    numbers[v, red] = len(places)
                    places.append("%r %r %r %d 0 0" % (*points[v].tolist(), 255 * red))
            lines.append("3 %d %d %d" % tuple(numbers[v, red] for v in face))
        with open(self.path("in.ply"), "w") as file:
            file.write("ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\n"
                       "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face %d\n"
                       "property list uchar int vertex_indices\nend_header\n%s\n"
                       % (len(places), len(lines), "\n".join(places + lines)))
        endings = [".ply", ".glb"] if hasattr(quadrille._core, "simplify_gltf") else [".ply"]
        for ending in endings:
            mesh = quadrille.read_mesh(self.path("in.ply"))
            quadrille.write_mesh(self.path("a" + ending), mesh)
            small = quadrille.simplify(quadrille.read_mesh(self.path("a" + ending)), ratio=0.3)
            self.assertLess(len(small.faces), 0.31 * len(faces))
            self.assertTrue((small.colors[small.faces] == small.colors[small.faces][:, :1]).all())
            ends = np.unique(small.points, axis=0, return_inverse=True)[1].reshape(-1)[small.faces]
            edges = np.sort(np.concatenate([ends[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
            self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all())  # not torn


class Preparations(Folder):
    def genus(self, points, faces):
        edges = np.unique(np.sort(np.concatenate([faces[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1), axis=0,
                          return_counts=True)
        self.assertTrue((edges[1] == 2).all())
        return 1 - (len(np.unique(faces)) - len(edges[0]) + len(faces)) // 2

    def test_textures_go_with_cuts_limits_and_splits(self):
        points, faces, uv = torus(40)
        asked = {"simplified_topology": 3, "uv": uv}
        small = quadrille.simplify(points, faces, faces=400, **asked)
        self.assertEqual((small.report.cut_handles, self.genus(small.points, small.faces)), (1, 0))
        self.assertLess(0.5, small.report.cut_distance)  # half of the hole, which is up to 2 wide
        self.assertLess(small.report.cut_distance, 1.2)
        values, triples = small.uv
        self.assertTrue((np.ptp(values[triples], axis=1) < 0.6).all())  # no face reaches across a seam
        limited = quadrille.simplify(points, faces, error=0.05, **asked)
        self.assertLessEqual(limited.report.distance_bound, 0.05)
        self.assertEqual(limited.report.cut_handles, 1)
        exact = quadrille.simplify(points, faces, error=0.05, both_ways=True, calibrated=True, **asked)
        self.assertLessEqual(len(exact.faces), len(limited.faces))
        corners = points[faces].reshape(-1, 3)  # of each face its own points
        split = quadrille.simplify(corners, np.arange(3 * len(faces)).reshape(-1, 3), faces=400, split_vertices=True,
                                   simplified_topology=3)
        self.assertEqual((split.report.cut_handles, len(split.faces), split.vertex_map), (1, 400, None))
        with self.assertRaisesRegex(ValueError, "levels"):
            quadrille.simplify(points, faces, manifold=True, levels=quadrille.Levels())
        with self.assertRaisesRegex(ValueError, "touch"):
            quadrille.simplify(points, faces, keep_solid=True, simplified_topology=3)

    @unittest.skipUnless(hasattr(quadrille._core, "simplify_gltf"), "built without glTF")
    def test_glTF_is_cut_with_all_that_it_has(self):
        points, faces, uv = torus(40)
        quadrille.write_mesh(self.path("a.glb"), quadrille.Mesh(points, faces, uv=uv))
        report = quadrille.simplify_gltf(self.path("a.glb"), self.path("b.glb"), faces=400, simplified_topology=3)
        self.assertEqual((report.cut_handles, report.faces_after), (1, 400))
        small = quadrille.read_mesh(self.path("b.glb"))
        self.assertEqual(len(small.faces), 400)
        values, triples = small.uv
        self.assertTrue((np.ptp(values[triples], axis=1) < 0.6).all())


class Copies(Folder):
    def same(self, a, b):
        self.assertIs(type(a), type(b))
        if isinstance(a, np.ndarray):
            self.assertEqual((a.dtype, a.shape), (b.dtype, b.shape))
            self.assertTrue((a == b).all())
        elif isinstance(a, (tuple, list)):
            self.assertEqual(len(a), len(b))
            for x, y in zip(a, b):
                self.same(x, y)
        elif isinstance(a, dict):
            self.assertEqual(list(a), list(b))
            self.same(list(a.values()), list(b.values()))
        elif isinstance(a, (quadrille.Mesh, quadrille.Channel)):
            self.same({k: v for k, v in vars(a).items() if k != "_source"},
                      {k: v for k, v in vars(b).items() if k != "_source"})
        elif isinstance(a, (quadrille.Report, quadrille.Status)):
            for name in dir(a):
                if not name.startswith("_") and not callable(getattr(a, name)):
                    self.assertEqual(getattr(a, name), getattr(b, name), name)
        else:
            self.assertEqual(a, b)

    def all_copies(self, value):
        yield copy.copy(value)
        yield copy.deepcopy(value)
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            yield pickle.loads(pickle.dumps(value, protocol))

    def test_results_and_reports(self):
        points, faces, uv = torus(20)
        seen = []
        result = quadrille.simplify(points, faces, error=0.1, faces=100, uv=quadrille.Channel(*uv),
                                    attributes={"x": points[:, 0]}, labels=faces[:, 0] // 200,
                                    progress=seen.append)
        self.assertLess(result.report.distance_bound, 0.2)
        for other in self.all_copies(result):
            self.same(result, other)
            self.assertEqual(str(other.report), str(result.report))
        deep = copy.deepcopy(result)
        deep.points[:] = 0
        self.assertTrue(result.points.any())
        for other in self.all_copies(seen[-1]):
            self.same(seen[-1], other)
        with self.assertRaises((ValueError, RuntimeError, TypeError)):
            broken = {**result.report, "stop": "whim"}
            quadrille.Report.__new__(quadrille.Report).__setstate__(broken)

    def test_meshes_keep_what_a_file_says_of_faces(self):
        write_obj(self.path("a.obj"), *torus(12))
        mesh = quadrille.read_mesh(self.path("a.obj"))
        files = []
        for i, other in enumerate([mesh, *self.all_copies(mesh)]):
            quadrille.write_mesh(self.path(f"{i}.obj"), quadrille.simplify(other, faces=100))
            with open(self.path(f"{i}.obj"), "rb") as file:
                files.append(file.read())
        self.assertIn(b"usemtl", files[0])
        self.assertEqual(len(set(files)), 1)

    def test_levels(self):
        points, faces, uv = torus(24)
        levels = quadrille.Levels()
        for other in self.all_copies(levels):
            self.assertFalse(other)
        quadrille.simplify(points, faces, faces=64, uv=uv, levels=levels)
        for other in self.all_copies(levels):
            self.assertEqual(other.coarsest, levels.coarsest)
            for count in (64, 200, 1151):
                self.same(other.at(faces=count), levels.at(faces=count))
        other = copy.copy(levels)
        quadrille.simplify(points, faces, faces=500, levels=other)
        self.assertEqual(levels.coarsest["faces"], 64)


class Recordings(unittest.TestCase):
    def test_one_call_records_at_a_time(self):
        points, faces, _ = torus(60)
        levels, alone = quadrille.Levels(), quadrille.Levels()
        quadrille.simplify(points, faces, faces=100, levels=alone)
        errors, ready = [], threading.Barrier(3)

        def work():
            ready.wait()
            for _ in range(4):
                try:
                    quadrille.simplify(points, faces, faces=100, levels=levels)
                except ValueError as error:
                    errors.append(str(error))

        threads = [threading.Thread(target=work) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertLessEqual(set(errors), {"these Levels are being recorded by another call of simplify()"})
        self.assertTrue((levels.at(faces=777).points == alone.at(faces=777).points).all())

    def test_nobody_reads_meanwhile(self):
        points, faces, _ = torus(20)
        levels = quadrille.Levels()
        quadrille.simplify(points, faces, levels=levels)
        errors = []

        def progress(status):
            for ask in (lambda: levels.at(faces=3), lambda: levels.info(faces=3), lambda: bool(levels),
                        lambda: copy.copy(levels), lambda: levels.save("none.qlv"),
                        lambda: quadrille.simplify(points, faces, levels=levels)):
                with self.assertRaisesRegex(ValueError, "these Levels are being recorded by another call"):
                    ask()
            errors.append(None)

        quadrille.simplify(points, faces, faces=100, levels=levels, progress=progress)
        self.assertTrue(errors)
        self.assertEqual(levels.coarsest["faces"], 100)
        with self.assertRaises(ZeroDivisionError):
            quadrille.simplify(points, faces, levels=levels, progress=lambda status: 1 / 0)
        quadrille.simplify(points, faces, faces=90, levels=levels)  # it is free again
        self.assertEqual(levels.coarsest["faces"], 90)


class Orientation(unittest.TestCase):
    def flipped(self, faces, every):
        faces = faces.copy()
        faces[::every] = faces[::every][:, [0, 2, 1]]
        return faces

    def test_faces_are_wound_as_their_neighbours(self):
        points, faces, (values, corners) = torus(20)
        expected = quadrille.simplify(points, faces, faces=200, uv=(values, corners))
        wrong, wrong_corners = self.flipped(faces, 3), self.flipped(corners, 3)
        kept = wrong.copy()
        result = quadrille.simplify(points, wrong, faces=200, uv=(values, wrong_corners), orient=True)
        self.assertTrue((wrong == kept).all())
        self.assertEqual(result.remarks, ["faces turned to agree with their neighbours: 267"])
        for a, b in ((result.points, expected.points), (result.faces, expected.faces),
                     (result.uv[0], expected.uv[0]), (result.uv[1], expected.uv[1])):
            self.assertTrue((a == b).all())
        self.assertEqual(expected.remarks, [])
        again = quadrille.simplify(points, faces, faces=200, uv=(values, corners), orient=True)
        self.assertEqual(again.remarks, [])

    def test_split_vertices_are_neighbours(self):
        points, faces, _ = torus(20)
        split, loose = points[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3)
        result = quadrille.simplify(split, self.flipped(loose, 3), ratio=1, split_vertices=True, orient=True)
        self.assertEqual(result.remarks, ["faces turned to agree with their neighbours: 267"])

    def test_a_strip_of_one_side(self):
        angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
        half = angles / 2
        rim = np.array([[(1 + s * np.cos(h)) * np.cos(a), (1 + s * np.cos(h)) * np.sin(a), s * np.sin(h)]
                        for s in (-0.3, 0.3) for a, h in zip(angles, half)])
        faces = []
        for i in range(24):
            a, b, c, d = i, i + 1, 24 + i, 25 + i
            if i == 23:
                b, d = 24, 0
            faces += [[a, b, c], [b, d, c]]
        result = quadrille.simplify(rim, np.array(faces), ratio=1, orient=True)
        self.assertEqual(result.remarks, ["one-sided components, whose faces cannot be wound alike: 1"])


class Quiet(unittest.TestCase):
    @unittest.skipUnless(quadrille._core.has_threads, "built without oneTBB")
    def test_more_threads_than_there_are_print_nothing(self):
        code = ("import quadrille, sys; from surfaces import torus; points, faces, _ = torus(60); "
                "quadrille.simplify(points, faces, order='relaxed', threads=1024)")
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True,
                             cwd=os.path.dirname(os.path.abspath(__file__)))
        self.assertEqual((run.stdout, run.stderr), (b"", b""))


class Help(unittest.TestCase):
    def test_everything_says_what_it_is(self):
        for name in quadrille.__all__:
            self.assertGreater(len(getattr(quadrille, name).__doc__), 20, name)
        for name in inspect.signature(quadrille.simplify).parameters:
            self.assertRegex(quadrille.simplify.__doc__, rf"\b{name}\b")

    def test_version(self):
        self.assertRegex(quadrille.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
