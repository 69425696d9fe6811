#ifndef QUADRILLE_INTERNAL_CORE_BASE_CONTAINERS_H
#define QUADRILLE_INTERNAL_CORE_BASE_CONTAINERS_H

#include <concepts>
#include <cstddef>
#include <ranges>
#include <type_traits>
#include <utility>

/// Containers of the user's.

namespace quadrille::internal {

/// Its elements have three indices each.
template <class T>
concept TriangleContainer = std::ranges::random_access_range<T> && requires(T& triangles) {
  triangles.push_back(triangles[0]);
  requires std::ranges::random_access_range<std::ranges::range_value_t<T>>;
  requires std::integral<std::ranges::range_value_t<std::ranges::range_value_t<T>>>;
};

/// The type of a container's elements; the container may be a view that makes them on demand.
template <class Container>
using ElementOf = std::remove_cvref_t<decltype(std::declval<const Container&>()[0])>;

/// An empty container for the elements that are to replace those of another: a view supplies its
/// own. It has the same allocator, since the two could not be swapped otherwise.
template <class Container>
auto empty_like(const Container& container) {
  if constexpr (requires { container.empty_like(); })
    return container.empty_like();
  else if constexpr (requires { Container(container.get_allocator()); })
    return Container(container.get_allocator());
  else
    return Container();
}

/// Returns the container that swap_in() puts in the place of another, made of its new elements: the
/// elements themselves, or a new view of them. `origin(i)` is the former index of element i.
template <class Container, class Elements, class Origin>
decltype(auto) replacement(const Container& container, Elements& elements, Origin origin) {
  if constexpr (requires { container.replacement(elements, origin); })
    return container.replacement(elements, origin);
  else
    return (elements);
}
/// Done twice, it changes nothing. Does not throw.
template <class Container, class Replacement>
void swap_in(Container& container, Replacement& replacement) {
  if constexpr (requires { container.swap_in(replacement); })
    container.swap_in(replacement);
  else
    std::swap(container, replacement);
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

#endif // QUADRILLE_INTERNAL_CORE_BASE_CONTAINERS_H
