#ifndef QUADRILLE_INTERNAL_BASE_CONTAINERS_H
#define QUADRILLE_INTERNAL_BASE_CONTAINERS_H

#include <concepts>
#include <cstddef>
#include <ranges>

/// Containers of the user's.

namespace quadrille::internal {

/// Of three indices each.
template <class T>
concept TriangleContainer = std::ranges::random_access_range<T> && requires(T& triangles) {
  triangles.push_back(triangles[0]);
  requires std::ranges::random_access_range<std::ranges::range_value_t<T>>;
  requires std::integral<std::ranges::range_value_t<std::ranges::range_value_t<T>>>;
};

/// With the same allocator, else the two can't be swapped.
template <class Container>
Container empty_like(const Container& container) {
  if constexpr (requires { Container(container.get_allocator()); })
    return Container(container.get_allocator());
  else
    return Container();
}

/// Three indices in a type of the user's, each from its place.
template <class Triple, class IndexAt>
Triple renumbered(Triple triple, IndexAt index_at) {
  using Integer = std::ranges::range_value_t<Triple>;
  for (std::size_t i = 0; i < 3; ++i)
    triple[i] = static_cast<Integer>(index_at(i));
  return triple;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_BASE_CONTAINERS_H
