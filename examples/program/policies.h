#ifndef QUADRILLE_EXAMPLES_PROGRAM_POLICIES_H
#define QUADRILLE_EXAMPLES_PROGRAM_POLICIES_H

/// \file
/// Policies chosen at run time: one engine for each cost is enough then.

#include <quadrille/compiled.h>
#include <quadrille/placement.h>
#include <quadrille/report.h>
#include <quadrille/stop.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <variant>

namespace quadrille_examples {

struct Target {
  std::variant<quadrille::FaceRatio, quadrille::FaceCount, quadrille::VertexCount,
               quadrille::ErrorLimit>
      chosen;
  double distance = 0; // of an error limit

  bool operator()(const quadrille::Status& status) const {
    return std::visit([&](const auto& stop) { return stop(status); }, chosen);
  }
  bool is_passed(const quadrille::Status& status) const {
    const auto asked = [&](const auto& stop) {
      if constexpr (requires { stop.is_passed(status); })
        return stop.is_passed(status);
      else
        return false;
    };
    return std::visit(asked, chosen);
  }
  void tell(quadrille::SoupOptions& options) const {
    if (const auto* stop = std::get_if<quadrille::FaceRatio>(&chosen))
      options.ratio = stop->ratio;
    if (const auto* stop = std::get_if<quadrille::FaceCount>(&chosen))
      options.faces = stop->faces;
    if (const auto* stop = std::get_if<quadrille::VertexCount>(&chosen))
      options.vertices = stop->vertices;
    if (std::holds_alternative<quadrille::ErrorLimit>(chosen))
      options.error = distance;
  }
  /// The target of a surface of some faces, where `done` tells of surfaces before it and `rest` are
  /// the faces from it on: its part of what those before it leave.
  Target share(const quadrille::Report& done, std::size_t faces, std::size_t rest) const {
    const auto left = [](double wanted, std::size_t used) {
      return std::max(0., wanted - static_cast<double>(used));
    };
    const auto share_of = [&](std::size_t wanted, std::size_t used) {
      const double part = static_cast<double>(faces) / static_cast<double>(rest);
      return static_cast<std::size_t>(std::llround(left(static_cast<double>(wanted), used) * part));
    };
    Target result = *this;
    if (auto* stop = std::get_if<quadrille::FaceRatio>(&result.chosen)) {
      const double wanted = stop->ratio * static_cast<double>(done.faces_before + rest);
      stop->ratio = std::min(1., left(wanted, done.faces_after) / static_cast<double>(rest));
    }
    if (auto* stop = std::get_if<quadrille::FaceCount>(&result.chosen))
      stop->faces = share_of(stop->faces, done.faces_after);
    if (auto* stop = std::get_if<quadrille::VertexCount>(&result.chosen))
      stop->vertices = share_of(stop->vertices, done.vertices_after);
    return result;
  }
  /// An error limit is kept also if there is nothing more to contract. A target that was passed by
  /// a face or so counts as met: the report tells.
  bool is_met(quadrille::StopReason reason) const {
    return quadrille::is_target_reached(reason) ||
           std::holds_alternative<quadrille::ErrorLimit>(chosen);
  }
};

struct Placement {
  enum { optimal, endpoint, midpoint } chosen;
  using ScaleFree = Placement; // as each of them is

  // The return type is spelt out so that asking whether this is a policy of another kind is no
  // error.
  auto operator()(const auto& cost, const auto& pair) const
      -> std::remove_cvref_t<decltype(pair.first)> {
    if constexpr (requires { cost.minimizer(pair); })
      if (chosen == optimal)
        return quadrille::OptimalPlacement{}(cost, pair);
    if (chosen == endpoint)
      return quadrille::EndpointPlacement{}(cost, pair);
    return quadrille::MidpointPlacement{}(cost, pair);
  }
};

} // namespace quadrille_examples

#endif
