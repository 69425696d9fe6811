#ifndef QUADRILLE_INTERNAL_BASE_TIE_IF_H
#define QUADRILLE_INTERNAL_BASE_TIE_IF_H

#include <tuple>

namespace quadrille::internal {

/// A tuple of a reference to a part, or of nothing.
template <bool is_there, class Part>
auto tie_if([[maybe_unused]] Part& part) {
  if constexpr (is_there)
    return std::tie(part);
  else
    return std::tie();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_BASE_TIE_IF_H
