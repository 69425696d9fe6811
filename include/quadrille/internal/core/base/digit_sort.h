#ifndef QUADRILLE_INTERNAL_CORE_BASE_DIGIT_SORT_H
#define QUADRILLE_INTERNAL_CORE_BASE_DIGIT_SORT_H

#include <array>
#include <cstddef>
#include <numeric>

namespace quadrille::internal {

/// One step of a radix sort: copies `count` values in the order of digit(value), which is below
/// 2^Bits. Values with the same digit keep their order.
template <unsigned Bits, class T, class Digit>
void sort_by_digit(const T* from, std::size_t count, T* to, Digit digit) {
  std::array<std::size_t, (std::size_t{1} << Bits) + 1> begin{};
  for (std::size_t i = 0; i < count; ++i)
    ++begin[digit(from[i]) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for (std::size_t i = 0; i < count; ++i)
    to[begin[digit(from[i])]++] = from[i];
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_DIGIT_SORT_H
