#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_NAMED_EDGES_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_NAMED_EDGES_H

#include <quadrille/internal/core/adapter/umbrellas.h>
#include <quadrille/internal/core/base/index.h>

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// The edges of a mesh that should remain between two vertices: fixed ones, and on the boundary
/// those that existed. No edge is given to two sides.
template <class Edge>
class NamedEdges {
public:
  /// After the last one, sort() must be called.
  void add(Index v, Index w, Edge edge, bool is_fixed) {
    edges_.push_back({(std::min)(v, w), (std::max)(v, w), edge, is_fixed});
  }
  void sort() { std::stable_sort(edges_.begin(), edges_.end(), Named::less); }

  /// The vertices have got other numbers; an edge goes if an end has `none`.
  template <class NumberOf>
  void renumber(NumberOf number_of) {
    for (Named& e : edges_)
      std::tie(e.low, e.high) = std::minmax({number_of(e.low), number_of(e.high)});
    std::erase_if(edges_, [](const Named& e) { return e.high == none; });
    sort();
  }

  bool contains(const Side& side, Edge edge) {
    const auto known = along(side);
    return std::any_of(known.begin(), known.end(), [&](const Named& e) { return e.edge == edge; });
  }

  /// Side `index` had this edge: if it is left, then to it.
  void own(Index index, const Side& side, Edge edge) {
    for (Named& e : along(side))
      if (e.edge == edge)
        e.owner = index;
  }

  /// Returns the edge that a side and its mate (`none` on the boundary) should get instead of the
  /// side's own, or null.
  const Edge* take(Index index, Index mate, const Side& side) {
    Named* best = nullptr;
    for (Named& e : along(side))
      if ((e.owner == none || e.owner == index || e.owner == mate) &&
          (e.is_fixed || mate == none) && (!best || rank(e) > rank(*best)))
        best = &e;
    if (!best)
      return nullptr;
    best->owner = index;
    return &best->edge;
  }

private:
  struct Named {
    Index low, high;
    Edge edge;
    bool is_fixed;
    Index owner = none; // the side that it is left to

    static bool less(const Named& a, const Named& b) {
      return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    }
  };

  // Fixed edges come before others, and those that the sides had before those that none had.
  static int rank(const Named& e) { return 2 * e.is_fixed + (e.owner != none); }

  std::span<Named> along(const Side& side) {
    const Named wanted{(std::min)(side.from, side.to), (std::max)(side.from, side.to), Edge(),
                       true};
    const auto [begin, end] = std::equal_range(edges_.begin(), edges_.end(), wanted, Named::less);
    return {begin, end};
  }

  std::vector<Named> edges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_NAMED_EDGES_H
