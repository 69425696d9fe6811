#ifndef QUADRILLE_VERDICT_H
#define QUADRILLE_VERDICT_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace quadrille {

/// The claims to verify about a result. Claims that are not set are not checked.
struct Claims {
  /// A claim that no point of the result is further from the input than this distance, in the unit
  /// of both: see DistanceLimit and Report::distance_bound.
  std::optional<double> distance = {};
  /// A claim that also no point of the input is further from the result.
  std::optional<double> distance_both_ways = {};
  /// The claimed tolerance at each vertex of the input, by its index or in the order of
  /// vertices(mesh); the tolerance of a face is the least of its corners. No point of an input face
  /// is further from the result, and each point of the result is within the tolerance of some input
  /// face: see ToleranceLimit. If it is empty, nothing is claimed.
  std::vector<double> tolerances = {};
  /// No more pairs of faces intersect than in the input: see NoSelfIntersection. If no pair of the
  /// input intersects, this is the whole guarantee.
  bool no_self_intersection = false;
  /// The input, which is closed, and the result are solids alike: the result is closed, and each
  /// component of the input corresponds to one component of the result, with the same number of
  /// handles, the same inner side, not flat, and enclosed by the same other components. It bounds a
  /// volume if the input does. See KeepSolid{}.
  bool solid = false;
  /// A claim that no normal of the result deviates by more than this angle, in degrees, from the
  /// normal of any input face that was merged into its face, or into one of the face's edges: see
  /// NormalDeviation. It needs `vertex_map`, which must explain each face of the result; so it
  /// cannot be used for results with duplicated vertices.
  std::optional<double> normal_deviation = {};
  /// For each vertex of the input, the vertex of the result into which it was merged, by their
  /// indices or in the order of vertices(mesh); parameters::vanished for none. They are the result
  /// of vertex_to_vertex_map.
  std::vector<std::size_t> vertex_map = {};
  /// Not a claim: a function that is called repeatedly with the fraction of the work that is done,
  /// from 0 to 1. If it returns false, verify() ends soon, with Verdict::is_cancelled.
  std::function<bool(double fraction)> progress = {};

  /// Returns whether distances are claimed, in one direction or both.
  bool are_distances_claimed() const { return distance || distance_both_ways; }
};

/// A claim and the measured value.
struct Finding {
  std::string claim; ///< the claim in words
  double promised =
      0; ///< a distance in the unit of the surfaces, degrees, or a number of what is named
  double measured = 0; ///< the measured number
  double error = 0;    ///< the greatest possible error of the measured value
  /// Whether the claim is met: always if it is true, and never if the true value exceeds it by
  /// more than the error.
  bool is_met = false;
  /// A place where the claim is broken, in the unit of the surfaces: one of the farthest points, a
  /// point of a face that intersects another one or whose normal deviates too far, or a point of a
  /// component that has changed.
  std::optional<Vector<3>> place = {};
};

/// The findings of verify(). They can be printed in one line.
struct Verdict {
  std::vector<Finding> findings; ///< one or more for each claim, in the order of Claims
  bool is_cancelled = false;     ///< cancelled by Claims::progress: then not everything was checked

  /// Returns whether all claims are met, as far as is known.
  bool is_met() const {
    return !is_cancelled && std::all_of(findings.begin(), findings.end(),
                                        [](const Finding& finding) { return finding.is_met; });
  }
  explicit operator bool() const { return is_met(); } ///< equals is_met()
};

/// Prints a verdict in one line, without an end of line.
inline std::ostream& operator<<(std::ostream& out, const Verdict& verdict) {
  const char* separator = "";
  for (const Finding& finding : verdict.findings) {
    out << separator << finding.claim << ": " << finding.promised << " promised, "
        << finding.measured << " measured" << (finding.is_met ? "" : ", BROKEN");
    if (const auto& p = finding.place; p && !finding.is_met)
      out << " near (" << (*p)[0] << ", " << (*p)[1] << ", " << (*p)[2] << ")";
    separator = "; ";
  }
  if (verdict.is_cancelled)
    out << separator << "cancelled before everything was measured";
  return out;
}

} // namespace quadrille

#endif // QUADRILLE_VERDICT_H
