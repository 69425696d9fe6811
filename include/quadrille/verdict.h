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

/// What is claimed of a result. What is left out is not looked at.
struct Claims {
  /// No point of the result is further from the input than that, in the unit of both: see
  /// DistanceLimit and Report::distance_bound.
  std::optional<double> distance = {};
  /// The same, and no point of the input is further from the result.
  std::optional<double> distance_both_ways = {};
  /// Of each vertex of the input, by its index or in the order of vertices(mesh), how far points
  /// may be there; a face has the least of its corners. No point of an input face is further from
  /// the result, and each point of the result is within that of some input face: see
  /// ToleranceLimit. Empty: nothing is claimed.
  std::vector<double> tolerances = {};
  /// No more pairs of faces intersect than in the input: see NoSelfIntersection. Where none did,
  /// that is all of its promise.
  bool no_self_intersection = false;
  /// The input, which is closed, and the result are solids alike: the result is closed, and each
  /// part of the input has become one of it, with as many handles, with its inside on the same side
  /// and not flat, and in the same ones of the others. It bounds a volume if the input does. See
  /// KeepSolid{}.
  bool solid = false;
  /// No normal of the result is further than so many degrees from that of any face of the input
  /// that has become it, or one of its edges: see NormalDeviation. Needs `images`, which have to
  /// explain each face of the result; so they are not for what is written with duplicates of
  /// vertices.
  std::optional<double> normal_deviation = {};
  /// Of each vertex of the input, the vertex of the result that it has become, by their indices or
  /// in the order of vertices(mesh); parameters::vanished for none. vertex_to_vertex_map tells
  /// them.
  std::vector<std::size_t> images = {};
  /// No claim, but how to follow what takes long: told again and again which part of it is done,
  /// from 0 to 1. If it returns false, verify() ends soon: Verdict::is_cancelled.
  std::function<bool(double part)> progress = {};

  /// One way or both.
  bool are_distances_claimed() const { return distance || distance_both_ways; }
};

/// A claim, and what has been measured.
struct Finding {
  std::string claim; ///< in words
  double promised =
      0; ///< a distance in the unit of the surfaces, degrees, or a number of what is named
  double measured = 0; ///< the same
  double error = 0;    ///< by how much what is measured may be wrong, at most
  /// Is what is measured as it was promised? Always if that is so of the truth, and never if the
  /// truth is beyond it by more than the error.
  bool is_held = false;
  /// Where it is broken, in the unit of the surfaces: a point of the farthest, of a face that
  /// intersects another one or has a normal too far away, of a part that has changed.
  std::optional<Vector<3>> place = {};
};

/// What verify() has found, one after the other. It prints itself in one line.
struct Verdict {
  std::vector<Finding> findings; ///< one or some for each claim, in the order of Claims
  bool is_cancelled = false;     ///< by Claims::progress: then not all has been looked at

  /// Are all claims held, as far as is known?
  bool is_held() const {
    return !is_cancelled && std::all_of(findings.begin(), findings.end(),
                                        [](const Finding& finding) { return finding.is_held; });
  }
  explicit operator bool() const { return is_held(); } ///< the same
};

/// Prints a verdict in one line, without an end of line.
inline std::ostream& operator<<(std::ostream& out, const Verdict& verdict) {
  const char* separator = "";
  for (const Finding& finding : verdict.findings) {
    out << separator << finding.claim << ": " << finding.promised << " promised, "
        << finding.measured << " measured" << (finding.is_held ? "" : ", BROKEN");
    if (const auto& p = finding.place; p && !finding.is_held)
      out << " near (" << (*p)[0] << ", " << (*p)[1] << ", " << (*p)[2] << ")";
    separator = "; ";
  }
  if (verdict.is_cancelled)
    out << separator << "cancelled before all was measured";
  return out;
}

} // namespace quadrille

#endif // QUADRILLE_VERDICT_H
