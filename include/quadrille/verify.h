// SPDX-License-Identifier: MIT
//
// Verifies whether a result keeps the claims made of it. This header only measures. It shares no
// code with the simplification, except for the reading of points and triangles, and
// quadrille/simplify.h never includes it.

#ifndef QUADRILLE_VERIFY_H
#define QUADRILLE_VERIFY_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_distance.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/claimed_maps.h>
#include <quadrille/internal/verify/distance_findings.h>
#include <quadrille/internal/verify/intersecting_pairs.h>
#include <quadrille/internal/verify/normal_angles.h>
#include <quadrille/internal/verify/solid_check.h>
#include <quadrille/quadric_form.h>
#include <quadrille/verdict.h>

#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <utility>
#include <vector>

namespace quadrille {

namespace internal {

/// Verifies claims about two surfaces, one after the other.
class Verification {
public:
  Verification(TriangleSoup<> input, TriangleSoup<> result)
      : input_(std::move(input)), result_(std::move(result)) {}

  Verdict operator()(const Claims& claims) {
    require_sense(claims);
    if (!are_both_there(claims))
      return std::move(verdict_);
    CheckProgress progress(claims.progress, stages(claims));
    try {
      look_at_all(claims, progress);
    } catch (const CheckCancelled&) {
      verdict_.is_cancelled = true;
    }
    return std::move(verdict_);
  }

private:
  static std::size_t stages(const Claims& claims) {
    return std::size_t{claims.are_distances_claimed()} + claims.distance_both_ways.has_value() +
           2 * std::size_t{!claims.tolerances.empty()} +
           2 * std::size_t{claims.no_self_intersection} + std::size_t{claims.solid};
  }

  static void require_sense(const Claims& claims) {
    DistanceFindings::require_sense(claims);
    if (!(claims.normal_deviation.value_or(0) >= 0))
      throw std::invalid_argument(
          "quadrille::verify: the claimed angle is negative or not a number");
  }

  // A surface without faces allows only one conclusion: whether the other one has no faces either.
  bool are_both_there(const Claims& claims) {
    const bool is_any_claimed = stages(claims) > 0 || claims.normal_deviation;
    if (!is_any_claimed || (!input_.triangles.empty() && !result_.triangles.empty()))
      return true;
    add_number("faces, which only one of the surfaces has", input_.triangles.size(),
               result_.triangles.size());
    return false;
  }

  void look_at_all(const Claims& claims, CheckProgress& progress) {
    if (claims.are_distances_claimed())
      DistanceFindings::look(claims, CheckedDistance(input_, {}, result_, progress), progress,
                             verdict_);
    if (!claims.tolerances.empty())
      DistanceFindings::look_at_tolerances(
          CheckedDistance(input_, claims.tolerances, result_, progress), progress, verdict_);
    if (claims.no_self_intersection)
      look_at_intersections(progress);
    if (claims.solid) {
      for (Finding& finding : SolidCheck(input_, result_, progress).look())
        verdict_.findings.push_back(std::move(finding));
      progress.next_stage();
    }
    if (claims.normal_deviation)
      look_at_normals(*claims.normal_deviation, claims.vertex_map);
  }

  void look_at_normals(double promised, const std::vector<std::size_t>& vertex_map) {
    const NormalAngles::Greatest greatest = NormalAngles(input_, vertex_map, result_).measure();
    constexpr double rounding = 1e-6; // degrees
    add({"degrees between normals", promised, greatest.at_least,
         greatest.at_most - greatest.at_least + rounding, greatest.at_least <= promised + rounding},
        greatest.face);
    add({"faces of the result without a face in the input", 0,
         static_cast<double>(greatest.unknown), 0, greatest.unknown == 0},
        greatest.first_unknown);
  }

  void look_at_intersections(CheckProgress& progress) {
    const IntersectingPairs::Found before = IntersectingPairs(input_).find(progress);
    progress.next_stage();
    const IntersectingPairs::Found after = IntersectingPairs(result_).find(progress);
    progress.next_stage();
    add_pairs("intersecting pairs of faces", before.meet, after.meet);
    if (before.meet.count > before.pass_through.count)
      add_pairs("pairs of faces that pass through each other", before.pass_through,
                after.pass_through);
  }

  void add_pairs(const char* claim, const IntersectingPairs::Kind& before,
                 const IntersectingPairs::Kind& after) {
    add({claim, static_cast<double>(before.count), static_cast<double>(after.count), 0,
         after.count <= before.count},
        after.first);
  }

  // A broken claim is located at a face of the result.
  void add(Finding finding, std::size_t face) {
    if (!finding.is_met)
      finding.place = result_.points[result_.triangles[face][0]];
    verdict_.findings.push_back(std::move(finding));
  }

  void add_number(const char* claim, std::size_t promised, std::size_t measured) {
    verdict_.findings.push_back({claim, static_cast<double>(promised),
                                 static_cast<double>(measured), 0, promised == measured});
  }

  TriangleSoup<> input_, result_;
  Verdict verdict_;
};

} // namespace internal

/// Verifies whether a simplified mesh keeps the claims made of it, with code that is independent of
/// the engine.
///
/// For distances, faces are cut along the faces of the other surface and subdivided until the
/// distance is known to a fortieth of the claim, but at least to 5·10⁻⁴ and at most to 5·10⁻⁶ of
/// the diagonal of both surfaces. Up to rounding, the measured distance never exceeds the true one.
/// A claim that is exceeded by no more than this accuracy counts as met; so a claim that is true
/// is always met, and one that is exceeded by more than twice the accuracy, Finding::error, is
/// always broken. Excess over tolerances is measured in the same way, relative to the least of
/// them. Angles are those of all pairs of faces. Faces intersect as for NoSelfIntersection, decided
/// by CGAL's exact predicates. If some input faces only touch or overlap in a plane, the pairs that
/// pass through each other are counted too.
///
/// Solids are compared component by component, after cutting the surface where it only touches
/// itself. Components are matched by their positions, or, if they lie closer together than the
/// distance by which they changed, by what they have in common. The input need not
/// bound a volume; the result must then have the same orientation.
///
/// If only one of the two surfaces has faces, no claim is met. `claims.progress` receives the
/// progress and may end the verification.
///
/// Both are models of CGAL's FaceListGraph with a vertex_point map; types may differ. Rounded
/// coordinates are measured as they are stored in the mesh. Complexity: about O(n log n) for n
/// faces of both; distances take about a second for 10⁴ faces at a thousandth of the diagonal,
/// whether surfaces are flat or curved, and solids of k components O(k²) in addition. Throws
/// std::invalid_argument for a face that is not a triangle, a coordinate that is not finite, an
/// invalid distance or angle, tolerances or a vertex map whose number is not that of the input
/// vertices, and a claim of solidity for an input with open edges.
template <class MeshA, class MeshB>
requires(!std::ranges::range<MeshA> && !std::ranges::range<MeshB>) Verdict
    verify(const MeshA& input, const MeshB& result, const Claims& claims) {
  return internal::Verification(internal::checked_surface("quadrille::verify: the input", input),
                                internal::checked_surface("quadrille::verify: the result", result))(
      claims);
}

/// Verifies with maps of the vertices of the input, as named parameters of quadrille::parameters
/// like those of simplify(): vertex_tolerance_map claims tolerances, and vertex_to_vertex_map,
/// which gives vertices of the result (or null_vertex()), is for Claims::normal_deviation.
template <class MeshA, class MeshB, class NamedParameters>
requires(!std::ranges::range<MeshA> && !std::ranges::range<MeshB>) Verdict
    verify(const MeshA& input, const MeshB& result, Claims claims, const NamedParameters& named) {
  internal::add_tolerances(input, named, claims);
  internal::add_vertex_map(input, result, named, claims);
  return verify(input, result, claims);
}

/// Verifies polygon soups, which may be non-manifold.
///
/// Points are anything with x(), y() and z(), or three numbers by index, in a range; triangles are
/// random access ranges of three indices. Faces whose three indices are not different are left out.
/// Throws std::invalid_argument also when an index names no point.
template <class PointsA, class TrianglesA, class PointsB, class TrianglesB>
requires internal::ReadableSoup<PointsA, TrianglesA> && internal::ReadableSoup<PointsB, TrianglesB>
    Verdict verify(const PointsA& input_points, const TrianglesA& input_triangles,
                   const PointsB& result_points, const TrianglesB& result_triangles,
                   const Claims& claims) {
  return internal::Verification(
      internal::checked_surface("quadrille::verify: the input", input_points, input_triangles),
      internal::checked_surface("quadrille::verify: the result", result_points, result_triangles))(
      claims);
}

} // namespace quadrille

#endif // QUADRILLE_VERIFY_H
