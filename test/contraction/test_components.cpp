// Topology::components_may_vanish: small parts go whole where that is the cheapest thing to do, and
// nothing else changes.

#include "mesh_types.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/levels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

namespace {

using namespace quadrille;
using test::PointSoup;
using test::Position;
using test::Soup;

constexpr Topology components_may_vanish = Topology::components_may_vanish;

Soup scaled(const Soup& soup, double factor) {
  return test::mapped(soup, [&](const Position& p) { return factor * p; });
}

Soup soup_of(const PointSoup& points) {
  Soup soup{{}, points.triangles};
  for (const auto& p : points.points)
    soup.points.push_back({{p.x(), p.y(), p.z()}});
  return soup;
}

template <class... Arguments>
Soup simplified(const Soup& input, Report& report, const Arguments&... arguments) {
  PointSoup soup(input);
  report = simplify(soup.points, soup.triangles, arguments...);
  return soup_of(soup);
}

/// Parts, by a plain walk, each as the points that it has.
std::vector<std::vector<Position>> components_of(const Soup& soup) {
  test::detail::Partition parts(soup.points.size());
  for (const auto& [a, b, c] : soup.triangles)
    parts.merge(a, b), parts.merge(b, c);
  std::map<std::uint32_t, std::vector<Position>> points;
  for (const auto& t : soup.triangles)
    for (std::uint32_t v : t)
      points[parts.root(v)].push_back(soup.points[v]);
  std::vector<std::vector<Position>> result;
  for (const auto& [root, of_part] : points)
    result.push_back(of_part);
  return result;
}

/// The greatest distance between two of its points.
double diameter(const std::vector<Position>& points) {
  double squared = 0;
  for (const Position& p : points)
    for (const Position& q : points)
      squared = std::max(squared, squared_distance(p, q));
  return std::sqrt(squared);
}

// Things in a row along x, so far apart.
constexpr double spacing = 4;

std::size_t thing_at(double x) {
  return static_cast<std::size_t>(std::lround(x / spacing));
}
Position place_of(std::size_t thing) {
  return {{spacing * static_cast<double>(thing), 0, 0}};
}

/// Which of these things are there.
std::vector<bool> things_in(const Soup& soup, std::size_t count) {
  std::vector<bool> is_there(count);
  for (const auto& part : components_of(soup))
    is_there.at(thing_at(part.front()[0])) = true;
  return is_there;
}

/// Spheres in that row, each of so large a radius.
Soup spheres(const std::vector<double>& radii, int levels = 2) {
  Soup soup;
  for (std::size_t i = 0; i < radii.size(); ++i)
    soup = test::joined(soup, scaled(test::sphere(levels), radii[i]), place_of(i));
  return soup;
}

/// A large noisy sphere, with small parts of many sizes and kinds in and around it.
Soup scan(std::size_t small) {
  Soup soup = scaled(test::with_noise(test::sphere(5), 1, 0.004), 10);
  test::Random random(7);
  for (std::size_t i = 0; i < small; ++i) {
    const Soup kinds[] = {test::sphere(1), test::torus(9, 7), test::grid(4, 3), test::triangle(),
                          test::octahedron()};
    const double size = std::exp(random(std::log(0.003), std::log(0.05)));
    const double u = random(0, 2 * std::numbers::pi), z = random(-1, 1), r = random(3, 14);
    const double w = std::sqrt(1 - z * z);
    soup = test::joined(soup, scaled(kinds[i % 5], size),
                        {{r * w * std::cos(u), r * w * std::sin(u), r * z}});
  }
  return soup;
}

} // namespace

// --- What goes and what stays --------------------------------------------------------------------

TEMPLATE_TEST_CASE("A target that small parts stand in the way of is met", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric) {
  const Soup input = scan(300);
  const auto check = [&](const auto& order) {
    Report report;
    const Soup kept = simplified(input, report, TestType{}, FaceCount{400}, Topology::kept, order);
    CHECK(report.stop == StopReason::target_unreachable);
    CHECK(report.vanished_components == 0);

    const Soup result =
        simplified(input, report, TestType{}, FaceCount{400}, components_may_vanish, order);
    INFO(report);
    CHECK(is_target_reached(report.stop));
    CHECK(result.triangles.size() <= 400);
    CHECK(result.triangles.size() >= 397);
    CHECK(report.faces_after == result.triangles.size());
    CHECK(report.vertices_after == result.points.size());
    const test::SoupTopology before = test::topology_of(input), after = test::topology_of(result);
    CHECK(after.is_manifold);
    CHECK(after.is_oriented);
    CHECK(after.vertices == result.points.size());
    CHECK_FALSE(after.has_duplicate_faces);
    CHECK(after.components < 301);
    CHECK(report.components_before == before.components);
    CHECK(report.components_after == after.components);
    CHECK(report.vanished_components == before.components - after.components);
    CHECK(report.non_manifold_edges + report.non_manifold_vertices == 0);
    // The large sphere is what it was.
    CHECK(test::volume(result) == Approx(4 * std::numbers::pi / 3 * 1000).epsilon(0.04));
  };
  check(GreedyOrder{});
  check(RelaxedOrder{});
  check(RelaxedOrder{.refresh = true});
}

TEMPLATE_TEST_CASE("Of parts of one shape the smaller ones go first", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric, EdgeLength) {
  std::vector<double> radii;
  for (int i = 0; i < 24; ++i)
    radii.push_back(0.4 * std::pow(0.8, i * 7 % 24));
  const Soup input = spheres(radii);
  using Placement =
      std::conditional_t<std::is_same_v<TestType, EdgeLength>, MidpointPlacement, OptimalPlacement>;
  for (std::size_t faces : {600u, 300u, 96u, 60u, 20u, 4u}) {
    CAPTURE(faces);
    Report report;
    const Soup result =
        simplified(input, report, TestType{}, Placement{}, FaceCount{faces}, components_may_vanish);
    CHECK(is_target_reached(report.stop));
    CHECK(result.triangles.size() + 2 >= faces);
    const std::vector<bool> is_there = things_in(result, radii.size());
    double largest_gone = 0, smallest_left = 1;
    for (std::size_t i = 0; i < radii.size(); ++i)
      if (is_there[i])
        smallest_left = std::min(smallest_left, radii[i]);
      else
        largest_gone = std::max(largest_gone, radii[i]);
    CHECK(largest_gone < smallest_left);
  }
}

TEST_CASE(
    "A part costs its squared distance, up to four radii, times the weight of what it remembers") {
  // Far apart, so that all count four radii; from a hundredth of the diagonal on they come behind
  // all that move the surface less. Spheres, tori and single triangles of many sizes: with Quadric
  // a face weighs its area at each of its corners, and a border edge 100 times its square at both
  // ends, and a quarter of that along the normal.
  std::vector<double> prices, squared_radii;
  Soup input;
  for (std::size_t i = 0; i < 30; ++i) {
    const Soup kinds[] = {test::sphere(2), test::torus(9, 7), test::triangle()};
    const Soup thing = scaled(kinds[i % 3], 0.3 * std::pow(0.9, static_cast<double>(i * 7 % 30)));
    double area = 0, border = 0, squared_radius = 0;
    Position low = thing.points[0], high = low;
    for (const Position& p : thing.points)
      for (std::size_t k = 0; k < 3; ++k)
        low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    for (const Position& p : thing.points)
      squared_radius = std::max(squared_radius, squared_distance(p, 0.5 * (low + high)));
    for (const test::Triangle& t : thing.triangles) {
      area += std::sqrt(squared_length(test::area_vector(thing, t)));
      if (i % 3 == 2)
        for (std::size_t k = 0; k < 3; ++k)
          border += squared_distance(thing.points[t[k]], thing.points[t[(k + 1) % 3]]);
    }
    prices.push_back(squared_radius * (3 * area + 2 * 125 * border));
    squared_radii.push_back(squared_radius);
    input = test::joined(input, thing, place_of(i));
  }
  for (std::size_t i = 0; i < prices.size(); ++i) {
    const double strain = 4 * std::sqrt(squared_radii[i]) / (0.01 * diameter(input.points));
    prices[i] *= strain > 1 ? 0x1p20 * std::pow(strain, 4) : 1;
  }
  for (std::size_t faces : {400u, 200u, 120u, 80u, 60u, 40u, 20u, 10u}) {
    Report report;
    const Soup result = simplified(input, report, FaceCount{faces}, components_may_vanish);
    const std::vector<bool> is_there = things_in(result, prices.size());
    double costliest_gone = 0, cheapest_left = 1e99;
    for (std::size_t i = 0; i < prices.size(); ++i)
      if (is_there[i])
        cheapest_left = std::min(cheapest_left, prices[i]);
      else
        costliest_gone = std::max(costliest_gone, prices[i]);
    CAPTURE(faces, costliest_gone, cheapest_left);
    CHECK(costliest_gone < cheapest_left);
    CHECK((costliest_gone > 0) == (report.vanished_components > 0));
  }
}

TEST_CASE("A part that lies apart outlives one of the same shape that touches what is left") {
  // Around a large sphere, every other one near it; and far away a pair of which one is larger.
  Soup input = scaled(test::sphere(5), 10);
  const auto add = [&](double radius, double distance, double angle) {
    const Position to = {{distance * std::cos(angle), distance * std::sin(angle), 0}};
    input = test::joined(input, scaled(test::sphere(1), radius), to);
  };
  for (int i = 0; i < 24; ++i)
    add(0.2, i % 2 == 0 ? 10.2 : 13, i * std::numbers::pi / 12);
  add(0.2, 16, 0.1);
  add(0.21, 16, 0.13);
  const auto is_there = [](const Soup& result, double low, double high) {
    return std::count_if(result.points.begin(), result.points.end(), [&](const Position& p) {
      const double distance = std::sqrt(squared_length(p));
      return low < distance && distance < high;
    });
  };
  Report report;
  const Soup result = simplified(input, report, FaceCount{300}, components_may_vanish);
  INFO(report);
  CHECK(report.vanished_components == 13);
  CHECK(is_there(result, 10.25, 11) == 0);
  CHECK(is_there(result, 12, 14) >= 12 * 4);
  CHECK(is_there(result, 15, 17) >= 4);
}

TEST_CASE("A trunk does not melt for the sake of leaves that lie apart") {
  Soup input = test::mapped(test::grid(32, 40), [](const Position& p) {
    const double angle = 2 * std::numbers::pi * p[0], radius = 0.12 * (1.2 - p[1]);
    return Position{{radius * std::cos(angle), 2 * p[1], radius * std::sin(angle)}};
  });
  test::Random random(5);
  const auto within = [&](double low, double high) {
    return Position{{random(low, high), random(low, high), random(low, high)}};
  };
  for (int leaf = 0; leaf < 100; ++leaf) {
    const Position u = within(-0.1, 0.1), v = within(-0.1, 0.1);
    const auto flat = [&](const Position& p) { return p[0] * u + p[1] * v; };
    input = test::joined(input, test::mapped(test::grid(1, 1), flat),
                         within(-1, 1) + Position{{0, 2, 0}});
  }
  for (std::size_t faces : {66u, 50u}) {
    Report report;
    const Soup result = simplified(input, report, FaceCount{faces}, components_may_vanish);
    CHECK(report.stop == StopReason::target_met);
    const auto is_of_trunk = [&](const test::Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
        return std::hypot(result.points[v][0], result.points[v][2]) < 0.16;
      });
    };
    CHECK(std::count_if(result.triangles.begin(), result.triangles.end(), is_of_trunk) >= 4);
  }
}

TEST_CASE("Near the floor a part that lies apart is not given for faces, nor is the rest for it") {
  // A plate of 20 holes can't lose many faces. Beside it are cubes: near it, and far away.
  Soup input = test::plate_with_holes(20, 6);
  for (int i = 0; i < 10; ++i) {
    input = test::joined(input, scaled(test::sphere(1), 0.2), {{3.0 * i, -6, 0}});
    input = test::joined(input, scaled(test::sphere(1), 0.2), {{3.0 * i, -0.3, 0.5}});
  }
  Report report;
  const Soup result = simplified(input, report, FaceCount{40}, components_may_vanish);
  INFO(report);
  CHECK(report.stop == StopReason::target_unreachable);
  CHECK(report.vanished_components == 10);
  for (const Position& p : result.points)
    CHECK((p[1] < -5 || p[1] > -0.2));
}

TEMPLATE_TEST_CASE("A part shrinks as far as it can before it vanishes", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric, EdgeLength) {
  using Placement =
      std::conditional_t<std::is_same_v<TestType, EdgeLength>, MidpointPlacement, OptimalPlacement>;
  const Soup input = spheres(std::vector<double>(10, 0.3), 3);
  for (std::size_t faces : {1000u, 100u, 40u, 36u, 20u}) {
    Report report;
    const Soup result =
        simplified(input, report, TestType{}, Placement{}, FaceCount{faces}, components_may_vanish);
    CAPTURE(faces, report);
    CHECK(result.triangles.size() == faces);
    CHECK(report.vanished_components == (faces >= 40 ? 0 : 10 - faces / 4));
  }
}

TEST_CASE("Thin and flat parts do not go before their size says so") {
  // A wire, a plate of two sides and a strip, beside small spheres: their planes pass through their
  // centres, or nearly, and yet they stay.
  const auto stretched = [](const Soup& soup, double x, double y, double z) {
    return test::mapped(soup, [=](const Position& p) {
      return Position{{x * p[0], y * p[1], z * p[2]}};
    });
  };
  Soup input = spheres(std::vector<double>(40, 0.02));
  input = test::joined(input, stretched(test::sphere(2), 0.01, 3, 0.01), place_of(40));
  input = test::joined(input, stretched(test::sphere(2), 0.4, 0.4, 1e-9), place_of(41));
  input = test::joined(input, stretched(test::grid(9, 9), 0.2, 0.2, 1), place_of(42));
  Report report;
  const Soup result = simplified(input, report, FaceCount{12}, components_may_vanish);
  INFO(report);
  CHECK(result.triangles.size() <= 12);
  const std::vector<bool> is_there = things_in(result, 43);
  CHECK(std::count(is_there.begin(), is_there.begin() + 40, true) == 0);
  CHECK(is_there[40]);
  CHECK(is_there[41]);
  CHECK(is_there[42]);
}

TEST_CASE("Parts that are gone are told with the size of the largest, with topology free, too") {
  const std::vector<double> radii = {1.5, 0.3, 0.5, 0.05, 0.2, 0.1};
  const Soup input = spheres(radii, 3);
  const auto check = [&](const auto&... arguments) {
    Report report;
    const Soup result = simplified(input, report, arguments...);
    INFO(report);
    const std::vector<bool> is_there = things_in(result, radii.size());
    double largest = 0;
    for (std::size_t i = 0; i < radii.size(); ++i)
      if (!is_there[i]) // the vertices of an octahedron are among those of a sphere
        largest = std::max(largest, 2 * radii[i] * std::sqrt(3));
    CHECK(report.vanished_components ==
          static_cast<std::size_t>(std::count(is_there.begin(), is_there.end(), false)));
    CHECK(report.largest_vanished_component == Approx(largest));
    CHECK(report.error >= largest / 3.5);
    CHECK(report.components_before == radii.size());
    return report.vanished_components;
  };
  CHECK(check(FaceCount{40}, Topology::free) > 1);
  CHECK(check(FaceCount{40}, Topology::free, RelaxedOrder{}) > 1);
  CHECK(check(FaceCount{12}, components_may_vanish) > 1);
  CHECK(check(FaceCount{40}, Topology::kept) == 0);
  Report report;
  const Soup joined = simplified(spheres({1.9, 1.9}), report, FaceCount{100}, ThresholdPairs{0.5});
  CHECK(test::topology_of(joined).components == 1);
  CHECK(report.components_before == 2);
  CHECK(report.vanished_components == 0);
}

TEST_CASE("A part of any topology vanishes, inside of another or not") {
  Soup input = scaled(test::sphere(4), 10);
  input = test::joined(input, scaled(test::plate_with_holes(3), 0.01), {{1, 0, 0}});
  input = test::joined(input, scaled(test::torus(12, 9), 0.02), {{20, 0, 0}});
  input = test::joined(input, scaled(test::open_cylinder(8, 3), 0.02), {{0, 20, 0}});
  input = test::joined(input, scaled(test::triangle(), 0.02), {{0, 0, 20}});
  // Spheres in spheres.
  for (double r : {0.03, 0.02, 0.01})
    input = test::joined(input, scaled(test::sphere(2), r), {{0, -20, 0}});
  Report report;
  const Soup result = simplified(input, report, FaceCount{100}, components_may_vanish);
  CHECK(report.vanished_components == 7);
  CHECK(report.stop == StopReason::target_met);
  CHECK(test::topology_of(result).components == 1);
  CHECK(result.triangles.size() == 100);
}

TEST_CASE("Never all parts vanish, and the one that stays is the largest") {
  const Soup input = spheres({0.05, 0.15, 0.1, 0.02});
  Report report;
  const Soup result = simplified(input, report, FaceCount{0}, components_may_vanish);
  CHECK(result.triangles.size() == 4);
  CHECK(report.vanished_components == 3);
  CHECK(report.stop == StopReason::all_pairs_rejected);
  CHECK(things_in(result, 4)[1]);

  const Soup equal = spheres(std::vector<double>(9, 0.25), 0);
  const Soup one = simplified(equal, report, FaceCount{0}, components_may_vanish);
  CHECK(one.triangles.size() == 4);
  const Soup sheets = test::joined(test::triangle(), test::triangle(), {{50, 0, 0}});
  CHECK(simplified(sheets, report, FaceCount{0}, components_may_vanish).triangles.size() == 1);
}

TEST_CASE(
    "Nothing else changes: a surface of one part gives the same bits as where topology is kept") {
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    const Soup input = seed == 1 ? test::random_with_boundaries(seed) : test::random_closed(seed);
    const auto check = [&](const auto&... arguments) {
      Report kept, may_vanish;
      const Soup a = simplified(input, kept, Topology::kept, arguments...);
      const Soup b = simplified(input, may_vanish, components_may_vanish, arguments...);
      CHECK(test::is_identical(a, b));
      CHECK(kept.error == may_vanish.error);
      CHECK(kept.stop == may_vanish.stop);
      CHECK(kept.rejections == may_vanish.rejections);
    };
    check(FaceRatio{0.1});
    check(FaceCount{0});
    check(FaceRatio{0.1}, RelaxedOrder{});
    check(FaceRatio{0.1}, MemorylessQuadric{});
    check(DistanceLimit{0.05});
  }
}

TEST_CASE("Parts that are dearer than what the target costs stay, with the same bits") {
  const Soup input = spheres({0.4, 0.4, 0.4, 0.4}, 4);
  Report kept, may_vanish;
  const Soup a = simplified(input, kept, FaceRatio{0.05}, Topology::kept);
  const Soup b = simplified(input, may_vanish, FaceRatio{0.05}, components_may_vanish);
  CHECK(test::is_identical(a, b));
  CHECK(may_vanish.vanished_components == 0);
}

// --- Targets and limits --------------------------------------------------------------------------

TEST_CASE("A count that a part would go beyond is met by pairs, or passed and told") {
  Report report;
  const Soup hundred = spheres(std::vector<double>(100, 0.25), 0); // octahedra
  const Soup ten = simplified(hundred, report, FaceCount{10}, components_may_vanish);
  CHECK(is_target_reached(report.stop));
  CHECK(ten.triangles.size() <= 10);
  CHECK(ten.triangles.size() >= 7);
  CHECK((report.stop == StopReason::target_met) == (ten.triangles.size() == 10));
  const Soup some = simplified(hundred, report, VertexCount{11}, components_may_vanish);
  CHECK(is_target_reached(report.stop));
  CHECK(some.points.size() <= 11);

  // The sphere has pairs that meet any even number, at little cost.
  const Soup crumbs =
      test::joined(scaled(test::with_noise(test::sphere(4), 1, 0.01), 10), hundred, {{20, 0, 0}});
  // An odd number is passed by one face, and not by all of an octahedron.
  for (std::size_t faces = 300; faces < 320; ++faces) {
    const Soup result = simplified(crumbs, report, FaceCount{faces}, components_may_vanish);
    CHECK(report.stop ==
          (faces % 2 == 0 ? StopReason::target_met : StopReason::target_passed));
    CHECK(result.triangles.size() == faces - faces % 2);
  }
}

TEST_CASE("With an error limit the parts vanish whose diameter is within it, and no others") {
  const std::vector<double> radii{0.4, 0.04, 0.1, 0.049, 0.051, 0.002, 0.2, 0.02};
  const Soup input = spheres(radii, 3);
  const auto check = [&](const Soup& result, const Report& report, double limit) {
    INFO(report);
    CHECK(report.stop == StopReason::target_met);
    const std::vector<bool> is_there = things_in(result, radii.size());
    for (std::size_t i = 0; i < radii.size(); ++i)
      CHECK(is_there[i] == (2 * radii[i] > limit));
  };
  for (double limit : {0.1, 0.03, 0.003, 0.0})
    for (double unit : {1.0, 1e-4}) {
      CAPTURE(limit, unit);
      Report report;
      const Soup small = scaled(input, unit);
      const DistanceLimit stop(limit * unit);
      check(scaled(simplified(small, report, stop, components_may_vanish), 1 / unit), report,
            limit);
      CHECK(report.distance_bound <= limit * unit + 1e-12);
      CHECK(report.rejected(Rejection::distance) > 0);
      check(
          scaled(simplified(small, report, stop, RelaxedOrder{}, components_may_vanish), 1 / unit),
          report, limit);
    }
  Report report;
  const Soup both =
      simplified(input, report, AnyOf{FaceCount{0}, DistanceLimit{0.1}}, components_may_vanish);
  check(both, report, 0.1);
}

TEST_CASE("The diameter within a limit is that of the part as it was, of any shape") {
  Report report;
  const Soup input = scan(200);
  for (double limit : {0.01, 0.05}) {
    const Soup result = simplified(input, report, DistanceLimit(limit), components_may_vanish);
    INFO(report);
    std::size_t within = 0, larger = 0;
    for (const auto& part : components_of(input)) {
      // Its points are few, but for the large sphere.
      const double size = part.size() > 2000 ? 20 : diameter(part);
      within += 1.8 * size <= limit; // a sphere around it has no more than √3 times its diameter
      larger += size > limit;
    }
    const std::size_t left = components_of(result).size();
    CHECK(left >= larger);
    CHECK(left + within <= components_of(input).size());
    CHECK(report.vanished_components > 0);
  }
}

TEST_CASE("As many parts vanish for a target that can't be reached as for the least that can") {
  // Two spheres with a fixed point each keep four faces each.
  const Soup input = spheres({0.2, 0.01, 0.2, 0.01, 0.02}, 2);
  std::vector<char> is_fixed(input.points.size());
  is_fixed.front() = true;
  is_fixed[2 * input.points.size() / 5] = true;
  const auto fixed = CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_fixed));
  Report report;
  Soup result = simplified(input, report, FaceCount{6}, components_may_vanish, fixed);
  CHECK(report.stop == StopReason::all_pairs_rejected);
  CHECK(report.vanished_components == 3);
  CHECK(result.triangles.size() == 8);
  result = simplified(input, report, FaceCount{8}, components_may_vanish, fixed);
  CHECK(report.stop == StopReason::target_met);
  CHECK(report.vanished_components == 3);
  CHECK(result.triangles.size() == 8);
}

// --- What keeps a part ---------------------------------------------------------------------------

TEST_CASE("A part with a fixed vertex stays") {
  const Soup input = spheres({0.4, 0.01, 0.02, 0.03, 0.04}, 1);
  std::vector<char> is_fixed(input.points.size());
  is_fixed[input.points.size() / 5 + 3] = true; // of the second
  Report report;
  const Soup result =
      simplified(input, report, FaceCount{10}, components_may_vanish,
                 CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_fixed)));
  CHECK(things_in(result, 5) == std::vector<bool>{true, true, false, false, false});
  CHECK(report.stop == StopReason::target_met);

  // Of a mesh, an edge as well.
  test::Mesh mesh = test::make_mesh(input);
  auto kept = mesh.add_property_map<test::Mesh::Edge_index, bool>("e:kept", false).first;
  const auto of_third = static_cast<test::Mesh::size_type>(2 * input.points.size() / 5);
  kept[mesh.edge(mesh.halfedge(test::Mesh::Vertex_index(of_third)))] = true;
  simplify(mesh, FaceCount{10}, components_may_vanish,
           CGAL::parameters::edge_is_constrained_map(kept));
  CHECK(test::is_valid_triangle_mesh(mesh));
  CHECK(things_in(test::to_soup(mesh), 5) == std::vector<bool>{true, false, true, false, false});
}

TEST_CASE("A label goes with the last part that has it, as the material of a prop does") {
  const std::vector<double> radii{0.4, 0.01, 0.02, 0.03, 0.04, 0.05};
  const Soup input = spheres(radii, 1);
  const std::vector<int> label_of{7, 7, 5, 5, 3, 8}; // 5: two small ones; 3 and 8: a single one
  std::vector<int> labels;
  for (const test::Triangle& t : input.triangles)
    labels.push_back(label_of[thing_at(input.points[t[0]][0])]);
  const auto check = [&](const auto& order) {
    PointSoup soup(input);
    std::vector<int> of_face = labels;
    const Report report =
        simplify(soup.points, soup.triangles, FaceCount{12}, components_may_vanish, order,
                 Labels{CGAL::make_property_map(of_face)});
    CHECK(report.stop == StopReason::target_met);
    CHECK(things_in(soup_of(soup), 6) ==
          std::vector<bool>{true, false, false, false, false, false});
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      CHECK(of_face[f] == label_of[thing_at(soup.points[soup.triangles[f][0]].x())]);
  };
  check(GreedyOrder{});
  check(RelaxedOrder{});
}

// --- Meshes, channels, maps ----------------------------------------------------------------------

TEMPLATE_TEST_CASE("Meshes of any kind lose parts", "", test::Mesh, test::Polyhedron, test::TriMesh,
                   test::CellComplex) {
  const Soup input = test::as_floats(scan(60));
  Report of_soup;
  const Soup expected = simplified(input, of_soup, FaceCount{200}, components_may_vanish);
  CHECK(of_soup.vanished_components > 30);
  TestType mesh = test::make_mesh<TestType>(input);
  const Report report = simplify(mesh, FaceCount{200}, components_may_vanish);
  CHECK(report.vanished_components == of_soup.vanished_components);
  CHECK(report.faces_after == of_soup.faces_after);
  CHECK(test::is_valid_triangle_mesh(mesh));
  CHECK(test::is_same_surface(test::to_soup(mesh), expected, 1e-4));
}

TEST_CASE("What became of the vertices of a part is told") {
  const Soup input = spheres({0.4, 0.01, 0.3}, 1);
  PointSoup soup(input);
  std::vector<std::size_t> image(input.points.size(), 12345);
  const Report report = simplify(soup.points, soup.triangles, FaceCount{8}, components_may_vanish,
                                 parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  REQUIRE(report.vanished_components == 1);
  const std::size_t each = input.points.size() / 3;
  for (std::size_t v = 0; v < image.size(); ++v)
    if (v / each == 1)
      CHECK(image[v] == parameters::vanished);
    else
      CHECK(thing_at(soup.points.at(image[v]).x()) == v / each);
}

TEST_CASE("Levels know which parts have vanished") {
  const Soup input = scan(60);
  const auto check = [&](const auto& order) {
    Levels levels;
    std::vector<std::array<double, 3>> points;
    for (const Position& p : input.points)
      points.push_back(p.coordinates);
    std::vector<test::Triangle> triangles = input.triangles;
    const Report report = simplify(points, triangles, FaceCount{200}, components_may_vanish, order,
                                   record_into(levels));
    CHECK(report.vanished_components > 20);
    const Level last = in_input_order(levels.at(FaceCount{report.faces_after}));
    CHECK(last.points == points);
    CHECK(last.triangles == triangles);
    CHECK(last.vertices == report.vertices_after);
    CHECK(last.error > 0);
    CHECK(last.error <= report.error); // that counts how far from the rest a part was
  };
  check(GreedyOrder{});
  check(RelaxedOrder{});
}

TEST_CASE("Channels of what is left are right") {
  const Soup input = spheres({0.4, 0.01, 0.3, 0.02}, 3);
  PointSoup soup(input);
  std::vector<std::array<double, 2>> uv;
  for (const Position& p : input.points)
    uv.push_back({0.25 * p[0], p[1] + 0.5});
  const Report report = simplify(soup.points, soup.triangles, FaceCount{100}, components_may_vanish,
                                 Texture{CGAL::make_property_map(uv)});
  CHECK(report.vanished_components == 2);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    CHECK(uv[v][0] == Approx(0.25 * soup.points[v].x()).margin(0.01));
    CHECK(uv[v][1] == Approx(soup.points[v].y() + 0.5).margin(0.04));
  }
}

TEST_CASE("Any order of passes and any unit of length lets the same parts vanish") {
  const Soup input = scan(150);
  Report report, of_other;
  const Soup one = simplified(input, report, FaceCount{300}, components_may_vanish);
  for (double unit : {0x1p-40, 0x1p30}) {
    const Soup other =
        simplified(scaled(input, unit), of_other, FaceCount{300}, components_may_vanish);
    CHECK(test::is_identical(scaled(other, 1 / unit), one));
    CHECK(of_other.vanished_components == report.vanished_components);
    CHECK(of_other.error == report.error * unit);
  }
}

TEST_CASE("A visitor may cancel when parts have vanished and nothing has been contracted") {
  // Tetrahedra can't be contracted; the visitor lets some of them go.
  const Soup input = spheres(std::vector<double>(3000, 0.1), 0);
  struct Cancelling : Visitor {
    bool proceed(const Status& status) const { return status.faces > 9000; }
  };
  PointSoup soup(input);
  const Report report = simplify(soup.points, soup.triangles, FaceCount{0}, components_may_vanish,
                                 CGAL::parameters::visitor(Cancelling{}));
  CHECK(report.stop == StopReason::cancelled);
  CHECK(report.faces_after == soup.triangles.size());
  CHECK(report.faces_after < input.triangles.size());
  CHECK(soup.triangles.size() > 4);
  CHECK(test::topology_of(soup_of(soup)).is_manifold);
}
