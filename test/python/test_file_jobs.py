"""Surfaces from file to file by parts: in one call, in steps by a pool of processes, ended and restarted."""

import multiprocessing
import os
import pickle
import unittest
import warnings

import numpy as np

import quadrille
from quadrille._file_jobs import read_bytes
from surfaces import Folder, torus


class Jobs(Folder):
    def setUp(self):
        super().setUp()
        points, faces, _ = torus(80, 50)
        self.write_ply("in.ply", points, faces)
        self.scratch = self.path("scratch")
        self.how = dict(faces=800, scratch=self.scratch, memory="200M", chunk_faces=2200)

    def write_ply(self, name, points, faces):
        rows = np.empty(len(faces), [("count", "u1"), ("corners", "<i4", 3)])
        rows["count"], rows["corners"] = 3, faces
        with open(self.path(name), "wb") as file:
            file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\n"
                       f"property float y\nproperty float z\nelement face {len(faces)}\n"
                       "property list uchar int vertex_indices\nend_header\n".encode())
            file.write(points.astype("<f4").tobytes() + rows.tobytes())

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def at_once(self, **options):
        return quadrille.simplify_file(self.path("in.ply"), self.path("once.ply"), **{**self.how, **options})

    def test_a_call(self):
        told = []
        result = self.at_once(progress=told.append)
        self.assertEqual((result.report.faces_before, result.report.faces_after), (8000, 800))
        self.assertTrue(result.is_count_exact and result.report.is_target_reached)
        self.assertEqual((result.output, result.remarks), (self.path("once.ply"), []))
        self.assertEqual((result.chunks, result.faces_of_phases[-1]), (4, 800))
        self.assertEqual(len(quadrille.read_mesh(self.path("once.ply")).faces), 800)
        self.assertFalse(os.path.exists(self.scratch))
        self.assertEqual((told[0].stage, told[0].estimate.faces, told[0].progress), ("survey", 8000, 0))
        self.assertGreater(told[0].estimate.scratch, 28 * 8000)
        self.assertEqual(pickle.loads(pickle.dumps(result)).report.to_dict(), result.report.to_dict())

    def test_tolerances_have_a_name(self):
        with self.assertRaisesRegex(ValueError, "no scalar allowed"):
            self.at_once(faces=None, tolerance="allowed")
        for wrong in ({"error": 1}, {"relative_error": 0.1}):
            with self.assertRaisesRegex(ValueError, "tolerance does not go with error"):
                self.at_once(tolerance="allowed", **wrong)
        with self.assertRaisesRegex(TypeError, "name of a scalar property"):
            self.at_once(tolerance=[1.0])
        mesh = quadrille.read_mesh(self.path("in.ply"))
        mesh.attributes["allowed"] = np.full(len(mesh.points), 0.01)
        quadrille.write_mesh(self.path("in.ply"), mesh)
        result = self.at_once(faces=None, tolerance="allowed")
        self.assertLessEqual(result.report.used_tolerance[0], 1)
        self.assertLessEqual(result.report.hausdorff_bound, 0.01)
        self.assertLess(result.report.faces_after, 7000)

    def test_a_pool_of_processes(self):
        self.at_once()
        job = quadrille.FileJob(self.path("in.ply"), **self.how)
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            parts, done = job.partition(), []
            while parts > 0:
                done.append(pool.map(job.simplify, range(parts)))
                parts = job.close()
        result = job.merge(self.path("out.ply"))
        self.assertEqual(done[0], [0, 1, 2, 3])
        self.assertEqual((result.phases, len(done)), (3, 3))
        self.assertEqual(self.content("out.ply"), self.content("once.ply"))
        self.assertFalse(os.path.exists(self.scratch))

    def test_limits_and_policies(self):
        for options in (dict(relative_error=0.005), dict(error=0.02, both_ways=True), dict(cost="memoryless_quadric"),
                        dict(cost="edge_length", ratio=0.2), dict(topology="components_may_vanish", lock_boundary=True)):
            with self.subTest(options):
                given = {"faces": None if "ratio" in options or "error" in str(options) else 800, **options}
                result = self.at_once(**given)
                self.assertLess(result.report.faces_after, 4000)
                if "error" in options:
                    self.assertLessEqual(result.report.hausdorff_bound, 0.02)

    def test_tiles(self):
        points, faces, _ = torus(80, 50)
        for name, half in (("a.ply", faces[:4000]), ("b.ply", faces[4000:])):
            used, corners = np.unique(half, return_inverse=True)
            self.write_ply(name, points[used], corners.reshape(-1, 3))
        tiles = quadrille.simplify_file(self.path("[ab].ply"), self.path("tiles"), keep_tiles=True, weld=True, **self.how)
        self.assertEqual(sorted(os.listdir(self.path("tiles"))), ["a.ply", "b.ply"])
        self.assertEqual(tiles.report.faces_after, 800)
        with self.assertRaisesRegex(FileNotFoundError, "no file matches this pattern"):
            quadrille.simplify_file(self.path("x*.ply"), self.path("out.ply"), **self.how)

    def test_what_ends_it_is_gone_on_with(self):
        self.at_once()
        for end in (lambda status: status.stage != "regroup", self.raise_at_regroup):
            job = self.path("in.ply"), self.path("out.ply")
            try:
                self.assertEqual(quadrille.simplify_file(*job, progress=end, **self.how).report.stop, "cancelled")
            except ZeroDivisionError:
                self.assertEqual(end, self.raise_at_regroup)
            self.assertFalse(os.path.exists(job[1]))
            with self.assertRaisesRegex(OSError, "has a job in it"):
                quadrille.simplify_file(*job, **self.how)
            quadrille.simplify_file(*job, restart=True, **self.how)
            self.assertEqual(self.content("out.ply"), self.content("once.ply"))
            os.remove(job[1])

    @staticmethod
    def raise_at_regroup(status):
        if status.stage == "regroup":
            raise ZeroDivisionError

    def test_errors(self):
        for error, words, options in (
                (ValueError, "both are targets", dict(ratio=0.5)), (ValueError, "both are limits", dict(error=1, relative_error=1)),
                (ValueError, "not a number of bytes", dict(memory="much")),
                (ValueError, "too small", dict(memory="1M")), (ValueError, "does not go with", dict(
                    cost="edge_length", placement="optimal")),
                (TypeError, "tolerance has to be the name of a scalar property", dict(tolerance=1)),
                (TypeError, r"simplify_file\(\) has no argument 'target_faces': .*faces=", dict(target_faces=1))):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                self.at_once(**options)
        with self.assertRaises(FileNotFoundError):
            quadrille.simplify_file(self.path("missing.ply"), self.path("out.ply"), **self.how)
        with self.assertRaisesRegex(OSError, "missing/out.ply: cannot be written"):
            quadrille.simplify_file(self.path("in.ply"), self.path("missing/out.ply"), **self.how)
        with open(self.path("bad.ply"), "wb") as file:
            file.write(self.content("in.ply")[:-7])
        with self.assertRaisesRegex(ValueError, "bad.ply: ends"):
            quadrille.simplify_file(self.path("bad.ply"), self.path("out.ply"), **self.how)
        self.assertEqual(sorted(os.listdir(self.folder)), ["bad.ply", "in.ply"])
        job = quadrille.FileJob(self.path("in.ply"), **self.how)
        with self.assertRaisesRegex(OSError, "has no job in it"):
            job.simplify(0)
        job.partition()
        with self.assertRaisesRegex(RuntimeError, "chunk 0 of phase 1 has not been simplified"):
            job.close()
        with self.assertRaisesRegex(IndexError, "the phase has 4"):
            job.simplify(4)

    def test_words_of_bytes(self):
        for word, number in (("4G", 4e9), ("4GB", 4e9), ("4 GiB", 2**32), ("1.5g", 1.5e9), ("500M", 5e8), (7, 7)):
            self.assertEqual(read_bytes("memory", word), number)


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
