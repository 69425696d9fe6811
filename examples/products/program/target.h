#ifndef QUADRILLE_EXAMPLES_PROGRAM_TARGET_H
#define QUADRILLE_EXAMPLES_PROGRAM_TARGET_H

/// \file
/// Where a run of the program ends.

#include "../mesh_io/amount.h"

#include <quadrille/compiled/soup_job.h>
#include <quadrille/report.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace quadrille_examples {

/// A run stops at the first of those that are given, or at half of the faces if none is.
struct Target {
  std::optional<std::size_t> faces = {}, vertices = {};
  std::optional<double> ratio = {}; ///< of the faces, in [0, 1]
  std::optional<Amount> error = {}; ///< a distance from the input
  bool both_ways = false;           ///< and of the input from the result
  bool is_calibrated = false;       ///< is it measured instead of added up?
  std::string tolerance = {};       ///< the scalar of vertices that limits it instead; empty: none

  bool is_given() const { return faces || vertices || ratio || is_limited(); }
  bool is_limited() const { return error || !tolerance.empty(); }

  /// Takes the part that the table of options has.
  void take(const quadrille::internal::SoupJob& options) {
    faces = options.faces;
    vertices = options.vertices;
    ratio = options.ratio;
    both_ways = options.both_ways;
    is_calibrated = options.calibrated;
  }

  void tell(quadrille::SoupOptions& options) const {
    options.faces = faces;
    options.vertices = vertices;
    options.ratio = ratio;
    if (error)
      (error->is_percentage ? options.relative_error : options.error) = error->value;
    options.both_ways = both_ways;
  }

  /// Would a surface of so many faces and vertices, of so many at the beginning, be coarse enough?
  /// A limit of distances does not tell.
  bool is_coarse_enough(const quadrille::Status& surface) const {
    const double part = ratio.value_or(is_given() ? -1 : 0.5);
    return (faces && surface.faces <= *faces) || (vertices && surface.vertices <= *vertices) ||
           static_cast<double>(surface.faces) <=
               std::round(part * static_cast<double>(surface.initial_faces));
  }

  /// An error limit is kept also if there is nothing more to contract. A target that was passed by
  /// a face or so counts as met: the report tells.
  bool is_met(quadrille::StopReason reason) const {
    return quadrille::is_target_reached(reason) ||
           (is_limited() && reason != quadrille::StopReason::cancelled);
  }
};

} // namespace quadrille_examples

#endif
