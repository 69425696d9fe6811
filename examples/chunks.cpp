// A terrain that is simplified in two pieces, each by itself, which fit afterwards: pieces [STEPS]
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Triangle = std::array<std::size_t, 3>;

struct Surface {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

Surface terrain(std::size_t steps) {
  Surface surface;
  for (std::size_t j = 0; j <= steps; ++j)
    for (std::size_t i = 0; i <= steps; ++i) {
      const double x = double(i) / double(steps), y = double(j) / double(steps);
      surface.points.emplace_back(x, y, 0.1 * std::sin(9 * x + 4 * y * y) * std::cos(7 * y));
    }
  for (std::size_t j = 0; j < steps; ++j)
    for (std::size_t i = 0; i < steps; ++i) {
      const std::size_t v = j * (steps + 1) + i, w = v + steps + 1;
      surface.triangles.push_back({v, v + 1, w});
      surface.triangles.push_back({v + 1, w + 1, w});
    }
  return surface;
}

// How many edges have so many faces.
std::map<int, int> edges(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::size_t, std::size_t>, int> faces;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++faces[std::minmax({t[i], t[(i + 1) % 3]})];
  std::map<int, int> count;
  for (const auto& [edge, number] : faces)
    ++count[number];
  return count;
}

int main(int argc, char** argv) {
  const Surface whole = terrain(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200);
  const std::vector<Point>& points = whole.points;
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());

  // A wavy line cuts it. A point is shared if faces of both sides have it.
  std::array<std::vector<Triangle>, 2> sides;
  std::array<std::vector<bool>, 2> is_on{std::vector<bool>(points.size()),
                                         std::vector<bool>(points.size())};
  for (const Triangle& t : whole.triangles) {
    const bool side = points[t[0]].x() > 0.5 + 0.1 * std::sin(20 * points[t[0]].y());
    sides[side].push_back(t);
    for (const std::size_t v : t)
      is_on[side][v] = true;
  }
  std::vector<int> is_shared(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    is_shared[v] = is_on[0][v] && is_on[1][v];

  // Each piece knows its own faces only. Both have the scale of the whole, and one limit.
  Surface sewn;
  std::map<std::size_t, std::size_t> merged_shared; // of each shared point, its new number
  for (std::vector<Triangle>& triangles : sides) {
    std::vector<Point> left = points;
    std::vector<std::size_t> image(points.size());
    const quadrille::Report report = quadrille::simplify<quadrille::MemorylessQuadric>(
        left, triangles, quadrille::CostLimit{1e-12},
        quadrille::parameters::vertex_is_shared_map(CGAL::make_property_map(is_shared))
            .vertex_to_vertex_map(CGAL::make_property_map(image))
            .bounding_box(box));
    std::cout << report << '\n';

    constexpr std::size_t none = ~std::size_t{0};
    std::vector<std::size_t> number(left.size(), none); // of each point that is left, when sewn
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (!is_shared[v])
        continue;
      if (left[image[v]] != points[v])
        return EXIT_FAILURE; // it has stayed, bit by bit
      const auto [at, is_new] = merged_shared.try_emplace(v, sewn.points.size());
      if (is_new)
        sewn.points.push_back(points[v]);
      number[image[v]] = at->second;
    }
    for (std::size_t i = 0; i < left.size(); ++i)
      if (number[i] == none) {
        number[i] = sewn.points.size();
        sewn.points.push_back(left[i]);
      }
    for (const auto& [a, b, c] : triangles)
      sewn.triangles.push_back({number[a], number[b], number[c]});
  }
  const std::map<int, int> count = edges(sewn.triangles);
  std::cout << sewn.triangles.size() << " faces; edges of one face: " << count.at(1)
            << ", of two: " << count.at(2) << '\n';
  return count.size() == 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
