#ifndef QUADRILLE_INTERNAL_MEMORY_COLUMNS_H
#define QUADRILLE_INTERNAL_MEMORY_COLUMNS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/prefetch.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>

#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// A column is an array with a value for each vertex. A part of the engine names its columns once:
///
///     static auto vertex_columns(auto& self) { return std::tie(self.positions_, self.reach_); }
///
/// All that is done with each column of a part is done by the functions here.

namespace quadrille::internal {

/// Leaves out all vertices but those of a list, which get the numbers 0, 1, …, of the columns of
/// some parts.
template <class... Part>
void pack_columns(const Array<Index>& left, Part&... part) {
  const auto pack_all = [&left](auto&... column) { (pack(column, left), ...); };
  (std::apply(pack_all, Part::vertex_columns(part)), ...);
}

/// Has each column of some parts a value for each of that many vertices? Some may be empty.
template <class... Part>
bool have_rows(std::size_t vertices, const Part&... part) {
  const auto fit = [vertices](const auto&... column) {
    return ((column.empty() || column.size() == vertices) && ...);
  };
  return (std::apply(fit, Part::vertex_columns(part)) && ...);
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
/// Asks for all that a part holds of a vertex.
template <class Part>
QUADRILLE_ALWAYS_INLINE inline void prefetch_columns(const Part& part, Index v) {
  const auto columns = Part::vertex_columns(part);
  prefetch_each(columns, v, std::make_index_sequence<std::tuple_size_v<decltype(columns)>>());
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

/// How much the columns of a part take for each vertex.
template <class Part>
inline constexpr std::size_t bytes_a_vertex =
    RowOf<decltype(Part::vertex_columns(std::declval<Part&>()))>::bytes;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_MEMORY_COLUMNS_H
