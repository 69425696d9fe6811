#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_ROWS_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_ROWS_H

#include <quadrille/buffers.h>
#include <quadrille/internal/core/adapter/matrix_soup.h>
#include <quadrille/internal/core/base/containers.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Soups that are no containers of points and triangles, as such: views of three numbers by index,
/// which know how they are rewritten (see `replacement` and `swap_in`).

namespace quadrille::internal {

template <class T>
inline constexpr bool is_span = false;
template <class T, std::size_t N>
inline constexpr bool is_span<std::span<T, N>> = true;
/// A span, or a view of a matrix.
template <class T>
inline constexpr bool is_view = is_span<T> || MatrixView<T>;
/// This overload is for constant numbers.
template <class T>
inline constexpr bool is_constant_view = MatrixView<T> && !WritableMatrix<T>;
template <class T, std::size_t N>
inline constexpr bool is_constant_view<std::span<const T, N>> = true;

/// One number after the other: a container that can grow, or a span.
template <class C>
concept FlatNumbers = std::ranges::random_access_range<C> &&
    (is_span<std::remove_const_t<C>> || requires(C & numbers) { numbers.push_back(numbers[0]); });

/// Three numbers for each row, one after the other. A container gets the size of what is left; a
/// span keeps its own, and what is left is at its beginning.
template <class Numbers>
class FlatRows {
public:
  using Number = std::ranges::range_value_t<Numbers>;
  using Row = std::array<Number, 3>;

  /// Throws std::invalid_argument if they are not three for each `what`.
  FlatRows(Numbers& numbers, const std::string& what) : numbers_(&numbers) {
    if (const std::size_t count = std::ranges::size(numbers); count % 3 != 0)
      throw std::invalid_argument("quadrille::simplify: " + std::to_string(count) +
                                  " numbers are not three for each " + what);
  }

  std::size_t size() const { return std::ranges::size(*numbers_) / 3; }
  Row operator[](std::size_t row) const {
    const auto first = std::ranges::begin(*numbers_) + static_cast<std::ptrdiff_t>(3 * row);
    return {first[0], first[1], first[2]};
  }

  std::vector<Row> empty_like() const { return {}; }
  template <class Origin>
  auto replacement(const std::vector<Row>& rows, Origin) const {
    auto numbers = empty_numbers();
    for (const Row& row : rows)
      for (Number number : row)
        numbers.push_back(number);
    return numbers;
  }
  template <class Replacement>
  void swap_in(Replacement& numbers) {
    if constexpr (is_span<std::remove_const_t<Numbers>>)
      std::swap_ranges(numbers.begin(), numbers.end(), numbers_->begin());
    else
      std::swap(*numbers_, numbers);
  }

private:
  auto empty_numbers() const {
    if constexpr (is_span<std::remove_const_t<Numbers>>)
      return std::vector<Number>();
    else
      return internal::empty_like(*numbers_);
  }

  Numbers* numbers_;
};

/// The positions of vertices that move as a whole; what is left is at the beginning.
template <class T>
class RowsOfVertices {
public:
  using Row = std::array<T, 3>;

  explicit RowsOfVertices(const VertexAttribute<T, 3>& positions) : positions_(positions) {}

  std::size_t size() const { return positions_.size(); }
  Row operator[](std::size_t vertex) const { return positions_[vertex]; }

  std::vector<Row> empty_like() const { return {}; }
  template <class Origin>
  std::vector<std::byte> replacement(const std::vector<Row>& rows, Origin origin) const {
    const std::size_t stride = positions_.stride();
    std::vector<std::byte> vertices(rows.size() * stride);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::byte* const vertex = vertices.data() + i * stride;
      std::memcpy(vertex, positions_.data() + std::size_t{origin(i)} * stride, stride);
      std::memcpy(vertex + positions_.offset(), rows[i].data(), sizeof(Row));
    }
    return vertices;
  }
  void swap_in(std::vector<std::byte>& vertices) {
    std::swap_ranges(vertices.begin(), vertices.end(), positions_.data());
  }

private:
  VertexAttribute<T, 3> positions_;
};

template <class T>
inline constexpr bool is_position_attribute = false;
template <std::floating_point T>
inline constexpr bool is_position_attribute<VertexAttribute<T, 3>> = true;

/// Does a type refer to what is simplified, so that a temporary or constant one does as well?
template <class T>
inline constexpr bool is_handle = (is_view<T> && !is_constant_view<T>) || is_position_attribute<T>;

/// Is it, passed as `Points&&`, something that a call may change?
template <class T>
inline constexpr bool is_changeable = is_handle<std::remove_cvref_t<T>> ||
                                      (std::is_lvalue_reference_v<T> &&
                                       !is_view<std::remove_cvref_t<T>> &&
                                       !std::is_const_v<std::remove_reference_t<T>>);

template <class P>
concept RowsOfPoints = is_position_attribute<std::remove_const_t<P>> || requires {
  requires FlatNumbers<P>;
  requires std::floating_point<std::ranges::range_value_t<P>>;
} || requires {
  requires MatrixLike<P>;
  requires std::floating_point<typename P::Scalar>;
};
template <class T>
concept RowsOfTriangles = requires {
  requires FlatNumbers<T>;
  requires std::integral<std::ranges::range_value_t<T>>;
}
|| requires {
  requires MatrixLike<T>;
  requires std::integral<typename T::Scalar>;
};

/// A container of rows as it is, anything else as a view of it. `other` is what it goes with, of
/// points the triangles.
template <class Soup, class Other>
decltype(auto) as_rows(Soup& soup, const char* what, [[maybe_unused]] const Other& other) {
  using Type = std::remove_const_t<Soup>;
  if constexpr (is_position_attribute<Type>)
    return RowsOfVertices(soup);
  else if constexpr (MatrixLike<Type>)
    return RowsOfMatrix<Soup>(soup, what, lies_in_columns(soup, lies_in_columns(other)));
  else if constexpr (std::is_arithmetic_v<std::ranges::range_value_t<Type>>)
    return FlatRows<Soup>(soup, what);
  else
    return (soup);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_ROWS_H
