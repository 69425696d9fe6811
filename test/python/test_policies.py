"""Policies in Python, hulls, volumes and glTF documents of the Python module quadrille."""

import json
import os
import struct
import tempfile
import unittest
import warnings

import numpy as np

import quadrille
from surfaces import sheet, torus


def normals(corners):
    """Of faces of the shape (faces, 3, 3), of length 1."""
    vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def same(a, b):
    return np.array_equal(a.points, b.points) and np.array_equal(a.faces, b.faces)


class Stops(unittest.TestCase):
    def test_it_is_asked_before_each_contraction(self):
        points, faces, _ = torus(16)
        seen = []

        def enough(status):
            seen.append(status.faces)
            return status.faces <= 100

        result = quadrille.simplify(points, faces, stop=enough)
        self.assertTrue(same(result, quadrille.simplify(points, faces, faces=100)))
        self.assertEqual(result.report.stop, "target met")
        self.assertLessEqual(set(range(512, 99, -2)), set(seen))

    def test_whatever_is_first_ends_it(self):
        points, faces, _ = torus(16)
        half = quadrille.simplify(points, faces, faces=256, stop=lambda status: status.faces <= 100)
        self.assertEqual(len(half.faces), 256)

    def test_it_alone_is_no_half(self):
        points, faces, _ = torus(16)
        all_of_it = quadrille.simplify(points, faces, stop=lambda status: status.next_error > 0)
        self.assertEqual(len(all_of_it.faces), 512)


class Filters(unittest.TestCase):
    def test_what_it_is_told(self):
        points, faces, _ = torus(12)
        seen = []

        def look(contraction):
            seen.append(contraction)
            return True

        report = quadrille.simplify(points, faces, faces=200, filter=look).report
        first = seen[0]  # nothing has changed yet
        self.assertEqual(first.faces.shape, (len(first.before),))
        self.assertEqual(first.before.shape[1:], (3, 3))
        ends = {first.first, first.second}
        for index, before, after in zip(first.faces, first.before, first.after):
            mine = [v for v in faces[index] if v in ends]
            self.assertEqual(len(mine), 1)
            self.assertEqual(before[0].tolist(), points[mine[0]].tolist())
            self.assertEqual(after[0].tolist(), first.target.tolist())
            self.assertEqual({tuple(p) for p in before.tolist()}, {tuple(p) for p in points[faces[index]].tolist()})
            self.assertEqual(before[1:].tolist(), after[1:].tolist())
        self.assertEqual(len(first.removed_faces), 2)
        self.assertTrue(all(ends <= set(faces[index]) for index in first.removed_faces))
        around = {end: sum(end in face for face in faces.tolist()) for end in ends}
        self.assertEqual(first.highest_degree, max(around.values()))
        self.assertEqual(len(first.faces), sum(around.values()) - 4)
        self.assertGreaterEqual(len(seen), report.contractions)

    def test_one_of_angles_is_that_of_the_library(self):
        points, faces, _ = torus(16)

        def turns_little(contraction):
            cosines = (normals(contraction.before) * normals(contraction.after)).sum(axis=1)
            return bool((cosines > np.cos(np.radians(25))).all())

        ours = quadrille.simplify(points, faces, faces=60, normal_flip=180, filter=turns_little)
        self.assertTrue(same(ours, quadrille.simplify(points, faces, faces=60, normal_flip=25)))
        self.assertFalse(same(ours, quadrille.simplify(points, faces, faces=60)))
        self.assertGreater(ours.report.rejections["filter"], 0)

    def test_keeps_away_from_a_selection(self):
        points, faces, uv = torus(16)
        is_selected = points[:, 0] > 0.5
        for channel in (None, uv):
            with self.assertWarnsRegex(UserWarning, "the filter returned False"):
                result = quadrille.simplify(
                    points, faces, faces=200, uv=channel,
                    filter=lambda c: not (is_selected[c.first] or is_selected[c.second]))
            self.assertTrue((result.points[result.vertex_map[is_selected]] == points[is_selected]).all())
            self.assertLess(len(result.faces), 420)

    @unittest.skipUnless(quadrille._core.has_threads, "built without oneTBB")
    def test_threads_ask_as_well(self):
        points, faces, _ = torus(40)
        call = dict(faces=400, order="relaxed", filter=lambda c: c.highest_degree < 9,
                    cost=lambda pair: pair.quadric * (1 + abs(pair.target[2])))
        one = quadrille.simplify(points, faces, **call)
        self.assertTrue(same(one, quadrille.simplify(points, faces, threads=2, **call)))
        self.assertLess(len(one.faces), 1000)


class Costs(unittest.TestCase):
    def test_what_it_is_told(self):
        points, faces, _ = torus(12)

        def cost(pair):
            self.assertEqual(pair.first.tolist(), points[pair.first_index].tolist())
            self.assertEqual(pair.second.tolist(), points[pair.second_index].tolist())
            self.assertGreaterEqual(pair.quadric, 0)
            self.assertIn(pair.target.tolist(), (pair.first.tolist(), pair.second.tolist()))
            return pair.quadric

        result = quadrille.simplify(points, faces, faces=100, cost=cost, placement="endpoint")
        self.assertEqual(len(result.faces), 100)

    def test_length_is_that_of_the_library(self):
        points, faces, uv = torus(16)
        points = points + 0.001 * np.random.default_rng(7).random(points.shape)  # no ties
        mine = quadrille.simplify(points, faces, faces=200, placement="midpoint",
                                  cost=lambda pair: ((pair.second - pair.first) ** 2).sum())
        theirs = quadrille.simplify(points, faces, faces=200, cost="edge_length")
        self.assertTrue(same(mine, theirs))
        self.assertEqual(mine.report.error, theirs.report.error)
        coarse = quadrille.simplify(points, faces, faces=200, uv=uv, cost=lambda pair: pair.quadric)
        self.assertEqual(len(coarse.uv[1]), len(coarse.faces))

    def test_a_factor_moves_faces(self):
        points, faces, _ = torus(30)
        upper = quadrille.simplify(points, faces, faces=300,
                                   cost=lambda pair: pair.quadric * (1000 if pair.target[0] > 0 else 1))
        even = quadrille.simplify(points, faces, faces=300, cost=lambda pair: pair.quadric)
        self.assertGreater((upper.points[:, 0] > 0).mean(), 0.8)
        self.assertLess((even.points[:, 0] > 0).mean(), 0.6)


class Functions(unittest.TestCase):
    def test_what_they_raise_comes_out(self):
        points, faces, _ = torus(12)
        before = points.copy()

        def fail(_):
            raise KeyError("mine")

        for name in ("cost", "filter", "stop"):
            for call in (dict(), dict(order="relaxed"), dict(order="relaxed", threads=2)):
                if call.get("threads", 1) > 1 and not quadrille._core.has_threads:
                    continue
                with self.subTest(name, **call), self.assertRaisesRegex(KeyError, "mine"):
                    quadrille.simplify(points, faces, **call, **{name: fail})
        self.assertTrue((points == before).all())

    def test_what_they_may_not_answer(self):
        points, faces, _ = torus(12)
        for name, answer, message in (("filter", None, "filter returned None"),
                                      ("stop", None, "stop returned None"),
                                      ("cost", "dear", "cost returned 'dear', not a number"),
                                      ("cost", None, "cost returned None, not a number"),
                                      ("cost", -1, "cost returned -1, which is negative or not finite"),
                                      ("cost", float("nan"), "cost returned nan, which is negative or not finite")):
            with self.subTest(name, answer=answer), self.assertRaisesRegex(ValueError, message):
                quadrille.simplify(points, faces, **{name: lambda _: answer})
        for name in ("filter", "stop", "progress"):
            with self.assertRaisesRegex(ValueError, f"{name} is 5, which is not a function"):
                quadrille.simplify(points, faces, **{name: 5})
        with self.assertRaisesRegex(ValueError, "cost"):
            quadrille.simplify(points, faces, cost=5)


def windings(points, faces, places):
    """How often a closed surface goes round places, by the sum of solid angles (van Oosterom and
    Strackee 1983)."""
    a, b, c = (points[faces[:, i]][None] - places[:, None] for i in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    numerator = (a * np.cross(b, c)).sum(axis=2)
    denominator = (la * lb * lc + (a * b).sum(axis=2) * lc + (b * c).sum(axis=2) * la
                   + (c * a).sum(axis=2) * lb)
    return 2 * np.arctan2(numerator, denominator).sum(axis=1) / (4 * np.pi)


class Shapes(unittest.TestCase):
    def test_hulls(self):
        points, faces, uv = torus(20)
        middles = points[faces].mean(axis=1)
        for channel in (None, uv):
            outer = quadrille.simplify(points, faces, faces=200, hull="outer", uv=channel)
            self.assertEqual(len(outer.faces), 200)
            inside = 0.999 * (points - 2 * points / np.linalg.norm(points[:, :2], axis=1)[:, None] * [1, 1, 0])
            inside += 2 * points / np.linalg.norm(points[:, :2], axis=1)[:, None] * [1, 1, 0]
            self.assertGreater(windings(outer.points, outer.faces, inside).min(), 0.9)
            self.assertGreater(outer.report.volume_after, outer.report.volume_before)
        inner = quadrille.simplify(points, faces, faces=200, hull="inner")
        self.assertLess(inner.report.volume_after, inner.report.volume_before)
        self.assertLess(np.abs(windings(inner.points, inner.faces, middles + 0.01 * normals(points[faces]))).max(),
                        0.1)

    def test_volume(self):
        points, faces, uv = torus(20)

        def volume(surface):
            places, triangles = surface
            a, b, c = (places[triangles[:, i]] for i in range(3))
            return (a * np.cross(b, c)).sum() / 6

        kept = quadrille.simplify(points, faces, faces=100, keep_volume=True, uv=uv)
        other = quadrille.simplify(points, faces, faces=100)
        self.assertAlmostEqual(volume(kept) / volume((points, faces)), 1, delta=1e-11)
        self.assertGreater(abs(volume(other) / volume((points, faces)) - 1), 1e-4)
        self.assertAlmostEqual(kept.report.volume_after, volume(kept), delta=1e-9)
        self.assertIsNone(other.report.volume_before)

    def test_errors(self):
        points, faces, _ = torus(12)
        for options, message in ((dict(hull="both"), "hull is 'both', not"),
                                 (dict(hull="outer", cost="quadric"), "hull needs cost='memoryless_quadric', not"),
                                 (dict(hull="outer", order="relaxed"), "hull needs order='greedy'"),
                                 (dict(keep_volume=True, placement="midpoint"), "keep_volume has its own placement"),
                                 (dict(hull="inner", keep_volume=True), "hull does not go with keep_volume"),
                                 (dict(calibrated=True, error=1, both_ways=True, cost=lambda pair: 1),
                                  "calibrated does not go with a function as cost")):
            with self.subTest(options), self.assertRaisesRegex(ValueError, message):
                quadrille.simplify(points, faces, **options)
        with self.assertRaisesRegex(ValueError, "closed|edges"):
            quadrille.simplify(*sheet(12)[:2], hull="outer")


def write_glb(path, points, faces, uv, image=None):
    """One mesh, twice in the scene, with a texture, a material and a name."""
    values, triples = uv
    corners, index = np.unique(np.stack([faces, triples], axis=-1).reshape(-1, 2), axis=0, return_inverse=True)
    arrays = [points[corners[:, 0]].astype("<f4"), values[corners[:, 1]].astype("<f4"),
              index.reshape(-1).astype("<u4")]
    blob, views, accessors = b"", [], []
    for array, kind, component in zip(arrays, ("VEC3", "VEC2", "SCALAR"), (5126, 5126, 5125)):
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": array.nbytes})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(array),
                          "type": kind})
        blob += array.tobytes()
    accessors[0].update(min=arrays[0].min(axis=0).tolist(), max=arrays[0].max(axis=0).tolist())
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0, "name": "left"}, {"mesh": 0, "name": "right", "translation": [9, 0, 0]}],
        "materials": [{"name": "skin"}], "buffers": [{"byteLength": len(blob)}], "bufferViews": views,
        "accessors": accessors,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}]}
    if image:
        document.update(images=[{"uri": image}], textures=[{"source": 0}])
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(blob)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(blob), b"BIN\0") + blob)


def json_of_glb(path):
    with open(path, "rb") as file:
        data = file.read()
    return json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])


@unittest.skipUnless(hasattr(quadrille._core, "simplify_gltf"), "built without nlohmann_json")
class Gltf(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.source = os.path.join(folder.name, "torus.glb")
        self.target = os.path.join(folder.name, "small.glb")
        write_glb(self.source, *torus(20))

    def triangles(self):
        document = json_of_glb(self.target)
        return document, document["accessors"][document["meshes"][0]["primitives"][0]["indices"]]["count"] // 3

    def test_a_document_stays_but_for_its_triangles(self):
        report = quadrille.simplify_gltf(self.source, self.target, ratio=0.25)
        document, count = self.triangles()
        self.assertEqual((count, report.faces_after, report.faces_before), (200, 200, 800))
        self.assertEqual([node["name"] for node in document["nodes"]], ["left", "right"])
        self.assertEqual(document["materials"], [{"name": "skin"}])
        self.assertIn("TEXCOORD_0", document["meshes"][0]["primitives"][0]["attributes"])

    def test_options_and_functions(self):
        seen = []
        quadrille.simplify_gltf(self.source, self.target, cost="memoryless_quadric", seams="kept",
                                stop=lambda status: status.faces <= 300, progress=seen.append)
        self.assertEqual(self.triangles()[1], 300)
        self.assertEqual(seen[-1].progress, 1)
        with self.assertRaisesRegex(KeyError, "mine"):
            def fail(_):
                raise KeyError("mine")
            quadrille.simplify_gltf(self.source, self.target, ratio=0.1, progress=fail)
        self.assertEqual(self.triangles()[1], 300)  # as it was

    def test_remarks(self):
        write_glb(self.source, *torus(8), image="bark.png")
        os.mkdir(self.target[:-4])
        elsewhere = os.path.join(self.target[:-4], "out.gltf")
        with self.assertWarnsRegex(UserWarning, "the image 'bark.png' is not there"):
            quadrille.simplify_gltf(self.source, elsewhere)
        with open(os.path.join(os.path.dirname(self.source), "bark.png"), "wb") as image:
            image.write(b"\x89PNG")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            quadrille.simplify_gltf(self.source, elsewhere)
        with open(elsewhere, encoding="utf8") as file:
            self.assertIn("data:image/png", file.read())

    def test_errors(self):
        with self.assertRaisesRegex(TypeError, r"simplify_gltf\(\) has no argument 'fixed'"):
            quadrille.simplify_gltf(self.source, self.target, fixed=[0])
        with self.assertRaisesRegex(ValueError, "^ratio is 2, not in"):
            quadrille.simplify_gltf(self.source, self.target, ratio=2)
        with self.assertRaisesRegex(ValueError, "seams is 'loose'"):
            quadrille.simplify_gltf(self.source, self.target, seams="loose")
        with self.assertRaisesRegex(ValueError, "small.obj is not .gltf or .glb"):
            quadrille.simplify_gltf(self.source, self.target[:-4] + ".obj")
        with self.assertRaises(FileNotFoundError):
            quadrille.simplify_gltf(self.source[:-4] + "s.glb", self.target)
        with open(self.source, "r+b") as file:
            file.truncate(100)
        with self.assertRaisesRegex(ValueError, "torus.glb"):
            quadrille.simplify_gltf(self.source, self.target)
        self.assertFalse(os.path.exists(self.target))


if __name__ == "__main__":
    unittest.main()
