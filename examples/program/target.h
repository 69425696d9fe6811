#ifndef QUADRILLE_EXAMPLES_PROGRAM_TARGET_H
#define QUADRILLE_EXAMPLES_PROGRAM_TARGET_H

/// \file
/// Where a run of the program ends.

#include "../amount.h"

#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace quadrille_examples {

/// A run stops at the first of those that are given, or at half of the faces if none is.
struct Target {
  std::optional<std::size_t> faces = {}, vertices = {};
  std::optional<double> ratio = {}; ///< of the faces, in [0, 1]
  std::optional<Amount> error = {}; ///< a distance from the input

  bool is_given() const { return faces || vertices || ratio || error; }

  void tell(quadrille::SoupOptions& options) const {
    options.faces = faces;
    options.vertices = vertices;
    options.ratio = ratio;
    if (error)
      (error->is_percentage ? options.relative_error : options.error) = error->value;
  }

  /// Would a surface of so many faces and vertices, of so many at the beginning, be coarse enough?
  /// A limit of distances does not tell.
  bool is_coarse_enough(const quadrille::Status& surface) const {
    const double part = ratio.value_or(is_given() ? -1 : 0.5);
    return (faces && surface.faces <= *faces) || (vertices && surface.vertices <= *vertices) ||
           static_cast<double>(surface.faces) <=
               std::round(part * static_cast<double>(surface.initial_faces));
  }

  /// The target of a surface of some faces, where `done` tells of surfaces before it and `rest` are
  /// the faces from it on: its part of what those before it leave.
  Target share(const quadrille::Report& done, std::size_t count, std::size_t rest) const {
    const auto left = [](double wanted, std::size_t used) {
      return std::max(0., wanted - static_cast<double>(used));
    };
    const auto share_of = [&](std::size_t wanted, std::size_t used) {
      const double part = static_cast<double>(count) / static_cast<double>(rest);
      return static_cast<std::size_t>(std::llround(left(static_cast<double>(wanted), used) * part));
    };
    Target result = *this;
    if (ratio || !is_given()) {
      const double wanted = ratio.value_or(0.5) * static_cast<double>(done.counted_faces + rest);
      result.ratio = std::min(1., left(wanted, done.faces_after) / static_cast<double>(rest));
    }
    if (faces)
      result.faces = share_of(*faces, done.faces_after);
    if (vertices)
      result.vertices = share_of(*vertices, done.vertices_after);
    return result;
  }

  /// An error limit is kept also if there is nothing more to contract. A target that was passed by
  /// a face or so counts as met: the report tells.
  bool is_met(quadrille::StopReason reason) const {
    return quadrille::is_target_reached(reason) ||
           (error && reason != quadrille::StopReason::cancelled);
  }
};

} // namespace quadrille_examples

#endif
