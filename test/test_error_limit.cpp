// An error limit keeps its word: the result lies within it, measured apart by CGAL.
#include "meshes.h"
#include "soups.h"

#include <CGAL/Polygon_mesh_processing/distance.h>
#include <quadrille/distance.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::read_model;

struct Model {
  std::string name;
  Mesh mesh;
};

std::vector<Model> models() {
  std::vector<Model> models;
  for (const char* name : {"cow", "bones", "nefertiti", "blobby_3cc", "pinion"})
    models.push_back({name, read_model(name)});
  models.push_back({"sphere", test::make_mesh(test::sphere(4))});
  models.push_back({"torus", test::make_mesh(test::torus(40, 20))});
  models.push_back({"cube", test::make_mesh(test::cube(6))});
  models.push_back({"noise", test::make_mesh(test::with_noise(test::sphere(4), 1, 0.02))});
  models.push_back({"holes", test::make_mesh(test::random_with_borders(3))});
  return models;
}

// From the result to the input, to a tenth of the limit.
double distance_to(const Mesh& input, const Mesh& result, double limit) {
  return CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(
      result, input, limit / 10);
}

} // namespace

TEMPLATE_TEST_CASE("No point of the result is further from the input than the limit", "", Quadric,
                   MemorylessQuadric) {
  const auto check = [](const Model& model, double limit, const auto& order) {
    Mesh mesh = model.mesh;
    const Report report = simplify<TestType, OptimalPlacement>(mesh, ErrorLimit{limit}, order);
    mesh.collect_garbage();
    INFO(model.name << ", limit " << limit << ": " << report);
    REQUIRE(report.stop == StopReason::target_met);
    REQUIRE(report.distance_bound <= limit);
    const double measured = distance_to(model.mesh, mesh, limit);
    CAPTURE(measured);
    REQUIRE(measured <= report.distance_bound + limit / 10);
  };
  for (const Model& model : models())
    for (double fraction : {0.002, 0.02}) {
      const double limit = fraction * bounding_box_diagonal(model.mesh);
      check(model, limit, GreedyOrder{});
      check(model, limit, RelaxedOrder{});
      check(model, limit, RelaxedOrder{.refresh = true});
    }
}

TEST_CASE("A limit in a stop policy that does not ask for distances lets nothing pass") {
  const auto limit = [](const Status& status) { return ErrorLimit{1e9}(status); };
  Mesh mesh = read_model("cow");
  const std::size_t faces = mesh.number_of_faces();
  CHECK(simplify<Quadric, OptimalPlacement>(mesh, limit).faces_after == faces);
  CHECK(simplify<Quadric, OptimalPlacement>(mesh, limit, RelaxedOrder{}).faces_after == faces);
}

TEST_CASE("Inside of a surface the limit is used, and not only kept") {
  const Mesh input = test::make_mesh(test::sphere(5));
  const double limit = 0.005 * bounding_box_diagonal(input);
  Mesh mesh = input;
  const Report report = simplify(mesh, ErrorLimit{limit});
  mesh.collect_garbage();
  INFO(report);
  CHECK(report.faces_after < report.faces_before / 3);
  CHECK(distance_to(input, mesh, limit) > limit / 8);
}

TEST_CASE("Where topology is free what contractions add up to is bounded, too") {
  for (const Mesh& input : {read_model("cow"), test::make_mesh(test::sphere(4))}) {
    const double limit = 0.2 * bounding_box_diagonal(input);
    Mesh mesh = input;
    const Report report =
        simplify(mesh, ErrorLimit{limit}, EdgeLength{}, MidpointPlacement{}, Topology::free);
    mesh.collect_garbage();
    INFO(report);
    CHECK(report.contractions > 100);
    CHECK(report.distance_bound <= limit);
    CHECK(distance_to(input, mesh, limit) <= report.distance_bound + limit / 10);
  }
}

TEST_CASE("Inside of a surface a limit goes as far where topology is free as where it is kept") {
  for (const char* name : {"cow", "lion-head"}) {
    const Mesh input = read_model(name);
    const double limit = 0.005 * bounding_box_diagonal(input);
    Mesh kept = input, free = input;
    const std::size_t faces = simplify(kept, ErrorLimit{limit}).faces_after;
    const Report report = simplify(free, ErrorLimit{limit}, Topology::free);
    free.collect_garbage();
    INFO(name << ": " << report << ", kept: " << faces);
    CHECK(10 * report.faces_after < 11 * faces);
    CHECK(report.distance_bound <= limit);
    CHECK(distance_to(input, free, limit) <= report.distance_bound + limit / 10);
  }
}

TEST_CASE("A flat part costs no distance at all") {
  Mesh mesh = test::make_mesh(test::cube(12));
  const Report report = simplify(mesh, ErrorLimit{1e-6});
  CHECK(report.distance_bound <= 1e-6);
  CHECK(report.faces_after < 100);
}

TEST_CASE("Bounds stay with their faces when these get new numbers") {
  using namespace quadrille::internal;
  TriangleComplex complex(6, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}});
  DistanceBounds bounds(4);
  PairStar star;
  for (const StarFace& f : {StarFace(1, 2, 3), StarFace(3, 4, 5)})
    star.first.add_if(true, f);
  bounds.set(star, {0.25f, 2.0f});
  CHECK(bounds.greatest(complex) == 2);
  complex.kill(0);
  complex.kill(2);
  bounds.pack_if([&](Index face) { return !complex.is_dead(face); });
  complex.pack({1, 2, 3, 4, 5});
  CHECK(bounds.greatest(complex) == 2);
  complex.kill(1);
  CHECK(bounds.greatest(complex) == 0.25);
}

TEST_CASE("Without an error limit no bound is known") {
  Mesh mesh = test::make_mesh(test::sphere(3));
  CHECK(simplify(mesh, FaceCount{100}).distance_bound == std::numeric_limits<double>::infinity());
}

TEST_CASE("A relative limit is one on a surface as large as numbers are") {
  const Mesh input =
      test::make_mesh(test::mapped(test::with_noise(test::sphere(3), 1, 0.02),
                                   [](const test::Position& p) { return 1.7e308 * p; }));
  CHECK(bounding_box_diagonal(input) == std::numeric_limits<double>::max());
  Mesh mesh = input;
  CHECK(simplify<Quadric, OptimalPlacement>(mesh, ErrorLimit::relative(0)).contractions == 0);
  const Report report = simplify<Quadric, OptimalPlacement>(mesh, ErrorLimit::relative(0.001));
  CHECK(report.contractions > 0);
  CHECK(report.stop == StopReason::target_met);
  CHECK(report.distance_bound <= 0.001 * std::numeric_limits<double>::max());
}
