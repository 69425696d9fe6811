#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_LISTS_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_LISTS_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille::internal {

/// The pairs that a policy selected, listed at both of their vertices: Pairs(v) of the 1997 paper.
/// As with corners, merging two vertices is a relabel and a splice; pairs that have become one are
/// dropped by the next walk that meets both.
class PairLists {
public:
  static constexpr std::size_t most = std::size_t{1} << 30;

  PairLists() = default;
  explicit PairLists(std::size_t vertices) : head_(vertices, none) {}

  void add(Index a, Index b) {
    if (size() == most)
      throw std::length_error("quadrille::simplify: the pair policy selected more than " +
                              std::to_string(most) + " pairs that are not edges");
    const Index end = static_cast<Index>(ends_.size());
    ends_.push_back({a, next_of(a, end)});
    ends_.push_back({b, next_of(b, end + 1)});
  }

  std::size_t size() const { return ends_.size() / 2; }

  /// Calls visit(w) for each partner w of v, and drops the pair if it returns false.
  template <class Visit>
  void prune_partners(Index v, Visit visit) {
    Index previous = none;
    for (Index end = head_[v]; end != none;) {
      const Index next = ends_[end].next;
      const Index partner = ends_[end ^ 1].vertex;
      if (partner != none && partner != v && visit(partner)) {
        previous = end;
      } else {
        ends_[end].vertex = none; // the partner's list drops its end when it is walked
        (previous == none ? head_[v] : ends_[previous].next) = next;
      }
      end = next;
    }
  }

  void merge(Index kept, Index gone) {
    if (ends_.empty())
      return;
    Index last = none;
    for (Index end = head_[gone]; end != none; end = ends_[end].next) {
      if (ends_[end].vertex != none)
        ends_[end].vertex = kept;
      last = end;
    }
    if (last == none)
      return;
    ends_[last].next = std::exchange(head_[kept], head_[gone]);
    head_[gone] = none;
  }

private:
  struct End {
    Index vertex; // none for a dropped pair
    Index next;   // end in the same list
  };

  Index next_of(Index v, Index end) { return std::exchange(head_[v], end); }

  Array<End> ends_; // of pair k: 2k and 2k + 1
  Array<Index> head_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_PAIR_LISTS_H
