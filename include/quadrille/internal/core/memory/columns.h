#ifndef QUADRILLE_INTERNAL_CORE_MEMORY_COLUMNS_H
#define QUADRILLE_INTERNAL_CORE_MEMORY_COLUMNS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// A column is an array with a value for each vertex. A component of the engine names its columns
/// once:
///
///     static auto vertex_columns(auto& self) { return std::tie(self.positions_, self.reach_); }
///
/// The functions here process the columns of a list of components, a tuple of references. Other
/// components may be in the list. A component may say:
///
///     static constexpr bool is_seldom_there = true; // its columns are mostly empty
///     static constexpr bool is_made_anew = true;    // they are computed once more after packing

namespace quadrille::internal {

template <class Part>
concept HasColumns = requires(Part& part) {
  Part::vertex_columns(part);
};
template <class Part>
inline constexpr bool is_seldom_there = requires {
  requires Part::is_seldom_there;
};
template <class Part>
inline constexpr bool is_made_anew = requires {
  requires Part::is_made_anew;
};

/// Returns the columns of a component; none if it names none.
template <class Part>
auto columns_of([[maybe_unused]] Part& part) {
  if constexpr (HasColumns<Part>)
    return Part::vertex_columns(part);
  else
    return std::tuple<>();
}

/// Keeps only the vertices of an ascending list, which get the numbers 0, 1, …, in the columns of
/// all components.
template <class... Part>
void pack_columns(const std::tuple<Part&...>& parts, const Array<Index>& left) {
  const auto pack_all = [&left](auto&... column) { (pack(column, left), ...); };
  const auto pack_part = [&]<class P>(P& part) {
    if constexpr (!is_made_anew<P>)
      std::apply(pack_all, columns_of(part));
  };
  std::apply([&](auto&... part) { (pack_part(part), ...); }, parts);
}

/// Packs data of components that are no columns: data of each face for which is_left(face) is
/// false, by pack_if(is_left), or data of vertices and faces, by pack(left, is_left).
template <class... Part, class IsLeft>
void pack_others(const std::tuple<Part&...>& parts, const Array<Index>& left, IsLeft is_left) {
  const auto pack_part = [&](auto& part) {
    if constexpr (requires { part.pack_if(is_left); })
      part.pack_if(is_left);
    if constexpr (requires { part.pack(left, is_left); })
      part.pack(left, is_left);
  };
  std::apply([&](auto&... part) { (pack_part(part), ...); }, parts);
}

/// Has each column of all components a value for each of that many vertices? Some may be empty.
template <class... Part>
bool have_rows(const std::tuple<Part&...>& parts, std::size_t vertices) {
  const auto fit = [vertices](const auto&... column) {
    return ((column.empty() || column.size() == vertices) && ...);
  };
  return std::apply([&](auto&... part) { return (std::apply(fit, columns_of(part)) && ...); },
                    parts);
}

/// A vector<bool> is too dense to gain from prefetching.
QUADRILLE_ALWAYS_INLINE inline void prefetch_value(const std::vector<bool>&, Index) {}
template <class Column>
QUADRILLE_ALWAYS_INLINE inline void prefetch_value(const Column& column, Index v) {
  prefetch(&column[v]);
}

// By index, since std::apply need not be inlined, and what only prefetches is left out else.
template <class Columns, std::size_t... I>
QUADRILLE_ALWAYS_INLINE inline void prefetch_each(const Columns& columns, [[maybe_unused]] Index v,
                                                  std::index_sequence<I...>) {
  (prefetch_value(std::get<I>(columns), v), ...);
}
/// Prefetches all data of a vertex in a component.
template <class Part>
QUADRILLE_ALWAYS_INLINE inline void prefetch_columns(const Part& part, Index v) {
  const auto columns = Part::vertex_columns(part);
  prefetch_each(columns, v, std::make_index_sequence<std::tuple_size_v<decltype(columns)>>());
}

template <class Part>
QUADRILLE_ALWAYS_INLINE inline void prefetch_part([[maybe_unused]] Part& part,
                                                  [[maybe_unused]] Index v) {
  if constexpr (requires { part.prefetch(v); })
    part.prefetch(v);
  else if constexpr (HasColumns<Part> && !is_seldom_there<Part>)
    prefetch_columns(part, v);
}
template <class Parts, std::size_t... I>
QUADRILLE_ALWAYS_INLINE inline void prefetch_each_part(const Parts& parts, Index v,
                                                       std::index_sequence<I...>) {
  (prefetch_part(std::get<I>(parts), v), ...);
}

/// Prefetches all data of a vertex in the components, or what their prefetch(v) selects.
template <class... Part>
QUADRILLE_ALWAYS_INLINE inline void prefetch_parts(const std::tuple<Part&...>& parts, Index v) {
  prefetch_each_part(parts, v, std::index_sequence_for<Part...>());
}

template <class Column>
inline constexpr std::size_t bytes_a_value = sizeof(typename Column::value_type);
template <>
inline constexpr std::size_t bytes_a_value<std::vector<bool>> = 0; // next to nothing

template <class Columns>
struct RowOf;
template <class... Column>
struct RowOf<std::tuple<Column&...>> {
  static constexpr std::size_t bytes = (bytes_a_value<Column> + ... + 0);
};

/// Returns how many bytes the columns of a component take for each vertex.
template <class Part>
inline constexpr std::size_t bytes_a_vertex =
    RowOf<decltype(columns_of(std::declval<Part&>()))>::bytes;

/// Prefetches rows of a list of components, except for those that are rarely present.
template <class Parts>
struct RowsOf;
template <class... Part>
struct RowsOf<std::tuple<Part&...>> {
  static constexpr std::size_t bytes = ((is_seldom_there<Part> ? 0 : bytes_a_vertex<Part>)+... + 0);
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_MEMORY_COLUMNS_H
