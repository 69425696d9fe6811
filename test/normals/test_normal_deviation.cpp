// With NormalDeviation no normal is further from those it stands for than it says: told by brute
// force, from what became of each vertex.
#include "meshes.h"
#include "replay.h"
#include "soups.h"

#include <quadrille/edge_length.h>
#include <quadrille/guards.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/guards/normals/face_cones.h>
#include <quadrille/internal/guards/normals/normal_cone.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/quadric.h>
#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;
using test::Triangle;

constexpr double degrees_a_radian = 180 / std::numbers::pi;

Position normal(const std::vector<Position>& points, const Triangle& t) {
  return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}
double degrees_between(const Position& a, const Position& b) {
  return std::atan2(std::sqrt(dot(cross(a, b), cross(a, b))), dot(a, b)) * degrees_a_radian;
}

/// What a simplicial map of an input onto a result does to normals.
struct Deviation {
  double greatest = 0;                  // degrees
  std::size_t into = 0, onto_edges = 0; // faces of the input
};

/// `image`: of each vertex of the input, of those of the result; or none.
Deviation deviation(const Soup& input, const Soup& result, const std::vector<std::uint32_t>& image,
                    std::uint32_t none) {
  std::map<std::set<std::uint32_t>, std::vector<Position>> normals; // of faces at a simplex
  for (const Triangle& t : result.triangles) {
    const Position n = normal(result.points, t);
    if (dot(n, n) == 0)
      continue;
    normals[{t[0], t[1], t[2]}].push_back(n);
    for (std::size_t i = 0; i < 3; ++i)
      normals[{t[i], t[(i + 1) % 3]}].push_back(n);
  }
  Deviation deviation;
  for (const Triangle& t : input.triangles) {
    const Position n = normal(input.points, t);
    const std::set<std::uint32_t> simplex{image[t[0]], image[t[1]], image[t[2]]};
    const auto found = normals.find(simplex);
    if (dot(n, n) == 0 || simplex.contains(none) || simplex.size() == 1 || found == normals.end())
      continue;
    ++(simplex.size() == 3 ? deviation.into : deviation.onto_edges);
    for (const Position& of_result : found->second)
      deviation.greatest = std::max(deviation.greatest, degrees_between(n, of_result));
  }
  return deviation;
}

struct Run {
  Report report;
  Soup result;
  Deviation deviation;
};

template <class Cost = Quadric, class Number = double>
Run run(const Soup& input, const auto&... arguments) {
  std::vector<std::array<Number, 3>> points;
  for (const Position& p : input.points)
    points.push_back({Number(p[0]), Number(p[1]), Number(p[2])});
  std::vector<std::uint32_t> image(points.size());
  Run run{{}, {{}, input.triangles}, {}};
  using Placement =
      std::conditional_t<std::is_same_v<Cost, EdgeLength>, MidpointPlacement, OptimalPlacement>;
  run.report =
      simplify<Cost, Placement>(points, run.result.triangles, arguments...,
                                parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  for (const auto& p : points)
    run.result.points.push_back({{double(p[0]), double(p[1]), double(p[2])}});
  run.deviation = deviation(input, run.result, image, std::uint32_t(parameters::vanished));
  return run;
}

/// Within the angle, which is not so by itself.
template <class Cost = Quadric, class Number = double>
Report check(const Soup& input, double degrees, const auto&... arguments) {
  const Run without = run<Cost, Number>(input, NormalFlip{180}, arguments...);
  const Run with =
      run<Cost, Number>(input, NormalFlip{180}, arguments..., NormalDeviation{degrees});
  INFO(with.report);
  CHECK(without.deviation.greatest > degrees);
  CHECK_FALSE(without.report.normal_bound_degrees.has_value());
  CHECK(with.deviation.greatest <= degrees);
  CHECK(with.deviation.greatest <= *with.report.normal_bound_degrees);
  CHECK(*with.report.normal_bound_degrees <= degrees * (1 + 1e-12));
  CHECK(with.deviation.into > 0);
  CHECK(with.deviation.onto_edges > 0);
  CHECK(with.report.contractions > 0);
  CHECK(with.report.rejected(Rejection::normal_deviation) > 0);
  return with.report;
}

Soup bumpy(Soup soup, double height, double frequency) {
  for (Position& p : soup.points) {
    const Position q = p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] += height * std::sin(frequency * q[(i + 1) % 3] + double(i)) *
              std::cos(frequency * q[(i + 2) % 3]);
  }
  return soup;
}
Soup waves() {
  Soup soup = test::grid(40, 40);
  for (Position& p : soup.points)
    p[2] = 0.02 * std::sin(31 * p[0]) * std::cos(23 * p[1]);
  return soup;
}
/// Three sheets that meet in a line.
Soup three_sheets() {
  Soup soup;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](int sheet, int x, int y) {
    const auto [at, is_new] = numbers.try_emplace({x == 0 ? 0 : sheet, x, y},
                                                  static_cast<std::uint32_t>(soup.points.size()));
    if (is_new) {
      const double angle = 2.1 * sheet, far = 0.05 * x, wave = 0.01 * std::sin(1.7 * x + 0.9 * y);
      soup.points.push_back({{far * std::cos(angle) - wave * std::sin(angle),
                              far * std::sin(angle) + wave * std::cos(angle), 0.05 * y}});
    }
    return at->second;
  };
  for (int sheet = 0; sheet < 3; ++sheet)
    for (int x = 0; x < 16; ++x)
      for (int y = 0; y < 16; ++y) {
        const auto a = vertex(sheet, x, y), b = vertex(sheet, x + 1, y),
                   c = vertex(sheet, x + 1, y + 1), d = vertex(sheet, x, y + 1);
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      }
  return soup;
}

using internal::FaceNormal;
using internal::NormalCone;

NormalCone cone_of(const Position& n) {
  const Position side = cross(n, std::abs(n[0]) < 0.5 ? Position{{1, 0, 0}} : Position{{0, 1, 0}});
  return NormalCone(FaceNormal({}, side, cross(n, side)));
}

} // namespace

TEST_CASE("A cone has all directions that it has taken in, and few others") {
  test::Random random(5);
  for (int round = 0; round < 3000; ++round) {
    const double spread = std::pow(10, random(-8, 0.3));
    std::vector<Position> directions;
    NormalCone cone;
    CHECK(cone.is_empty());
    const Position middle{{random(-1, 1), random(-1, 1), random(-1, 1)}};
    for (int i = 0; i < 2 + round % 9; ++i) {
      Position d = middle;
      for (std::size_t k = 0; k < 3; ++k)
        d[k] += random(-spread, spread);
      d = (1 / std::sqrt(dot(d, d))) * d;
      directions.push_back(d);
      if (i % 3 == 2) { // by another cone
        NormalCone two = cone_of(directions[0]);
        two.add(cone_of(d));
        cone.add(two);
      } else {
        cone.add(cone_of(d));
      }
    }
    double widest = 0;
    for (const Position& d : directions) {
      // From the axis, d is no further than the half-angle: so from d, anything is within twice it.
      REQUIRE(cone.greatest_angle(d) <= 2 * cone.half_angle() + 1e-12);
      for (const Position& e : directions)
        widest = std::max(widest, internal::angle_between(d, e));
    }
    REQUIRE(2 * cone.half_angle() >= widest);
    if (directions.size() == 2)
      REQUIRE(2 * cone.half_angle() <= widest + 1e-5);
  }
  NormalCone all = cone_of({{1, 0, 0}});
  all.add(cone_of({{-1, 0, 0}}));
  CHECK(all.half_angle() >= std::numbers::pi);
  all.add(cone_of({{0, 1, 0}}));
  CHECK(all.half_angle() >= std::numbers::pi);
  CHECK(NormalCone(FaceNormal({}, {{1, 0, 0}}, {{2, 0, 0}})).is_empty());
}

TEST_CASE("Faces that come to have the same vertices take the cones of each other") {
  // The tetrahedron a b p q: two faces vanish, and the others come to lie on each other.
  const internal::Index b = 1, p = 2, q = 3;
  internal::PairStar star;
  star.first.add_if(true, {0, p, q});
  star.second.add_if(true, {1, q, p});
  star.shared.add_if(true, {2, b, p});
  star.shared.add_if(true, {3, q, b});
  const std::vector<Position> normals{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 1}}};
  const auto cone = [&](internal::Index face) { return cone_of(normals[face]); };
  const internal::ConesOfStar free(star, b, false, cone), kept(star, b, true, cone);
  CHECK(free.is_complete());
  for (std::size_t i = 0; i < 2; ++i) {
    const NormalCone &of_free = free.faces()[i].cone, &of_kept = kept.faces()[i].cone;
    for (const Position& n : normals)
      CHECK(of_free.greatest_angle(n) <= 2 * of_free.half_angle() + 1e-12);
    CHECK(of_kept.greatest_angle(normals[1 - i]) > 2 * of_kept.half_angle() + 0.01);
  }
}

TEST_CASE("A face that would leave nothing at its edge stays where topology is free") {
  CHECK(run(test::triangle(), FaceCount{0}, Topology::free).report.faces_after == 0);
  const Run of = run(test::triangle(), FaceCount{0}, Topology::free, NormalDeviation{60});
  CHECK(of.report.faces_after == 1);
  CHECK(of.report.rejected(Rejection::normal_deviation) > 0);
}

TEST_CASE("Normals stay within the angle: closed surfaces, whatever the cost") {
  const Soup soup = bumpy(test::sphere(4), 0.1, 9);
  for (const double degrees : {15, 40, 80}) {
    CAPTURE(degrees);
    check(soup, degrees, FaceRatio{0.05});
    check<MemorylessQuadric>(soup, degrees, FaceRatio{0.05});
    check<EdgeLength>(soup, degrees, FaceRatio{0.05});
  }
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    run(test::random_closed(seed), FaceCount{4}, NormalDeviation{30});
}

TEST_CASE("Normals stay within the angle: borders, and sheets that meet") {
  for (const double degrees : {10, 30}) {
    check(waves(), degrees, FaceRatio{0.05});
    check(three_sheets(), degrees, FaceRatio{0.1});
    check(three_sheets(), degrees, FaceRatio{0.1}, Topology::free);
    check(waves(), degrees, FaceRatio{0.05}, Topology::components_may_vanish);
  }
}

TEST_CASE("Normals stay within the angle: where topology is free, and pairs are no edges") {
  const Soup sphere = bumpy(test::sphere(3), 0.1, 9);
  const Soup near = test::joined(sphere, sphere, {{0.01, 0.02, 0.03}});
  check(near, 40, FaceRatio{0.05}, Topology::free);
  check(near, 40, FaceRatio{0.05}, ThresholdPairs(0.08));
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    const Soup soup = test::with_noise(test::random_with_boundaries(seed), seed, 0.2);
    for (const auto topology : {Topology::kept, Topology::free, Topology::components_may_vanish}) {
      const Run of = run(soup, FaceCount{3}, topology, NormalFlip{180}, NormalDeviation{60});
      CHECK(of.deviation.greatest <= 60);
      const Run joining =
          run(soup, FaceCount{3}, ThresholdPairs(0.7), NormalFlip{180}, NormalDeviation{60});
      CHECK(joining.deviation.greatest <= 60);
    }
  }
}

TEST_CASE("Normals stay within the angle: in passes") {
  check(bumpy(test::sphere(5), 0.1, 9), 30, FaceRatio{0.1}, RelaxedOrder{});
  check(bumpy(test::sphere(5), 0.1, 9), 30, FaceRatio{0.1}, RelaxedOrder{.refresh = true});
  check(bumpy(test::sphere(5), 0.1, 9), 30, FaceRatio{0.1}, RelaxedOrder{}, Topology::free);
}

TEST_CASE("Normals stay within the angle: around a vertex of very many faces") {
  Soup cone;
  const std::uint32_t n = 400;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = 1 + 0.02 * std::sin(40 * angle);
    cone.points.push_back({{r * std::cos(angle), r * std::sin(angle), 0}});
    cone.triangles.push_back({i, (i + 1) % n, n});
    cone.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  cone.points.push_back({{0, 0, 0.5}});
  cone.points.push_back({{0, 0, -0.3}});
  check(cone, 20, FaceCount{8});
  check(cone, 20, FaceCount{8}, Topology::free);
}

TEST_CASE("Normals stay within the angle as they are written, in floats far from the origin") {
  Soup soup = bumpy(test::sphere(4), 0.1, 9);
  for (Position& p : soup.points)
    p += Position{{3000, 0, 0}};
  soup = test::as_floats(soup);
  check<Quadric, float>(soup, 30, FaceRatio{0.05});
  check<Quadric, float>(soup, 30, FaceRatio{0.05}, NoSelfIntersection{});
}

TEST_CASE("Normals stay within the angle at every step of a recording") {
  const Soup input = bumpy(test::sphere(2), 0.2, 5);
  test::Log log;
  std::vector<Position> points = input.points;
  test::PointSoup soup(input);
  simplify<MemorylessQuadric>(soup.points, soup.triangles, FaceCount{4}, NormalFlip{180},
                              NormalDeviation{50}, record_into(log));
  std::vector<std::uint32_t> image(points.size());
  for (std::uint32_t v = 0; v < image.size(); ++v)
    image[v] = v;
  std::set<std::uint32_t> left;
  for (std::uint32_t f = 0; f < input.triangles.size(); ++f)
    left.insert(f);
  REQUIRE(log.contractions.size() > 20);
  double greatest = 0;
  for (const test::KeptContraction& c : log.contractions) {
    for (std::uint32_t& v : image)
      v = v == c.gone ? c.kept : v;
    points[c.kept] = {{c.values[0], c.values[1], c.values[2]}};
    for (const std::uint32_t f : c.removed)
      left.erase(f);
    Soup now{points, {}};
    for (const std::uint32_t f : left) {
      const auto& [u, v, w] = input.triangles[f];
      now.triangles.push_back({image[u], image[v], image[w]});
    }
    const Deviation of = deviation(input, now, image, ~0u);
    REQUIRE(of.greatest <= 50);
    greatest = std::max(greatest, of.greatest);
  }
  CHECK(greatest > 35); // what is allowed is used
}

TEST_CASE("NormalDeviation: chosen at run time; what is no angle is refused") {
  const Soup soup = bumpy(test::sphere(3), 0.1, 9);
  const Run without = run(soup), with = run(soup, std::optional<NormalDeviation>());
  CHECK(test::is_same_surface(without.result, with.result, 0));
  CHECK_FALSE(with.report.normal_bound_degrees.has_value());
  for (const double degrees : {0.0, -1.0, 180.0, std::nan("")})
    CHECK_THROWS_AS(run(soup, NormalDeviation{degrees}), std::invalid_argument);
}

TEST_CASE("NormalDeviation: flat parts are contracted as ever, at any angle") {
  const Soup cube = test::cube(8);
  const Run of = run(cube, FaceCount{12}, NormalDeviation{0.01});
  INFO(of.report);
  CHECK(of.report.faces_after <= 24); // a face does not go onto a crease: each side keeps a vertex
  CHECK(of.deviation.greatest <= 0.01);
}
