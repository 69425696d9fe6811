#ifndef QUADRILLE_EXAMPLES_FIGURES_MEASURES_H
#define QUADRILLE_EXAMPLES_FIGURES_MEASURES_H

#include "surfaces.h"

#include <quadrille/quadric_form.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <type_traits>
#include <vector>

/// What the figures measure beside the distance of two surfaces.

namespace figures {

/// A place on a surface: a face, and the weights of its corners, which add up to 1.
struct Place {
  std::size_t face;
  std::array<double, 3> weights;
};

/// Triangles that carry N numbers at each corner.
template <std::size_t N>
class Field {
public:
  using Value = quadrille::Vector<N>;

  template <class Map>
  Field(const Mesh& mesh, const Map& attributes) {
    for (const auto f : mesh.faces()) {
      std::array<Point, 3> corners;
      std::array<Value, 3> values;
      std::size_t k = 0;
      for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
        corners[k] = mesh.point(v);
        for (std::size_t i = 0; i < N; ++i)
          values[k][i] = static_cast<double>(get(attributes, v)[i]);
        ++k;
      }
      triangles_.emplace_back(corners[0], corners[1], corners[2]);
      values_.push_back(values);
    }
    tree_.rebuild(triangles_.begin(), triangles_.end());
    tree_.accelerate_distance_queries();
  }
  Field(const Field&) = delete;

  Point point(const Place& place) const {
    const Kernel::Triangle_3& t = triangles_[place.face];
    return CGAL::barycenter(t[0], place.weights[0], t[1], place.weights[1], t[2], place.weights[2]);
  }

  Value value(const Place& place) const {
    Value sum;
    for (std::size_t i = 0; i < 3; ++i)
      sum += place.weights[i] * values_[place.face][i];
    return sum;
  }

  /// The place of the surface that is nearest to a point.
  Place nearest(const Point& query) const {
    const auto [point, triangle] = tree_.closest_point_and_primitive(query);
    return {static_cast<std::size_t>(triangle - triangles_.begin()), weights(*triangle, point)};
  }

  /// Places spread evenly by area.
  std::vector<Place> sample(std::size_t count) const {
    std::vector<double> areas;
    for (const auto& t : triangles_)
      areas.push_back(std::sqrt(t.squared_area()));
    std::mt19937 generator;
    std::discrete_distribution<std::size_t> face(areas.begin(), areas.end());
    std::uniform_real_distribution<double> uniform;
    std::vector<Place> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double side = std::sqrt(uniform(generator)), along = uniform(generator);
      places.push_back({face(generator), {1 - side, side * (1 - along), side * along}});
    }
    return places;
  }

private:
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

  // Of a point of the triangle, by area; of a triangle without area, the first corner's.
  static std::array<double, 3> weights(const Kernel::Triangle_3& t, const Point& p) {
    const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
    const double scale = normal.squared_length();
    if (!(scale > 0))
      return {1, 0, 0};
    const auto part = [&](const Point& a, const Point& b) {
      return std::clamp(normal * CGAL::cross_product(b - a, p - a) / scale, 0.0, 1.0);
    };
    const double first = part(t[1], t[2]), second = std::min(part(t[2], t[0]), 1 - first);
    return {first, second, 1 - first - second};
  }

  Triangles triangles_;
  std::vector<std::array<Value, 3>> values_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

/// The root mean square difference of the numbers of two surfaces, one number: the mean is over N,
/// over points sampled evenly on either surface, each against the nearest point of the other, and
/// over both directions.
template <std::size_t N>
double rms_difference(const Field<N>& a, const Field<N>& b, std::size_t samples = 20'000) {
  const auto squares = [&](const Field<N>& from, const Field<N>& to) {
    double sum = 0;
    for (const Place& place : from.sample(samples))
      sum += squared_distance(from.value(place), to.value(to.nearest(from.point(place))));
    return sum;
  };
  const double mean = (squares(a, b) + squares(b, a)) / static_cast<double>(2 * N * samples);
  return std::sqrt(mean);
}

/// A point next to a vertex, a ten-thousandth of the way to the middle of one of its faces: where
/// several surfaces have a vertex in one place, this is on the vertex's own.
inline Point next_to(Vertex v, const Mesh& mesh) {
  auto h = mesh.halfedge(v);
  if (mesh.is_border(h))
    h = mesh.prev(mesh.opposite(h));
  const Point middle = CGAL::centroid(mesh.point(v), mesh.point(mesh.source(h)),
                                      mesh.point(mesh.target(mesh.next(h))));
  return mesh.point(v) + 1e-4 * (middle - mesh.point(v));
}

/// Gives each vertex of a mesh what a field has at the place nearest to it.
template <std::size_t N, class Map>
void transfer(const Field<N>& field, const Mesh& mesh, Map attributes) {
  using Component = std::remove_cvref_t<decltype(attributes[Vertex()][0])>;
  for (const Vertex v : mesh.vertices()) {
    const auto value = field.value(field.nearest(next_to(v, mesh)));
    for (std::size_t i = 0; i < N; ++i)
      if constexpr (std::is_integral_v<Component>)
        attributes[v][i] = static_cast<Component>(std::lround(value[i]));
      else
        attributes[v][i] = value[i];
  }
}

} // namespace figures

#endif
