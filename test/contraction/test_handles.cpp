// SimplifiedTopology: tunnels and handles up to a size are cut, wider ones stay, and the surface
// stays a closed manifold.

#include "meshes.h"
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/guards.h>
#include <quadrille/levels.h>
#include <quadrille/manifold.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplified_topology.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::PointSoup;
using test::Position;
using test::Soup;

// --- Shapes with tunnels and handles of known widths ---------------------------------------------

struct Square {
  int x, y, width;
  bool has(int at_x, int at_y) const {
    return at_x >= x && at_x < x + width && at_y >= y && at_y < y + width;
  }
  bool is_apart_from(const Square& other) const {
    return x > other.x + other.width + 1 || other.x > x + width + 1 ||
           y > other.y + other.width + 1 || other.y > y + width + 1;
  }
};

constexpr int columns = 26, rows = 20;

/// Squares of these widths, somewhere on a plate, apart from each other.
std::vector<Square> squares(std::uint64_t seed, const std::vector<int>& widths) {
  test::Random random(seed);
  std::vector<Square> result;
  for (const int width : widths)
    for (bool is_placed = false; !is_placed;) {
      const auto most = [width](int cells) { return static_cast<std::size_t>(cells - width - 4); };
      const Square square{2 + static_cast<int>(random.below(most(columns))),
                          2 + static_cast<int>(random.below(most(rows))), width};
      is_placed = true;
      for (const Square& other : result)
        is_placed &= square.is_apart_from(other);
      if (is_placed)
        result.push_back(square);
    }
  return result;
}

bool is_in(const std::vector<Square>& squares, int x, int y) {
  for (const Square& square : squares)
    if (square.has(x, y))
      return true;
  return false;
}

Soup plate(const std::vector<Square>& holes) {
  return test::surface_of_cubes(columns, rows, 4,
                                [&](int x, int y, int) { return !is_in(holes, x, y); });
}

/// Walls of two cubes around a hollow room, with holes in one of them.
Soup shell(const std::vector<Square>& holes) {
  return test::surface_of_cubes(columns, rows, 10, [&](int x, int y, int z) {
    const bool is_wall = x < 2 || y < 2 || z < 2 || x >= columns - 2 || y >= rows - 2 || z >= 8;
    return is_wall && (z >= 2 || !is_in(holes, x, y));
  });
}

/// Two plates with posts between them.
Soup posts(const std::vector<Square>& posts) {
  return test::surface_of_cubes(columns, rows, 10, [&](int x, int y, int z) {
    return z < 3 || z >= 7 || is_in(posts, x, y);
  });
}

/// Each point goes half of the way to the mean of its neighbours, several times.
Soup smoothed(Soup soup, int times) {
  for (int i = 0; i < times; ++i) {
    std::vector<Position> sum(soup.points.size());
    std::vector<double> count(soup.points.size());
    for (const auto& t : soup.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        sum[t[k]] += soup.points[t[(k + 1) % 3]];
        ++count[t[k]];
      }
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      soup.points[v] = 0.5 * soup.points[v] + 0.5 / count[v] * sum[v];
  }
  return soup;
}
Soup smooth_plate(const std::vector<Square>& holes) {
  return smoothed(plate(holes), 3);
}

struct Shape {
  const char* name;
  Soup (*make)(const std::vector<Square>&);
};
constexpr std::array<Shape, 4> shapes{
    {{"plate", plate}, {"shell", shell}, {"posts", posts}, {"smooth plate", smooth_plate}}};

const std::vector<int> widths{1, 4, 2, 1, 2, 1};

/// What is left of a shape once all that is narrower than a size has been filled or taken away.
Soup filled(const Shape& shape, std::vector<Square> squares, double size) {
  std::erase_if(squares, [size](const Square& square) { return square.width < size; });
  return shape.make(squares);
}

Soup soup_of(const PointSoup& points) {
  Soup soup{{}, points.triangles};
  for (const auto& p : points.points)
    soup.points.push_back(test::to_position(p));
  return soup;
}

template <class... Arguments>
std::pair<Soup, Report> simplified(const Soup& input, const Arguments&... arguments) {
  PointSoup soup(input);
  const Report report = simplify(soup.points, soup.triangles, arguments...);
  return {soup_of(soup), report};
}

void require_manifold(const Soup& soup) {
  const auto topology = test::topology_of(soup);
  CAPTURE(topology);
  CHECK(topology.is_closed());
  CHECK(topology.is_manifold);
  CHECK(topology.is_oriented);
  CHECK(!topology.has_duplicate_faces);
}

/// The parts that a shape has, and how many handles they have together.
std::pair<std::size_t, long> parts_and_genus(const Soup& soup) {
  const auto topology = test::topology_of(soup);
  return {topology.components, topology.genus()};
}

/// A shape without tunnels and handles below a size, where few faces are left.
template <class... Arguments>
void check(const Shape& shape, std::uint64_t seed, double size, const Arguments&... arguments) {
  INFO(shape.name << ", seed " << seed << ", size " << size);
  const auto holes = squares(seed, widths);
  const Soup input = shape.make(holes);
  const auto [result, report] =
      simplified(input, FaceCount{76}, SimplifiedTopology{size}, arguments...);
  require_manifold(result);
  const auto before = parts_and_genus(input), after = parts_and_genus(result);
  CHECK(after.second == parts_and_genus(filled(shape, holes, size)).second);
  CHECK(before.second == after.second + static_cast<long>(report.cut_handles));
  CHECK(report.components_before == before.first);
  CHECK(report.components_after == after.first);
  CHECK(after.first == before.first + report.split_components);
  CHECK(result.triangles.size() == report.faces_after);
  CHECK(result.points.size() == report.vertices_after);
}

/// A plate with a narrow tunnel and a wide one.
Soup two_tunnels() {
  return plate({{4, 4, 1}, {12, 8, 5}});
}

} // namespace

TEST_CASE("What is narrower than the size goes, all else stays") {
  for (const Shape& shape : shapes)
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      for (double size : {0., 0.4, 1.5, 3.})
        check(shape, seed, size);
}

TEMPLATE_TEST_CASE("Other costs cut as well", "", MemorylessQuadric, ThinFeatureQuadric) {
  for (const Shape& shape : shapes)
    check(shape, 1, 1.5, TestType());
}

TEST_CASE("Passes leave the cuts to the greedy order after them") {
  for (const Shape& shape : shapes) {
    check(shape, 1, 1.5, RelaxedOrder{});
    check(shape, 2, 1.5, RelaxedOrder{.refresh = true});
  }
}

TEST_CASE("A tunnel that alone joins two walls parts them, and a limb stays however thin") {
  // A hollow box with one hole in its wall: the room gets a surface of its own.
  const auto [room, of_room] =
      simplified(shell({{8, 8, 1}}), FaceCount{24}, SimplifiedTopology{1.5});
  require_manifold(room);
  CHECK(of_room.cut_handles == 0);
  CHECK(of_room.split_components == 1);
  CHECK(of_room.components_after == 2);
  // Two blocks joined by a bar.
  const Soup bar = test::surface_of_cubes(
      30, 8, 8, [](int x, int y, int z) { return x < 8 || x >= 22 || (y == 4 && z == 4); });
  const auto [limbs, of_limbs] = simplified(bar, FaceCount{16}, SimplifiedTopology{1.5});
  require_manifold(limbs);
  CHECK(of_limbs.split_components + of_limbs.cut_handles == 0);
  CHECK(of_limbs.components_after == 1);
}

TEST_CASE("A size of nothing cuts nothing, to the same bits") {
  const Soup input = two_tunnels();
  const auto [plain, report] = simplified(input, FaceCount{60});
  CHECK(test::is_identical(plain, simplified(input, FaceCount{60}, SimplifiedTopology{0}).first));
  CHECK(report.cut_handles == 0);
  const std::optional<SimplifiedTopology> none;
  CHECK(test::is_identical(plain, simplified(input, FaceCount{60}, none).first));
}

TEST_CASE("Small parts may vanish beside cuts, with what was cut of them") {
  Soup input = two_tunnels();
  Soup ring = test::torus(24, 12); // a small one, with a hole of its own
  for (Position& p : ring.points)
    p = 0.4 * p;
  for (int i = 0; i < 5; ++i)
    input = test::joined(input, ring, {{4. * i, -6, 0}});
  const auto [result, report] =
      simplified(input, FaceCount{30}, SimplifiedTopology{1.5}, Topology::components_may_vanish);
  require_manifold(result);
  CHECK(report.faces_after <= 30);
  CHECK(report.components_before == 6);
  CHECK(report.components_after == test::topology_of(result).components);
  CHECK(report.vanished_components + report.components_after ==
        report.components_before + report.split_components);
}

TEST_CASE("Nothing is cut at what is fixed") {
  const Soup input = two_tunnels();
  std::vector<unsigned char> is_fixed(input.points.size());
  for (std::size_t v = 0; v < is_fixed.size(); ++v) {
    const Position& p = input.points[v];
    is_fixed[v] = p[0] >= 4 && p[0] <= 5 && p[1] >= 4 && p[1] <= 5;
  }
  const auto [result, report] =
      simplified(input, FaceCount{60}, SimplifiedTopology{1.5},
                 CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_fixed)));
  CHECK(report.cut_handles == 0);
  CHECK(test::topology_of(result).genus() == 2);
}

TEST_CASE("Maps name the points of the input, and added points come behind them") {
  const Soup input = two_tunnels();
  PointSoup soup(input);
  std::vector<std::size_t> image(input.points.size(), 0);
  const Report report =
      simplify(soup.points, soup.triangles, FaceCount{24}, SimplifiedTopology{1.5},
               parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  CHECK(report.cut_handles == 1);
  std::vector<bool> is_named(soup.points.size());
  for (const std::size_t v : image)
    is_named.at(v) = true;
  std::size_t added = 0;
  for (const bool is : is_named)
    added += !is;
  CHECK(added <= 3);
}

TEST_CASE("The map of faces names those of the input, and not those of cuts") {
  const Soup input = two_tunnels();
  PointSoup soup(input);
  std::vector<std::size_t> faces(input.triangles.size() + 8, 7777);
  const Report report =
      simplify(soup.points, soup.triangles, FaceCount{24}, SimplifiedTopology{1.5},
               parameters::face_to_face_map(CGAL::make_property_map(faces)));
  CHECK(report.cut_handles == 1);
  for (std::size_t f = 0; f < faces.size(); ++f)
    CHECK((faces[f] == 7777) == (f >= input.triangles.size()));
}

TEST_CASE("Edges are counted with those of cuts") {
  const auto [result, report] = simplified(two_tunnels(), EdgeCount{36}, SimplifiedTopology{1.5});
  CHECK(report.cut_handles == 1);
  CHECK(test::topology_of(result).edges == 36);
}

TEST_CASE("Simplified topology goes with what knows its faces") {
  const Soup input = two_tunnels();
  const auto complaint = [&](const auto&... arguments) -> std::string {
    PointSoup soup(input);
    try {
      simplify(soup.points, soup.triangles, SimplifiedTopology{1}, arguments...);
    } catch (const std::invalid_argument& error) {
      CHECK(test::is_identical(soup_of(soup), input));
      return error.what();
    }
    return "";
  };
  CHECK(complaint() == "");
  CHECK_THAT(complaint(Topology::free), Catch::Contains("does not go with Topology::free"));
  CHECK_THAT(complaint(ThresholdPairs(1)), Catch::Contains("pairs that are not edges"));
  CHECK_THAT(complaint(DistanceLimit(1)), Catch::Contains("needs distances"));
  CHECK_THAT(complaint(NoSelfIntersection{}), Catch::Contains("a guard"));
  Levels levels;
  CHECK_THAT(complaint(record_into(levels)), Catch::Contains("a recorder"));
  std::vector<int> labels(input.triangles.size());
  CHECK_THAT(complaint(Labels{CGAL::make_property_map(labels)}), Catch::Contains("labels"));
  for (const double size : {-1., std::numeric_limits<double>::infinity()})
    CHECK_THROWS_WITH(simplified(input, SimplifiedTopology{size}), Catch::Contains("is no length"));
}

TEST_CASE("Arrays that cannot grow have room for what is cut, or throw") {
  const Soup input = two_tunnels();
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  for (const Position& p : input.points)
    points.insert(points.end(), p.coordinates.begin(), p.coordinates.end());
  for (const auto& t : input.triangles)
    triangles.insert(triangles.end(), t.begin(), t.end());
  const Report report =
      simplify(std::span(points), std::span(triangles), FaceCount{24}, SimplifiedTopology{1.5});
  CHECK(report.cut_handles == 1);
  CHECK(report.faces_after == 24);
}
