#ifndef QUADRILLE_EXAMPLES_PICTURES_H
#define QUADRILLE_EXAMPLES_PICTURES_H

#include <quadrille/concepts.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/pairs/pair_selection.h>
#include <quadrille/internal/core/policy/pair_source.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <ranges>
#include <stdexcept>
#include <string>
#include <vector>

/// \file
/// The shapes that can be drawn of a simplification in addition to its surfaces: quadrics, as
/// ellipsoids, and the pairs that a policy selects, as segments. This header computes shapes, and
/// leaves it to the caller to draw them.

namespace figures {

/// How quadric_ellipsoids() makes an ellipsoid of a quadric.
struct EllipsoidShape {
  /// The value of the quadric on the ellipsoid is level² above that at the vertex, but for the
  /// linear term. Of a quadric that `vertex_quadric_map` writes, whose weights add up to 1, level
  /// is a root mean square distance to planes, in the unit of the mesh. Above 0.
  double level;
  /// No half axis is longer than this: a quadric is the same anywhere along its plane. Above 0.
  double longest;
  std::size_t meridians = 16; ///< of the mesh of an ellipsoid, at least 3
  std::size_t parallels = 8;  ///< at least 1; it has 2 · meridians · parallels faces
};

/// A pair of vertices, to be drawn as a segment.
template <class Point>
struct PairSegment {
  std::array<std::uint32_t, 2> vertices; ///< as they are counted off in the surface, ascending
  std::array<Point, 2> ends;             ///< where these are
  bool is_edge;                          ///< of the surface
};

namespace pictures {

using namespace quadrille;
using namespace quadrille::internal;

/// Three vectors that the linear map to which they belong takes the unit sphere with to the
/// ellipsoid xᵀAx = 1: they are orthonormal as A measures. No eigenvalue of A is below `least`.
inline std::array<Vector<3>, 3> conjugate_half_axes(const SymmetricMatrix<3>& a, double least) {
  std::array<Vector<3>, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector<3> axis;
    axis[i] = 1;
    for (std::size_t j = 0; j < i; ++j)
      axis -= dot(axes[j], a * axis) * axes[j];
    const double squared = (std::max)(dot(axis, a * axis), least * squared_length(axis));
    axes[i] = (1 / std::sqrt(squared)) * axis;
  }
  return axes;
}

/// Around the origin: a pole, the parallels from there, and the other pole.
inline TriangleSoup<Vector<3>> unit_sphere(std::size_t meridians, std::size_t parallels) {
  TriangleSoup<Vector<3>> sphere;
  const auto part = [](std::size_t i, std::size_t of) {
    return std::numbers::pi * static_cast<double>(i) / static_cast<double>(of);
  };
  sphere.points.push_back({{0, 0, -1}});
  for (std::size_t j = 1; j <= parallels; ++j)
    for (std::size_t i = 0; i < meridians; ++i) {
      const double polar = part(j, parallels + 1), angle = part(2 * i, meridians);
      sphere.points.push_back({{std::sin(polar) * std::cos(angle),
                                std::sin(polar) * std::sin(angle), -std::cos(polar)}});
    }
  sphere.points.push_back({{0, 0, 1}});

  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    sphere.triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                static_cast<std::uint32_t>(c)});
  };
  const std::size_t north = sphere.points.size() - 1, last = north - meridians;
  for (std::size_t i = 0; i < meridians; ++i) {
    const std::size_t next = (i + 1) % meridians;
    add(0, 1 + next, 1 + i);
    add(last + i, last + next, north);
    for (std::size_t row = 1; row < last; row += meridians) {
      add(row + i, row + next, row + meridians + next);
      add(row + i, row + meridians + next, row + meridians + i);
    }
  }
  return sphere;
}

template <class Point>
class EllipsoidMaker {
public:
  explicit EllipsoidMaker(const EllipsoidShape& shape) : shape_(shape) {
    const auto is_length = [](double x) { return x > 0 && std::isfinite(x); };
    if (!is_length(shape.level) || !is_length(shape.longest))
      refuse("level and longest must be above 0 and finite");
    if (shape.meridians < 3 || shape.parallels < 1)
      refuse("an ellipsoid has at least 3 meridians and a parallel");
    sphere_ = unit_sphere(shape.meridians, shape.parallels);
  }

  template <class P>
  void add(const P& centre, const QuadricForm<3>& quadric) {
    const Vector<3> position = position_of(centre);
    if (!is_finite(position) || !std::isfinite(quadric.trace()))
      refuse("vertex " + std::to_string(count_) + " or its quadric is not finite");
    const std::size_t first = count_++ * sphere_.points.size();
    const double ratio = shape_.level / shape_.longest;
    SymmetricMatrix<3> a = quadric.matrix();
    a.add_to_diagonal(ratio * ratio);
    const auto axes = conjugate_half_axes(a, ratio * ratio);
    for (const Vector<3>& u : sphere_.points)
      ellipsoids.points.push_back(point_at<Point>(
          position + shape_.level * (u[0] * axes[0] + u[1] * axes[1] + u[2] * axes[2])));
    for (const auto& triangle : sphere_.triangles) {
      auto& moved = ellipsoids.triangles.emplace_back(triangle);
      for (std::uint32_t& v : moved)
        v += static_cast<std::uint32_t>(first);
    }
  }

  TriangleSoup<Point> ellipsoids;

private:
  [[noreturn]] static void refuse(const std::string& what) {
    throw std::invalid_argument("quadrille::quadric_ellipsoids: " + what);
  }

  EllipsoidShape shape_;
  TriangleSoup<Vector<3>> sphere_;
  std::size_t count_ = 0;
};

/// The edges of a surface, each once with the lower index first, in order.
inline std::vector<std::array<Index, 2>> edges_of(const SurfaceView& surface) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& t : surface.triangles)
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) // else it is no face
      for (std::size_t i = 0; i < 3; ++i)
        edges.push_back({(std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3])});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

template <class Point, PairPolicy Pairs>
std::vector<PairSegment<Point>> pair_segments(const SurfaceView& surface, const Pairs& policy) {
  if constexpr (requires { policy.validate(); })
    policy.validate();
  const auto edges = edges_of(surface);
  std::vector<bool> has_faces(surface.points.size(), false);
  for (const auto& [v, w] : edges)
    has_faces[v] = has_faces[w] = true;
  auto pairs = emitted_pairs(PairSource::of(policy), surface);
  std::erase_if(pairs,
                [&](const auto& pair) { return !has_faces[pair[0]] || !has_faces[pair[1]]; });
  if (includes_edges<Pairs>)
    pairs.insert(pairs.end(), edges.begin(), edges.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  const auto place = [&](Index v) { return point_at<Point>(surface.points[v]); };
  std::vector<PairSegment<Point>> segments;
  segments.reserve(pairs.size());
  for (const auto& pair : pairs)
    segments.push_back({pair,
                        {place(pair[0]), place(pair[1])},
                        std::binary_search(edges.begin(), edges.end(), pair)});
  return segments;
}

} // namespace pictures

/// For each vertex an ellipsoid around it that shows its quadric: thin across the surface, wide
/// along it where it is flat, long along its creases.
///
/// `mesh` models CGAL's FaceListGraph; `quadrics` is a readable property map from its vertices to
/// `QuadricForm<3>`, as `parameters::vertex_quadric_map` has it written. The soup has the point
/// type of the mesh, and the same number of points and of triangles for each vertex, in the order
/// of these; all are oriented outwards. O(n · meridians · parallels) for n vertices.
///
/// Throws std::invalid_argument for a shape out of its range, and a vertex or a quadric that is not
/// finite.
/// Source: Garland and Heckbert 1997, section 4 and the figure of the error ellipsoids.
template <class Mesh, class QuadricMap>
requires quadrille::internal::ReadableGraph<Mesh>
auto quadric_ellipsoids(const Mesh& mesh, const QuadricMap& quadrics, const EllipsoidShape& shape) {
  const auto points = get(CGAL::vertex_point, mesh);
  pictures::EllipsoidMaker<typename boost::property_traits<decltype(points)>::value_type> maker(
      shape);
  for (const auto v : vertices(mesh))
    maker.add(get(points, v), get(quadrics, v));
  return maker.ellipsoids;
}

/// Returns ellipsoids for the points of a soup; `quadrics` is a random access range of at least as
/// many `QuadricForm<3>`. Throws std::invalid_argument if it has fewer.
template <std::ranges::random_access_range Points, std::ranges::random_access_range Quadrics>
requires(!quadrille::internal::ReadableGraph<Points>) auto quadric_ellipsoids(
    const Points& points, const Quadrics& quadrics, const EllipsoidShape& shape) {
  if (std::ranges::size(quadrics) < std::ranges::size(points))
    throw std::invalid_argument("quadrille::quadric_ellipsoids: there are " +
                                std::to_string(std::ranges::size(quadrics)) + " quadrics for " +
                                std::to_string(std::ranges::size(points)) + " points");
  pictures::EllipsoidMaker<std::ranges::range_value_t<Points>> maker(shape);
  for (std::size_t v = 0; v < std::ranges::size(points); ++v)
    maker.add(points[v], quadrics[v]);
  return maker.ellipsoids;
}

/// The pairs that `simplify` may contract first, if it has this pair policy, as segments: the
/// edges, if the policy includes them, and what it selects. Each is there once, in the order of
/// its vertices; those of other points than vertices of faces are not there.
///
/// `mesh` models CGAL's FaceListGraph, its faces are triangles; `pairs` models PairPolicy. Ends
/// have the point type of the mesh, and vertices are counted off in the order of `vertices(mesh)`.
/// O((n + m) log (n + m)) for n faces and m pairs, and the time of the policy.
///
/// Throws std::invalid_argument for a face that is not a triangle, a point that is not finite, and
/// what the policy refuses.
/// Source: Garland and Heckbert 1997, section 3.2 and the figure of the pairs of a foot.
template <class Mesh, quadrille::PairPolicy Pairs>
requires quadrille::internal::ReadableGraph<Mesh>
auto pair_segments(const Mesh& mesh, const Pairs& pairs) {
  using Points = typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
  return pictures::pair_segments<typename boost::property_traits<Points>::value_type>(
      quadrille::internal::read_surface("quadrille::pair_segments", mesh), pairs);
}

/// Returns them for a soup. Throws std::invalid_argument also for a triangle that names a point
/// that does not exist.
template <std::ranges::random_access_range Points, std::ranges::input_range Triangles,
          quadrille::PairPolicy Pairs>
auto pair_segments(const Points& points, const Triangles& triangles, const Pairs& pairs) {
  return pictures::pair_segments<std::ranges::range_value_t<Points>>(
      quadrille::internal::read_surface("quadrille::pair_segments", points, triangles), pairs);
}

} // namespace figures

#endif // QUADRILLE_EXAMPLES_PICTURES_H
