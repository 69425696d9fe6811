// Vertices of very many faces, most of whose contractions are refused, cost about the square of
// these, not the cube.
#include "contractions.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <boost/property_map/function_property_map.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Soup;

// A fan of n faces round its first point, over a polygon with teeth.
Soup fan(std::uint32_t n) {
  Soup soup;
  soup.points.push_back({{0, 0, 0}});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double radius = i / 2 % 2 == 0 ? 0.85 : 1;
    soup.points.push_back({{radius * std::cos(angle), radius * std::sin(angle), 0}});
    soup.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return soup;
}

// A gear: two such fans and a strip between them.
Soup gear(std::uint32_t n) {
  Soup soup = fan(n);
  for (auto& [a, b, c] : soup.triangles)
    std::swap(b, c);
  soup = test::joined(std::move(soup), fan(n), {{0, 0, 0.3}});
  const std::uint32_t top = n + 1;
  for (std::uint32_t i = 1; i <= n; ++i) {
    const std::uint32_t j = i % n + 1;
    soup.triangles.push_back({i, j, top + j});
    soup.triangles.push_back({i, top + j, top + i});
  }
  return soup;
}

template <class Cost, class... Order>
void require_little_work(Mesh mesh, double ratio, const Order&... order) {
  const std::size_t faces = mesh.number_of_faces();
  const Report report = simplify<Cost, OptimalPlacement>(mesh, FaceRatio{ratio}, order...);
  INFO(report);
  REQUIRE(test::is_valid_triangle_mesh(mesh));
  if (ratio > 0)
    CHECK(report.stop == StopReason::target_met);
  else
    CHECK(mesh.number_of_faces() <= 16);
  const std::size_t rejected =
      std::accumulate(report.rejections.begin(), report.rejections.end(), std::size_t{0});
  CHECK(rejected < 32 * faces);
}

// Lets points go to the origin, and only from far on one side, in the engine's unit.
struct OnlyFarOnes {
  double least_x;

  bool is_far(const Vector<3>& p) const { return p[0] > least_x; }
  bool allows(const auto& contraction) const {
    for (const auto& f : contraction.faces())
      if (f.before != f.after && (!is_far(f.before) || f.after != Vector<3>{}))
        return false;
    return true;
  }
};

} // namespace

TEST_CASE("Pairs of a vertex of many faces are not all looked at again at each change") {
  for (const Soup& soup : {gear(800), fan(2000)})
    for (double ratio : {0.5, 0.0}) {
      const Mesh mesh = test::make_mesh(soup);
      require_little_work<Quadric>(mesh, ratio);
      require_little_work<MemorylessQuadric>(mesh, ratio);
      require_little_work<Quadric>(mesh, ratio, RelaxedOrder{});
    }
}

TEST_CASE("Dear pairs of a vertex of many faces get their turn when the cheap ones are refused") {
  Soup soup = test::large(gear(100));
  for (std::size_t v = 1; v < soup.points.size(); ++v) // the other side gets nearer
    soup.points[v][0] += 0x1p19;
  const OnlyFarOnes filter{0x1.8p19};
  std::vector<test::Point> points = test::points_of(soup);
  const auto is_first =
      boost::make_function_property_map<std::size_t>([](std::size_t v) { return v == 0; });
  const Report report = simplify<EdgeLength, MidpointPlacement>(
      points, soup.triangles, FaceCount{0}, filter, NormalFlip{180},
      CGAL::parameters::vertex_is_constrained_map(is_first));
  INFO(report);
  CHECK(report.contractions > 4); // until fewer than one in 64 of those that waited can be done
}
