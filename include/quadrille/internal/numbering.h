#ifndef QUADRILLE_INTERNAL_NUMBERING_H
#define QUADRILLE_INTERNAL_NUMBERING_H

#include <quadrille/internal/packing.h>
#include <quadrille/internal/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The numbers that vertices, or faces, had before what is gone was left out, once or several
/// times.
class Origins {
public:
  Index operator[](Index number) const { return of_.empty() ? number : of_[number]; }

  /// The inverse; `none` for what has been left out.
  Index find(Index origin) const {
    if (of_.empty())
      return origin;
    const auto at = std::lower_bound(of_.begin(), of_.end(), origin);
    return at != of_.end() && *at == origin ? static_cast<Index>(at - of_.begin()) : none;
  }

  /// Those that are not among `left`, ascending indices and at least one, are left out.
  void leave(std::vector<Index> left) {
    if (of_.empty())
      of_ = std::move(left);
    else
      pack(of_, left);
  }

  bool empty() const { return of_.empty(); } ///< Nothing has been left out.
  const std::vector<Index>& all() const { return of_; }

private:
  std::vector<Index> of_;
};

/// What vertices have become part of, and the first numbers of vertices and faces.
class Numbering {
public:
  Numbering(std::size_t vertex_count, std::size_t face_count)
      : merged_into_(vertex_count, none), face_count_(face_count) {}

  /// By the numbers that they have now.
  void merge(Index kept, Index gone) { merged_into_[vertices[gone]] = vertices[kept]; }
  void prefetch(Index v) const { internal::prefetch(&merged_into_[vertices[v]]); }

  /// What a vertex has become part of, both by their first numbers.
  Index image(Index v) const {
    while (merged_into_[v] != none)
      v = merged_into_[v];
    return v;
  }

  std::size_t first_vertex_count() const { return merged_into_.size(); }
  std::size_t first_face_count() const { return face_count_; }

  Origins vertices, faces;

private:
  std::vector<Index> merged_into_; // of each vertex that is gone, by first numbers
  std::size_t face_count_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_NUMBERING_H
