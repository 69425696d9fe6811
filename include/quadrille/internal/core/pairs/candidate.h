#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_CANDIDATE_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_CANDIDATE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/quadric_form.h>

#include <array>

namespace quadrille::internal {

struct VertexPair {
  Index first, second;
};
using TwoPairs = std::array<VertexPair, 2>;

/// A pair of vertices with the place of its contraction, what that costs, the key by which pairs
/// are ordered, and the error as a distance in the mesh's unit.
template <class Cost>
struct Candidate {
  using Position = Vector<Cost::dimension>;

  Index first, second;
  PairOf<Cost> pair; ///< as cost and placement see it
  Position target = {};
  double cost = 0, key = 0, error = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_CANDIDATE_H
