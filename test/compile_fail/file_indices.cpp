// A cost that asks for indices, of a file in parts: each of them counts anew.
#include <quadrille/file.h>

#include <cstddef>

struct OfIndices {
  static constexpr std::size_t dimension = 3;
#ifndef REMEDY
  static constexpr bool asks_for_indices = true;
#endif
  struct State {};
};

// As simplify_file does for its cost.
const bool has_state = quadrille::internal::ChunkConversion<OfIndices>::has_state; // mistake
