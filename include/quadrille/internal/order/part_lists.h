#ifndef QUADRILLE_INTERNAL_ORDER_PART_LISTS_H
#define QUADRILLE_INTERNAL_ORDER_PART_LISTS_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/parts.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille::internal {

/// The vertices of each part of a surface.
class PartLists {
public:
  PartLists() = default;
  /// In linear time.
  template <std::size_t N>
  PartLists(const TriangleComplex& complex, const Parts<N>& parts)
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
  void count_vanished() { --left_; }

private:
  std::vector<Index> vertices_;     // part after part
  std::vector<Index> begin_, size_; // of each part
  std::size_t left_ = 0;            // parts
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_PART_LISTS_H
