#ifndef QUADRILLE_INTERNAL_ORDER_PART_LISTS_H
#define QUADRILLE_INTERNAL_ORDER_PART_LISTS_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/parts.h>
#include <quadrille/internal/memory/array.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The vertices of each part of a surface, and the labels that it has.
class PartLists {
public:
  PartLists() = default;
  /// In linear time but for sorting labels. `labels`: of each face; or empty.
  template <std::size_t N>
  PartLists(const TriangleComplex& complex, const Parts<N>& parts, const Array<Index>& labels)
      : begin_(parts.size() + 1, 0), size_(parts.size(), 0) {
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      if (complex.has_faces(v))
        ++size_[parts.of(v)];
    std::partial_sum(size_.begin(), size_.end(), begin_.begin() + 1);
    left_ = static_cast<std::size_t>(
        std::count_if(size_.begin(), size_.end(), [](Index size) { return size > 0; }));
    vertices_.resize(begin_.back());
    std::fill(size_.begin(), size_.end(), 0);
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      if (complex.has_faces(v))
        vertices_[begin_[parts.of(v)] + size_[parts.of(v)]++] = v;
    if (!labels.empty())
      gather_labels(complex, parts, labels);
  }

  /// How many have not vanished.
  std::size_t left() const { return left_; }
  /// What is left of the vertices of a part. Later calls for the same part make it shorter.
  std::span<const Index> vertices(const TriangleComplex& complex, Index part) {
    const auto first = vertices_.begin() + begin_[part];
    const auto last =
        std::remove_if(first, first + size_[part], [&](Index v) { return !complex.has_faces(v); });
    size_[part] = static_cast<Index>(last - first);
    return {vertices_.data() + begin_[part], size_[part]};
  }
  /// Has it the last faces of a label?
  bool has_last_of_a_label(Index part) const {
    const auto labels = labels_of(part);
    return std::any_of(labels.begin(), labels.end(), [this](const PartLabel& of_part) {
      return parts_with_[of_part.second] == 1;
    });
  }
  /// The part has vanished.
  void remove(Index part) {
    --left_;
    for (const PartLabel& of_part : labels_of(part))
      --parts_with_[of_part.second];
  }

private:
  using PartLabel = std::pair<Index, Index>; // a part and a label that it has

  template <std::size_t N>
  void gather_labels(const TriangleComplex& complex, const Parts<N>& parts,
                     const Array<Index>& labels) {
    for (Index face = 0; face < labels.size(); ++face)
      if (!complex.is_removed(face)) {
        const PartLabel next(parts.of(complex.vertices(face)[0]), labels[face]);
        if (labels_.empty() || labels_.back() != next)
          labels_.push_back(next);
      }
    std::sort(labels_.begin(), labels_.end());
    labels_.erase(std::unique(labels_.begin(), labels_.end()), labels_.end());
    parts_with_.resize(labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1);
    for (const PartLabel& of_part : labels_)
      ++parts_with_[of_part.second];
  }

  std::span<const PartLabel> labels_of(Index part) const {
    const auto first = std::lower_bound(labels_.begin(), labels_.end(), PartLabel(part, 0));
    const auto last = std::lower_bound(first, labels_.end(), PartLabel(part + 1, 0));
    return {labels_.data() + (first - labels_.begin()), static_cast<std::size_t>(last - first)};
  }

  std::vector<Index> vertices_;         // part after part
  std::vector<Index> begin_, size_;     // of each part
  std::size_t left_ = 0;                // parts
  std::vector<PartLabel> labels_;       // ascending
  std::vector<std::size_t> parts_with_; // by label
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_PART_LISTS_H
