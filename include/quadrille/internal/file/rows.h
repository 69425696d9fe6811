#ifndef QUADRILLE_INTERNAL_FILE_ROWS_H
#define QUADRILLE_INTERNAL_FILE_ROWS_H

#include <quadrille/quadric_form.h>

#include <array>
#include <cstdint>
#include <type_traits>

namespace quadrille::internal {

/// The number that a vertex has in the input, and keeps.
using VertexId = std::uint32_t;
inline constexpr std::uint64_t most_vertex_ids = 0xFFFFFFFFU;

/// A vertex as files of the scratch folder store it; its scalars and its state follow.
struct VertexRow {
  VertexId id;
  std::uint32_t is_shared; ///< 1 if another chunk has the vertex, too; else 0
  Vector<3> position;      ///< in the input's units
};
static_assert(sizeof(VertexRow) == 32 && std::is_trivially_copyable_v<VertexRow>);

/// The corners of a face.
using FaceRow = std::array<VertexId, 3>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_ROWS_H
