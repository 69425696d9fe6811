#ifndef QUADRILLE_INTERNAL_CORE_BASE_CONTAINERS_H
#define QUADRILLE_INTERNAL_CORE_BASE_CONTAINERS_H

#include <concepts>
#include <cstddef>
#include <ranges>
#include <type_traits>
#include <utility>

/// Containers of the user's.

namespace quadrille::internal {

/// Of three indices each.
template <class T>
concept TriangleContainer = std::ranges::random_access_range<T> && requires(T& triangles) {
  triangles.push_back(triangles[0]);
  requires std::ranges::random_access_range<std::ranges::range_value_t<T>>;
  requires std::integral<std::ranges::range_value_t<std::ranges::range_value_t<T>>>;
};

/// What a container holds; it may be a view whose elements are made when they are asked for.
template <class Container>
using ElementOf = std::remove_cvref_t<decltype(std::declval<const Container&>()[0])>;

/// Where the elements that are to replace those of a container are gathered: a view tells its own.
/// With the same allocator, else the two can't be swapped.
template <class Container>
auto empty_like(const Container& container) {
  if constexpr (requires { container.empty_like(); })
    return container.empty_like();
  else if constexpr (requires { Container(container.get_allocator()); })
    return Container(container.get_allocator());
  else
    return Container();
}

/// What swap_in() puts in the place of a container, made of its new elements: these themselves; a
/// view makes its own. `origin(i)` is the element that i was.
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
