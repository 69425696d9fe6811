#ifndef QUADRILLE_INTERNAL_PAIRS_PAIR_FINDER_H
#define QUADRILLE_INTERNAL_PAIRS_PAIR_FINDER_H

#include <quadrille/internal/complex/link_condition.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/complex/vertex_labels.h>
#include <quadrille/internal/contraction/scratch.h>
#include <quadrille/internal/cost/pair_costs.h>
#include <quadrille/internal/memory/packing.h>
#include <quadrille/internal/pairs/pair_lists.h>
#include <quadrille/internal/policy/policies.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The pairs at a vertex, and what they cost: edges, if the policy includes them, and those that it
/// has listed.
template <class Policies>
class PairFinder {
public:
  PairFinder(TriangleComplex& complex, const LinkCondition& link_condition,
             const PairCosts<Policies>& costs, PairLists listed)
      : complex_(complex), link_condition_(link_condition), costs_(costs),
        listed_(std::move(listed)) {}

  /// Are there others than edges?
  bool has_others() const { return listed_.size() > 0; }
  /// Are they the edges, all of them and no others?
  bool are_edges() const { return includes_edges<Pairs> && !has_others(); }
  /// About, of a surface with so many faces.
  std::size_t count(std::size_t faces) const {
    return listed_.size() + (includes_edges<Pairs> ? 3 * faces / 2 : 0);
  }

  void merge(Index kept, Index gone) { listed_.merge(kept, gone); }

  /// Calls visit(w, cost) for each pair of v with another vertex.
  template <class Visit>
  void for_each(Scratch& scratch, Index v, Visit visit) {
    scratch.pairs.clear();
    find(scratch, v, 0);
    visit_found(scratch, [&](Index, Index w, float cost) { visit(w, cost); });
  }

  /// Calls visit(v, w, cost) for each pair of a vertex v of `vertices` with another vertex w for
  /// which is_wanted(v, w) holds.
  template <class IsWanted, class Visit>
  void for_each_of(Scratch& scratch, const std::vector<Index>& vertices, IsWanted is_wanted,
                   Visit visit) {
    Room<VertexPair>& pairs = scratch.pairs;
    pairs.clear();
    const auto end = static_cast<Index>(vertices.size());
    for (Index i = 0; i < end; ++i) {
      prefetch(i, end, 1, [&](Index k) { return vertices[k]; });
      find(scratch, vertices[i], 0);
    }
    pack_if(pairs, [&](Index i) { return is_wanted(pairs[i].first, pairs[i].second); });
    visit_found(scratch, visit);
  }

  /// Calls visit(v, w, cost) for each pair of a vertex v = begin, begin + step, … below `end` with
  /// one of a higher number.
  template <class Visit>
  void for_each_above(Scratch& scratch, Index begin, Index end, Index step, Visit visit) {
    constexpr std::size_t many = 256; // evaluated in one go
    for (Index v = begin; v < end;) {
      scratch.pairs.clear();
      for (; v < end && scratch.pairs.size() < many; v += std::min(step, end - v)) {
        if (step > 1)
          prefetch(v, end, step, [](Index w) { return w; });
        else
          prefetch_next(v, end);
        find(scratch, v, v + 1);
      }
      visit_found(scratch, visit);
    }
  }

private:
  using Pairs = typename Policies::Pairs;

  // Asks for what the pairs of vertices that lie apart will read, one thing after the other.
  template <class VertexAt>
  [[gnu::always_inline]] void prefetch(Index i, Index end, Index step, VertexAt vertex_at) const {
    const Index left = end - i;
    if (12 * step < left) {
      complex_.prefetch(vertex_at(i + 12 * step));
      costs_.prefetch(vertex_at(i + 12 * step));
    }
    if (9 * step < left)
      complex_.prefetch_corners(vertex_at(i + 9 * step));
    if (6 * step < left)
      complex_.prefetch_faces(vertex_at(i + 6 * step));
    if (3 * step < left)
      complex_.for_each_next(
          vertex_at(i + 3 * step), [&](Index w)
                                       __attribute__((always_inline)) { costs_.prefetch(w); });
  }

  // The same of vertices side by side: what surrounds them has mostly been read before them.
  [[gnu::always_inline]] void prefetch_next(Index v, Index end) const {
    if (96 >= end - v)
      return;
    costs_.prefetch(v + 96);
    complex_.prefetch_corners(v + 48);
  }

  // Adds the pairs of v with vertices from `least` on to those of the scratch, each once.
  void find(Scratch& scratch, Index v, Index least) {
    const std::size_t begin = scratch.pairs.size();
    if constexpr (includes_edges<Pairs>)
      find_edges(scratch, v, least);
    if (has_others())
      find_listed(scratch, v, least, begin);
  }

  // The pairs in the scratch, with what they cost.
  template <class Visit>
  void visit_found(Scratch& scratch, Visit visit) {
    costs_.evaluate_all(scratch);
    for (std::size_t i = 0; i < scratch.pairs.size(); ++i)
      visit(scratch.pairs[i].first, scratch.pairs[i].second, scratch.costs[i]);
  }

  // No branch: whether a vertex has been met before, or what its number is, is hard to guess.
  void find_edges(Scratch& scratch, Index v, Index least) {
    VertexPair* const pairs = scratch.pairs.extend(2 * complex_.degree_bound(v) + 1);
    std::size_t count = 0;
    const auto add = [&](Index w, bool is_new) {
      pairs[count] = {v, w};
      count += is_new & (w >= least);
    };
    if (link_condition_.is_oriented(v)) {
      complex_.for_each_corner(v, [&](Index face, Index i) {
        add(PairStar::star_face(complex_, face, i).second, true);
      });
    } else {
      Marks& marks = scratch.marks;
      marks.clear();
      complex_.for_each_corner(v, [&](Index face, Index i) {
        const StarFace f = PairStar::star_face(complex_, face, i);
        add(f.second, marks.insert(f.second));
        add(f.third, marks.insert(f.third));
      });
    }
    scratch.pairs.add(count);
  }

  // The pairs from `begin` on are known.
  void find_listed(Scratch& scratch, Index v, Index least, std::size_t begin) {
    constexpr Index by_edge = 0, by_list = 1;
    Marks& marks = scratch.marks;
    marks.clear(2);
    for (std::size_t i = begin; i < scratch.pairs.size(); ++i)
      marks.set(scratch.pairs[i].second, by_edge);
    marks.set(v, by_list);
    listed_.for_each_partner(v, [&](Index w) {
      if (!complex_.has_faces(w) || marks.is_marked_with(w, by_list))
        return false; // a leftover, or a pair that has become the same as another
      scratch.pairs.add_if(!marks.is_marked(w) && w >= least, {v, w});
      marks.set(w, by_list);
      return true;
    });
  }

  TriangleComplex& complex_;
  const LinkCondition& link_condition_;
  const PairCosts<Policies>& costs_;
  PairLists listed_; // those of the policy that are not edges
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PAIRS_PAIR_FINDER_H
