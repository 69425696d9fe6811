#ifndef QUADRILLE_INTERNAL_MEMORY_COLUMNS_H
#define QUADRILLE_INTERNAL_MEMORY_COLUMNS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/prefetch.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// A column is an array with a value for each vertex. A part of the engine names its columns once:
///
///     static auto vertex_columns(auto& self) { return std::tie(self.positions_, self.reach_); }
///
/// All that is done with each column of a part is done by the functions here.

namespace quadrille::internal {

/// Leaves out all vertices but those of a list, and gives the others the numbers 0, 1, ….
template <class Part>
void pack_columns(Part& part, const Array<Index>& left) {
  std::apply([&](auto&... column) { (pack(column, left), ...); }, Part::vertex_columns(part));
}

/// Bits are too small to ask for.
QUADRILLE_ALWAYS_INLINE inline void prefetch_value(const std::vector<bool>&, Index) {}
template <class Column>
QUADRILLE_ALWAYS_INLINE inline void prefetch_value(const Column& column, Index v) {
  prefetch(&column[v]);
}

/// Asks for all that a part holds of a vertex.
template <class Part>
QUADRILLE_ALWAYS_INLINE inline void prefetch_columns(const Part& part, Index v) {
  std::apply([v](const auto&... column)
                 QUADRILLE_ALWAYS_INLINE_LAMBDA { (prefetch_value(column, v), ...); },
             Part::vertex_columns(part));
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
