// SPDX-License-Identifier: MIT
//
// Does a result keep what was promised of it? This header measures; it takes no part in
// simplifying, shares no code with what does, and quadrille/simplify.h never includes it.
//
// Licence: this file is MIT, but it includes CGAL's Polygon Mesh Processing, box intersection and
// Surface_mesh, which are GPL-3.0-or-later (or commercial). A program that includes it is bound by
// their terms.

#ifndef QUADRILLE_VERIFY_H
#define QUADRILLE_VERIFY_H

#include <quadrille/internal/verify/checked_distance.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/claimed_maps.h>
#include <quadrille/internal/verify/intersecting_pairs.h>
#include <quadrille/internal/verify/normal_angles.h>
#include <quadrille/internal/verify/solid_check.h>
#include <quadrille/internal/verify/tolerance_check.h>
#include <quadrille/verdict.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <ranges>
#include <stdexcept>
#include <utility>
#include <vector>

namespace quadrille {

namespace internal {

/// What claims say of two surfaces, one after the other.
class Verification {
public:
  Verification(CheckedSurface input, CheckedSurface result)
      : input_(std::move(input)), result_(std::move(result)) {}

  Verdict operator()(const Claims& claims) {
    if (claims.distance || claims.distance_both_ways)
      look_at_distance(claims);
    if (!claims.tolerances.empty())
      look_at_tolerances(claims.tolerances);
    if (claims.no_self_intersection)
      look_at_intersections();
    if (claims.solid)
      look_at_solid();
    if (claims.normal_deviation)
      look_at_normals(*claims.normal_deviation, claims.images);
    return std::move(verdict_);
  }

private:
  void look_at_distance(const Claims& claims) {
    const CheckedDistance distance(result_, input_);
    const double greatest = (std::min)(claims.distance.value_or(infinity),
                                       claims.distance_both_ways.value_or(infinity));
    add_distance("distance of the result from the input", greatest, distance,
                 &CheckedDistance::from_a);
    if (claims.distance_both_ways)
      add_distance("distance of the input from the result", *claims.distance_both_ways, distance,
                   &CheckedDistance::from_b);
  }

  // CGAL takes the longer the less it may be wrong, so a small part of the promise is enough.
  void add_distance(const char* claim, double promised, const CheckedDistance& distance,
                    double (CheckedDistance::*measure)(double) const) {
    if (!(promised >= 0))
      throw std::invalid_argument("quadrille::verify: what is claimed is not a distance");
    const double error = error_of(promised, distance.diagonal_of_both());
    const double measured = (distance.*measure)(error);
    verdict_.findings.push_back({claim, promised, measured, error, measured <= promised + error});
  }

  static double error_of(double promised, double diagonal) {
    return (std::max)((std::min)(promised / 20, 1e-3 * diagonal), 1e-5 * diagonal);
  }

  // What is measured is no more than the truth, and less by no more than half of the error: so what
  // is beyond half of it is broken, and what is broken by all of it is found.
  void look_at_tolerances(const std::vector<double>& tolerances) {
    const ToleranceCheck check(input_, tolerances, result_);
    const double error = error_of(check.least_tolerance(), check.diagonal_of_both());
    const auto add = [&](const char* claim, double measured) {
      verdict_.findings.push_back({claim, 0, measured, error, measured <= error / 2});
    };
    add("distance of the input from the result, beyond its tolerances", check.of_input(error / 2));
    add("distance of the result from the input, beyond its tolerances", check.of_result(error / 2));
  }

  void look_at_normals(double promised, const std::vector<std::size_t>& images) {
    if (!(promised >= 0))
      throw std::invalid_argument("quadrille::verify: what is claimed is not an angle");
    const auto [at_least, at_most, unknown] = NormalAngles(input_, images, result_).measure();
    constexpr double rounding = 1e-6; // degrees
    verdict_.findings.push_back({"degrees between normals", promised, at_least,
                                 at_most - at_least + rounding, at_least <= promised + rounding});
    add_number("faces of the result that none of the input has become", std::size_t{0}, unknown);
  }

  void look_at_intersections() {
    add_number("intersecting pairs of faces", IntersectingPairs(input_).count(),
               IntersectingPairs(result_).count(),
               [](double before, double after) { return after <= before; });
  }

  void look_at_solid() {
    const SolidMeasures before = SolidCheck(input_).measure();
    const SolidMeasures after = SolidCheck(result_).measure();
    add_number("open edges", std::size_t{0}, after.open_edges);
    add_number("components", before.components, after.components);
    add_number("Euler number", before.euler_number, after.euler_number);
    add_number("components inside of others", before.nesting, after.nesting);
    add_number("bounds a volume", true, after.bounds_a_volume);
  }

  template <class Number, class IsHeld = std::equal_to<double>>
  void add_number(const char* claim, Number promised, Number measured, IsHeld is_held = {}) {
    const auto p = static_cast<double>(promised), m = static_cast<double>(measured);
    verdict_.findings.push_back({claim, p, m, 0, is_held(p, m)});
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  CheckedSurface input_, result_;
  Verdict verdict_;
};

/// The two halves of a polygon soup: points, and triples of indices into them.
template <class Points, class Triangles>
concept CheckableSoup =
    std::ranges::input_range<const Points> && std::ranges::input_range<const Triangles> &&
    std::ranges::input_range<std::ranges::range_reference_t<const Triangles>>;

} // namespace internal

/// Looks whether a simplified mesh keeps what is claimed of it, by code that shares nothing with
/// the engine.
///
/// Distances are those of CGAL's bounded_error_Hausdorff_distance (Tang, Lee and Kim, "Interactive
/// Hausdorff distance computation for general polygonal models", 2009). They are wrong by at most a
/// twentieth of what is promised, but not by less than 10⁻⁵ of the diagonal of both surfaces, nor
/// by more than 10⁻³; what is beyond the promise by no more than that counts as held. What is
/// beyond tolerances is measured by pieces of faces, with an error in the same bounds by the least
/// of them: what is told is never more than the truth. Angles are those of all pairs of faces.
/// Faces intersect as for NoSelfIntersection; CGAL's exact predicates decide. A surface is solid if
/// each edge has as many faces on one side as on the other, and CGAL's does_bound_a_volume says so
/// of what is left when it has been cut where it only touches itself.
///
/// Both are models of CGAL's FaceListGraph with a vertex_point map; types may differ. What was
/// rounded to the numbers of a mesh is measured as it is there. Complexity: about O(n log n) for n
/// faces of both, but for distances, which take seconds for 10⁵ faces, the more the smaller they
/// are. Throws std::invalid_argument for a face that is not a triangle, a coordinate that is not
/// finite, a claimed distance or angle that is none, tolerances or images that are not as many as
/// the vertices of the input, and a surface without faces whose distance is claimed.
template <class MeshA, class MeshB>
requires(!std::ranges::range<MeshA> && !std::ranges::range<MeshB>) Verdict
    verify(const MeshA& input, const MeshB& result, const Claims& claims) {
  return internal::Verification(internal::checked_surface(input),
                                internal::checked_surface(result))(claims);
}

/// The same with maps of the vertices of the input, as named parameters of quadrille::parameters
/// like those of simplify(): vertex_tolerance_map claims tolerances, and vertex_image_map, which
/// tells vertices of the result (or null_vertex()), is for Claims::normal_deviation.
template <class MeshA, class MeshB, class NamedParameters>
requires(!std::ranges::range<MeshA> && !std::ranges::range<MeshB>) Verdict
    verify(const MeshA& input, const MeshB& result, Claims claims, const NamedParameters& named) {
  internal::add_tolerances(input, named, claims);
  internal::add_images(input, result, named, claims);
  return verify(input, result, claims);
}

/// The same for polygon soups, which may be non-manifold.
///
/// Points are anything with x(), y() and z(), or three numbers by index, in a range; triangles are
/// ranges of three indices. Faces whose three indices are not different are left out. Throws
/// std::out_of_range when an index names no point, otherwise as for meshes.
template <class PointsA, class TrianglesA, class PointsB, class TrianglesB>
requires internal::CheckableSoup<PointsA, TrianglesA> &&
    internal::CheckableSoup<PointsB, TrianglesB>
        Verdict verify(const PointsA& input_points, const TrianglesA& input_triangles,
                       const PointsB& result_points, const TrianglesB& result_triangles,
                       const Claims& claims) {
  return internal::Verification(internal::checked_surface(input_points, input_triangles),
                                internal::checked_surface(result_points, result_triangles))(claims);
}

} // namespace quadrille

#endif // QUADRILLE_VERIFY_H
