#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CONTRACTED_PAIR_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CONTRACTED_PAIR_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/vector.h>

namespace quadrille::internal {

/// A pair as channels see it.
struct ContractedPair {
  Index first, second;
  Vector<3> to_second; ///< from the first end
  bool is_first_fixed = false, is_second_fixed = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CONTRACTED_PAIR_H
