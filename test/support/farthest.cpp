// A translation unit of its own, as CGAL's tree takes long to compile.
#include "farthest.h"

#include "meshes.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test {

struct Nearest::Tree {
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

Nearest::Nearest(const Soup& soup) : tree_(std::make_unique<Tree>()) {
  for (const auto& [a, b, c] : soup.triangles)
    tree_->triangles.emplace_back(to_point<Point>(soup.points[a]), to_point<Point>(soup.points[b]),
                                  to_point<Point>(soup.points[c]));
  tree_->tree.insert(tree_->triangles.begin(), tree_->triangles.end());
  tree_->tree.build();
}

Nearest::Nearest(Nearest&&) noexcept = default;
Nearest::~Nearest() = default;

double Nearest::distance(const Position& p) const {
  return std::sqrt(tree_->tree.squared_distance(to_point<Point>(p)));
}

double farthest(const Soup& from, const Soup& to, int steps) {
  const Nearest nearest(to);
  double most = 0;
  for (const Triangle& t : from.triangles)
    for_each_point(from, t, steps,
                   [&](const Position& p) { most = std::max(most, nearest.distance(p)); });
  return most;
}

double greatest_coordinate(const Soup& soup) {
  double greatest = 0;
  for (const Position& p : soup.points)
    for (double x : p.coordinates)
      greatest = std::max(greatest, std::abs(x));
  return greatest;
}

} // namespace test
