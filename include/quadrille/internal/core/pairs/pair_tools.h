#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_TOOLS_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_TOOLS_H

#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/memory/append_buffer.h>
#include <quadrille/internal/core/pairs/candidate.h>

#include <cstddef>

namespace quadrille::internal {

/// The tools of a search for pairs, in addition to the surface, and its results.
struct PairTools {
  explicit PairTools(std::size_t vertices, Arena* arena = nullptr) : labels(vertices, arena) {}

  VertexLabels labels;
  AppendBuffer<VertexPair> pairs;
  AppendBuffer<float> keys; // of these
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_TOOLS_H
