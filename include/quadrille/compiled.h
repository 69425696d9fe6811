#ifndef QUADRILLE_COMPILED_H
#define QUADRILLE_COMPILED_H

#include <quadrille/quadric.h>
#include <quadrille/report.h>
#include <quadrille/topology.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

/// \file
/// Quadrille without templates, for polygon soups of doubles: what takes its time to compile is
/// compiled once, in the target quadrille::compiled, which a program that includes this header
/// links.

namespace quadrille {

/// What simplify_soup() is asked for. Each field is a policy of `simplify`, by its name.
struct SoupOptions {
  /// The costs by their names: see Quadric and the others.
  enum class Cost { quadric, memoryless_quadric, thin_feature_quadric, edge_length };
  /// The placements: see OptimalPlacement and the others.
  enum class Placement { optimal, endpoint, midpoint };
  /// The orders: see GreedyOrder and RelaxedOrder.
  enum class Order { greedy, relaxed };

  // --- Targets: it stops at the first that is met; FaceRatio{0.5} where there is none.
  std::optional<std::size_t> faces;     ///< see FaceCount
  std::optional<double> ratio;          ///< see FaceRatio, in [0, 1]
  std::optional<std::size_t> vertices;  ///< see VertexCount
  std::optional<double> error;          ///< see ErrorLimit: a distance, at least 0
  std::optional<double> relative_error; ///< see ErrorLimit::relative: a part of the diagonal

  Cost cost = Cost::quadric;                          ///< what a contraction costs
  double boundary_weight = Quadric{}.boundary_weight; ///< of costs that have one; at least 0
  std::optional<Placement> placement = std::nullopt;  ///< the best that the cost has by default
  Order order = Order::greedy;                        ///< which pair is next
  double pairs_closer_than = 0;                       ///< see ThresholdPairs; 0: edges only
  std::optional<Topology> topology = std::nullopt;    ///< kept, or free with pairs by default
  double normal_flip = 90;                            ///< degrees, see NormalFlip
  /// Points that stay where they are: empty, or a value for each point.
  std::vector<bool> fixed = {};
  /// Asked now and then; the simplification ends early when it returns false. See Visitor.
  std::function<bool(const Status&)> proceed = {};
};

using SoupPoints = std::vector<std::array<double, 3>>;           ///< coordinates, finite
using SoupTriangles = std::vector<std::array<std::uint32_t, 3>>; ///< indices of points

/// Simplifies a polygon soup in place, as `simplify(points, triangles, …)` does with the same
/// policies, to the same bits. `image`, if there is one, becomes a list of what became of each
/// point of the input: an index of the result, or parameters::vanished.
///
/// Throws std::invalid_argument for options that make no sense, and what `simplify` throws; the
/// soup is then as it was.
Report simplify_soup(SoupPoints& points, SoupTriangles& triangles, const SoupOptions& options = {},
                     std::vector<std::size_t>* image = nullptr);

} // namespace quadrille

#endif // QUADRILLE_COMPILED_H
