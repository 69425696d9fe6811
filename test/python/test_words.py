"""What the Python module answers to words of other libraries, to what cannot be, and to targets that are missed."""

import copy
import inspect
import json
import re
import typing
import unittest
import warnings

import numpy as np

import quadrille
from quadrille import _choices, _gltf, _words
from surfaces import Folder, torus

CPP = re.compile(r"::|\b(?:[A-Z][a-z]+){2,}\b|std|channel \d|_map\b")  # names of C++, but for UserWarning and the like


def tetrahedra(count):
    points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.0)])
    faces = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
    return (np.concatenate([points + [3 * k, 0, 0] for k in range(count)]),
            np.concatenate([faces + 4 * k for k in range(count)]))


class Words(unittest.TestCase):
    def setUp(self):
        self.points, self.faces, _ = torus(12)

    def answered(self, answer, *surface, **named):
        with self.assertRaises(TypeError) as raised:
            quadrille.simplify(*(surface or (self.points, self.faces)), **named)
        self.assertIn(answer, str(raised.exception))
        return str(raised.exception)

    def test_keywords_of_other_libraries(self):
        answers = {
            "faces=": "face_count target_count target_number_of_triangles targetfacenum target_face_count max_m n m n_faces "
                      "num_triangles numFaces targetFaces face_num max_faces target_tris nfaces target size",
            "vertices=": "n_vertices target_vertices num_verts vertex_count target_points",
            "ratio=": "percent reduction percentage target_reduction_ratio targetperc fraction keep keep_ratio "
                      "decimation target_percent",
            "error=": "max_error maximum_error target_error tolerance_error epsilon distance_tolerance agg aggressiveness "
                      "aggression lossless max_iterations update_rate threshold",
            "boundary_weight=": "preserve_border preserveboundary boundaryweight lock_border preserve_boundary "
                                "boundary_vertex_deletion",
            "fixed=": "locked lock_vertices vertex_lock frozen constrained",
            "topology=": "preserve_topology preservetopology topology_preserving",
            "progress=": "verbose progress_bar callback show_progress quiet",
            "colors=": "vertex_colors colours rgb vertexColors",
            "uv=": "texture_coordinates tcoords uvs texcoords extratcoordw",
            "normals=": "vertex_normals preservenormal normals_weight",
            "crease_degrees=": "feature_angle split_angle",
            "keep_volume": "volume_preservation preserve_volume",
            "attributes=": "point_data scalars vertex_attributes tensors_weight",
            "split_vertices=": "weld merge_vertices autoclean merge_tex",
            "threads=": "n_jobs num_threads workers",
            "placement=": "optimalplacement midpoints",
            "cost=": "method algorithm",
            "importance=": "qualityweight quality vertex_weights",
            "selected=": "selection face_mask_selected region",
            "to_like": "inplace copy",
            "vertex_map": "return_collapses return_map mapping",
            "labels=": "materials groups segments",
            "levels=": "lods history",
        }
        for answer, names in answers.items():
            for name in names.split():
                if name not in inspect.signature(quadrille.simplify).parameters:
                    self.answered(answer, **{name: 0.5})
        self.assertIn("faces=250", self.answered("face_count", face_count=250))
        self.assertEqual(self.answered("", zebra=3), "simplify() has no argument 'zebra'")
        self.answered("did you mean placement=", placment="optimal")
        self.answered("its name is both_ways=", bothWays=True)

    def test_numbers_without_a_name(self):
        self.answered("faces=500", self.points, self.faces, 500)
        message = self.answered("ratio=0.5", self.points, self.faces, 0.5)
        self.assertIn("target_reduction=0.5", message)
        self.answered("faces=500", quadrille.Mesh(self.points, self.faces), 500)
        self.answered("target_reduction=0.9", (self.points, self.faces), 0.9)
        self.answered("is a str: all arguments except the surface need their names", self.points, self.faces, "quadric")
        with self.assertRaisesRegex(ValueError, "^faces is 0.25, not an integer: for a fraction of the faces, pass ratio=0.25"):
            quadrille.simplify(self.points, self.faces, faces=0.25)

    def test_surfaces_by_name(self):
        for call in (quadrille.simplify, quadrille.curvature_importance):
            for named in (dict(vertices=self.points, faces=self.faces), dict(points=self.points, triangles=self.faces),
                          dict(V=self.points.tolist(), F=self.faces.tolist())):
                with self.assertRaisesRegex(TypeError, r"come first, .* " + call.__name__ + r"\(points, triangles, "):
                    call(**named)
        with self.assertRaisesRegex(TypeError, r"second argument: simplify\(points, triangles, faces=1000\)"):
            quadrille.simplify(self.points, faces=self.faces)
        with self.assertRaisesRegex(TypeError, r"the mesh comes first, without a name: simplify\(mesh, ...\)"):
            quadrille.simplify(mesh=(self.points, self.faces))

    def test_faces_of_other_shapes(self):
        padded = np.insert(self.faces, 0, 3, axis=1)
        for faces, answer in ((padded, r"padded .* faces\[:, 1:\]"), (self.faces[:, [0, 1, 2, 0]], "split quads"),
                              (padded.ravel(), r"faces.reshape\(-1, 4\)\[:, 1:\]"),
                              (self.points[self.faces], "coordinates of corners.*split_vertices=True")):
            with self.assertRaisesRegex(ValueError, answer):
                quadrille.simplify(self.points, faces)

    def test_other_functions_answer_as_well(self):
        mesh = (self.points, self.faces)
        for call, answer in ((lambda: quadrille.surface_distance(mesh, mesh, n_samples=9), "samples="),
                             (lambda: quadrille.verify(mesh, mesh, max_error=9), "distance="),
                             (lambda: quadrille.simplify_gltf("a.glb", "b.glb", face_count=9), "faces=9"),
                             (lambda: quadrille.simplify_gltf("a.glb", "b.glb", 0.5), "ratio=0.5"),
                             (lambda: quadrille.read_mesh("a.obj", merge=True), "weld="),
                             (lambda: quadrille.view_importance(*mesh, camera=(1, 2, 3)), "eye="),
                             (lambda: quadrille.Levels().at(target_count=3), "faces=3")):
            with self.assertRaises(TypeError) as raised:
                call()
            self.assertIn(answer, str(raised.exception))

    def test_signatures_stay(self):
        self.assertIn("boundary_weight", inspect.signature(quadrille.simplify).parameters)
        self.assertEqual(quadrille.simplify.__name__, "simplify")


class Messages(unittest.TestCase):
    def test_no_names_of_cpp(self):
        points, faces, (values, corners) = torus(12)
        channel, opened, huge = quadrille.Channel, faces[:-20], 3e38
        of_points = np.zeros((len(points), 2))
        for options in (
                dict(ratio=10), dict(ratio=-0.5), dict(error=-1), dict(relative_error=-1), dict(error=-1, both_ways=True),
                dict(threads=4), dict(threads=0, order="relaxed"), dict(threads=2000, order="relaxed"),
                dict(share=0, order="relaxed"), dict(share=2, order="relaxed"), dict(pairs_closer_than=5),
                dict(pairs_closer_than=-1), dict(no_self_intersection=True, order="relaxed"),
                dict(keep_solid=True, topology="free"), dict(keep_solid=True, order="relaxed"),
                dict(hull="outer", topology="free"), dict(hull="inner", topology="components_may_vanish"),
                dict(keep_volume=True, order="relaxed"), dict(hull="outer", placement="optimal"),
                dict(cost="memoryless_quadric", crease_degrees=30), dict(cost="edge_length", line_weight=1),
                dict(cost="edge_length", placement="optimal"), dict(normal_flip=0), dict(normal_flip=200),
                dict(normal_deviation=0), dict(boundary_weight=-1), dict(crease_degrees=-1), dict(crease_weight=-1),
                dict(line_weight=-1), dict(normal_noise=-1), dict(position_noise=-1), dict(region_boundary_weight=-1,
                                                                                          labels=faces[:, 0]),
                dict(cost="memoryless_quadric", boundary_weight=-1), dict(cost="thin_feature_quadric", boundary_weight=-1),
                dict(tolerance=np.full(len(points), -1.0)), dict(importance=np.full(len(points), -1.0)),
                dict(uv=channel(of_points, importance=0)), dict(uv=channel(of_points, weights=[1])),
                dict(uv=channel(of_points, weights=[1, -1])), dict(uv=channel(of_points, chart_boundary_weight=-1)),
                dict(uv=channel(of_points, new_values="existing")), dict(uv=channel(of_points, new_values="weights")),
                dict(uv=channel(of_points, new_values="recomputed")), dict(uv=channel(of_points, linear_light=True)),
                dict(uv=of_points, normals=channel(points, weights=[1])),
                dict(attributes={"heat": channel(points[:, 2], weights=[huge] * 2)}),
                dict(calibrated=True, error=1), dict(error=1, tolerance=np.ones(len(points)))):
            self.plain(lambda options=options: quadrille.simplify(points, faces, **options), options)
        for options in (dict(keep_solid=True), dict(hull="outer"), dict(hull="inner")):
            self.plain(lambda options=options: quadrille.simplify(points, opened, **options), options)
        inside_out = faces[:, ::-1]
        self.plain(lambda: quadrille.simplify(points, inside_out, hull="outer"), "inside out")
        levels = quadrille.Levels()
        quadrille.simplify(points, faces, levels=levels)
        self.plain(lambda: levels.at(distance=1), "levels")
        self.plain(lambda: quadrille.surface_distance((points, faces), (points, faces[:0])), "nothing")
        self.plain(lambda: quadrille.verify((points, faces), (points, faces), distance=-1), "verify")
        self.plain(lambda: quadrille.view_importance(points, faces, eye=[np.nan, 0, 0]), "eye")
        self.plain(lambda: quadrille.view_importance(points, faces, eye=[1, 0, 0], outline=-1), "outline")
        self.plain(lambda: quadrille.curvature_importance(points, faces, strength=-1), "strength")

    def plain(self, call, what):
        with self.subTest(str(what)):
            with self.assertRaises(ValueError) as raised:
                call()
            self.assertNotRegex(str(raised.exception), CPP)
            self.assertNotRegex(str(raised.exception), "^quadrille|^ |  |: :")

    def test_channels_are_named(self):
        points, faces, _ = torus(12)
        with self.assertRaisesRegex(ValueError, "^normals has 3 components and 1 weights"):
            quadrille.simplify(points, faces, colors=points, normals=quadrille.Channel(points, weights=[1]))

    def test_what_functions_raise_stays(self):
        points, faces, _ = torus(12)

        def fail(status):
            raise ValueError("GreedyOrder::mine")
        with self.assertRaisesRegex(ValueError, "^GreedyOrder::mine$"):
            quadrille.simplify(points, faces, progress=fail)


class MissedTargets(unittest.TestCase):
    def warned(self, *surface, **options):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            result = quadrille.simplify(*surface, **options)
        self.assertTrue(all(w.filename == __file__ and w.category is UserWarning for w in said), said)
        self.assertLessEqual(len(said), 1)
        self.assertEqual(len(said), 0 if result.report.is_target_reached or result.report.stop == "cancelled" else 1)
        return str(said[0].message) if said else ""

    def test_points_that_are_not_joined(self):
        points, faces, _ = torus(12)
        loose = points[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3)
        told = self.warned(*loose)
        self.assertRegex(told, "^the target was not reached: 288 of 288 faces are left, but half of them were asked for")
        self.assertIn("720 points coincide with another one", told)
        self.assertIn("split_vertices=True", told)
        self.assertEqual(self.warned(*loose, split_vertices=True), "")

    def test_parts(self):
        told = self.warned(*tetrahedra(20), faces=10)
        self.assertIn("but faces=10 was asked for (all pairs rejected)", told)
        self.assertIn("20 components are left, and each keeps some faces: topology='components_may_vanish'", told)
        self.assertEqual(self.warned(*tetrahedra(20), faces=10, topology="components_may_vanish"), "")
        told = self.warned(*tetrahedra(3), faces=4, topology="components_may_vanish")  # large ones stay
        self.assertIn("3 components are left, and each keeps some faces: pairs_closer_than= joins components", told)

    def test_what_else_is_in_the_way(self):
        points, faces, _ = torus(12)
        self.assertIn("topology='free'", self.warned(points, faces, faces=2))
        self.assertIn("fixed", self.warned(points, faces, faces=10, fixed=np.arange(100)))
        self.assertIn("the filter returned False", self.warned(points, faces, faces=10, filter=lambda c: False))
        self.assertIn("boundaries of labels stay", self.warned(points, faces, faces=10, labels=np.arange(len(faces))))
        self.assertIn("vertices=3 or ratio=0.01", self.warned(*tetrahedra(3), vertices=3, ratio=0.01))
        self.assertIn("stop was asked for", self.warned(*tetrahedra(3), stop=lambda status: False))

    def test_nothing_is_said_of_what_was_met_or_ended(self):
        points, faces, _ = torus(12)
        for options in (dict(), dict(faces=100), dict(error=0.01), dict(relative_error=0.01, both_ways=True),
                        dict(tolerance=np.full(len(points), 0.01)), dict(progress=lambda status: False), dict(ratio=1),
                        dict(relative_error=0.02, both_ways=True, calibrated=True), dict(vertices=60),
                        dict(stop=lambda status: status.faces < 200), dict(faces=1000)):
            self.assertEqual(self.warned(points, faces, **options), "")
        self.assertEqual(self.warned(np.empty((0, 3)), np.empty((0, 3), int)), "")


class Reports(unittest.TestCase):
    def reports(self):
        points, faces, _ = torus(12)
        yield quadrille.simplify(points, faces).report
        yield quadrille.simplify(points, faces, error=0.05, both_ways=True, normal_deviation=60).report
        yield quadrille.simplify(points, faces, tolerance=np.full(len(points), 0.02), keep_solid=True).report
        yield quadrille.simplify(points, faces, faces=100, hull="outer").report
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield quadrille.simplify(*tetrahedra(3), faces=3).report

    def test_dict_and_json_and_back(self):
        reports = list(self.reports())
        for report in reports:
            members = report.to_dict()
            text = json.dumps(members, allow_nan=False)
            self.assertEqual(json.loads(report.to_json()), json.loads(text))
            for again in (quadrille.Report.from_dict(members), quadrille.Report.from_dict(json.loads(text)),
                          quadrille.Report.from_json(report.to_json()), quadrille.Report.from_dict(dict(report)),
                          copy.deepcopy(report)):
                self.assertEqual(again, report)
                self.assertEqual((str(again), again.rejections, again.seconds),
                                 (str(report), report.rejections, report.seconds))
            for name in members.keys() - {"seconds", "duplicated_vertices", "doubled_labels"}:
                value = getattr(report, name)
                self.assertEqual(members[name], None if value == float("inf") else value, name)
            self.assertEqual(sum(members["seconds"].values()), report.seconds)
        self.assertEqual(len({report.to_json() for report in reports}), len(reports))
        self.assertNotEqual(reports[0], reports[1])
        self.assertNotEqual(reports[0], "a report")

    def test_other_dicts_are_refused(self):
        members = next(self.reports()).to_dict()
        for broken, message in (({}, "it has no faces_before"), ({**members, "stop": "whim"}, "unknown name 'whim'"),
                                ({**members, "contractions": -1}, "its contractions is -1"),
                                ({**members, "error": "much"}, "its error is 'much'"),
                                ({**members, "rejections": {"whim": 1}}, "unknown name 'whim'"),
                                ({**members, "seconds": {}}, "it has no read")):
            with self.assertRaisesRegex(ValueError, f"^not a report: .*{message}"):
                quadrille.Report.from_dict(broken)


class Levels(unittest.TestCase):
    def test_they_say_what_they_hold(self):
        points, faces, uv = torus(12)
        levels = quadrille.Levels()
        self.assertEqual(repr(levels), "<quadrille.Levels: nothing recorded>")
        quadrille.simplify(points, faces, faces=100, levels=levels, uv=uv, attributes={"heat": points[:, 2]})
        self.assertRegex(repr(levels), r"^<quadrille.Levels: 288 to 100 faces by 94 contractions, uv, heat>$")


class Types(Folder):
    def test_kinds_are_those_of_the_compiled_part(self):
        self.assertEqual(set(typing.get_args(_choices.KindName)), set(quadrille._core.Kind.__members__))

    def test_options_of_gltf_are_those_of_its_types(self):
        known = inspect.signature(quadrille.simplify_gltf).parameters
        self.assertLessEqual(set(_gltf.GltfOptions.__annotations__), set(known))
        self.assertIn("boundary_weight", _gltf.GltfOptions.__annotations__)
        with self.assertRaisesRegex(TypeError, "no argument 'split_vertices'"):
            quadrille.simplify_gltf("a.glb", "b.glb", split_vertices=True)

    def test_answers_name_arguments_that_are_there(self):
        known = set()
        for name in quadrille.__all__:
            thing = getattr(quadrille, name)
            if inspect.isfunction(thing):
                known.update(inspect.signature(thing).parameters)
        for rule in _words._RULES:
            self.assertLessEqual(set(rule.arguments), known, rule)


if __name__ == "__main__":
    unittest.main()
