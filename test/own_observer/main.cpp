// A surface has a part that is not of the library, see every_build.sh: has it followed
// contractions?
#include <quadrille/internal/core/call/run.h>
#include <quadrille/parameters.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <tuple>
#include <vector>

using namespace quadrille;

namespace {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

void make_torus(std::uint32_t n, std::uint32_t m, Points& points, Triangles& triangles) {
  const auto angle = [](std::uint32_t i, std::uint32_t count) {
    return 2 * std::numbers::pi * i / count;
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double r = 2 + std::cos(angle(j, m));
      points.push_back(
          {r * std::cos(angle(i, n)), r * std::sin(angle(i, n)), std::sin(angle(j, m))});
      const std::uint32_t i1 = (i + 1) % n, j1 = (j + 1) % m;
      triangles.push_back({i * m + j, i1 * m + j, i1 * m + j1});
      triangles.push_back({i * m + j, i1 * m + j1, i * m + j1});
    }
}

// Of how many each is made, without those that are gone, in ascending order.
std::vector<int> sizes(std::vector<int> of) {
  of.erase(std::remove(of.begin(), of.end(), 0), of.end());
  std::sort(of.begin(), of.end());
  return of;
}

bool is_right(bool is_expected, const char* what) {
  if (!is_expected)
    std::printf("wrong: %s\n", what);
  return is_expected;
}

template <class Order>
bool follows(const Order& order, bool packs) {
  Points points;
  Triangles triangles;
  make_torus(160, 80, points, triangles);
  const std::size_t vertices = points.size(), faces = triangles.size();
  std::vector<std::size_t> images(vertices);
  simplify(points, triangles, FaceRatio{0.05}, order,
           parameters::vertex_to_vertex_map(CGAL::make_property_map(images)));

  std::vector<int> of(points.size());
  for (const std::size_t image : images)
    ++of[image];
  const auto left = std::count_if(counted.faces.begin(), counted.faces.end(),
                                  [](int changes) { return changes >= 0; });
  const auto changed = std::count_if(counted.faces.begin(), counted.faces.end(),
                                     [](int changes) { return changes > 0; });
  return is_right(sizes(counted.vertices) == sizes(of), "vertices") &&
         is_right(left == static_cast<std::ptrdiff_t>(triangles.size()), "faces") &&
         is_right(2 * changed > left, "changes of faces") &&
         is_right((counted.vertices.size() < vertices) == packs, "packed vertices") &&
         is_right((counted.faces.size() < faces) == packs, "packed faces");
}

} // namespace

int main() {
  using internal::MergedVertices;
  static_assert(internal::RowsOf<std::tuple<MergedVertices&>>::bytes == sizeof(int));
  const bool greedy = follows(GreedyOrder{}, false);
  const bool passes = follows(RelaxedOrder{}, true);
  return greedy && passes ? 0 : 1;
}
