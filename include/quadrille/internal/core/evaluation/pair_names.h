#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_NAMES_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_NAMES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <concepts>

namespace quadrille::internal {

/// Gives cost and placement the input vertices of a pair. If neither asks for them, it is empty and
/// does nothing.
template <class Policies>
class PairNames {
public:
  explicit PairNames(const Numbering&) {}

  NoIndices of_cost(Index, Index) const { return {}; }
  template <class Pair>
  const Pair& for_placement(const Pair& pair, Index, Index) const {
    return pair;
  }
};

template <class Policies>
requires(asks_for_indices<typename Policies::Cost> ||
         asks_for_indices<typename Policies::Placement>) class PairNames<Policies> {
public:
  explicit PairNames(const Numbering& numbering) : numbering_(numbering) {}

  /// For the pair of the vertices a and b, as the cost sees it.
  IndicesFor<typename Policies::Cost> of_cost(Index a, Index b) const {
    if constexpr (asks_for_indices<typename Policies::Cost>)
      return indices(a, b);
    else
      return {};
  }
  /// Returns that pair in the form that the placement sees.
  template <class Pair>
  PairFor<typename Policies::Placement, Pair> for_placement(const Pair& pair, Index a,
                                                            Index b) const {
    if constexpr (std::same_as<PairFor<typename Policies::Placement, Pair>, Pair>)
      return pair;
    else
      return {pair, indices(a, b)};
  }

private:
  PairIndices indices(Index a, Index b) const {
    return {numbering_.vertices[a], numbering_.vertices[b]};
  }

  const Numbering& numbering_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_NAMES_H
