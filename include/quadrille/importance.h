#ifndef QUADRILLE_IMPORTANCE_H
#define QUADRILLE_IMPORTANCE_H

#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>
#include <vector>

/// \file
/// Importance maps for vertex_importance_map, from the curvature and the visibility of a surface.
/// Only ratios of importances matter, and they do not depend on the unit of length. They may be
/// multiplied with another map. <quadrille/simplify.h> does not include this header.

namespace quadrille {

/// Options of curvature_importance().
struct CurvatureImportance {
  /// A region of average curvature has 2 to this power times the importance of a flat one: with 3
  /// it gets about twice as many faces, in addition to the effect of the cost. At least 0; with 0
  /// all importances are equal.
  double strength = 3;
};

/// Options of view_importance().
struct ViewImportance {
  Vector<3> eye = {}; ///< the position of the viewer, in the surface's coordinates
  /// The factor for a vertex whose faces are all turned away from the eye, relative to others at
  /// the same distance; at least 0. With 1/64 the regions turned away get about a quarter of the
  /// faces.
  double turned_away = 1. / 64;
  /// The factor for a vertex with faces of both kinds, which may lie on the outline; at least 0.
  double outline = 8;
};

namespace internal {

/// Scales a surface to the engine's unit, so that nothing over- or underflows.
inline Scale<3> rescale(TriangleSoup<>& surface) {
  const Scale<3> scale(Box<3>(surface.points), true);
  for (Vector<3>& p : surface.points)
    p = scale.position_from_mesh(p);
  return scale;
}

/// Returns the vertex normals of a surface: of unit length, or 0 where no face has an area.
inline std::vector<Vector<3>> vertex_normals(const SurfaceView& surface) {
  std::vector<Vector<3>> normals(surface.points.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& at = surface.points;
    const Vector<3> normal = normal_vector(at[a], at[b], at[c]);
    for (std::size_t v : {a, b, c})
      normals[v] += normal;
  }
  for (Vector<3>& n : normals)
    if (const double length = std::sqrt(squared_length(n)); length > 0)
      n *= 1 / length;
  return normals;
}

/// Returns four times the area of a triangle, times the mean of the squared gradient of a map that
/// is linear on it: each edge counts by the cotangent of the opposite angle.
inline double dirichlet_energy(const std::array<Vector<3>, 3>& at,
                               const std::array<Vector<3>, 3>& values, double doubled_area) {
  double energy = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    energy +=
        dot(at[j] - at[i], at[k] - at[i]) / doubled_area * squared_distance(values[j], values[k]);
  }
  return 2 * energy;
}

/// Returns the root of the sum of the squares of both principal curvatures at each vertex: the
/// change of vertex normals over its faces, averaged by area.
inline std::vector<double> curvatures(const SurfaceView& surface) {
  const std::vector<Vector<3>> normals = vertex_normals(surface);
  std::vector<double> curvature(surface.points.size()), area(surface.points.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const std::array at{surface.points[a], surface.points[b], surface.points[c]};
    const double doubled = std::sqrt(squared_length(normal_vector(at[0], at[1], at[2])));
    if (!(doubled > 0))
      continue;
    const double energy = dirichlet_energy(at, {normals[a], normals[b], normals[c]}, doubled);
    for (std::size_t v : {a, b, c}) {
      curvature[v] += energy;
      area[v] += 2 * doubled;
    }
  }
  for (std::size_t v = 0; v < curvature.size(); ++v)
    curvature[v] = area[v] > 0 ? std::sqrt((std::max)(curvature[v] / area[v], 0.0)) : 0;
  return curvature;
}

/// Returns the mean of values at vertices over the area of a surface.
inline double mean_over(const SurfaceView& surface, const std::vector<double>& values) {
  double sum = 0, area = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& at = surface.points;
    const double of_face = std::sqrt(squared_length(normal_vector(at[a], at[b], at[c])));
    sum += of_face * (values[a] + values[b] + values[c]) / 3;
    area += of_face;
  }
  return area > 0 ? sum / area : 0;
}

inline void require_factor(const char* function, const char* name, double factor) {
  if (!(factor >= 0) || !std::isfinite(factor))
    throw std::invalid_argument(std::string(function) + ": " + name + " " + text_of(factor) +
                                " is negative or not finite");
}

inline std::vector<double> importances(const char* function, TriangleSoup<> surface,
                                       const CurvatureImportance& how) {
  require_factor(function, "strength", how.strength);
  rescale(surface);
  std::vector<double> importances = curvatures(surface);
  constexpr double flat = 0x1p-50; // a turn of 2⁻³⁰ across a surface of the size 2²⁰: rounding
  const double mean = mean_over(surface, importances);
  for (double& x : importances)
    x = mean > flat ? std::pow(1 + x / mean, how.strength) : 1;
  return importances;
}

/// Returns a factor for each vertex from its orientation to an eye, in the unit of the surface.
inline std::vector<double> facing(const SurfaceView& surface, const Vector<3>& eye,
                                  const ViewImportance& how) {
  std::vector<std::array<bool, 2>> has_face(surface.points.size()); // away, towards the eye
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& at = surface.points;
    const Vector<3> normal = normal_vector(at[a], at[b], at[c]);
    if (!(squared_length(normal) > 0))
      continue;
    for (std::size_t v : {a, b, c})
      has_face[v][dot(normal, eye - at[a]) > 0] = true;
  }
  std::vector<double> factors;
  for (const auto& [is_away, is_towards] : has_face)
    factors.push_back(!is_away ? 1 : is_towards ? how.outline : how.turned_away);
  return factors;
}

inline std::vector<double> importances(const char* function, TriangleSoup<> surface,
                                       const ViewImportance& how) {
  constexpr double nearest = 1e-2; // fraction of the distance to the farthest vertex
  require_factor(function, "turned_away", how.turned_away);
  require_factor(function, "outline", how.outline);
  if (!is_finite(how.eye))
    throw std::invalid_argument(std::string(function) + ": the eye is not finite");
  const Scale<3> scale = rescale(surface);
  const Vector<3> eye = scale.position_from_mesh(how.eye);
  std::vector<double> importances = facing(surface, eye, how);
  const auto distance = [&](const Vector<3>& p) { return std::sqrt(squared_distance(p, eye)); };
  double farthest = 0;
  for (const Vector<3>& p : surface.points)
    farthest = (std::max)(farthest, distance(p));
  for (std::size_t v = 0; v < importances.size() && farthest > 0; ++v)
    importances[v] *= std::pow((std::max)(distance(surface.points[v]) / farthest, nearest), -3);
  return importances;
}

template <class Mesh, class Map>
void put_importances(const Mesh& mesh, Map map, const std::vector<double>& importances) {
  std::size_t i = 0;
  for (const auto v : vertices(mesh))
    put(map, v, importances[i++]);
}

} // namespace internal

/// Returns importances for vertex_importance_map that keep more faces where the surface is curved:
/// (1 + κ/κ̄)^strength, where κ² is the sum of the squares of both principal curvatures and κ̄ the
/// mean of κ over the area; 1 everywhere on a flat surface. There is one for each point. It takes
/// linear time.
///
/// `points` and `triangles` are a polygon soup. Throws std::invalid_argument for a strength that is
/// negative or not finite, a point that is not finite, and a face that is not a triangle or has an
/// index without a point.
///
/// κ² is the square of the gradient of the vertex normals, linear on each face, in the mean over
/// the faces of a vertex. Source: Rusinkiewicz, Estimating Curvatures and Their Derivatives on
/// Triangle Meshes, 2004, section 3 (normals that are linear on faces); Pinkall and Polthier,
/// Computing Discrete Minimal Surfaces and Their Conjugates, 1993 (the gradient by cotangents).
template <std::ranges::input_range Points, std::ranges::input_range Triangles>
std::vector<double> curvature_importance(const Points& points, const Triangles& triangles,
                                         const CurvatureImportance& how = {}) {
  constexpr const char* function = "quadrille::curvature_importance";
  return internal::importances(function, internal::read_surface(function, points, triangles), how);
}

/// Writes the importances of a mesh, a model of CGAL's FaceListGraph, to a property map of its
/// vertices.
template <class Mesh, class Map>
requires internal::ReadableGraph<Mesh>
void curvature_importance(const Mesh& mesh, Map map, const CurvatureImportance& how = {}) {
  constexpr const char* function = "quadrille::curvature_importance";
  internal::put_importances(
      mesh, map, internal::importances(function, internal::read_surface(function, mesh), how));
}

/// Returns importances for vertex_importance_map for a surface that is seen from one position:
/// proportional to distance⁻³, so that errors look equally large at any distance (half the
/// distance, half the error), times ViewImportance::turned_away and outline. Occluded regions count
/// as visible. Distances below a hundredth of that of the farthest vertex count as this value.
/// There is one importance for each point. It takes linear time.
///
/// `points` and `triangles` are a polygon soup. Throws std::invalid_argument for factors that are
/// negative or not finite, an eye or a point that is not finite, and a face that is not a triangle
/// or has an index without a point.
template <std::ranges::input_range Points, std::ranges::input_range Triangles>
std::vector<double> view_importance(const Points& points, const Triangles& triangles,
                                    const ViewImportance& how) {
  constexpr const char* function = "quadrille::view_importance";
  return internal::importances(function, internal::read_surface(function, points, triangles), how);
}

/// Writes the importances of a mesh, a model of CGAL's FaceListGraph, to a property map of its
/// vertices.
template <class Mesh, class Map>
requires internal::ReadableGraph<Mesh>
void view_importance(const Mesh& mesh, Map map, const ViewImportance& how) {
  constexpr const char* function = "quadrille::view_importance";
  internal::put_importances(
      mesh, map, internal::importances(function, internal::read_surface(function, mesh), how));
}

} // namespace quadrille

#endif // QUADRILLE_IMPORTANCE_H
