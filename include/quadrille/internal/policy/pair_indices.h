#ifndef QUADRILLE_INTERNAL_POLICY_PAIR_INDICES_H
#define QUADRILLE_INTERNAL_POLICY_PAIR_INDICES_H

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace quadrille::internal {

/// Does a cost or a placement want to know which vertices of the input a pair is about?
template <class Policy>
inline constexpr bool asks_for_indices = requires {
  requires Policy::asks_for_indices;
};

/// Does a cost let vertices remember something that it knows by their indices in the input?
template <class Cost>
concept RemembersByIndex = requires(const Cost& cost, typename Cost::Memory memory) {
  memory += cost.input_vertex(std::size_t{});
};

struct NoIndices {};

/// By the indices in the input, the ends of a pair, for who asks for them.
struct PairIndices {
  std::size_t first_index, second_index;
};

template <class Policy>
using IndicesFor = std::conditional_t<asks_for_indices<Policy>, PairIndices, NoIndices>;

/// What a placement is handed that asks for indices: a pair that has none by itself, with them.
template <class Pair>
struct IndexedPair : Pair, PairIndices {
  IndexedPair(const Pair& pair, const PairIndices& indices) : Pair(pair), PairIndices(indices) {}
};
template <class Placement, class Pair>
using PairFor =
    std::conditional_t<asks_for_indices<Placement> && !std::derived_from<Pair, PairIndices>,
                       IndexedPair<Pair>, Pair>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_PAIR_INDICES_H
