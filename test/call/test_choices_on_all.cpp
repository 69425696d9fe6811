// Constraints, stops and filters, on every kind of mesh and on soups.
#include "on_all.h"

#include <quadrille/distance_limits.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

// --- Constraints ---------------------------------------------------------------------------------

TEMPLATE_TEST_CASE("A constrained edge stays, with its ends", "", Mesh, Polyhedron, CellComplex,
                   PolyMesh, TriMesh) {
  using Traits = boost::graph_traits<TestType>;
  const std::uint64_t seed = GENERATE(0u, 1u, 2u);
  TestType mesh = convert<TestType>(as_floats(random_with_boundaries(seed)));
  const auto points = get(CGAL::vertex_point, mesh);
  const auto ends = [&](const auto& e) {
    return std::array{to_position(get(points, source(e, mesh))),
                      to_position(get(points, target(e, mesh)))};
  };
  std::map<typename Traits::edge_descriptor, bool> is_constrained;
  std::map<typename Traits::edge_descriptor, std::array<Position, 2>> before;
  std::size_t i = 0;
  for (const auto e : edges(mesh)) {
    is_constrained[e] = i++ % 17 == 0;
    if (is_constrained[e])
      before[e] = ends(e);
  }
  const Report report = simplify(
      mesh, FaceCount{0},
      CGAL::parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_constrained)));
  INFO(report);
  CHECK(report.rejected(Rejection::constraint) > 0);
  CHECK(is_valid_triangle_mesh(mesh));
  CHECK(num_edges(mesh) > before.size());
  std::size_t found = 0;
  for (const auto e : edges(mesh))
    if (const auto old = before.find(e); old != before.end()) {
      ++found;
      auto now = ends(e);
      if (now[0] != old->second[0])
        std::swap(now[0], now[1]);
      CHECK(now == old->second);
    }
  CHECK(found == before.size());
}

TEMPLATE_TEST_CASE("A constrained vertex stays where it is", "", Mesh, Polyhedron, CellComplex,
                   PolyMesh, TriMesh) {
  using Vertex = typename boost::graph_traits<TestType>::vertex_descriptor;
  const bool are_pairs_free = GENERATE(false, true);
  TestType mesh = convert<TestType>(two_parts());
  const auto points = get(CGAL::vertex_point, mesh);
  std::map<Vertex, bool> is_constrained;
  std::map<Vertex, Position> before;
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) {
    is_constrained[v] = i++ % 9 == 0;
    if (is_constrained[v])
      before[v] = to_position(get(points, v));
  }
  const auto named =
      CGAL::parameters::vertex_is_constrained_map(boost::make_assoc_property_map(is_constrained));
  const Report report = are_pairs_free
                            ? simplify(mesh, FaceRatio{0.4}, ThresholdPairs::relative(0.1), named)
                            : simplify(mesh, FaceRatio{0.4}, named);
  INFO(report);
  CHECK(report.stop == StopReason::target_met);
  std::size_t found = 0;
  for (const auto v : vertices(mesh))
    if (const auto old = before.find(v); old != before.end()) {
      ++found;
      CHECK(to_position(get(points, v)) == old->second);
    }
  CHECK(found == before.size());
}

TEST_CASE("A constrained point of a soup stays where it is") {
  const Soup soup = two_parts();
  std::vector<Point> points = points_of(soup);
  const auto input = points;
  auto triangles = soup.triangles;
  const auto is_constrained = [](std::size_t v) { return v % 9 == 0; };
  simplify(points, triangles, FaceRatio{0.3}, ThresholdPairs::relative(0.1),
           CGAL::parameters::vertex_is_constrained_map(
               boost::make_function_property_map<std::size_t>(is_constrained)));
  for (std::size_t v = 0; v < input.size(); v += 9)
    CHECK(std::find(points.begin(), points.end(), input[v]) != points.end());
}

// --- Stops ---------------------------------------------------------------------------------------

namespace {

template <class M, class Stop>
Report stopped_by(const Stop& stop) {
  M mesh = convert<M>(as_floats(random_closed(4)));
  const Report report = simplify(mesh, stop);
  CHECK(report.stop == StopReason::target_met);
  CHECK(std::size_t(std::distance(faces(mesh).begin(), faces(mesh).end())) == report.faces_after);
  return report;
}

} // namespace

TEMPLATE_TEST_CASE("Stops do what they say", "", Mesh, Polyhedron, CellComplex, PolyMesh, TriMesh) {
  const Report whole = stopped_by<TestType>([](const Status&) { return true; });
  CHECK(whole.contractions == 0);
  const std::size_t faces = whole.faces_before;
  const double diagonal = test::diagonal(as_floats(random_closed(4)));

  CHECK(stopped_by<TestType>(FaceCount{40}).faces_after == 40);
  CHECK(stopped_by<TestType>(FaceRatio{0.5}).faces_after == 2 * (faces / 4));
  CHECK(stopped_by<TestType>(VertexCount{31}).vertices_after == 31);
  const auto callable = [](const Status& status) { return status.contractions == 7; };
  CHECK(stopped_by<TestType>(callable).contractions == 7);

  // An error limit takes no contraction that may leave it.
  const double limit = 0.05 * diagonal;
  const Report at_limit = stopped_by<TestType>(DistanceLimit{limit});
  CHECK(at_limit.contractions > 0);
  CHECK(at_limit.distance_bound <= limit);
  CHECK(at_limit.rejected(Rejection::distance) > 0);
  CHECK(stopped_by<TestType>(DistanceLimit{limit / 2}).faces_after > at_limit.faces_after);
  const Report relative =
      stopped_by<TestType>(DistanceLimit::relative(limit / diagonal * (1 + 1e-9)));
  CHECK(relative.faces_after == at_limit.faces_after);

  const DistanceLimit early{limit};
  const FaceCount late{40};
  REQUIRE(at_limit.faces_after > 40);
  CHECK(stopped_by<TestType>(AnyOf{early, late}).faces_after == at_limit.faces_after);
  CHECK(stopped_by<TestType>(AnyOf{late, early}).faces_after == at_limit.faces_after);
  CHECK(stopped_by<TestType>(AllOf{early, late}).faces_after <= 40);
  CHECK(stopped_by<TestType>(AllOf{late, VertexCount{1000}}).faces_after == 40);
  CHECK(stopped_by<TestType>(AllOf{late, AnyOf{VertexCount{10}, callable}}).contractions ==
        stopped_by<TestType>(VertexCount{10}).contractions);
}

// --- Filters -------------------------------------------------------------------------------------

namespace {

// Looks at what the filters before it have let pass.
struct Onlooker {
  double* largest_turn;   // of the normal of a face that has one, in degrees
  double* smallest_angle; // of a face that had a larger one before, in degrees
  std::size_t* highest_degree;
  bool allows(const auto& contraction) const {
    *highest_degree = std::max(*highest_degree, contraction.faces().size());
    for (const auto& face : contraction.faces()) {
      const auto before = double_area_vector(face.before, face.second, face.third);
      const auto after = double_area_vector(face.after, face.second, face.third);
      const double lengths = std::sqrt(squared_length(before) * squared_length(after));
      const double cosine = lengths > 0 ? dot(before, after) / lengths : 1;
      *largest_turn = std::max(*largest_turn,
                               std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
      const double angle_after = angle(face.after, face);
      if (angle_after < angle(face.before, face))
        *smallest_angle = std::min(*smallest_angle, angle_after);
    }
    return true;
  }

  // The smallest of a face, by the law of cosines.
  static double angle(const Position& p, const auto& face) {
    std::array<double, 3> edges{squared_distance(p, face.second),
                                squared_distance(face.second, face.third),
                                squared_distance(face.third, p)};
    std::sort(edges.begin(), edges.end());
    const double sides = 2 * std::sqrt(edges[1] * edges[2]);
    const double cosine = sides > 0 ? (edges[1] + edges[2] - edges[0]) / sides : 1;
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
  }
};

struct Seen {
  double largest_turn = 0, smallest_angle = 60;
  std::size_t highest_degree = 0;
  Onlooker onlooker() { return {&largest_turn, &smallest_angle, &highest_degree}; }
};

std::size_t highest_degree(const Soup& soup) {
  std::map<std::uint32_t, std::size_t> degree;
  std::size_t highest = 0;
  for (const auto& t : soup.triangles)
    for (const std::uint32_t v : t)
      highest = std::max(highest, ++degree[v]);
  return highest;
}

template <class Kind>
void check_filters() {
  const Soup soup = as_floats(with_noise(random_closed(8), 0, 0.3));
  const FaceRatio stop{0.4};
  Seen freely, turning, shaped, slim;
  Kind::run(soup, Quadric{}, stop, NormalFlip{180}, freely.onlooker());
  CHECK(freely.largest_turn > 90);
  CHECK(freely.smallest_angle < 10);

  for (const double degrees : {30.0, 90.0, 120.0}) {
    CAPTURE(degrees);
    turning = {};
    const Result result = Kind::run(soup, Quadric{}, stop, NormalFlip{degrees}, turning.onlooker());
    CHECK(result.report.rejected(Rejection::normal_flip) > 0);
    CHECK(turning.largest_turn < degrees * (1 + 1e-9));
    CHECK(turning.largest_turn > 0.5 * degrees);
  }

  const Result with_shape = Kind::run(soup, Quadric{}, stop, SmallestAngle{20}, shaped.onlooker());
  CHECK(with_shape.report.rejected(Rejection::shape) > 0);
  CHECK(shaped.smallest_angle >= 20 - 1e-5);

  const std::size_t before = highest_degree(soup);
  REQUIRE(before <= 10);
  const NormalFlip turns(90, FoldOvers::allowed);
  CHECK(highest_degree(Kind::run(soup, Quadric{}, stop, turns).soup) > 10);
  const Result with_degree =
      Kind::run(soup, Quadric{}, stop, turns, HighestDegree{10}, slim.onlooker());
  CHECK(with_degree.report.rejected(Rejection::degree) > 0);
  CHECK(highest_degree(with_degree.soup) <= 10);
  CHECK(slim.highest_degree <= 10);

  Seen all;
  const Result with_all = Kind::run(soup, Quadric{}, stop, HighestDegree{10}, SmallestAngle{5},
                                    NormalFlip{60}, all.onlooker());
  CHECK(highest_degree(with_all.soup) <= 10);
  CHECK(all.smallest_angle >= 5 - 1e-5);
  CHECK(all.largest_turn < 60 * (1 + 1e-9));
}

} // namespace

TEMPLATE_TEST_CASE("Filters let pass what they say", "", OnSoup, OnMesh<Mesh>, OnMesh<Polyhedron>,
                   OnMesh<CellComplex>, OnMesh<PolyMesh>, OnMesh<TriMesh>) {
  check_filters<TestType>();
}
