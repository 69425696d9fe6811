// SPDX-License-Identifier: MIT

#include "measure.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <algorithm>
#include <span>

namespace bench {
namespace {

using Vector = Kernel::Vector_3;
using Triangle = Kernel::Triangle_3;

/// An edge of one face, with its end points in ascending order.
struct Side {
  std::uint32_t a, b, face;
  auto operator<=>(const Side&) const = default;
};

/// The sides of all faces; those of one edge are next to each other.
std::vector<Side> sides_by_edge(const Soup& soup) {
  std::vector<Side> sides;
  sides.reserve(soup.triangles.size() * 3);
  for (std::uint32_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]);
      sides.push_back({a, b, f});
    }
  std::ranges::sort(sides);
  return sides;
}

/// Calls `visit` with the sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [&](const Side& side) {
      return side.a != first->a || side.b != first->b;
    });
    visit(std::span(first, last));
    first = last;
  }
}

std::vector<Triangle> geometric_triangles(const Soup& soup) {
  std::vector<Triangle> triangles;
  triangles.reserve(soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles)
    triangles.emplace_back(soup.points[a], soup.points[b], soup.points[c]);
  return triangles;
}

Vector normal(const Triangle& t) {
  return CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
}

/// Answers which way a surface looks at its point nearest to another point.
class Orientation {
public:
  explicit Orientation(const Soup& soup) {
    for (const Triangle& t : geometric_triangles(soup))
      if (!t.is_degenerate())
        triangles_.push_back(t);
    tree_.rebuild(triangles_.begin(), triangles_.end());
  }

  Vector operator()(const Point& p) const {
    return normal(*tree_.closest_point_and_primitive(p).second);
  }

private:
  using Iterator = std::vector<Triangle>::const_iterator;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Iterator>;
  std::vector<Triangle> triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

/// Faces that are folded over a neighbour (their normals lie more than 90 degrees apart) and look
/// against the input surface below their centroid. The second condition says which of the two is
/// wrong and lets sharp edges be; the first lets thin sheets be, where the nearest input face may
/// belong to the other side.
std::size_t flipped_faces(const Soup& input, const Soup& answer, const std::vector<Side>& sides) {
  const std::vector<Triangle> triangles = geometric_triangles(answer);
  std::vector<bool> folded(triangles.size(), false);
  for_each_edge(sides, [&](auto edge) {
    if (edge.size() == 2 && normal(triangles[edge[0].face]) * normal(triangles[edge[1].face]) < 0)
      folded[edge[0].face] = folded[edge[1].face] = true;
  });
  const Orientation orientation(input);
  std::size_t flipped = 0;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    if (folded[f] && normal(t) * orientation(CGAL::centroid(t)) < 0)
      ++flipped;
  }
  return flipped;
}

/// The smallest angle of each face, ascending.
std::vector<double> smallest_angles(const Soup& soup) {
  std::vector<double> angles;
  for (const Triangle& t : geometric_triangles(soup)) {
    double smallest = 180;
    for (int i = 0; i < 3; ++i)
      smallest = std::min(smallest, CGAL::approximate_angle(t[i + 1], t[i], t[i + 2]));
    angles.push_back(smallest);
  }
  std::ranges::sort(angles);
  return angles;
}

quadrille::SurfaceDistance scaled(quadrille::SurfaceDistance d, double factor) {
  for (double* figure : {&d.rms, &d.hausdorff, &d.rms_a_to_b, &d.rms_b_to_a, &d.hausdorff_a_to_b,
                         &d.hausdorff_b_to_a})
    *figure *= factor;
  return d;
}

} // namespace

Quality measure(const Soup& input, const Soup& answer, std::size_t samples) {
  const std::vector<Side> sides = sides_by_edge(answer);
  std::size_t non_manifold_edges = 0;
  std::vector<std::size_t> degree(answer.points.size(), 0);
  for_each_edge(sides, [&](auto edge) {
    non_manifold_edges += edge.size() > 2;
    ++degree[edge[0].a];
    ++degree[edge[0].b];
  });
  const auto distance = quadrille::surface_distance(input.points, input.triangles, answer.points,
                                                    answer.triangles, {.samples = samples});
  const std::vector<double> angles = smallest_angles(answer);
  return {.faces = answer.triangles.size(),
          .distance = scaled(distance, 1 / quadrille::bounding_box_diagonal(input.points)),
          .flipped_faces = flipped_faces(input, answer, sides),
          .non_manifold_edges = non_manifold_edges,
          .highest_degree = degree.empty() ? 0 : *std::ranges::max_element(degree),
          .smallest_angle = angles.empty() ? 0 : angles.front(),
          .low_angle = angles.empty() ? 0 : angles[angles.size() / 100]};
}

} // namespace bench
