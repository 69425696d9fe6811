// SPDX-License-Identifier: MIT
//
// Does a result keep what was promised of it? This header measures; it takes no part in
// simplifying, shares no code with what does but how points and triangles are read, and
// quadrille/simplify.h never includes it.
//
// Licence: this file is MIT, but it includes CGAL's Polygon Mesh Processing, box intersection and
// Surface_mesh, which are GPL-3.0-or-later (or commercial). A program that includes it is bound by
// their terms.

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

/// What claims say of two surfaces, one after the other.
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
      throw std::invalid_argument("quadrille::verify: what is claimed is not an angle");
  }

  // Nothing can be said of a surface without faces but that the other one has none either.
  bool are_both_there(const Claims& claims) {
    const bool is_any_claimed = stages(claims) > 0 || claims.normal_deviation;
    if (!is_any_claimed || (!input_.triangles.empty() && !result_.triangles.empty()))
      return true;
    add_number("faces, where only one of both surfaces has any", input_.triangles.size(),
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
      look_at_normals(*claims.normal_deviation, claims.images);
  }

  void look_at_normals(double promised, const std::vector<std::size_t>& images) {
    const NormalAngles::Greatest greatest = NormalAngles(input_, images, result_).measure();
    constexpr double rounding = 1e-6; // degrees
    add({"degrees between normals", promised, greatest.at_least,
         greatest.at_most - greatest.at_least + rounding, greatest.at_least <= promised + rounding},
        greatest.face);
    add({"faces of the result that none of the input has become", 0,
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

  // Where it is not held, it is so at a face of the result.
  void add(Finding finding, std::size_t face) {
    if (!finding.is_held)
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

/// Looks whether a simplified mesh keeps what is claimed of it, by code that shares nothing with
/// the engine.
///
/// Distances are measured by pieces of faces, cut along those of the other surface and halved until
/// they are known to a fortieth of what is promised, but to no less than 5·10⁻⁶ of the diagonal of
/// both surfaces, nor to more than 5·10⁻⁴: what is told is never more than the truth but for
/// roundings. What is beyond the promise by no more than that counts as held, so what is broken by
/// twice as much, Finding::error, never does, and what is kept always does. What is beyond
/// tolerances is measured in the same way, by the least of them. Angles are those of all pairs of
/// faces. Faces intersect as for NoSelfIntersection; CGAL's exact predicates decide. Where some of
/// the input only touch or overlap in a plane, those that pass through each other are counted, too.
///
/// Solids are compared part by part, cut where a surface only touches itself. Which part has become
/// which is told by where they are, and where that says little, since parts lie closer together
/// than they have changed, by what they have in common. An input need not bound a volume: then the
/// result has to be turned like it.
///
/// Where only one of both has faces, no claim is held. `claims.progress` follows it and may end it.
///
/// Both are models of CGAL's FaceListGraph with a vertex_point map; types may differ. What was
/// rounded to the numbers of a mesh is measured as it is there. Complexity: about O(n log n) for n
/// faces of both; distances take about a second for 10⁴ faces at a thousandth of the diagonal,
/// whether surfaces are flat or curved, and solids of k parts O(k²) beside that. Throws
/// std::invalid_argument for a face that is not a triangle, a coordinate that is not finite, a
/// claimed distance or angle that is none, tolerances or images that are not as many as the
/// vertices of the input, and an input with open edges of which it is claimed that it is a solid.
template <class MeshA, class MeshB>
requires(!std::ranges::range<MeshA> && !std::ranges::range<MeshB>) Verdict
    verify(const MeshA& input, const MeshB& result, const Claims& claims) {
  return internal::Verification(internal::checked_surface("quadrille::verify: the input", input),
                                internal::checked_surface("quadrille::verify: the result", result))(
      claims);
}

/// The same with maps of the vertices of the input, as named parameters of quadrille::parameters
/// like those of simplify(): vertex_tolerance_map claims tolerances, and vertex_to_vertex_map,
/// which tells vertices of the result (or null_vertex()), is for Claims::normal_deviation.
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
