#ifndef QUADRILLE_INTERNAL_EVALUATION_VERTEX_PAIR_H
#define QUADRILLE_INTERNAL_EVALUATION_VERTEX_PAIR_H

#include <quadrille/internal/base/index.h>

#include <array>

namespace quadrille::internal {

struct VertexPair {
  Index first, second;
};
using TwoPairs = std::array<VertexPair, 2>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_EVALUATION_VERTEX_PAIR_H
