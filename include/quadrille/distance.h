// SPDX-License-Identifier: MIT
//
// How far apart are two triangle surfaces? This header measures; it takes no part in simplifying,
// and quadrille/simplify.h never includes it.

#ifndef QUADRILLE_DISTANCE_H
#define QUADRILLE_DISTANCE_H

#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/distance_tree.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <ranges>
#include <stdexcept>
#include <vector>

namespace quadrille {

/// The distance between two surfaces, in the unit of their coordinates. Divide by
/// bounding_box_diagonal() of the reference surface for a figure without unit.
///
/// The one-sided figures go from samples of one surface to the nearest point of the other. The two
/// directions differ when one surface has a region that the other lacks.
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

/// Points spread evenly by area over consecutive faces whose total area is given. One point is
/// drawn in each of `samples` strips of equal area along the list of faces, so that no face gets
/// more than its share. The mean then converges faster than with independent points.
class StripSampling {
public:
  /// Both arguments are above 0.
  StripSampling(double area, const DistanceSampling& sampling)
      : samples_(sampling.samples), strip_(area / static_cast<double>(sampling.samples)),
        generator_(sampling.seed) {
    draw();
  }

  /// Appends the points of the next face.
  void take(const DistanceTriangle& face, std::vector<DistancePoint>& points) {
    area_up_to_ += std::sqrt(face.squared_area());
    last_ = face;
    while (drawn_ <= samples_ && area_of_next_ < area_up_to_)
      append(face, points);
  }
  /// Draws the points that rounding has left, on the last face.
  void end(std::vector<DistancePoint>& points) {
    while (drawn_ <= samples_)
      append(last_, points);
  }

private:
  void draw() { area_of_next_ = (static_cast<double>(drawn_++) + uniform(generator_)) * strip_; }
  void append(const DistanceTriangle& face, std::vector<DistancePoint>& points) {
    const double s = uniform(generator_);
    points.push_back(at(face, s, uniform(generator_)));
    draw();
  }

  std::size_t samples_, drawn_ = 0;
  double strip_, area_up_to_ = 0, area_of_next_ = 0;
  std::mt19937_64 generator_;
  DistanceTriangle last_;
};

/// Samples a surface. One without area is represented by its vertices.
inline std::vector<DistancePoint> sample(const DistanceSurface& surface,
                                         const DistanceSampling& sampling) {
  const double area = surface.area();
  if (!(area > 0) || sampling.samples == 0)
    return surface.vertices;
  StripSampling strips(area, sampling);
  std::vector<DistancePoint> points;
  points.reserve(sampling.samples);
  for (const DistanceTriangle& face : surface.triangles)
    strips.take(face, points);
  strips.end(points);
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
    largest = (std::max)(largest, distance2);
  }
  for (const DistancePoint& p : from.vertices)
    largest = (std::max)(largest, to.squared_distance(p));
  return {std::sqrt(sum / static_cast<double>(points.size())), std::sqrt(largest)};
}

/// Combines both directions, in the unit outside of the frame.
inline SurfaceDistance symmetric_distance(const OneSidedDistance& ab, const OneSidedDistance& ba,
                                          const DistanceFrame& frame) {
  return {.rms = frame.from(std::hypot(ab.rms, ba.rms) / std::sqrt(2.0)),
          .hausdorff = frame.from((std::max)(ab.hausdorff, ba.hausdorff)),
          .rms_a_to_b = frame.from(ab.rms),
          .rms_b_to_a = frame.from(ba.rms),
          .hausdorff_a_to_b = frame.from(ab.hausdorff),
          .hausdorff_b_to_a = frame.from(ba.hausdorff)};
}

inline SurfaceDistance distance_between(DistanceSurface a, DistanceSurface b,
                                        const DistanceSampling& sampling) {
  const DistanceFrame frame(bounding_box(a.vertices) + bounding_box(b.vertices));
  frame.apply(a);
  frame.apply(b);
  const auto ab = one_sided_distance(a, DistanceTree(b.triangles), sampling);
  const auto ba = one_sided_distance(b, DistanceTree(a.triangles), sampling);
  return symmetric_distance(ab, ba, frame);
}

} // namespace internal

/// The sampled distance between two triangle meshes.
///
/// Each surface is sampled evenly by area, and every sample looks for the nearest point of the
/// other surface (the method of Cignoni, Rocchini and Scopigno, "Metro: measuring error on
/// simplified surfaces", 1998). The vertices count for the Hausdorff figures only. Sampling makes a
/// Hausdorff figure a lower bound; with the default 100,000 samples an RMS figure is accurate to
/// about one per cent. Equal inputs give equal figures.
///
/// `MeshA` and `MeshB` are models of CGAL's `FaceListGraph` with a `vertex_point` map; kernels and
/// mesh types may differ. Isolated vertices do not count.
///
/// Complexity: O((n + s) log n) for n faces and s samples.
/// Throws std::invalid_argument when a mesh has no face, a face that is not a triangle, or a vertex
/// that is not finite; the message has its number.
///
/// The unit of the coordinates does not matter as long as doubles can represent them: the function
/// measures a copy of both surfaces, scaled by a power of two.
template <internal::ReadableGraph MeshA, internal::ReadableGraph MeshB>
SurfaceDistance surface_distance(const MeshA& a, const MeshB& b,
                                 const DistanceSampling& sampling = {}) {
  return internal::distance_between(
      internal::measured_surface("quadrille::surface_distance: surface a", a),
      internal::measured_surface("quadrille::surface_distance: surface b", b), sampling);
}

/// The sampled distance between two polygon soups, which may be non-manifold.
///
/// Points are anything with x(), y() and z(), or three numbers by index, in a range; triangles are
/// random access ranges of three indices. Otherwise as for meshes; std::invalid_argument also for
/// an index without a point.
template <class PointsA, class TrianglesA, class PointsB, class TrianglesB>
requires internal::ReadableSoup<PointsA, TrianglesA> && internal::ReadableSoup<PointsB, TrianglesB>
    SurfaceDistance surface_distance(const PointsA& points_a, const TrianglesA& triangles_a,
                                     const PointsB& points_b, const TrianglesB& triangles_b,
                                     const DistanceSampling& sampling = {}) {
  return internal::distance_between(
      internal::measured_surface("quadrille::surface_distance: surface a", points_a, triangles_a),
      internal::measured_surface("quadrille::surface_distance: surface b", points_b, triangles_b),
      sampling);
}

/// Returns the length of the diagonal of the axis-parallel box around the vertices of a mesh, or 0
/// without vertices. Vertices without an edge belong to no surface and do not count.
template <internal::ReadableGraph Mesh>
double bounding_box_diagonal(const Mesh& mesh) {
  const auto position = get(CGAL::vertex_point, mesh);
  std::vector<internal::DistancePoint> points;
  std::size_t number = 0;
  for (const auto v : vertices(mesh)) {
    if (halfedge(v, mesh) != boost::graph_traits<Mesh>::null_halfedge())
      points.push_back(internal::distance_point(
          internal::read_point("quadrille::bounding_box_diagonal", get(position, v), number)));
    ++number;
  }
  return points.empty() ? 0 : internal::diagonal(internal::bounding_box(points));
}

/// Returns the length of the diagonal for points, all of which count.
template <std::ranges::input_range Points>
requires(!internal::ReadableGraph<Points>) double bounding_box_diagonal(const Points& points) {
  std::vector<internal::DistancePoint> copies;
  for (const auto& p : points)
    copies.push_back(internal::distance_point(
        internal::read_point("quadrille::bounding_box_diagonal", p, copies.size())));
  return copies.empty() ? 0 : internal::diagonal(internal::bounding_box(copies));
}

} // namespace quadrille

#endif
