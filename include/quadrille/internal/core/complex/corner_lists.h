#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_CORNER_LISTS_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_CORNER_LISTS_H

#include <quadrille/internal/core/base/assert.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <algorithm>
#include <cstddef>
#include <utility>

/// \file
/// A triangle complex builds its lists here, and reserves places after those of high-valence
/// vertices.

namespace quadrille::internal {

inline TriangleComplex::TriangleComplex(std::size_t vertex_count, Array<Triangle> triangles,
                                        bool will_merge, Threads threads)
    : faces_(std::move(triangles)), pool_(faces_.get_allocator()),
      lists_(vertex_count, faces_.get_allocator()) {
  check_size(vertex_count, faces_.size());
  for (Index face = 0; face < faces_.size(); ++face) {
    const auto [a, b, c] = faces_[face];
    if (a == b || b == c || c == a)
      remove_face(face);
  }
  pool_.reserve((will_merge ? 4 : 3) * faces_.size());
  build_lists(threads);
}

inline void TriangleComplex::build_lists(Threads threads) {
  for_each_range(threads, lists_.size(), [this](const auto& range, std::size_t) {
    for (Index v = range.begin; v < range.end; ++v)
      lists_[v].size = 0;
    for (const Triangle& face : faces_)
      if (face[0] != none)
        for (Index v : face)
          if (range.contains(v))
            ++lists_[v].size;
  });
  fill_lists(threads);
}

inline void TriangleComplex::fill_lists(Threads threads) {
  Index all = 0;
  for (List& list : lists_) {
    list.begin = all;
    all += std::exchange(list.size, 0);
  }
  pool_.resize(all);
  for_each_range(threads, lists_.size(), [this](const auto& range, std::size_t) {
    for (Index face = 0; face < faces_.size(); ++face)
      if (!is_removed(face))
        for (Index i = 0; i < 3; ++i)
          if (const Index v = faces_[face][i]; range.contains(v)) {
            List& list = lists_[v];
            pool_[list.begin + list.size++] = 4 * face + i;
          }
  });
  QUADRILLE_ASSERT(are_lists_right());
  high_valence_vertices_.mark(lists_);
}

// Does each corner in the list of a vertex have that vertex?
inline bool TriangleComplex::are_lists_right() const {
  for (Index v = 0; v < lists_.size(); ++v)
    for (Index i = 0; i < lists_[v].size; ++i)
      if (const Index corner = pool_[lists_[v].begin + i]; faces_[corner >> 2][corner & 3] != v)
        return false;
  return true;
}

inline void TriangleComplex::pack(const Array<Index>& vertices) {
  for (List& list : lists_)
    list.size = 0;
  for (Index v = 0; v < vertices.size(); ++v)
    lists_[vertices[v]].begin = v; // until fill_lists()
  const auto is_left = [this](Index face) { return !is_removed(face); };
  reverse_faces_.pack_if(is_left);
  pack_if(faces_, is_left);
  for (Triangle& face : faces_)
    for (Index& v : face) {
      v = lists_[v].begin;
      ++lists_[v].size;
    }
  lists_.resize(vertices.size());
}

inline bool TriangleComplex::has_room_after(Index high_valence, std::size_t corners) const {
  const std::size_t begin = lists_[high_valence].begin + lists_[high_valence].size;
  return begin + corners <= pool_.size() &&
         std::all_of(pool_.data() + begin, pool_.data() + begin + corners,
                     [](Index corner) { return corner == none; });
}

// For half as many corners again: a list is moved as seldom as an array that grows.
QUADRILLE_NOINLINE inline void TriangleComplex::make_room_after(Index high_valence,
                                                                std::size_t corners) {
  if (has_room_after(high_valence, corners))
    return;
  const std::size_t room = corners + lists_[high_valence].size / 2;
  reserve_corners(lists_[high_valence].size + room);
  const std::size_t begin = pool_.size();
  pool_.resize(begin + lists_[high_valence].size + room, none);
  Index size = 0;
  for_each_corner(high_valence, [&](Index face, Index i) { pool_[begin + size++] = 4 * face + i; });
  lists_[high_valence] = {static_cast<Index>(begin), size};
}

QUADRILLE_NOINLINE inline void TriangleComplex::append_to_high_valence(Index high_valence,
                                                                       Index gone) {
  List& list = lists_[high_valence];
  for_each_corner(gone, [&](Index face, Index i) {
    faces_[face][i] = high_valence;
    pool_[list.begin + list.size++] = 4 * face + i;
  });
  lists_[gone].size = 0;
}

template <class Visit>
void TriangleComplex::review_high_valence(Visit visit) {
  const auto count = [&](Index high_valence) {
    List& list = lists_[high_valence];
    const Index size = list.size;
    prune_corners(high_valence);
    std::fill_n(pool_.data() + list.begin + list.size, size - list.size, none);
    return list.size;
  };
  high_valence_vertices_.review(count, visit);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_CORNER_LISTS_H
