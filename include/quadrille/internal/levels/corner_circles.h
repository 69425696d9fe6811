#ifndef QUADRILLE_INTERNAL_LEVELS_CORNER_CIRCLES_H
#define QUADRILLE_INTERNAL_LEVELS_CORNER_CIRCLES_H

#include <quadrille/internal/core/base/index.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace quadrille::internal {

/// The corners of each vertex of a level. Changes are undone in the reverse order; each takes
/// constant time, and nothing is stored for it.
///
/// The corners of a vertex form a circle of links in both directions, with a node for the vertex.
/// What is unlinked keeps its own links, by which it is linked again. Source: Knuth, Dancing Links,
/// 2000.
class CornerCircles {
public:
  /// Builds the circles. Corner i of a face is 3 · face + i.
  void build(std::size_t vertices, const std::vector<std::array<Index, 3>>& triangles) {
    first_vertex_ = static_cast<Index>(3 * triangles.size());
    next_.resize(first_vertex_ + vertices);
    std::iota(next_.begin(), next_.end(), Index{0});
    previous_ = next_;
    for (Index face = 0; face < triangles.size(); ++face)
      for (Index i = 0; i < 3; ++i)
        insert_before(first_vertex_ + triangles[face][i], 3 * face + i);
  }

  /// Calls visit(corner) for all corners of a vertex.
  template <class Visit>
  void for_each(Index vertex, Visit visit) const {
    const Index end = first_vertex_ + vertex;
    for (Index corner = next_[end]; corner != end; corner = next_[corner])
      visit(corner);
  }

  /// Gives the corners of a vertex to another one.
  void merge(Index kept, Index gone) {
    exchange(first_vertex_ + kept, first_vertex_ + gone);
    unlink(first_vertex_ + gone);
  }
  /// Undoes merge().
  void split(Index kept, Index gone) {
    link(first_vertex_ + gone);
    exchange(first_vertex_ + kept, first_vertex_ + gone);
  }
  /// Removes the corners of a face.
  void remove(Index face) {
    for (Index i = 0; i < 3; ++i)
      unlink(3 * face + i);
  }
  /// Undoes remove().
  void restore(Index face) {
    for (Index i = 3; i-- > 0;)
      link(3 * face + i);
  }

private:
  void insert_before(Index place, Index node) {
    next_[node] = place;
    previous_[node] = previous_[place];
    link(node);
  }
  void link(Index node) { next_[previous_[node]] = previous_[next_[node]] = node; }
  void unlink(Index node) {
    next_[previous_[node]] = next_[node];
    previous_[next_[node]] = previous_[node];
  }
  // Joins the circles of two nodes; if they are in one circle, divides it again.
  void exchange(Index a, Index b) {
    const Index after_a = next_[a], after_b = next_[b];
    next_[a] = after_b;
    previous_[after_b] = a;
    next_[b] = after_a;
    previous_[after_a] = b;
  }

  Index first_vertex_ = 0; // the node of vertex 0, after those of all corners
  std::vector<Index> next_, previous_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_CORNER_CIRCLES_H
