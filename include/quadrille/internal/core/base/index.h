#ifndef QUADRILLE_INTERNAL_CORE_BASE_INDEX_H
#define QUADRILLE_INTERNAL_CORE_BASE_INDEX_H

#include <cstdint>

namespace quadrille::internal {

/// The number of a vertex or a face.
using Index = std::uint32_t;
inline constexpr Index none = ~Index{0};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_INDEX_H
