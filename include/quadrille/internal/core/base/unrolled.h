#ifndef QUADRILLE_INTERNAL_CORE_BASE_UNROLLED_H
#define QUADRILLE_INTERNAL_CORE_BASE_UNROLLED_H

#include <quadrille/internal/core/base/compiler.h>

#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// Calls visit(i) for i from 0 to below N, without a loop, so that compilers keep small arrays in
/// registers. With g++ 12 that saves 2 % of the instructions of a plain call, with clang 18 % of
/// those with colours in six dimensions.
template <std::size_t N, class Visit>
QUADRILLE_ALWAYS_INLINE constexpr void unrolled(Visit visit) {
  [&]<std::size_t... i>(std::index_sequence<i...>) QUADRILLE_ALWAYS_INLINE_LAMBDA {
    (visit(i), ...);
  }
  (std::make_index_sequence<N>());
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_UNROLLED_H
