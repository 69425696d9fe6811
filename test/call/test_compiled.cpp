// The compiled library gives the same bits as the templates with the same policies.
#include "soups.h"

#include <quadrille/compiled.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/guards.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/parameters.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>
#include <boost/property_map/function_property_map.hpp>
#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace {

using namespace quadrille;
using test::Soup;

struct Arrays {
  SoupPoints points;
  SoupTriangles triangles;

  explicit Arrays(const Soup& soup) : triangles(soup.triangles) {
    for (const auto& p : soup.points)
      points.push_back({p[0], p[1], p[2]});
  }
  friend bool operator==(const Arrays&, const Arrays&) = default;
};

template <class... Policies>
void check(const Soup& soup, const SoupOptions& options, const Policies&... policies) {
  Arrays expected(soup), result(soup);
  const Report of_templates = simplify(expected.points, expected.triangles, policies...);
  const Report report = simplify_soup(result.points, result.triangles, options);
  const bool is_same = result == expected;
  CHECK(is_same);
  CHECK(report.stop == of_templates.stop);
  CHECK(report.contractions == of_templates.contractions);
  CHECK(report.contractions > 0);
}

SoupOptions options_to(std::size_t faces, SoupOptions::Cost cost = SoupOptions::Cost::quadric) {
  SoupOptions options;
  options.faces = faces;
  options.cost = cost;
  return options;
}

// What a filter has been told of all contractions, of which it refuses some.
struct Told {
  std::vector<std::size_t> indices;
  std::vector<std::array<double, 3>> places;

  bool add(std::size_t first, std::size_t second, std::size_t degree, const auto& removed,
           const std::array<double, 3>& target) {
    indices.insert(indices.end(), {first, second, degree});
    for (const std::size_t face : removed)
      indices.push_back(face);
    places.push_back(target);
    return target[2] > -0.5;
  }
  bool add_faces(const auto& faces, auto of) {
    for (const auto& face : faces) {
      indices.push_back(face.index);
      for (const auto& place : {face.before, face.after, face.second, face.third})
        places.push_back(of(place));
    }
    return true;
  }
};

struct Listening {
  Told* told;
  bool allows(const auto& contraction) const {
    return told->add(contraction.first(), contraction.second(), contraction.highest_degree(),
                     contraction.removed_faces(), contraction.target().coordinates) &&
           told->add_faces(contraction.faces(),
                           [](const auto& place) { return place.coordinates; });
  }
};

const Soup soup = test::random_with_boundaries(3), closed = test::sphere(3);

} // namespace

TEST_CASE("Each cost of the compiled library is that of its name") {
  using Cost = SoupOptions::Cost;
  check(soup, options_to(60, Cost::quadric), Quadric{}, FaceCount{60});
  check(soup, options_to(60, Cost::memoryless_quadric), MemorylessQuadric{}, FaceCount{60});
  check(soup, options_to(60, Cost::thin_feature_quadric), ThinFeatureQuadric{}, FaceCount{60});
  check(soup, options_to(60, Cost::edge_length), EdgeLength{}, MidpointPlacement{}, FaceCount{60});
}

TEST_CASE("Each option of the compiled library is the policy of its name") {
  SoupOptions options;
  check(soup, options, Quadric{});
  options = options_to(61);
  options.boundary_weight = 1;
  check(soup, options, Quadric{.boundary_weight = 1}, FaceCount{61});
  options = options_to(60);
  options.placement = SoupOptions::Placement::endpoint;
  check(soup, options, Quadric{}, EndpointPlacement{}, FaceCount{60});
  options.placement = SoupOptions::Placement::midpoint;
  check(soup, options, Quadric{}, MidpointPlacement{}, FaceCount{60});
  options = options_to(60);
  options.order = SoupOptions::Order::relaxed;
  check(soup, options, Quadric{}, RelaxedOrder{}, FaceCount{60});
  options = options_to(60);
  options.topology = Topology::free;
  check(soup, options, Quadric{}, Topology::free, FaceCount{60});
  options = options_to(60);
  options.normal_flip = 20;
  check(soup, options, Quadric{}, NormalFlip(20), FaceCount{60});
  options = options_to(60);
  options.no_self_intersection = true;
  check(soup, options, Quadric{}, NoSelfIntersection{}, FaceCount{60});
  options = options_to(60);
  options.normal_deviation = 40;
  check(soup, options, Quadric{}, NormalDeviation{40}, FaceCount{60});
  options = options_to(60);
  options.keep_solid = true;
  check(closed, options, Quadric{}, KeepSolid{}, FaceCount{60});
  options.order = SoupOptions::Order::relaxed;
  Arrays arrays(soup);
  CHECK_THROWS_AS(simplify_soup(arrays.points, arrays.triangles, options), std::invalid_argument);
  for (const double t : {0.3, 1e-9}) { // by the second there are no pairs but edges
    options = options_to(60);
    options.pairs_closer_than = t;
    check(soup, options, Quadric{}, ThresholdPairs{t}, FaceCount{60});
  }
  options = {};
  options.vertices = 40;
  check(soup, options, Quadric{}, VertexCount{40});
  options = {};
  options.error = 0.05;
  check(soup, options, Quadric{}, DistanceLimit(0.05));
  options = {};
  options.relative_error = 0.02;
  check(soup, options, Quadric{}, DistanceLimit::relative(0.02));
  options.bounding_box = SoupBox{{-5, -5, -5}, {5, 5, 5}};
  check(soup, options, Quadric{}, DistanceLimit::relative(0.02),
        parameters::bounding_box({-5, -5, -5, 5, 5, 5}));
  options = {};
  options.cost_limit = 1e-4;
  check(soup, options, Quadric{}, CostLimit{1e-4});
}

TEST_CASE("Shared points of the compiled library are those of the named parameters") {
  SoupOptions options;
  options.cost_limit = 1e-3;
  options.shared.assign(soup.points.size(), false);
  for (std::size_t v = 0; v < soup.points.size(); v += 2)
    options.shared[v] = true;
  for (const auto& t : soup.triangles)
    options.boundaries.push_back({t[0], t[1]});
  const auto is_shared = boost::make_function_property_map<std::size_t>(
      [](std::size_t v) -> bool { return v % 2 == 0; });
  check(
      soup, options, Quadric{}, CostLimit{1e-3},
      parameters::vertex_is_shared_map(is_shared, parameters::boundary_edges(options.boundaries)));
  Arrays arrays(soup);
  options.shared.pop_back();
  CHECK_THROWS_AS(simplify_soup(arrays.points, arrays.triangles, options), std::invalid_argument);
}

TEST_CASE("Lines, noise and importance are options of the compiled library") {
  SoupOptions options = options_to(60);
  options.weighting = Weighting::by_squared_area;
  options.line_weight = 0.03;
  options.normal_noise = 0.2;
  options.position_noise = 0.01;
  check(soup, options,
        Quadric{.weighting = Weighting::by_squared_area,
                .line_weight = 0.03,
                .normal_noise = 0.2,
                .position_noise = 0.01},
        FaceCount{60});
  options = options_to(60);
  for (const auto& p : soup.points)
    options.importance.push_back(p[0] > 0 ? 50 : 1);
  std::vector<double> importance = options.importance;
  check(soup, options, Quadric{}, FaceCount{60},
        parameters::vertex_importance_map(CGAL::make_property_map(importance)));
  Arrays arrays(soup);
  options.importance.pop_back();
  CHECK_THROWS_WITH(simplify_soup(arrays.points, arrays.triangles, options),
                    Catch::Contains("importance has "));
  options = options_to(60, SoupOptions::Cost::edge_length);
  options.line_weight = 1;
  CHECK_THROWS_WITH(simplify_soup(arrays.points, arrays.triangles, options),
                    Catch::Contains("need the cost quadric"));
}

TEST_CASE("A filter and a stop of the compiled library are asked as those of the templates") {
  const auto is_enough = [](const Status& status) { return status.contractions >= 40; };
  Told of_templates, of_options;
  SoupOptions options;
  options.stop = is_enough; // and there is no FaceRatio
  options.allows = [&](const SoupContraction& contraction) {
    return of_options.add(contraction.first, contraction.second, contraction.highest_degree,
                          contraction.removed_faces, contraction.target) &&
           of_options.add_faces(contraction.faces, [](const auto& place) { return place; });
  };
  check(closed, options, is_enough, Listening{&of_templates});
  CHECK(of_options.indices == of_templates.indices);
  CHECK(of_options.places == of_templates.places);
  Arrays result(closed);
  const Report report = simplify_soup(result.points, result.triangles, options);
  CHECK(report.contractions == 40);
  CHECK(report.rejections[static_cast<std::size_t>(Rejection::filter)] > 0);

  options.faces = closed.triangles.size() - 20; // is met before
  result = Arrays(closed);
  CHECK(simplify_soup(result.points, result.triangles, options).contractions == 10);
}

TEST_CASE("Fixed points stay, and the images tell what became of the others") {
  Arrays result(soup);
  SoupOptions options = options_to(60);
  options.fixed.assign(result.points.size(), false);
  options.fixed[7] = true;
  std::vector<std::size_t> vertex_map;
  simplify_soup(result.points, result.triangles, options, &vertex_map);
  REQUIRE(vertex_map.size() == soup.points.size());
  REQUIRE(vertex_map[7] < result.points.size());
  const auto& p = soup.points[7];
  CHECK(result.points[vertex_map[7]] == std::array{p[0], p[1], p[2]});
  for (std::size_t i : vertex_map)
    CHECK((i < result.points.size() || i == parameters::vanished));
}

TEST_CASE("The compiled library is cancelled before it has begun, and the soup stays") {
  Arrays result(soup);
  SoupOptions options = options_to(60);
  std::size_t calls = 0;
  options.proceed = [&](const Status&) { return ++calls < 2; };
  std::vector<std::size_t> vertex_map;
  CHECK(simplify_soup(result.points, result.triangles, options, &vertex_map).stop ==
        StopReason::cancelled);
  const bool is_same = result == Arrays(soup);
  CHECK(is_same);
  REQUIRE(vertex_map.size() == soup.points.size());
  CHECK(vertex_map[5] == 5);
}

TEST_CASE("The compiled library refuses options that make no sense") {
  Arrays result(soup);
  const auto refuses = [&](const SoupOptions& options) {
    CHECK_THROWS_AS(simplify_soup(result.points, result.triangles, options), std::invalid_argument);
    const bool is_same = result == Arrays(soup);
    CHECK(is_same);
  };
  SoupOptions options = options_to(60, SoupOptions::Cost::edge_length);
  options.placement = SoupOptions::Placement::optimal;
  refuses(options);
  options = options_to(60);
  options.fixed.assign(3, true);
  refuses(options);
  options = {};
  options.ratio = 2;
  refuses(options);
  options = {};
  options.error = -1;
  refuses(options);
}
