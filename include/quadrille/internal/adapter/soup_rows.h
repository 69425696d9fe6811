#ifndef QUADRILLE_INTERNAL_ADAPTER_SOUP_ROWS_H
#define QUADRILLE_INTERNAL_ADAPTER_SOUP_ROWS_H

#include <quadrille/buffers.h>
#include <quadrille/internal/base/containers.h>

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
inline constexpr bool is_span<std::span<T, N>> = !std::is_const_v<T>;

/// One number after the other: a container that can grow, or a span.
template <class C>
concept FlatNumbers = std::ranges::random_access_range<C> &&
    (is_span<std::remove_const_t<C>> || requires(C & numbers) { numbers.push_back(numbers[0]); });

/// A matrix of Eigen, or what looks like one. It is told by its names first: to call with two
/// numbers what may be anybody's policy could be an error.
template <class M>
concept Matrix = requires(M& matrix) {
  typename M::Scalar;
  matrix.rows();
  matrix.cols();
}
&&requires(M& matrix) {
  requires std::same_as<decltype(matrix(0, 0)), typename M::Scalar&>;
  matrix.swap(matrix);
  M(matrix.rows(), matrix.cols());
};

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

/// The rows of a matrix of three columns, which gets as many as are left.
template <class M>
class RowsOfMatrix {
public:
  using Number = typename M::Scalar;
  using Row = std::array<Number, 3>;

  /// Throws std::invalid_argument if there are not three columns.
  RowsOfMatrix(M& matrix, const std::string& what) : matrix_(&matrix) {
    if constexpr (requires { M::RowsAtCompileTime; })
      static_assert(M::RowsAtCompileTime < 0 &&
                        (M::ColsAtCompileTime < 0 || M::ColsAtCompileTime == 3),
                    "quadrille::simplify: a matrix of points or triangles has a row for each, of "
                    "which the number is not fixed, and three columns: use Eigen::MatrixXd or "
                    "Eigen::MatrixX3d, Eigen::MatrixXi or Eigen::MatrixX3i.");
    if (matrix.cols() != 3)
      throw std::invalid_argument("quadrille::simplify: a matrix of " + what + "s has " +
                                  std::to_string(matrix.rows()) + " rows and " +
                                  std::to_string(matrix.cols()) +
                                  " columns, not a row of three columns for each " + what);
  }

  std::size_t size() const { return static_cast<std::size_t>(matrix_->rows()); }
  Row operator[](std::size_t row) const {
    const auto r = static_cast<Index>(row);
    return {(*matrix_)(r, 0), (*matrix_)(r, 1), (*matrix_)(r, 2)};
  }

  std::vector<Row> empty_like() const { return {}; }
  template <class Origin>
  M replacement(const std::vector<Row>& rows, Origin) const {
    M matrix(static_cast<Index>(rows.size()), Index{3});
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t column = 0; column < 3; ++column)
        matrix(static_cast<Index>(row), static_cast<Index>(column)) = rows[row][column];
    return matrix;
  }
  void swap_in(M& matrix) { matrix_->swap(matrix); }

private:
  using Index = decltype(std::declval<const M&>().rows());
  M* matrix_;
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
inline constexpr bool is_handle = is_span<T> || is_position_attribute<T>;

/// Is it, passed as `Points&&`, something that a call may change?
template <class T>
inline constexpr bool is_changeable = is_handle<std::remove_cvref_t<T>> ||
                                      (std::is_lvalue_reference_v<T> &&
                                       !std::is_const_v<std::remove_reference_t<T>>);

template <class P>
concept RowsOfPoints = is_position_attribute<std::remove_const_t<P>> || requires {
  requires FlatNumbers<P>;
  requires std::floating_point<std::ranges::range_value_t<P>>;
} || requires {
  requires Matrix<P>;
  requires std::floating_point<typename P::Scalar>;
};
template <class T>
concept RowsOfTriangles = requires {
  requires FlatNumbers<T>;
  requires std::integral<std::ranges::range_value_t<T>>;
}
|| requires {
  requires Matrix<T>;
  requires std::integral<typename T::Scalar>;
};

/// A container of rows as it is, anything else as a view of it.
template <class Soup>
decltype(auto) as_rows(Soup& soup, const char* what) {
  using Type = std::remove_const_t<Soup>;
  if constexpr (is_position_attribute<Type>)
    return RowsOfVertices(soup);
  else if constexpr (Matrix<Type>)
    return RowsOfMatrix<Soup>(soup, what);
  else if constexpr (std::is_arithmetic_v<std::ranges::range_value_t<Type>>)
    return FlatRows<Soup>(soup, what);
  else
    return (soup);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ADAPTER_SOUP_ROWS_H
