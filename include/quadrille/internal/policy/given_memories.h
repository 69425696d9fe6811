#ifndef QUADRILLE_INTERNAL_POLICY_GIVEN_MEMORIES_H
#define QUADRILLE_INTERNAL_POLICY_GIVEN_MEMORIES_H

#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// What vertices remember at the beginning, by input indices, instead of what their faces leave: in
/// the engine's units, about the vertex.
template <class Memory>
struct GivenMemories {
  std::vector<Memory> memories;
  std::vector<bool> is_given; ///< of each; empty: all are

  bool has(std::size_t vertex) const {
    return !memories.empty() && (is_given.empty() || is_given[vertex]);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_GIVEN_MEMORIES_H
