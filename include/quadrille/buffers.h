#ifndef QUADRILLE_BUFFERS_H
#define QUADRILLE_BUFFERS_H

#include <boost/property_map/property_map.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <ranges>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

/// \file
/// Attributes of the vertices of a soup that lie in a matrix, or in vertices as renderers have
/// them: records in one piece of memory, of which each has a position and its other attributes.
///
/// ```cpp
/// struct Vertex {
///   float position[3], normal[3], uv[2];
/// };
/// Report report = simplify(VertexAttribute(vertices, &Vertex::position), std::span(indices),
///                          Normals{VertexAttribute(vertices, &Vertex::normal)},
///                          Texture{VertexAttribute(vertices, &Vertex::uv)}, SplitVertices{});
/// vertices.resize(report.vertices_after);
/// indices.resize(3 * report.faces_after);
/// ```

namespace quadrille {

/// N numbers of type T of each vertex: what glVertexAttribPointer and an accessor of glTF describe.
///
/// As the points of a soup (T is float or double, N is 3) it stands for whole vertices: those that
/// are left come to the front with all their bytes, and with their new positions. There are
/// Report::vertices_after of them; what follows them is unspecified, and the memory stays the
/// caller's. As the map of a channel (`Normals{…}`, `Texture{…}`) it is that attribute, in the same
/// memory or elsewhere. It is a read-write property map over the index of a vertex, whose values
/// are std::array<T, N>; it owns nothing, and is copied as a pointer is.
template <class T, std::size_t N>
class VertexAttribute {
  static_assert(std::is_arithmetic_v<T> && N > 0);

public:
  using key_type = std::size_t; ///< the index of a vertex
  /// N numbers.
  using value_type = std::array<T, N>;
  using reference = value_type;                        ///< a copy
  using category = boost::read_write_property_map_tag; ///< of property maps

  /// `count` vertices of `stride` bytes each, in which it is `offset` bytes from the beginning.
  /// Throws std::invalid_argument if it does not lie inside of a vertex, or there is no memory.
  VertexAttribute(void* vertices, std::size_t count, std::size_t stride = sizeof(value_type),
                  std::size_t offset = 0)
      : vertices_(static_cast<std::byte*>(vertices)), count_(count), stride_(stride),
        offset_(offset) {
    const auto require = [](bool holds, const std::string& what) {
      if (!holds)
        throw std::invalid_argument("quadrille::VertexAttribute: " + what);
    };
    require(offset <= stride && sizeof(value_type) <= stride - offset,
            std::to_string(sizeof(value_type)) + " bytes at " + std::to_string(offset) +
                " do not lie in a stride of " + std::to_string(stride));
    require(vertices || count == 0, "no memory of " + std::to_string(count) + " vertices");
  }

  /// A member of each vertex in a container that is one piece of memory.
  template <std::ranges::contiguous_range Vertices, class Member, class Vertex>
  requires std::same_as<std::ranges::range_value_t<Vertices>, Vertex>
  VertexAttribute(Vertices& vertices, Member Vertex::*member)
      : VertexAttribute(std::ranges::data(vertices), std::ranges::size(vertices), sizeof(Vertex),
                        offset_of(vertices, member)) {
    static_assert(std::is_trivially_copyable_v<Vertex>,
                  "quadrille::VertexAttribute: vertices are moved as bytes, which these are not.");
    static_assert(sizeof(Member) == sizeof(value_type) && std::is_trivially_copyable_v<Member>,
                  "quadrille::VertexAttribute: this member is not N numbers of type T.");
  }

  std::byte* data() const { return vertices_; }  ///< of the first vertex
  std::size_t size() const { return count_; }    ///< how many vertices
  std::size_t stride() const { return stride_; } ///< bytes a vertex
  std::size_t offset() const { return offset_; } ///< bytes from its beginning

  /// Throws std::out_of_range for a vertex that is not there.
  value_type operator[](std::size_t vertex) const {
    value_type value;
    std::memcpy(value.data(), at(vertex), sizeof value);
    return value;
  }
  /// The same, as of a property map.
  friend value_type get(const VertexAttribute& attribute, std::size_t vertex) {
    return attribute[vertex];
  }
  /// Throws std::out_of_range for a vertex that is not there.
  friend void put(const VertexAttribute& attribute, std::size_t vertex, const value_type& value) {
    std::memcpy(attribute.at(vertex), value.data(), sizeof value);
  }

private:
  template <class Vertices, class Member>
  static std::size_t offset_of(Vertices& vertices, Member member) {
    if (std::ranges::size(vertices) == 0)
      return 0;
    auto* const first = std::ranges::data(vertices);
    return static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&(first->*member)) -
                                    reinterpret_cast<const std::byte*>(first));
  }
  std::byte* at(std::size_t vertex) const {
    if (vertex >= count_)
      throw std::out_of_range("quadrille::VertexAttribute: vertex " + std::to_string(vertex) +
                              " of " + std::to_string(count_));
    return vertices_ + vertex * stride_ + offset_;
  }

  std::byte* vertices_;
  std::size_t count_, stride_, offset_;
};
template <class Vertices, class T, std::size_t N, class Vertex>
VertexAttribute(Vertices&, T (Vertex::*)[N]) -> VertexAttribute<T, N>;
template <class Vertices, class T, std::size_t N, class Vertex>
VertexAttribute(Vertices&, std::array<T, N> Vertex::*) -> VertexAttribute<T, N>;

/// The rows of a matrix of Eigen, or of what looks like one, as the map of a channel: N numbers of
/// each vertex. It is a read-write property map over row numbers, and refers to the matrix, which
/// keeps its size.
template <class Matrix, std::size_t N>
class MatrixRows {
public:
  using key_type = std::size_t; ///< the index of a row
  /// N numbers.
  using value_type = std::array<typename Matrix::Scalar, N>;
  using reference = value_type;                        ///< a copy
  using category = boost::read_write_property_map_tag; ///< of property maps

  /// Throws std::invalid_argument if it has fewer columns.
  explicit MatrixRows(Matrix& matrix) : matrix_(&matrix) {
    if (matrix.cols() < static_cast<Index>(N))
      throw std::invalid_argument("quadrille::matrix_rows: " + std::to_string(matrix.cols()) +
                                  " columns are fewer than " + std::to_string(N));
  }

  /// Throws std::out_of_range for a row that is not there.
  friend value_type get(const MatrixRows& rows, std::size_t row) {
    value_type value;
    for (std::size_t i = 0; i < N; ++i)
      value[i] = rows.at(row, i);
    return value;
  }
  /// Throws std::out_of_range for a row that is not there.
  friend void put(const MatrixRows& rows, std::size_t row, const value_type& value) {
    for (std::size_t i = 0; i < N; ++i)
      rows.at(row, i) = value[i];
  }

private:
  using Index = decltype(std::declval<const Matrix&>().rows());

  typename Matrix::Scalar& at(std::size_t row, std::size_t column) const {
    if (row >= static_cast<std::size_t>(matrix_->rows()))
      throw std::out_of_range("quadrille::matrix_rows: row " + std::to_string(row) + " of " +
                              std::to_string(matrix_->rows()));
    return (*matrix_)(static_cast<Index>(row), static_cast<Index>(column));
  }

  Matrix* matrix_;
};
/// `simplify(V, F, Colors{matrix_rows<3>(C)}); C.conservativeResize(V.rows(), 3);`
template <std::size_t N, class Matrix>
MatrixRows<Matrix, N> matrix_rows(Matrix& matrix) {
  return MatrixRows<Matrix, N>(matrix);
}

} // namespace quadrille

#endif // QUADRILLE_BUFFERS_H
