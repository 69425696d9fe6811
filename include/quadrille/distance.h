// SPDX-License-Identifier: MIT
//
// How far apart are two triangle surfaces? This header measures; it takes no part in simplifying,
// and quadrille/simplify.h never includes it.
//
// Licence: this file is MIT, but it includes CGAL's AABB tree and, for bounded_hausdorff(), CGAL's
// Polygon Mesh Processing and Surface_mesh, all of which are GPL-3.0-or-later (or commercial). A
// program that includes it is bound by their terms.

#ifndef QUADRILLE_DISTANCE_H
#define QUADRILLE_DISTANCE_H

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <ranges>
#include <stdexcept>
#include <vector>

namespace quadrille {

/// The distance between two surfaces, in the unit of their coordinates. Divide by
/// bounding_box_diagonal() of the reference surface for a figure without unit.
///
/// The one-sided figures look from samples of one surface to the nearest point of the other; the
/// two directions differ when one surface has a part that the other lacks.
struct SurfaceDistance {
  double rms;              ///< root of the mean of both squared one-sided figures
  double hausdorff;        ///< the larger of both one-sided figures
  double rms_a_to_b;       ///< root mean square over the samples of a
  double rms_b_to_a;       ///< root mean square over the samples of b
  double hausdorff_a_to_b; ///< the largest over the samples and the vertices of a
  double hausdorff_b_to_a; ///< the largest over the samples and the vertices of b
};

/// How surface_distance() samples each of the two surfaces.
struct DistanceSampling {
  std::size_t samples = 100'000; ///< points on each surface, besides its vertices
  std::uint64_t seed = 0;        ///< equal seeds give equal points, on every platform
};

namespace internal {

using DistancePoint = CGAL::Simple_cartesian<double>::Point_3;
using DistanceVector = CGAL::Simple_cartesian<double>::Vector_3;
using DistanceTriangle = CGAL::Simple_cartesian<double>::Triangle_3;

/// A surface as distances see it: triangles, and the vertices that they use.
struct DistanceSurface {
  std::vector<DistanceTriangle> triangles;
  std::vector<DistancePoint> vertices;
};

template <class Point>
DistancePoint to_distance_point(const Point& p) {
  const DistancePoint q(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  if (!std::isfinite(q.x()) || !std::isfinite(q.y()) || !std::isfinite(q.z()))
    throw std::invalid_argument("quadrille: a coordinate of a measured surface is not finite");
  return q;
}

inline void require_triangles(const DistanceSurface& surface) {
  if (surface.triangles.empty())
    throw std::invalid_argument("quadrille: a surface without faces is at no distance");
}

template <class Mesh>
DistanceSurface distance_surface(const Mesh& mesh) {
  using Traits = boost::graph_traits<Mesh>;
  const auto position = get(CGAL::vertex_point, mesh);
  DistanceSurface surface;
  for (const auto v : vertices(mesh))
    if (halfedge(v, mesh) != Traits::null_halfedge())
      surface.vertices.push_back(to_distance_point(get(position, v)));
  for (const auto f : faces(mesh)) {
    std::array<DistancePoint, 3> corners;
    std::size_t degree = 0;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) {
      if (degree < 3)
        corners[degree] = to_distance_point(get(position, v));
      ++degree;
    }
    if (degree != 3)
      throw std::invalid_argument("quadrille: a face of a measured surface is not a triangle");
    surface.triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  require_triangles(surface);
  return surface;
}

template <class Points, class Triangles>
DistanceSurface distance_surface(const Points& points, const Triangles& triangles) {
  const auto count = static_cast<std::size_t>(std::ranges::distance(points));
  const auto first = std::ranges::begin(points);
  using Step = std::iter_difference_t<decltype(first)>;
  DistanceSurface surface;
  std::vector<bool> used(count, false);
  for (const auto& triangle : triangles) {
    if (std::ranges::distance(triangle) != 3)
      throw std::invalid_argument("quadrille: a face of a measured surface is not a triangle");
    std::array<DistancePoint, 3> corners;
    std::size_t corner = 0;
    for (const auto vertex : triangle) {
      const auto v = static_cast<std::size_t>(vertex);
      if (v >= count)
        throw std::out_of_range("quadrille: a triangle names a point that does not exist");
      used[v] = true;
      corners[corner++] = to_distance_point(first[static_cast<Step>(v)]);
    }
    surface.triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  require_triangles(surface);
  for (std::size_t v = 0; v < count; ++v)
    if (used[v])
      surface.vertices.push_back(to_distance_point(first[static_cast<Step>(v)]));
  return surface;
}

inline CGAL::Bbox_3 bounding_box(const std::vector<DistancePoint>& points) {
  CGAL::Bbox_3 box;
  for (const DistancePoint& p : points)
    box += p.bbox();
  return box;
}

inline double diagonal(const CGAL::Bbox_3& box) {
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

/// A change of unit by a power of two, which is exact both ways. Distances are measured where the
/// box of both surfaces has a size of about 1, so that no product of lengths over- or underflows.
class DistanceUnit {
public:
  explicit DistanceUnit(const CGAL::Bbox_3& box) {
    double extent = 0, farthest = 0;
    for (int i = 0; i < 3; ++i) {
      // Half of the extent: the difference of the halves can't overflow.
      extent = std::max(extent, 0.5 * box.max(i) - 0.5 * box.min(i));
      farthest = std::max({farthest, std::abs(box.min(i)), std::abs(box.max(i))});
    }
    // A flat surface far along its normal must not leave the range of doubles.
    extent = std::max(extent, 0x1p-1000 * farthest);
    if (extent > 0)
      exponent_ = -std::ilogb(extent);
  }

  double to(double length) const { return std::ldexp(length, exponent_); }
  double from(double length) const { return std::ldexp(length, -exponent_); }

  DistancePoint to(const DistancePoint& p) const {
    return DistancePoint(to(p.x()), to(p.y()), to(p.z()));
  }

  void apply(DistanceSurface& surface) const {
    for (DistancePoint& p : surface.vertices)
      p = to(p);
    for (DistanceTriangle& t : surface.triangles)
      t = DistanceTriangle(to(t[0]), to(t[1]), to(t[2]));
  }

private:
  int exponent_ = 0;
};

/// Moves the surface by -origin, so that far-away coordinates cost the distances no digits.
inline void recentre(DistanceSurface& surface, const DistanceVector& origin) {
  for (DistancePoint& p : surface.vertices)
    p = p - origin;
  for (DistanceTriangle& t : surface.triangles)
    t = DistanceTriangle(t[0] - origin, t[1] - origin, t[2] - origin);
}

inline DistancePoint nearest_on_segment(const DistancePoint& a, const DistancePoint& b,
                                        const DistancePoint& query) {
  const DistanceVector ab = b - a;
  const double length2 = ab.squared_length();
  if (!(length2 > 0))
    return a;
  return a + std::clamp(((query - a) * ab) / length2, 0.0, 1.0) * ab;
}

/// The nearest point of a triangle, which may be a needle or a point: where the foot of the
/// perpendicular is inside, that; else the best of the three edges. A needle's normal is noise, so
/// the foot is made a convex combination of the corners and must beat the edges: the answer is
/// always a point of the triangle.
inline DistancePoint nearest_on_triangle(const DistanceTriangle& t, const DistancePoint& query) {
  DistancePoint best = nearest_on_segment(t[0], t[1], query);
  double best_distance = CGAL::squared_distance(query, best);
  const auto offer = [&](const DistancePoint& candidate) {
    const double distance = CGAL::squared_distance(query, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  };
  offer(nearest_on_segment(t[1], t[2], query));
  offer(nearest_on_segment(t[2], t[0], query));

  const DistanceVector ab = t[1] - t[0], ac = t[2] - t[0], aq = query - t[0];
  const DistanceVector normal = CGAL::cross_product(ab, ac);
  const double scale = normal.squared_length();
  const double v = normal * CGAL::cross_product(aq, ac);
  const double w = normal * CGAL::cross_product(ab, aq);
  if (scale > 0 && v >= 0 && w >= 0 && v + w <= scale)
    offer(t[0] + (v / scale) * ab + (w / scale) * ac);
  return best;
}

/// The plain kernel, but with a projection onto triangles that bears degenerate ones.
struct DistanceKernel : CGAL::Simple_cartesian<double> {
  struct Construct_projected_point_3 {
    using result_type = DistancePoint;
    DistancePoint operator()(const DistanceTriangle& t, const DistancePoint& query) const {
      return nearest_on_triangle(t, query);
    }
  };
  Construct_projected_point_3 construct_projected_point_3_object() const { return {}; }
};

/// A surface made ready to be asked for its nearest point: O(n log n) to build, about O(log n) a
/// question.
class DistanceTree {
public:
  explicit DistanceTree(const std::vector<DistanceTriangle>& triangles)
      : tree_(triangles.begin(), triangles.end()) {
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  double squared_distance(const DistancePoint& query) const {
    return CGAL::squared_distance(query, tree_.closest_point(query));
  }

private:
  using Iterator = std::vector<DistanceTriangle>::const_iterator;
  using Primitive = CGAL::AABB_triangle_primitive<DistanceKernel, Iterator>;
  CGAL::AABB_tree<CGAL::AABB_traits<DistanceKernel, Primitive>> tree_;
};

/// Uniform in [0, 1), the same on every platform, as the distributions of <random> are not.
inline double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

/// The point of a triangle at (s, t) of the unit square, folded along its diagonal.
inline DistancePoint at(const DistanceTriangle& triangle, double s, double t) {
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  return triangle[0] + s * (triangle[1] - triangle[0]) + t * (triangle[2] - triangle[0]);
}

/// Points spread evenly by area. One point is drawn in each of `samples` strips of equal area along
/// the list of faces, so that no face has more than its share, which makes the mean converge faster
/// than with independent points. A surface without area is given by its vertices.
inline std::vector<DistancePoint> sample(const DistanceSurface& surface,
                                         const DistanceSampling& sampling) {
  std::vector<double> area_up_to;
  area_up_to.reserve(surface.triangles.size());
  double total = 0;
  for (const DistanceTriangle& t : surface.triangles)
    area_up_to.push_back(total += std::sqrt(t.squared_area()));
  if (!(total > 0) || sampling.samples == 0)
    return surface.vertices;

  std::mt19937_64 generator(sampling.seed);
  const double strip = total / static_cast<double>(sampling.samples);
  std::vector<DistancePoint> points;
  points.reserve(sampling.samples);
  std::size_t face = 0;
  for (std::size_t i = 0; i < sampling.samples; ++i) {
    const double area = (static_cast<double>(i) + uniform(generator)) * strip;
    while (face + 1 < area_up_to.size() && area_up_to[face] <= area)
      ++face;
    const double s = uniform(generator);
    points.push_back(at(surface.triangles[face], s, uniform(generator)));
  }
  return points;
}

struct OneSidedDistance {
  double rms;
  double hausdorff;
};

inline OneSidedDistance one_sided_distance(const DistanceSurface& from, const DistanceTree& to,
                                           const DistanceSampling& sampling) {
  double sum = 0, largest = 0;
  const std::vector<DistancePoint> points = sample(from, sampling);
  for (const DistancePoint& p : points) {
    const double distance2 = to.squared_distance(p);
    sum += distance2;
    largest = std::max(largest, distance2);
  }
  for (const DistancePoint& p : from.vertices)
    largest = std::max(largest, to.squared_distance(p));
  return {std::sqrt(sum / static_cast<double>(points.size())), std::sqrt(largest)};
}

inline SurfaceDistance distance_between(DistanceSurface a, DistanceSurface b,
                                        const DistanceSampling& sampling) {
  const CGAL::Bbox_3 box = bounding_box(a.vertices);
  const DistanceVector centre(box.xmin() / 2 + box.xmax() / 2, box.ymin() / 2 + box.ymax() / 2,
                              box.zmin() / 2 + box.zmax() / 2);
  recentre(a, centre);
  recentre(b, centre);
  const DistanceUnit unit(bounding_box(a.vertices) + bounding_box(b.vertices));
  unit.apply(a);
  unit.apply(b);
  const auto ab = one_sided_distance(a, DistanceTree(b.triangles), sampling);
  const auto ba = one_sided_distance(b, DistanceTree(a.triangles), sampling);
  return {.rms = unit.from(std::hypot(ab.rms, ba.rms) / std::sqrt(2.0)),
          .hausdorff = unit.from(std::max(ab.hausdorff, ba.hausdorff)),
          .rms_a_to_b = unit.from(ab.rms),
          .rms_b_to_a = unit.from(ba.rms),
          .hausdorff_a_to_b = unit.from(ab.hausdorff),
          .hausdorff_b_to_a = unit.from(ba.hausdorff)};
}

using DistanceMesh = CGAL::Surface_mesh<DistancePoint>;

/// The box of the vertices that faces use. Throws where the mesh cannot be measured.
template <class Mesh>
CGAL::Bbox_3 distance_box(const Mesh& mesh) {
  return bounding_box(distance_surface(mesh).vertices);
}

template <class Mesh>
DistanceMesh distance_mesh(const Mesh& mesh, const DistanceUnit& unit) {
  DistanceMesh copy;
  CGAL::copy_face_graph(mesh, copy);
  for (const auto v : vertices(copy))
    copy.point(v) = unit.to(copy.point(v));
  return copy;
}

/// A mesh whose faces can be listed and walked around.
template <class Mesh>
concept MeasurableMesh = requires(const Mesh& mesh) {
  vertices(mesh);
  halfedges(mesh);
  faces(mesh);
};

/// The two halves of a polygon soup: points, and triples of indices into them.
template <class Points, class Triangles>
concept MeasurableSoup =
    std::ranges::random_access_range<const Points> && std::ranges::input_range<const Triangles> &&
    std::ranges::input_range<std::ranges::range_reference_t<const Triangles>>;

} // namespace internal

/// The sampled distance between two triangle meshes.
///
/// Each surface is sampled evenly by area, and every sample looks for the nearest point of the
/// other surface (the method of Cignoni, Rocchini and Scopigno, "Metro: measuring error on
/// simplified surfaces", 1998). The vertices count for the Hausdorff figures only. Sampling makes a
/// Hausdorff figure a lower bound; with the default 100,000 samples an RMS figure is good to about
/// one per cent. Equal inputs give equal figures.
///
/// `MeshA` and `MeshB` are models of CGAL's `FaceListGraph` with a `vertex_point` map; kernels and
/// mesh types may differ. Isolated vertices do not count.
///
/// Complexity: O((n + s) log n) for n faces and s samples.
/// Throws std::invalid_argument when a mesh has no face, a face that is no triangle, or a
/// coordinate that is not finite.
///
/// The unit of the coordinates does not matter, as far as doubles hold them: what is measured is a
/// copy of both surfaces, scaled by a power of two.
template <internal::MeasurableMesh MeshA, internal::MeasurableMesh MeshB>
SurfaceDistance surface_distance(const MeshA& a, const MeshB& b,
                                 const DistanceSampling& sampling = {}) {
  return internal::distance_between(internal::distance_surface(a), internal::distance_surface(b),
                                    sampling);
}

/// The sampled distance between two polygon soups, which may be non-manifold.
///
/// Points are anything with x(), y() and z(), in a random access range; triangles are ranges of
/// three indices. Otherwise as for meshes, and std::out_of_range when an index names no point.
template <class PointsA, class TrianglesA, class PointsB, class TrianglesB>
requires internal::MeasurableSoup<PointsA, TrianglesA> &&
    internal::MeasurableSoup<PointsB, TrianglesB>
        SurfaceDistance surface_distance(const PointsA& points_a, const TrianglesA& triangles_a,
                                         const PointsB& points_b, const TrianglesB& triangles_b,
                                         const DistanceSampling& sampling = {}) {
  return internal::distance_between(internal::distance_surface(points_a, triangles_a),
                                    internal::distance_surface(points_b, triangles_b), sampling);
}

/// The Hausdorff distance between two triangle meshes, the larger of both directions, in the unit
/// of their coordinates and wrong by at most `error`, which is in the same unit.
///
/// Where surface_distance() samples, this bounds: CGAL subdivides the triangles that may still hold
/// the largest distance (Tang, Lee and Kim, "Interactive Hausdorff distance computation for general
/// polygonal models", 2009). An error of 1e-4 of the bounding-box diagonal costs seconds on 100,000
/// faces; the time grows as the error falls. A result below `error` says no more than that.
///
/// Mesh types, the scaled copies, and what is thrown, are as for surface_distance();
/// std::invalid_argument also when `error` is not positive.
template <internal::MeasurableMesh MeshA, internal::MeasurableMesh MeshB>
double bounded_hausdorff(const MeshA& a, const MeshB& b, double error) {
  if (!(error > 0))
    throw std::invalid_argument("quadrille: the error of bounded_hausdorff() must be positive");
  const internal::DistanceUnit unit(internal::distance_box(a) + internal::distance_box(b));
  // CGAL squares the error; one so much larger than the surfaces is as good as any above it.
  const double error_in_unit = std::min(unit.to(error), 0x1p500);
  return unit.from(CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<
                   CGAL::Sequential_tag>(internal::distance_mesh(a, unit),
                                         internal::distance_mesh(b, unit), error_in_unit));
}

/// The length of the diagonal of the axis-parallel box around the vertices of a mesh; 0 when there
/// are none.
template <internal::MeasurableMesh Mesh>
double bounding_box_diagonal(const Mesh& mesh) {
  const auto position = get(CGAL::vertex_point, mesh);
  std::vector<internal::DistancePoint> points;
  for (const auto v : vertices(mesh))
    points.push_back(internal::to_distance_point(get(position, v)));
  return points.empty() ? 0 : internal::diagonal(internal::bounding_box(points));
}

/// The same for the points of a soup.
template <std::ranges::input_range Points>
requires(!internal::MeasurableMesh<Points>) double bounding_box_diagonal(const Points& points) {
  std::vector<internal::DistancePoint> copies;
  for (const auto& p : points)
    copies.push_back(internal::to_distance_point(p));
  return copies.empty() ? 0 : internal::diagonal(internal::bounding_box(copies));
}

} // namespace quadrille

#endif
