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
/// Attributes of a soup's vertices that are stored in a matrix or in a renderer's vertex
/// buffer: contiguous records, each with a position and other attributes.
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

/// A view of N numbers of type T for each vertex, as glVertexAttribPointer and a glTF accessor
/// describe them.
///
/// As the points of a soup (T is float or double, N is 3) it stands for whole vertices: the
/// Report::vertices_after vertices that are left are moved to the front with all their bytes and
/// get their new positions. The content after them is unspecified, and the caller keeps the buffer.
/// As the map of a channel (`Normals{…}`, `Texture{…}`) it is that attribute, in the same buffer or
/// in another one. It is a read-write property map from vertex indices to std::array<T, N>. It owns
/// nothing and is as cheap to copy as a pointer.
template <class T, std::size_t N>
class VertexAttribute {
  static_assert(std::is_arithmetic_v<T> && N > 0);

public:
  using key_type = std::size_t; ///< the index of a vertex
  /// The N numbers of a vertex.
  using value_type = std::array<T, N>;
  using reference = value_type;                        ///< a copy
  using category = boost::read_write_property_map_tag; ///< the category of property maps

  /// Views `count` vertices of `stride` bytes each, with the attribute `offset` bytes after the
  /// start of the vertex. Throws std::invalid_argument if the attribute does not lie inside the
  /// vertex, or if `vertices` is null.
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
    require(vertices || count == 0, "no buffer of " + std::to_string(count) + " vertices");
  }

  /// Views a member of each vertex in a contiguous container.
  template <std::ranges::contiguous_range Vertices, class Member, class Vertex>
  requires std::same_as<std::ranges::range_value_t<Vertices>, Vertex>
  VertexAttribute(Vertices& vertices, Member Vertex::*member)
      : VertexAttribute(std::ranges::data(vertices), std::ranges::size(vertices), sizeof(Vertex),
                        offset_of(vertices, member)) {
    static_assert(std::is_trivially_copyable_v<Vertex>,
                  "quadrille::VertexAttribute: vertices are copied as bytes, so they have to be "
                  "trivially copyable.");
    static_assert(
        sizeof(Member) == sizeof(value_type) && std::is_trivially_copyable_v<Member>,
        "quadrille::VertexAttribute: this member does not consist of N numbers of type T.");
  }

  std::byte* data() const { return vertices_; }  ///< points to the first vertex
  std::size_t size() const { return count_; }    ///< the number of vertices
  std::size_t stride() const { return stride_; } ///< bytes per vertex
  std::size_t offset() const { return offset_; } ///< bytes from the start of a vertex

  /// Throws std::out_of_range if there is no such vertex.
  value_type operator[](std::size_t vertex) const {
    value_type value;
    std::memcpy(value.data(), at(vertex), sizeof value);
    return value;
  }
  /// Reads the attribute of a vertex, as for a property map.
  friend value_type get(const VertexAttribute& attribute, std::size_t vertex) {
    return attribute[vertex];
  }
  /// Throws std::out_of_range if there is no such vertex.
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

/// A view of the rows of an Eigen matrix, or of a type with the same interface, as the map of a
/// channel: N numbers for each vertex. It is a read-write property map over row numbers. It refers
/// to the matrix, whose size does not change.
template <class Matrix, std::size_t N>
class MatrixRows {
public:
  using key_type = std::size_t; ///< the index of a row
  /// The N numbers of a row.
  using value_type = std::array<typename Matrix::Scalar, N>;
  using reference = value_type;                        ///< a copy
  using category = boost::read_write_property_map_tag; ///< the category of property maps

  /// Throws std::invalid_argument if the matrix has fewer than N columns.
  explicit MatrixRows(Matrix& matrix) : matrix_(&matrix) {
    if (matrix.cols() < static_cast<Index>(N))
      throw std::invalid_argument("quadrille::matrix_rows: " + std::to_string(matrix.cols()) +
                                  " columns are less than " + std::to_string(N));
  }

  /// Throws std::out_of_range if there is no such row.
  friend value_type get(const MatrixRows& rows, std::size_t row) {
    value_type value;
    for (std::size_t i = 0; i < N; ++i)
      value[i] = rows.at(row, i);
    return value;
  }
  /// Throws std::out_of_range if there is no such row.
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
/// Makes a view of the first N columns:
/// `simplify(V, F, Colors{matrix_rows<3>(C)}); C.conservativeResize(V.rows(), 3);`
template <std::size_t N, class Matrix>
MatrixRows<Matrix, N> matrix_rows(Matrix& matrix) {
  return MatrixRows<Matrix, N>(matrix);
}

} // namespace quadrille

#endif // QUADRILLE_BUFFERS_H
