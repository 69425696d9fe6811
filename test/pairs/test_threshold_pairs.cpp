// Pairs closer than a threshold: which they are, and what becomes of them.
#include "on_all.h"

#include <quadrille/compiled/soup_pairs.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

using IndexPairs = std::vector<std::pair<std::size_t, std::size_t>>;

IndexPairs emitted(const auto& pairs, const Soup& soup) {
  IndexPairs all;
  pairs(SurfaceView{soup.points, soup.triangles},
        [&](std::size_t i, std::size_t j) { all.emplace_back(i, j); });
  return all;
}

IndexPairs closer_than(double t, const Soup& soup) {
  IndexPairs all;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    for (std::size_t j = i + 1; j < soup.points.size(); ++j)
      if (squared_distance(soup.points[i], soup.points[j]) < t * t)
        all.emplace_back(i, j);
  return all;
}

// Faces of which each of the points from `first` to `end` is a corner.
std::vector<Triangle> triangles_over(std::size_t end, std::size_t first = 0) {
  std::vector<Triangle> triangles;
  for (auto v = static_cast<std::uint32_t>(first); v + 2 < end; ++v)
    triangles.push_back({v, v + 1, v + 2});
  return triangles;
}

// n vertices at a position, with faces.
void add_coincident(Soup& soup, std::size_t n, const Position& p) {
  const std::size_t first = soup.points.size();
  soup.points.resize(first + n, p);
  for (const Triangle& t : triangles_over(first + n, first))
    soup.triangles.push_back(t);
}

Soup scaled(Soup soup, int exponent) {
  for (Position& p : soup.points)
    for (double& x : p.coordinates)
      x = std::ldexp(x, exponent);
  return soup;
}

Soup two_tetrahedra(double distance) {
  return joined(tetrahedron(), tetrahedron(), {{1 + distance, 0, 0}});
}

} // namespace

TEST_CASE("With t = 0 the result is that of EdgePairs, to the bit") {
  const std::uint64_t seed = GENERATE(range(0u, 6u));
  for (const Soup& soup : {random_closed(seed), random_with_boundaries(seed), two_parts()}) {
    const Result by_edges = OnSoup::run(soup, Quadric{}, EdgePairs{});
    const Result by_pairs = OnSoup::run(soup, Quadric{}, ThresholdPairs{0});
    CHECK(is_identical(by_pairs.soup, by_edges.soup));
    CHECK(by_pairs.report.error == by_edges.report.error);
    CHECK(by_pairs.report.rejections == by_edges.report.rejections);
    const Result mesh_by_edges = OnMesh<Mesh>::run(soup, Quadric{}, EdgePairs{});
    const Result mesh_by_pairs = OnMesh<Mesh>::run(soup, Quadric{}, ThresholdPairs{0});
    CHECK(is_identical(mesh_by_pairs.soup, mesh_by_edges.soup));
  }
}

TEST_CASE("With t = 0 a large flat surface in disorder is simplified as by EdgePairs") {
  const Soup soup = shuffled(grid(140, 140), 1); // full of pairs that cost the same
  const Result by_edges = OnSoup::run(soup, Quadric{}, EdgePairs{});
  const Result by_pairs = OnSoup::run(soup, Quadric{}, ThresholdPairs{0});
  CHECK(is_identical(by_pairs.soup, by_edges.soup));
}

TEST_CASE("Pairs are those closer than t: a distance of exactly t does not count") {
  Soup lattice; // its distances are often exactly 1, 2, 3 and 5 = |(3, 4, 0)|
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y)
      for (int z = 0; z < 2; ++z)
        lattice.points.push_back({{double(x), double(y), double(z)}});
  lattice.triangles = triangles_over(lattice.points.size());
  for (const double t : {0.5, 1.0, 2.0, 3.0, 5.0}) {
    CAPTURE(t);
    const double more = std::nextafter(t, 10);
    const IndexPairs expected = closer_than(t, lattice);
    CHECK(emitted(ThresholdPairs{t}, lattice) == expected);
    CHECK(emitted(ThresholdPairs{more}, lattice) == closer_than(more, lattice));
    if (t >= 1)
      CHECK(closer_than(more, lattice).size() > expected.size());
  }
  const Soup scattered = random_closed(3);
  for (const double t : {0.1, 0.3, 0.8})
    CHECK(emitted(ThresholdPairs{t}, scattered) == closer_than(t, scattered));
}

TEST_CASE("Parts exactly t apart stay apart, and join with a larger t") {
  const auto components = [](double t) {
    return OnSoup::run(two_tetrahedra(0.5), Quadric{}, FaceCount{6}, ThresholdPairs{t})
        .report.components_after;
  };
  CHECK(components(0.5) == 2);
  CHECK(components(std::nextafter(0.5, 1)) == 1);
}

TEST_CASE("A relative t is a fraction of the diagonal of the bounding box") {
  const Soup soup = two_parts();
  const double t = 0.07 * diagonal(soup);
  const IndexPairs relative = emitted(ThresholdPairs::relative(0.07), soup);
  CHECK(relative == closer_than(t, soup));
  CHECK(relative.size() > 100);
  CHECK(is_identical(OnSoup::run(soup, Quadric{}, ThresholdPairs::relative(0.07)).soup,
                     OnSoup::run(soup, Quadric{}, ThresholdPairs{t}).soup));
}

TEST_CASE("A threshold that is no distance is refused") {
  for (const double t :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(OnSoup::run(tetrahedron(), Quadric{}, ThresholdPairs{t}),
                    std::invalid_argument);
}

TEST_CASE("Too many pairs are refused with their number, and nothing is changed") {
  const Soup soup = sphere(3);
  const std::size_t n = soup.points.size();
  const std::string all = std::to_string(n * (n - 1) / 2);
  std::vector<Point> points = points_of(soup);
  auto triangles = soup.triangles;
  const auto before = points;
  CHECK_THROWS_MATCHES(simplify(points, triangles, ThresholdPairs::relative(2)), std::length_error,
                       Catch::Matchers::Predicate<std::length_error>([&](const auto& error) {
                         return std::string(error.what()).find(' ' + all + ' ') !=
                                std::string::npos;
                       }));
  CHECK(points == before);
  CHECK(triangles == soup.triangles);

  // The limit is 64 pairs a vertex.
  Soup many;
  add_coincident(many, 129, {{1, 2, 3}});
  CHECK(emitted(ThresholdPairs{1}, many).size() == 64 * 129);
  many.points.push_back({{1, 2, 3}});
  many.triangles.push_back({0, 1, 129});
  CHECK_THROWS_AS(emitted(ThresholdPairs{1}, many), std::length_error);
}

TEST_CASE("Coincident vertices are paired with each other, and with all that are close to them") {
  Soup soup = joined(random_closed(1), random_closed(1), {{0, 0, 0}});
  add_coincident(soup, 7, soup.points[5]);
  add_coincident(soup, 3, {{-0.0, 0.0, 0}});
  add_coincident(soup, 3, {{0.0, -0.0, 0}});
  soup = shuffled(soup, 2);
  for (const double t :
       {std::numeric_limits<double>::denorm_min(), 1e-300, 1e-160, 1e-9, 0.1, 0.3}) {
    CAPTURE(t);
    const IndexPairs expected = emitted(ThresholdPairs{t}, soup);
    CHECK(expected.size() >= soup.points.size() / 2);
    CHECK(expected == closer_than(std::max(t, 1e-100), soup));
  }
}

TEST_CASE("nanoflann finds the pairs that CGAL finds") {
  const auto agree = [](double t, const Soup& soup) {
    const IndexPairs expected = emitted(ThresholdPairs{t}, soup);
    CHECK(emitted(SoupPairs{t}, soup) == expected);
    return expected.size();
  };
  Soup lattice; // its distances are often exactly t
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 12; ++y)
      for (int z = 0; z < 12; ++z)
        lattice.points.push_back({{double(x), double(y), double(z)}});
  lattice.triangles = triangles_over(lattice.points.size());
  for (const double t : {1.0, std::nextafter(1.0, 2), 2.0, std::sqrt(2.0), std::sqrt(3.0)})
    agree(t, lattice);
  Soup crowd = joined(random_closed(2), random_closed(2), {{0, 0, 0}}); // all points twice
  add_coincident(crowd, 40, crowd.points[5]);
  add_coincident(crowd, 3, {{-0.0, 0.0, 0}});
  add_coincident(crowd, 3, {{0.0, -0.0, 0}});
  crowd = shuffled(crowd, 2);
  for (const double t : {std::numeric_limits<double>::denorm_min(), 1e-300, 1e-9, 0.1, 0.2})
    CHECK(agree(t, crowd) > 40 * 39 / 2);
  for (const int exponent : {-1060, -500, 500, 1020})
    agree(std::ldexp(0.1, exponent), scaled(crowd, exponent));
  Soup towards; // 2^-k, each half as far from the next: a tree that halves boxes is deep
  for (int k = 0; k < 900; ++k)
    towards.points.push_back({{std::ldexp(1, -k), std::ldexp(k % 3, -k), 1}});
  towards.triangles = triangles_over(towards.points.size());
  for (const double t : {1e-260, 1e-200, 1e-175})
    CHECK(agree(t, shuffled(towards, 1)) > 0);
  Soup beside; // no number lies between their x
  Random random(1);
  for (std::size_t i = 0; i < 3000; ++i)
    beside.points.push_back({{1 + random.below(2) * 0x1p-52, random(0, 0.01), 0}});
  beside.triangles = triangles_over(beside.points.size());
  CHECK(agree(1e-5, beside) > 3000);
}

TEST_CASE("nanoflann refuses what CGAL refuses, in the same words") {
  Soup many;
  add_coincident(many, 60'000, {{1, 2, 3}});
  const auto refusal = [&](const auto& pairs) {
    try {
      pairs.validate();
      emitted(pairs, many);
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const double t : {-1.0, std::numeric_limits<double>::infinity(), 1e-3}) {
    CHECK(refusal(SoupPairs{t}) != "");
    CHECK(refusal(SoupPairs{t}) == refusal(ThresholdPairs{t}));
  }
}

TEST_CASE("However many vertices lie at a place, they are refused and nothing breaks") {
  Soup many;
  add_coincident(many, 100'000, {{1, 2, 3}});
  Soup beside = grid(100, 100);
  add_coincident(beside, 60'000, {{0.3, 0.3, 1}});
  Soup neighbours; // no number lies between their x, and their y differ by less
  Random random(1);
  for (std::size_t i = 0; i < 100'000; ++i)
    neighbours.points.push_back({{1 + random.below(2) * 0x1p-52, random(0, 0x1p-52), 0}});
  neighbours.triangles = triangles_over(neighbours.points.size());
  for (const Soup& soup : {many, beside, neighbours}) {
    const std::size_t faces = soup.triangles.size();
    std::vector<Point> points = points_of(soup);
    auto triangles = soup.triangles;
    CHECK_THROWS_AS(simplify(points, triangles, ThresholdPairs{1e-3}), std::length_error);
    CHECK(triangles.size() == faces);
  }
  CHECK(emitted(ThresholdPairs::relative(0.1), many).empty()); // its box has no size
}

TEST_CASE("The pairs do not depend on the unit of the mesh") {
  const Soup soup = two_parts();
  const double t = 0.07 * diagonal(soup);
  const IndexPairs expected = closer_than(t, soup);
  CHECK(expected.size() > 100);
  for (const int exponent : {-900, -560, -30, 0, 30, 520, 900, 1020}) {
    CAPTURE(exponent);
    const Soup other = scaled(soup, exponent);
    CHECK(emitted(ThresholdPairs{std::ldexp(t, exponent)}, other) == expected);
    CHECK(emitted(ThresholdPairs::relative(0.07), other) == expected);
  }
}

TEST_CASE("The bounding box may be as large and as small as numbers are") {
  // The corners of a cube, and one point close to the first.
  Soup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.push_back({{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0}});
  soup.points.push_back({{-0.5, -1, -1}});
  soup.triangles = triangles_over(9);
  const IndexPairs expected{{0, 8}};
  for (const int exponent : {1023, 0, -1073}) { // the diagonal of the first is above all doubles
    CAPTURE(exponent);
    CHECK(emitted(ThresholdPairs::relative(0.2), scaled(soup, exponent)) == expected);
    CHECK(emitted(ThresholdPairs{std::ldexp(1, exponent)}, scaled(soup, exponent)) == expected);
  }
  CHECK(emitted(ThresholdPairs{std::numeric_limits<double>::max()}, soup).size() == 36);
  CHECK(emitted(ThresholdPairs{std::numeric_limits<double>::max()}, scaled(soup, -1000)).size() ==
        36);
  CHECK(emitted(ThresholdPairs::relative(1e300), scaled(soup, 1000)).size() == 36);
}

TEST_CASE("Points that no face uses make no pairs and do not count") {
  Soup soup = sphere(3);
  const double t = 0.2;
  const IndexPairs expected = closer_than(t, soup);
  CHECK_FALSE(expected.empty());
  const std::size_t n = soup.points.size();
  soup.points.resize(n + 300, {{1, 0, 0}});
  soup.points.push_back({{1e300, 0, 0}}); // nor is the size of the surface theirs
  soup.triangles.push_back({0, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n)});
  CHECK(emitted(ThresholdPairs{t}, soup) == expected);
  CHECK(emitted(ThresholdPairs::relative(t / std::sqrt(12)), soup) == expected);
  CHECK_NOTHROW(OnSoup::run(soup, Quadric{}, FaceRatio{0.5}, ThresholdPairs{1e-3}));

  soup.triangles.clear();
  CHECK(emitted(ThresholdPairs{t}, soup).empty());
}

TEST_CASE("Messages show small numbers as they are") {
  const auto shows = [](const std::string& number) {
    return Catch::Matchers::Predicate<std::exception>([=](const std::exception& error) {
      return std::string(error.what()).find(' ' + number + ' ') != std::string::npos;
    });
  };
  CHECK_THROWS_MATCHES(OnSoup::run(tetrahedron(), Quadric{}, ThresholdPairs{-1e-300}),
                       std::invalid_argument, shows("-1e-300"));
  Soup soup;
  add_coincident(soup, 130, {{1, 2, 3}});
  CHECK_THROWS_MATCHES(emitted(ThresholdPairs(1e-20), soup), std::length_error,
                       shows("64") && shows("8385"));
  CHECK_THROWS_WITH(emitted(ThresholdPairs(1e-20), soup),
                    Catch::Contains("closer than 1e-20, more"));
}

namespace {

// Every pair of the first corners of n triangles, in both directions and twice.
struct AllFirstCorners {
  std::size_t n;
  void operator()(const SurfaceView&, const EmitPair& emit) const {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (i != j) {
          emit(3 * i, 3 * j);
          emit(3 * i, 3 * j);
        }
  }
};

struct CountedMidpoint {
  std::size_t* count;
  auto operator()(const auto& cost, const auto& pair) const {
    ++*count;
    return MidpointPlacement{}(cost, pair);
  }
};

} // namespace

TEST_CASE("A refused pair comes back only when the faces around it have changed") {
  const Soup soup = test::with_noise(test::grid(9, 9), 1, 0.05);
  std::vector<test::Point> points = test::points_of(soup);
  std::vector<test::Triangle> triangles = soup.triangles;
  const std::size_t all_pairs = points.size() * (points.size() - 1) / 2;
  const Report report =
      simplify(points, triangles, FaceCount{0}, ThresholdPairs{100}, HighestDegree{6});
  INFO(report);
  CHECK(report.stop == StopReason::target_met);
  CHECK(report.rejected(Rejection::degree) > 0);
  CHECK(std::accumulate(report.rejections.begin(), report.rejections.end(), std::size_t{0}) <
        all_pairs);
}

TEST_CASE("No pair is there twice, at the beginning or after contractions") {
  const std::size_t n = 12;
  Soup soup;
  Random random(5);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Position p{{random(0, 1), random(0, 1), random(0, 1)}};
    soup.points.insert(soup.points.end(), {p, p + Position{{9, 1, 0}}, p + Position{{9, 0, 1}}});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  std::size_t evaluations = 0;
  const Result result = OnSoup::run(soup, Quadric{}, CountedMidpoint{&evaluations},
                                    AllFirstCorners{n}, FaceCount{0}, NormalFlip{180});
  CHECK(result.report.contractions == n - 1);
  CHECK(result.report.non_edge_contractions == n - 1);
  CHECK(result.report.stop == StopReason::no_pair_left);

  // All n(n − 1)/2 pairs once; then each contraction looks at its pair again, and of k vertices
  // that are left the new one makes a pair with k − 1.
  CHECK(evaluations == n * (n - 1));
}

TEST_CASE("Neither degenerate nor duplicate faces are ever left, but backs") {
  const std::uint64_t seed = GENERATE(0u, 1u, 2u);
  Soup soup = joined(random_closed(seed), random_with_boundaries(seed + 1), {{0.3, 0.2, 0.1}});
  for (std::size_t i = 0; i < 10; ++i) {
    const Triangle t = soup.triangles[7 * i];
    soup.triangles.push_back({t[2], t[1], t[0]}); // the other way round
    soup.triangles.push_back(t);
    soup.triangles.push_back({t[0], t[1], t[1]});
  }
  const double t = 0.1 * diagonal(soup);
  for (std::size_t faces = 0; faces < soup.triangles.size(); faces += 9) {
    CAPTURE(faces);
    REQUIRE(is_clean(OnSoup::run(soup, Quadric{}, FaceCount{faces}, ThresholdPairs{t}).soup, true));
    REQUIRE(is_clean(OnSoup::run(soup, Quadric{}, FaceCount{faces}).soup, true));
    REQUIRE(is_clean(
        OnSoup::run(soup, MemorylessQuadric{}, FaceCount{faces}, ThresholdPairs{t}, NormalFlip{180})
            .soup,
        true));
  }
}

TEST_CASE("Parts whose faces go in twos reach odd targets with pairs between them") {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto below_4 = [&] { return static_cast<double>(random.below(1024)) / 256; };
    Soup soup;
    for (std::size_t parts = 2 + random.below(6); parts > 0; --parts) {
      const Position place{{below_4() / 2, below_4() / 2, below_4() / 2}};
      soup = joined(soup, with_noise(octahedron(), random.below(1 << 20), 0.2), place);
    }
    const std::size_t target = 1 + 2 * random.below(soup.triangles.size() / 2);
    const ThresholdPairs pairs(0.3 + below_4());
    const auto check = [&]<class Placement>(Placement) {
      PointSoup result(soup);
      const Report report =
          simplify<Quadric, Placement>(result.points, result.triangles, FaceCount{target}, pairs,
                                       Topology::free, NormalFlip{180});
      INFO(report);
      REQUIRE(is_target_reached(report.stop));
      REQUIRE(report.faces_after <= target);
      REQUIRE(report.faces_after == result.triangles.size());
      REQUIRE(report.vertices_after == result.points.size());
      REQUIRE(without_isolated_points({soup.points, result.triangles}).points.size() ==
              result.points.size());
      auto mesh = make_mesh(soup);
      const Report of_mesh = simplify<Quadric, Placement>(mesh, FaceCount{target}, pairs);
      REQUIRE(of_mesh.faces_after == mesh.number_of_faces());
      REQUIRE(of_mesh.vertices_after == mesh.number_of_vertices());
      REQUIRE(is_valid_triangle_mesh(mesh));
    };
    check(OptimalPlacement{});
    check(EndpointPlacement{});
  }
}
