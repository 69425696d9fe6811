#ifndef QUADRILLE_INTERNAL_CORE_BASE_PREFETCH_H
#define QUADRILLE_INTERNAL_CORE_BASE_PREFETCH_H

#include <quadrille/internal/core/base/compiler.h>

#include <cstddef>
#include <numeric>
#include <type_traits>

namespace quadrille::internal {

/// Asks for an object that will be read or written soon, without waiting for it: for all lines of a
/// cache that it can lie in, wherever it begins.
///
/// This and all that calls it for others must be inlined always: g++ takes a function that does
/// nothing but prefetch for one without effect, and drops the calls.
template <class T>
QUADRILLE_ALWAYS_INLINE inline void prefetch(const T* object) {
  constexpr std::size_t line = 64, size = sizeof(T);
  constexpr std::size_t latest = line - std::gcd(line, size); // it begins there in its first line
  if constexpr (!std::is_empty_v<T>) {
    for (std::size_t i = 0; i < size; i += line)
      QUADRILLE_PREFETCH(reinterpret_cast<const char*>(object) + i);
    if constexpr ((latest + size - 1) / line > (size - 1) / line)
      QUADRILLE_PREFETCH(reinterpret_cast<const char*>(object + 1) - 1);
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_PREFETCH_H
