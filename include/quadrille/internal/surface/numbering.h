#ifndef QUADRILLE_INTERNAL_SURFACE_NUMBERING_H
#define QUADRILLE_INTERNAL_SURFACE_NUMBERING_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/prefetch.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>

#include <cstddef>
#include <numeric>
#include <utility>

namespace quadrille::internal {

/// The numbers that vertices, or faces, have for whoever made the surface.
class Origins {
public:
  /// `of`: theirs; empty if these are 0, 1, …
  Origins(std::size_t count, Array<Index> of) : of_(std::move(of)), first_count_(count) {}

  std::size_t first_count() const { return first_count_; }
  Index operator[](Index number) const { return is_identity() ? number : of_[number]; }
  /// Those of a list of numbers.
  Array<Index> of(const Array<Index>& numbers) const {
    Array<Index> origins(numbers);
    if (!is_identity())
      for (Index& number : origins)
        number = of_[number];
    return origins;
  }
  /// The other way round: the number of each origin; `none` for what has been left out.
  Origins inverse() const {
    return {first_count_, is_identity() ? of_ : places(of_, first_count_)};
  }
  bool is_identity() const { return of_.empty(); }
  Workspace* workspace() const { return of_.get_allocator().workspace(); }

  /// Leaves out those that are not among `left`, ascending numbers and at least one.
  void pack(Array<Index> left) {
    if (is_identity())
      of_ = std::move(left);
    else
      internal::pack(of_, left);
  }
  /// Leaves out those for which is_left(number) is false; at least one is left.
  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    if (is_identity()) {
      of_.resize(first_count_);
      std::iota(of_.begin(), of_.end(), 0);
    }
    internal::pack_if(of_, is_left);
  }
  void shrink_to_fit() { of_.shrink_to_fit(); }

private:
  Array<Index> of_;
  std::size_t first_count_;
};

/// What vertices have become part of, and where vertices and faces come from.
class Numbering {
public:
  /// Without `by_origins`, a merge has not to look up any, but no vertex may be left out before
  /// use_origins() is called.
  Numbering(Origins vertex_origins, Origins face_origins, bool by_origins)
      : vertices(std::move(vertex_origins)), faces(std::move(face_origins)),
        merged_into_(vertices.first_count(), none, vertices.workspace()),
        is_by_origins_(by_origins) {}

  void merge(Index kept, Index gone) {
    if (is_by_origins_)
      merged_into_[vertices[gone]] = vertices[kept];
    else
      merged_into_[gone] = kept;
  }
  QUADRILLE_ALWAYS_INLINE void prefetch(Index v) const {
    internal::prefetch(&merged_into_[is_by_origins_ ? vertices[v] : v]);
  }

  /// All merges are told by origins from here on, those before as well.
  void use_origins() {
    if (std::exchange(is_by_origins_, true) || vertices.is_identity())
      return;
    Array<Index> by_origins(merged_into_.size(), none, merged_into_.get_allocator());
    for (Index v = 0; v < merged_into_.size(); ++v)
      if (merged_into_[v] != none)
        by_origins[vertices[v]] = vertices[merged_into_[v]];
    merged_into_ = std::move(by_origins);
  }

  /// The origin of what the vertex of an origin has become part of. By origins only. Shortens the
  /// way that it goes, so that many questions take little more than linear time.
  Index image(Index origin) const {
    while (merged_into_[origin] != none) {
      Index& next = merged_into_[origin];
      if (merged_into_[next] != none)
        next = merged_into_[next];
      origin = next;
    }
    return origin;
  }

  Origins vertices, faces;

private:
  mutable Array<Index> merged_into_; // of each vertex that is gone, or one further on
  bool is_by_origins_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_SURFACE_NUMBERING_H
