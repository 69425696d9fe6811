// Maps between the input and its levels, by plain arithmetic on their rows.
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/level_maps.h>
#include <quadrille/levels.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/stop.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A soup with its simplification, its levels and the maps to the coarsest one.
struct Mapped {
  template <class... Policies>
  explicit Mapped(Soup soup, const Policies&... policies) : input(std::move(soup)) {
    for (const Position& p : input.points)
      points.push_back(p.coordinates);
    triangles = input.triangles;
    report = simplify(points, triangles, policies..., record_into(levels));
    new_of_old = old_to_new(levels, levels.coarsest());
    old_of_new = new_to_old(levels, levels.coarsest());
  }

  // The positions of the rows on a surface.
  std::vector<Position> places_of_old() const {
    std::vector<Position> result;
    for (const std::array<double, 3>& p : points)
      result.push_back({p});
    return new_of_old * result;
  }
  std::vector<Position> places_of_new() const { return old_of_new * input.points; }

  Soup input;
  Points points;
  Triangles triangles;
  Levels levels;
  Report report;
  SparseRows new_of_old, old_of_new;
};

std::size_t length(const SparseRows& rows, std::size_t row) {
  return static_cast<std::size_t>(rows.begins[row + 1] - rows.begins[row]);
}

// Requires rows as they are promised. Returns the number of empty ones.
std::size_t require_rows(const SparseRows& rows, std::size_t count, std::size_t columns) {
  REQUIRE(rows.rows() == count);
  REQUIRE(rows.columns == columns);
  REQUIRE(rows.indices.size() == rows.weights.size());
  REQUIRE(rows.begins.front() == 0);
  REQUIRE(rows.begins.back() == static_cast<std::int64_t>(rows.indices.size()));
  std::size_t empty = 0;
  for (std::size_t row = 0; row < count; ++row) {
    double sum = 0;
    for (auto i = static_cast<std::size_t>(rows.begins[row]);
         i < static_cast<std::size_t>(rows.begins[row + 1]); ++i) {
      REQUIRE(rows.weights[i] > 0);
      REQUIRE(rows.indices[i] >= 0);
      REQUIRE(rows.indices[i] < static_cast<std::int64_t>(columns));
      REQUIRE((i == static_cast<std::size_t>(rows.begins[row]) ||
               rows.indices[i - 1] < rows.indices[i]));
      sum += rows.weights[i];
    }
    empty += length(rows, row) == 0;
    REQUIRE(length(rows, row) <= 3);
    REQUIRE((length(rows, row) == 0 || std::abs(sum - 1) < 1e-15));
  }
  return empty;
}

// The same of both maps. Returns the number of empty rows of vertices of the input.
std::size_t require_rows(const Mapped& mapped) {
  CHECK(require_rows(mapped.old_of_new, mapped.points.size(), mapped.input.points.size()) == 0);
  return require_rows(mapped.new_of_old, mapped.input.points.size(), mapped.points.size());
}

double farthest_pair(const std::vector<Position>& a, const std::vector<Position>& b) {
  double farthest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    farthest = (std::max)(farthest, std::sqrt(squared_distance(a[i], b[i])));
  return farthest;
}

std::vector<Position> positions_of(const Points& points) {
  std::vector<Position> positions;
  for (const std::array<double, 3>& p : points)
    positions.push_back({p});
  return positions;
}

bool is_identity(const SparseRows& rows) {
  for (std::size_t row = 0; row < rows.rows(); ++row)
    if (length(rows, row) != 1 || rows.indices[row] != static_cast<std::int64_t>(row) ||
        rows.weights[row] != 1)
      return false;
  return rows.rows() == rows.columns;
}

TEST_CASE("where nothing is contracted, maps are the identity") {
  const Mapped mapped(torus(12, 8), FaceCount{192});
  CHECK(is_identity(mapped.new_of_old));
  CHECK(is_identity(mapped.old_of_new));
}

TEST_CASE("vertices go no further than the surface is known to be") {
  std::vector<Soup> soups = {with_noise(sphere(3), 1, 0.005),
                             torus(30, 18),
                             cube(8),
                             plate_with_holes(3, 4),
                             with_noise(open_cylinder(24, 16), 2, 0.005),
                             with_noise(grid(24, 24), 3, 0.005)};
  soups.push_back(torus(24, 14)); // every second face the other way round
  for (std::size_t face = 0; face < soups.back().triangles.size(); face += 2)
    std::swap(soups.back().triangles[face][1], soups.back().triangles[face][2]);
  for (const Soup& soup : soups)
    for (const double limit : {0.02, 0.1}) {
      const Mapped mapped(soup, HausdorffLimit{limit});
      CAPTURE(limit, soup.points.size(), mapped.points.size());
      CHECK(require_rows(mapped) == 0);
      CHECK((limit < 0.1 || mapped.points.size() < soup.points.size()));
      CHECK(farthest_pair(mapped.input.points, mapped.places_of_old()) <=
            mapped.report.hausdorff_bound);
      CHECK(farthest_pair(positions_of(mapped.points), mapped.places_of_new()) <=
            mapped.report.hausdorff_bound);
    }
}

TEST_CASE("on planes, maps reproduce places, and so linear fields") {
  for (const bool is_relaxed : {false, true}) {
    const Soup soup = tilted(mapped(grid(20, 12), [](Position p) {
      p[0] *= 1 + p[1] / 3;
      return p;
    }));
    const auto check = [&](const Mapped& mapped) {
      CHECK(require_rows(mapped) == 0);
      CHECK(mapped.points.size() < 30);
      CHECK(farthest_pair(mapped.input.points, mapped.places_of_old()) < 1e-14);
      CHECK(farthest_pair(positions_of(mapped.points), mapped.places_of_new()) < 1e-14);
    };
    if (is_relaxed)
      check(Mapped(soup, AnyOf{FaceCount{20}, DistanceLimit{1e-9}}, RelaxedOrder{}));
    else
      check(Mapped(soup, AnyOf{FaceCount{20}, DistanceLimit{1e-9}}));
  }
}

TEST_CASE("the places of vertices that are vertices of the input are these") {
  const Mapped mapped(torus(30, 20), Quadric{}, EndpointPlacement{}, FaceCount{200});
  require_rows(mapped);
  for (std::size_t row = 0; row < mapped.points.size(); ++row) {
    REQUIRE(length(mapped.old_of_new, row) == 1);
    const auto old = static_cast<std::size_t>(mapped.old_of_new.indices[row]);
    REQUIRE(mapped.input.points[old].coordinates == mapped.points[row]);
    REQUIRE(length(mapped.new_of_old, old) == 1); // and back
    const auto begin = static_cast<std::size_t>(mapped.new_of_old.begins[old]);
    REQUIRE(mapped.new_of_old.indices[begin] == static_cast<std::int64_t>(row));
  }
}

TEST_CASE("rows of what vanishes and of points without a face are empty") {
  Soup soup = joined(sphere(3),
                     mapped(sphere(1),
                            [](Position p) {
                              p *= 0.01;
                              return p;
                            }),
                     {{3, 0, 0}});
  const std::size_t connected = soup.points.size();
  soup.points.push_back({{9, 9, 9}});
  const Mapped mapped(soup, FaceCount{100}, Topology::components_may_vanish);
  CHECK(mapped.report.vanished_components == 1);
  const std::size_t of_first = sphere(3).points.size();
  CHECK(require_rows(mapped) == connected - of_first + 1);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    CHECK((length(mapped.new_of_old, v) == 0) == (v >= of_first));
}

TEST_CASE("places on the last face of a vertex move to the faces next to it") {
  Soup soup = with_noise(grid(6, 6), 1, 0.05);
  const auto first = static_cast<std::uint32_t>(soup.points.size()); // a narrow fin at vertex 0
  soup.points.push_back(soup.points[0] + Position{{-0.1, 0, 0}});
  soup.points.push_back(soup.points[0] + Position{{-0.1, 1e-7, 0}});
  soup.triangles.push_back({0, first + 1, first});
  const Mapped mapped(soup, FaceCount{72}, Topology::free);
  CHECK(mapped.points.size() == first); // only the fin has gone
  CHECK(require_rows(mapped) == 0);
  const std::vector<Position> places = mapped.places_of_old();
  for (const std::uint32_t v : {first, first + 1})
    CHECK(std::sqrt(squared_distance(places[v], soup.points[0])) < 1e-6);
}

TEST_CASE("maps of surfaces of any kind") {
  const auto is_solid = [](int i, int j, int k) { return (i + j + k) % 3 != 0; };
  const Soup cubes = surface_of_cubes(5, 5, 5, is_solid);
  Soup doubled = grid(12, 12); // with both sides
  for (std::size_t face = 0, count = doubled.triangles.size(); face < count; ++face) {
    const auto [a, b, c] = doubled.triangles[face];
    doubled.triangles.push_back({a, c, b});
  }
  for (const Soup& soup : {cubes, doubled}) {
    const Mapped kept(soup, AnyOf{FaceCount{150}, HausdorffLimit{0.4}});
    CHECK(require_rows(kept) == 0);
    CHECK(farthest_pair(kept.input.points, kept.places_of_old()) <= kept.report.hausdorff_bound);
    const Mapped free(soup, FaceCount{60}, Topology::free, ThresholdPairs{0.3});
    CHECK(require_rows(free) < soup.points.size() / 2);
  }
}

TEST_CASE("both sides of a thin plate stay apart, even where it is thinner than the error") {
  const Soup block = cube(16);
  const Soup plate = mapped(block, [](Position p) {
    p[2] = 0.002 * p[2] + 0.02 * std::sin(9 * p[0]) * std::cos(7 * p[1]);
    return p;
  });
  const Mapped mapped(plate, FaceCount{100});
  const Levels& levels = mapped.levels;
  const auto places = carried_places(levels, levels.finest(), levels.coarsest(),
                                     internal::surface_of_input(levels).places());
  const Level level = levels.at(FaceCount{100});
  const internal::CornersByFace corners =
      internal::corners_by_face(level.triangles, level.input_faces);
  std::size_t count = 0, turned = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const auto& [x, y, z] = block.points[v].coordinates;
    if ((z > 0 && z < 1) || x == 0 || x == 1 || y == 0 || y == 1) // at the walls
      continue;
    const auto& [a, b, c] = corners[places[v].face];
    const Position normal = double_area_vector(Position{level.points[a]}, Position{level.points[b]},
                                               Position{level.points[c]});
    ++count;
    turned += (normal[2] > 0) != (z == 1);
  }
  CHECK(count == 2 * 15 * 15);
  CHECK(turned < count / 50);
  CHECK(farthest_pair(mapped.places_of_old(), plate.points) > 0.002); // the error is larger
}

TEST_CASE("maps do not depend on the unit") {
  const Soup soup = with_noise(torus(20, 12), 5, 0.01);
  const Mapped mapped(soup, FaceCount{60});
  for (const double unit : {0x1p-600, 0x1p900}) {
    Soup other = soup;
    for (Position& p : other.points)
      p *= unit;
    const Mapped scaled(other, FaceCount{60});
    CHECK(scaled.new_of_old.indices == mapped.new_of_old.indices);
    CHECK(scaled.new_of_old.weights == mapped.new_of_old.weights);
    CHECK(scaled.old_of_new.weights == mapped.old_of_new.weights);
  }
}

TEST_CASE("places on any level, and the result of a mesh") {
  const Soup soup = with_noise(sphere(3), 7, 0.01);
  Levels levels;
  Mesh mesh = make_mesh(soup);
  simplify(mesh, FaceCount{50}, record_into(levels));
  const LevelInfo middle = levels.info(FaceCount{400});
  const SparseRows rows = old_to_new(levels, middle);
  require_rows(rows, soup.points.size(), middle.vertices);
  const Level level = in_input_order(levels.at(FaceCount{400}));
  CHECK(farthest_pair(rows * positions_of(level.points), soup.points) < 0.1);

  std::vector<SurfacePlace> places{{level.input_faces[7], {0.2, 0.3, 0.5}}, {}};
  const auto coarse = carried_places(levels, middle, levels.coarsest(), places);
  CHECK(coarse[0].face != not_recorded);
  CHECK(coarse[1].face == not_recorded); // nowhere stays nowhere
  const auto there = carried_places(levels, middle, middle, places);
  CHECK(there[0].face == places[0].face);
  CHECK(there[0].weights == places[0].weights);
  places[0].face = levels.at(FaceCount{500}).input_faces.back();
  CHECK_THROWS_AS(carried_places(levels, middle, middle, places), std::invalid_argument);
}

} // namespace
