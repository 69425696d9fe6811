#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_VERTEX_LABELS_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_VERTEX_LABELS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// A small number for each vertex that can be forgotten for all vertices at once, in constant time.
class VertexLabels {
public:
  explicit VertexLabels(std::size_t vertices, Arena* arena = nullptr)
      : label_(vertices, 0, arena) {}

  /// Forgets all labels. The next ones are below `numbers`, at most 2³¹.
  void clear(std::size_t numbers = 1) {
    base_ = end_;
    if (base_ > none / 2) {
      std::fill(label_.begin(), label_.end(), 0);
      base_ = 1;
    }
    end_ = base_ + static_cast<Index>(numbers);
  }

  bool is_labelled(Index vertex) const { return label_[vertex] >= base_; }
  bool has_label(Index vertex, Index number) const { return label_[vertex] == base_ + number; }
  /// Labels a vertex with 0; false if it had a label before.
  bool insert(Index vertex) {
    const bool is_new = label_[vertex] < base_;
    label_[vertex] = (std::max)(label_[vertex], base_);
    return is_new;
  }
  /// The label of a labelled vertex.
  Index operator[](Index vertex) const { return label_[vertex] - base_; }
  void set(Index vertex, Index number = 0) { label_[vertex] = base_ + number; }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index vertex) const { internal::prefetch(&label_[vertex]); }

private:
  Array<Index> label_;
  Index base_ = 1, end_ = 1;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_VERTEX_LABELS_H
