#ifndef QUADRILLE_INTERNAL_EVALUATION_VERTEX_PAIR_H
#define QUADRILLE_INTERNAL_EVALUATION_VERTEX_PAIR_H

#include <quadrille/internal/base/index.h>

namespace quadrille::internal {

struct VertexPair {
  Index first, second;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_EVALUATION_VERTEX_PAIR_H
