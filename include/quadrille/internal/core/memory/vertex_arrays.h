#ifndef QUADRILLE_INTERNAL_CORE_MEMORY_VERTEX_ARRAYS_H
#define QUADRILLE_INTERNAL_CORE_MEMORY_VERTEX_ARRAYS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// A vertex array has a value for each vertex. A class of the engine that owns vertex arrays names
/// them once:
///
///     static auto vertex_arrays(auto& self) { return std::tie(self.positions_, self.ring_radius_);
///     }
///
/// The functions here process the vertex arrays of a list of owners, a tuple of references. The
/// list may contain objects without vertex arrays. An owner may say:
///
///     static constexpr bool is_seldom_there = true; // its vertex arrays are mostly empty
///     static constexpr bool is_recomputed = true;    // they are computed once more after packing

namespace quadrille::internal {

template <class Owner>
concept HasVertexArrays = requires(Owner& owner) {
  Owner::vertex_arrays(owner);
};
template <class Owner>
inline constexpr bool is_seldom_there = requires {
  requires Owner::is_seldom_there;
};
template <class Owner>
inline constexpr bool is_recomputed = requires {
  requires Owner::is_recomputed;
};

/// Returns the vertex arrays of an owner; none if it names none.
template <class Owner>
auto vertex_arrays_of([[maybe_unused]] Owner& owner) {
  if constexpr (HasVertexArrays<Owner>)
    return Owner::vertex_arrays(owner);
  else
    return std::tuple<>();
}

/// Keeps only the vertices of an ascending list, which get the numbers 0, 1, …, in the vertex
/// arrays of all owners.
template <class... Owner>
void pack_vertex_arrays(const std::tuple<Owner&...>& owners, const Array<Index>& left) {
  const auto pack_all = [&left](auto&... array) { (pack(array, left), ...); };
  const auto pack_owner = [&]<class P>(P& owner) {
    if constexpr (!is_recomputed<P>)
      std::apply(pack_all, vertex_arrays_of(owner));
  };
  std::apply([&](auto&... owner) { (pack_owner(owner), ...); }, owners);
}

/// Packs data of owners that are no vertex arrays: data of each face for which is_left(face) is
/// false, by pack_if(is_left), or data of vertices and faces, by pack(left, is_left).
template <class... Owner, class IsLeft>
void pack_others(const std::tuple<Owner&...>& owners, const Array<Index>& left, IsLeft is_left) {
  const auto pack_owner = [&](auto& owner) {
    if constexpr (requires { owner.pack_if(is_left); })
      owner.pack_if(is_left);
    if constexpr (requires { owner.pack(left, is_left); })
      owner.pack(left, is_left);
  };
  std::apply([&](auto&... owner) { (pack_owner(owner), ...); }, owners);
}

/// Has each vertex array of all owners a value for each of that many vertices? Some may be empty.
template <class... Owner>
bool have_rows(const std::tuple<Owner&...>& owners, std::size_t vertices) {
  const auto fit = [vertices](const auto&... array) {
    return ((array.empty() || array.size() == vertices) && ...);
  };
  return std::apply(
      [&](auto&... owner) { return (std::apply(fit, vertex_arrays_of(owner)) && ...); }, owners);
}

/// A vector<bool> is too dense to gain from prefetching.
QUADRILLE_ALWAYS_INLINE inline void prefetch_value(const std::vector<bool>&, Index) {}
template <class VertexArray>
QUADRILLE_ALWAYS_INLINE inline void prefetch_value(const VertexArray& array, Index v) {
  prefetch(&array[v]);
}

// By index, since std::apply need not be inlined, and what only prefetches is left out else.
template <class VertexArrays, std::size_t... I>
QUADRILLE_ALWAYS_INLINE inline void
prefetch_each(const VertexArrays& arrays, [[maybe_unused]] Index v, std::index_sequence<I...>) {
  (prefetch_value(std::get<I>(arrays), v), ...);
}
/// Prefetches all data of a vertex in an owner.
template <class Owner>
QUADRILLE_ALWAYS_INLINE inline void prefetch_vertex_arrays(const Owner& owner, Index v) {
  const auto arrays = Owner::vertex_arrays(owner);
  prefetch_each(arrays, v, std::make_index_sequence<std::tuple_size_v<decltype(arrays)>>());
}

template <class Owner>
QUADRILLE_ALWAYS_INLINE inline void prefetch_owner([[maybe_unused]] Owner& owner,
                                                   [[maybe_unused]] Index v) {
  if constexpr (requires { owner.prefetch(v); })
    owner.prefetch(v);
  else if constexpr (HasVertexArrays<Owner> && !is_seldom_there<Owner>)
    prefetch_vertex_arrays(owner, v);
}
template <class Owners, std::size_t... I>
QUADRILLE_ALWAYS_INLINE inline void prefetch_each_owner(const Owners& owners, Index v,
                                                        std::index_sequence<I...>) {
  (prefetch_owner(std::get<I>(owners), v), ...);
}

/// Prefetches all data of a vertex in the owners, or what their prefetch(v) selects.
template <class... Owner>
QUADRILLE_ALWAYS_INLINE inline void prefetch_owners(const std::tuple<Owner&...>& owners, Index v) {
  prefetch_each_owner(owners, v, std::index_sequence_for<Owner...>());
}

template <class VertexArray>
inline constexpr std::size_t bytes_a_value = sizeof(typename VertexArray::value_type);
template <>
inline constexpr std::size_t bytes_a_value<std::vector<bool>> = 0; // next to nothing

template <class VertexArrays>
struct RowOf;
template <class... VertexArray>
struct RowOf<std::tuple<VertexArray&...>> {
  static constexpr std::size_t bytes = (bytes_a_value<VertexArray> + ... + 0);
};

/// Returns how many bytes the vertex arrays of an owner take for each vertex.
template <class Owner>
inline constexpr std::size_t bytes_a_vertex =
    RowOf<decltype(vertex_arrays_of(std::declval<Owner&>()))>::bytes;

/// Prefetches rows of a list of owners, except for those that are rarely present.
template <class Owners>
struct RowsOf;
template <class... Owner>
struct RowsOf<std::tuple<Owner&...>> {
  static constexpr std::size_t bytes =
      ((is_seldom_there<Owner> ? 0 : bytes_a_vertex<Owner>)+... + 0);
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_MEMORY_VERTEX_ARRAYS_H
