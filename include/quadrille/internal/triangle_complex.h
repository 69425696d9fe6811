#ifndef QUADRILLE_INTERNAL_TRIANGLE_COMPLEX_H
#define QUADRILLE_INTERNAL_TRIANGLE_COMPLEX_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

using Index = std::uint32_t;
inline constexpr Index none = ~Index{0};

/// Any set of triangles over any set of vertices, in flat arrays with 32-bit indices: incidence,
/// and nothing of positions or costs.
///
/// A *corner* is a face at one of its vertices, written 4·face + 0, 1 or 2. The corners at a vertex
/// form a circular singly linked list in no particular order, so merging two vertices is a relabel
/// and a splice, and an edge of three faces is nothing special. A face that has died stays in the
/// lists of its corners until the next walk along them drops it.
class TriangleComplex {
public:
  static constexpr std::size_t max_faces = std::size_t{1} << 30;
  static constexpr std::size_t max_vertices = none;

  using Triangle = std::array<Index, 3>;

  TriangleComplex() = default;

  /// Builds the lists in linear time. A triangle with two equal vertices is dead from the
  /// beginning.
  TriangleComplex(std::size_t vertex_count, const std::vector<Triangle>& triangles);

  static void check_size(std::size_t vertices, std::size_t faces) {
    if (vertices >= max_vertices || faces >= max_faces)
      throw std::length_error(
          "quadrille::simplify: " + std::to_string(vertices) + " vertices and " +
          std::to_string(faces) + " faces do not fit into 32-bit indices (at most " +
          std::to_string(max_vertices - 1) + " and " + std::to_string(max_faces - 1) + ")");
  }

  std::size_t vertex_capacity() const { return head_.size(); }
  std::size_t face_capacity() const { return faces_.size(); }
  std::size_t live_faces() const { return live_faces_; }

  bool is_dead(Index face) const { return faces_[face].vertex[0] == none; }
  const Triangle& vertices(Index face) const { return faces_[face].vertex; }
  bool has_faces(Index vertex) const { return head_[vertex] != none; }

  /// Calls visit(face, i) for each live face at `vertex`, i being the place of the vertex in the
  /// face. Drops the corners of dead faces on its way, so its cost is repaid by the faces that
  /// died.
  template <class Visit>
  void for_each_corner(Index vertex, Visit visit) {
    Index previous = head_[vertex];
    if (previous == none)
      return;
    const Index last = previous;
    bool at_end = false;
    while (!at_end) {
      const Index corner = next(previous);
      at_end = corner == last;
      if (!is_dead(corner >> 2)) {
        visit(corner >> 2, corner & 3);
        previous = corner;
      } else if (corner == previous) {
        head_[vertex] = none; // it was the only one
      } else {
        next(previous) = next(corner);
        if (at_end)
          head_[vertex] = previous;
      }
    }
  }

  void kill(Index face) {
    faces_[face].vertex = {none, none, none};
    --live_faces_;
  }

  /// Moves all faces of `gone` to `kept`. The caller kills those that hold both.
  void merge(Index kept, Index gone) {
    for_each_corner(gone, [&](Index face, Index i) { faces_[face].vertex[i] = kept; });
    if (head_[gone] == none)
      return;
    if (head_[kept] == none)
      head_[kept] = head_[gone];
    else
      std::swap(next(head_[kept]), next(head_[gone])); // two circles become one
    head_[gone] = none;
  }

  /// Asks for a vertex some time before its faces are walked; and for the first of them a little
  /// later.
  void prefetch(Index vertex) const { __builtin_prefetch(&head_[vertex]); }
  void prefetch_faces(Index vertex) const {
    if (head_[vertex] != none)
      __builtin_prefetch(&faces_[head_[vertex] >> 2]);
  }

private:
  struct Face {
    Triangle vertex;
    std::array<Index, 3> next; // the next corner at the same vertex
  };

  Index& next(Index corner) { return faces_[corner >> 2].next[corner & 3]; }

  void add_corner(Index corner, Index vertex) {
    if (head_[vertex] == none) {
      next(corner) = corner;
    } else {
      next(corner) = next(head_[vertex]);
      next(head_[vertex]) = corner;
    }
    head_[vertex] = corner;
  }

  std::vector<Face> faces_;
  std::vector<Index> head_; // of each vertex: one of its corners, or none
  std::size_t live_faces_ = 0;
};

inline TriangleComplex::TriangleComplex(std::size_t vertex_count,
                                        const std::vector<Triangle>& triangles)
    : faces_(triangles.size()), head_(vertex_count, none), live_faces_(triangles.size()) {
  check_size(vertex_count, triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const auto [a, b, c] = triangles[f];
    const Index face = static_cast<Index>(f);
    faces_[face].vertex = triangles[f];
    if (a == b || b == c || c == a) {
      kill(face);
      continue;
    }
    add_corner(4 * face, a);
    add_corner(4 * face + 1, b);
    add_corner(4 * face + 2, c);
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_TRIANGLE_COMPLEX_H
