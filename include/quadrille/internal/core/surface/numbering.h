#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_NUMBERING_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_NUMBERING_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <cstddef>
#include <numeric>
#include <utility>

namespace quadrille::internal {

/// Returns the number into which a number has been merged in the end, where `merged_into` gives for
/// each number the next one, or none. It shortens the path that it follows, so that many queries
/// take little more than linear time.
template <class Numbers>
Index follow_merges(Numbers& merged_into, Index number) {
  while (merged_into[number] != none) {
    Index& next = merged_into[number];
    if (merged_into[next] != none)
      next = merged_into[next];
    number = next;
  }
  return number;
}

/// The numbers that vertices, or faces, have for whoever made the surface.
class InputIndices {
public:
  /// `of`: theirs; empty if these are 0, 1, …
  InputIndices(std::size_t count, Array<Index> of) : of_(std::move(of)), input_count_(count) {}

  std::size_t input_count() const { return input_count_; }
  Index operator[](Index number) const { return is_identity() ? number : of_[number]; }
  /// Returns the new numbers of a list of numbers.
  Array<Index> of(const Array<Index>& numbers) const {
    Array<Index> inputs(numbers);
    if (!is_identity())
      for (Index& number : inputs)
        number = of_[number];
    return inputs;
  }
  /// The other way round: the number of each input index; `none` for what has been left out.
  InputIndices inverse() const {
    return {input_count_, is_identity() ? of_ : places(of_, input_count_)};
  }
  bool is_identity() const { return of_.empty(); }
  Arena* arena() const { return of_.get_allocator().arena(); }

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
      of_.resize(input_count_);
      std::iota(of_.begin(), of_.end(), 0);
    }
    internal::pack_if(of_, is_left);
  }
  void shrink_to_fit() { of_.shrink_to_fit(); }

private:
  Array<Index> of_;
  std::size_t input_count_;
};

/// Records into which vertices other vertices were merged, and the input indices of vertices and
/// faces.
class Numbering {
public:
  /// Without `by_input`, a merge has not to look up any, but no vertex may be left out before
  /// use_input_indices() is called.
  Numbering(InputIndices input_vertices, InputIndices input_faces, bool by_input)
      : vertices(std::move(input_vertices)), faces(std::move(input_faces)),
        merged_into_(vertices.input_count(), none, vertices.arena()), is_by_input_(by_input) {}

  void merge(Index kept, Index gone) {
    if (is_by_input_)
      merged_into_[vertices[gone]] = vertices[kept];
    else
      merged_into_[gone] = kept;
  }
  QUADRILLE_ALWAYS_INLINE void prefetch(Index v) const {
    internal::prefetch(&merged_into_[is_by_input_ ? vertices[v] : v]);
  }

  /// All merges are reported by input indices from here on, earlier ones as well.
  void use_input_indices() {
    if (std::exchange(is_by_input_, true) || vertices.is_identity())
      return;
    Array<Index> by_input(merged_into_.size(), none, merged_into_.get_allocator());
    for (Index v = 0; v < merged_into_.size(); ++v)
      if (merged_into_[v] != none)
        by_input[vertices[v]] = vertices[merged_into_[v]];
    merged_into_ = std::move(by_input);
  }

  /// Returns the input index of the vertex into which a vertex of the input was merged. It needs
  /// input indices. See follow_merges.
  Index merged_vertex(Index input) const { return follow_merges(merged_into_, input); }

  InputIndices vertices, faces;

private:
  mutable Array<Index> merged_into_; // of each vertex that is gone, or one further on
  bool is_by_input_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_NUMBERING_H
