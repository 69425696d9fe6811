#ifndef QUADRILLE_EXAMPLES_TRANSFER_ATTRIBUTES_H
#define QUADRILLE_EXAMPLES_TRANSFER_ATTRIBUTES_H

#include "mesh_io/indexed_mesh.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace quadrille_examples {

/// A place on a surface: a mean of the corners of a triangle.
struct SurfacePlace {
  std::array<std::uint32_t, 3> corners;
  std::array<double, 3> weights; ///< at least 0, with a sum of 1
};

/// Finds the places of a surface that are closest to points.
class ClosestPlaces {
public:
  explicit ClosestPlaces(const IndexedMesh& mesh) {
    const auto box = CGAL::bounding_box(mesh.points.begin(), mesh.points.end());
    origin_ = box.min();
    const Vector size = box.max() - box.min();
    scale_ = 1 / std::max({size.x(), size.y(), size.z()});
    for (const auto& [a, b, c] : mesh.triangles) {
      const Triangle triangle(local(mesh.points[a]), local(mesh.points[b]), local(mesh.points[c]));
      if (!(triangle.squared_area() > 0))
        continue; // the tree takes triangles of some area only
      triangles_.push_back(triangle);
      corners_.push_back({a, b, c});
    }
    tree_.insert(triangles_.begin(), triangles_.end());
  }

  bool empty() const { return triangles_.empty(); }

  SurfacePlace operator()(const Point& point) const {
    const auto [place, triangle] = tree_.closest_point_and_primitive(local(point));
    return {corners_[static_cast<std::size_t>(triangle - triangles_.begin())],
            barycentric(*triangle, place)};
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Vector = Kernel::Vector_3;
  using Triangle = Kernel::Triangle_3;
  using Iterator = std::vector<Triangle>::const_iterator;
  using Tree =
      CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator>>>;

  /// In the unit cube, so that no area over- or underflows.
  Point local(const Point& point) const { return CGAL::ORIGIN + scale_ * (point - origin_); }

  static std::array<double, 3> barycentric(const Triangle& triangle, const Point& place) {
    const Vector normal = CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    std::array<double, 3> weights;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const Vector area = CGAL::cross_product(triangle[i + 1] - place, triangle[i + 2] - place);
      sum += weights[static_cast<std::size_t>(i)] = std::max(0., area * normal);
    }
    if (!(sum > 0))
      return {1, 0, 0}; // a triangle of hardly any area
    for (double& weight : weights)
      weight /= sum;
    return weights;
  }

  Point origin_;
  double scale_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<std::uint32_t, 3>> corners_;
  Tree tree_;
};

/// The places of the mesh closest to the points. A mesh without area has one place, its first
/// point.
inline std::vector<SurfacePlace> closest_places(const IndexedMesh& mesh,
                                                const std::vector<Point>& points) {
  const ClosestPlaces closest(mesh);
  std::vector<SurfacePlace> places(points.size(), {{0, 0, 0}, {1, 0, 0}});
  if (!closest.empty())
    std::transform(points.begin(), points.end(), places.begin(), std::cref(closest));
  return places;
}

inline CGAL::IO::Color mean(const std::vector<CGAL::IO::Color>& colors, const SurfacePlace& place) {
  CGAL::IO::Color result;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += place.weights[i] * colors[place.corners[i]][channel];
    result[channel] = static_cast<unsigned char>(std::lround(sum));
  }
  return result;
}

inline std::array<double, 2> mean(const std::vector<std::array<double, 2>>& values,
                                  const SurfacePlace& place) {
  std::array<double, 2> result = {0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis)
      result[axis] += place.weights[i] * values[place.corners[i]][axis];
  return result;
}

/// What the attributes are at the places; none, if there are none.
template <class Attribute>
std::vector<Attribute> sampled(const std::vector<Attribute>& attributes,
                               const std::vector<SurfacePlace>& places) {
  std::vector<Attribute> samples;
  if (!attributes.empty())
    for (const SurfacePlace& place : places)
      samples.push_back(mean(attributes, place));
  return samples;
}

} // namespace quadrille_examples

#endif
