#ifndef QUADRILLE_INTERNAL_CORE_COST_VERTEX_IMPORTANCE_H
#define QUADRILLE_INTERNAL_CORE_COST_VERTEX_IMPORTANCE_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Throws std::invalid_argument for an importance that makes no sense.
inline void require_importance(double importance, std::size_t vertex) {
  if (!(importance >= 0) || !std::isfinite(importance))
    throw std::invalid_argument("quadrille::simplify: the importance of vertex " +
                                std::to_string(vertex) + ", " + text_of(importance) +
                                ", is negative or not finite");
}

/// Importances divided by the greatest of them, which becomes 1: only their ratios matter, and no
/// key overflows. A negligible importance keeps a small value, so that the cheapest of such pairs
/// still comes first. If all are zero, the result is empty: they are all alike.
inline std::vector<float> relative_importances(std::span<const double> importances) {
  constexpr double least = 0x1p-60; // times a cost it is far above the smallest float
  double greatest = 0;
  for (double importance : importances)
    greatest = (std::max)(greatest, importance);
  std::vector<float> relative;
  if (!(greatest > 0))
    return relative;
  relative.reserve(importances.size());
  for (double importance : importances)
    relative.push_back(static_cast<float>((std::max)(importance / greatest, least)));
  return relative;
}

/// How much costs of pairs at a vertex count: see vertex_importance_map.
///
/// A pair has the importance of the more important of its ends, and so does the vertex that a
/// contraction leaves: the importance of a vertex is the greatest of all that were merged into it,
/// in any order, so that an important feature does not fade where it meets the rest, and a key
/// never falls while a pair waits.
class VertexImportance {
public:
  /// Takes fractions of the greatest importance; empty if all are equal.
  explicit VertexImportance(std::vector<float> of)
      : of_(std::move(of)), is_any_given_(!of_.empty()) {}

  bool is_any_given() const { return is_any_given_; } // one look, for each contraction
  /// Returns the importance of a pair. It may be called only if any is given, like the next
  /// function.
  float of_pair(Index v, Index w) const { return (std::max)(of_[v], of_[w]); }
  /// The greatest of some vertices.
  float greatest_of(std::span<const Index> vertices) const {
    float greatest = 0;
    for (Index v : vertices)
      greatest = (std::max)(greatest, of_[v]);
    return greatest;
  }

  static constexpr bool is_seldom_there = true;
  static auto vertex_arrays(auto& self) { return std::tie(self.of_); }

  QUADRILLE_ALWAYS_INLINE void merge(Index kept, Index gone) {
    if (is_any_given()) [[unlikely]]
      join(kept, gone);
  }

private:
  QUADRILLE_NOINLINE void join(Index kept, Index gone) { of_[kept] = of_pair(kept, gone); }

  std::vector<float> of_;
  bool is_any_given_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COST_VERTEX_IMPORTANCE_H
