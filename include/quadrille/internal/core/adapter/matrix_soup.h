#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_MATRIX_SOUP_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_MATRIX_SOUP_H

#include <array>
#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Matrices as soups: a row of three numbers for each point or triangle, or a column.

namespace quadrille::internal {

/// Is it a matrix of Eigen, a view of one, or similar? Its names are checked first: calling an
/// arbitrary user's policy with two numbers could be an error.
template <class M>
concept MatrixLike = requires(M& matrix) {
  typename M::Scalar;
  matrix.rows();
  matrix.cols();
}
&&requires(M& matrix) {
  { matrix(0, 0) } -> std::convertible_to<typename M::Scalar>;
};

template <class M>
concept WritableMatrix = MatrixLike<M> && requires(M& matrix) {
  requires std::same_as<decltype(matrix(0, 0)), typename M::Scalar&>;
};

/// One that can be made of another size.
template <class M>
concept Matrix = WritableMatrix<M> && requires(M& matrix) {
  matrix.swap(matrix);
  M(matrix.rows(), matrix.cols());
};

/// One that refers to the numbers of another, as maps, blocks and transposes of Eigen do.
template <class M>
concept MatrixView = MatrixLike<M> && !Matrix<std::remove_const_t<M>>;

/// The size of a matrix, as far as its type determines it: three, a number that is not three, or
/// unknown.
enum class Extent { three, other, any };
template <int size>
inline constexpr Extent extent = size < 0    ? Extent::any
                                 : size == 3 ? Extent::three
                                             : Extent::other;
template <class M>
inline constexpr Extent row_extent = Extent::any;
template <class M>
requires requires {
  M::RowsAtCompileTime;
}
inline constexpr Extent row_extent<M> = extent<int{M::RowsAtCompileTime}>;
template <class M>
inline constexpr Extent column_extent = Extent::any;
template <class M>
requires requires {
  M::ColsAtCompileTime;
}
inline constexpr Extent column_extent<M> = extent<int{M::ColsAtCompileTime}>;

/// Has a matrix a column for each point or triangle, and not a row? One of three rows and three
/// columns whose type does not determine this has rows, unless the matrix that belongs to it has
/// columns.
template <class M>
bool lies_in_columns(const M& matrix, bool does_other = false) {
  if constexpr (!MatrixLike<M>)
    return false;
  else if constexpr (row_extent<M> != column_extent<M>)
    return row_extent<M> == Extent::three || column_extent<M> == Extent::other;
  else
    return matrix.rows() == 3 && (matrix.cols() != 3 || does_other);
}

/// Can there be a row or a column of three for each, and as many of them as are left?
template <class M>
constexpr bool can_be_rows() {
  constexpr Extent rows = row_extent<M>, columns = column_extent<M>;
  if constexpr (MatrixView<M>)
    return rows != Extent::other || columns != Extent::other;
  else
    return rows != Extent::other && columns != Extent::other &&
           (rows == Extent::any || columns == Extent::any);
}

/// A matrix of three columns, which gets as many rows as are left, or of three rows. A view keeps
/// its size, and what is left is at its beginning.
template <class M>
class RowsOfMatrix {
  static constexpr bool is_view = MatrixView<M>;

public:
  using Number = typename M::Scalar;
  using Row = std::array<Number, 3>;

  /// Throws std::invalid_argument if there are not three.
  RowsOfMatrix(M& matrix, const std::string& what, bool in_columns)
      : stored_(store(matrix)), in_columns_(in_columns) {
    static_assert(
        can_be_rows<M>(),
        "quadrille::simplify: a matrix of points or triangles has three columns and any "
        "number of rows, or the other way round: use Eigen::MatrixXd, Eigen::MatrixX3d or "
        "Eigen::Matrix3Xd, and the same with integers.");
    if ((in_columns ? matrix.rows() : matrix.cols()) != 3)
      throw std::invalid_argument(
          "quadrille::simplify: a matrix of " + what + "s has " + std::to_string(matrix.rows()) +
          " rows and " + std::to_string(matrix.cols()) +
          " columns, not a row of three columns for each " + what + ", nor a column of three rows");
  }

  std::size_t size() const {
    return static_cast<std::size_t>(in_columns_ ? matrix().cols() : matrix().rows());
  }
  Row operator[](std::size_t row) const {
    return {at(matrix(), row, 0), at(matrix(), row, 1), at(matrix(), row, 2)};
  }

  std::vector<Row> empty_like() const { return {}; }
  template <class Origin>
  auto replacement(const std::vector<Row>& rows, Origin) const {
    if constexpr (is_view) {
      return rows;
    } else {
      const auto count = static_cast<Index>(rows.size());
      M result(in_columns_ ? Index{3} : count, in_columns_ ? count : Index{3});
      for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t i = 0; i < 3; ++i)
          at(result, row, i) = rows[row][i];
      return result;
    }
  }
  void swap_in(M& other) requires(!is_view) { stored_->swap(other); }
  void swap_in(std::vector<Row>& rows) {
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t i = 0; i < 3; ++i)
        std::swap(at(stored_, row, i), rows[row][i]);
  }

private:
  using Index = decltype(std::declval<const M&>().rows());

  static auto store(M& matrix) {
    if constexpr (is_view)
      return std::remove_const_t<M>(matrix); // it is copied as a pointer is
    else
      return &matrix;
  }
  const M& matrix() const {
    if constexpr (is_view)
      return stored_;
    else
      return *stored_;
  }
  decltype(auto) at(auto& matrix, std::size_t row, std::size_t i) const {
    const auto r = static_cast<Index>(row), c = static_cast<Index>(i);
    return in_columns_ ? matrix(c, r) : matrix(r, c);
  }

  std::conditional_t<is_view, std::remove_const_t<M>, M*> stored_;
  bool in_columns_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_MATRIX_SOUP_H
