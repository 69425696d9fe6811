#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_FINDER_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_FINDER_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/evaluation/pair_evaluator.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/pairs/pair_lists.h>
#include <quadrille/internal/core/pairs/pair_tools.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/surface_state.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The pairs at a vertex, and their keys: edges, if the policy includes them, and those that it
/// has listed.
template <class Policies>
class PairFinder {
public:
  PairFinder(SurfaceState<Policies>& state, const PairEvaluator<Policies>& evaluator)
      : complex_(state.complex), link_condition_(state.link_condition), listed_(state.listed),
        evaluator_(evaluator), includes_edges_(state.policies.pairs.includes_edges()) {}

  /// Are there others than edges?
  bool has_others() const { return listed_.size() > 0; }
  /// Are they the edges, all of them and no others?
  bool are_edges() const { return includes_edges_ && !has_others(); }
  /// About, of a surface with that many faces and vertices. Reverse faces have none of their own.
  std::size_t count(std::size_t faces, std::size_t vertices) const {
    if (!complex_.reverse_faces().is_empty())
      faces = (std::min)(faces, 2 * vertices);
    return listed_.size() + (includes_edges_ ? 3 * faces / 2 : 0);
  }

  /// Calls visit(w, key) for each pair of v with another vertex.
  template <class Visit>
  void for_each(PairTools& tools, Index v, Visit visit) {
    tools.pairs.clear();
    find(tools, v, 0);
    visit_found(tools, [&](Index, Index w, float key) { visit(w, key); });
  }

  /// Calls visit(v, w, key) for each pair of a vertex v of `vertices` with another vertex w that
  /// satisfies is_wanted(v, w).
  template <class IsWanted, class Visit>
  void for_each_of(PairTools& tools, const std::vector<Index>& vertices, IsWanted is_wanted,
                   Visit visit) {
    AppendBuffer<VertexPair>& pairs = tools.pairs;
    pairs.clear();
    const auto end = static_cast<Index>(vertices.size());
    for (Index i = 0; i < end; ++i) {
      prefetch(i, end, 1, [&](Index k) { return vertices[k]; });
      find(tools, vertices[i], 0);
    }
    pack_if(pairs, [&](Index i) { return is_wanted(pairs[i].first, pairs[i].second); });
    visit_found(tools, visit);
  }

  /// Calls visit(v, w, key) for each pair of a vertex v = begin, begin + step, … below `end` with
  /// one of a higher number. Pairs whose keys are above `limit` may be left out.
  template <class Visit>
  void for_each_above(PairTools& tools, Index begin, Index end, Index step, Visit visit,
                      float limit = std::numeric_limits<float>::infinity()) {
    constexpr std::size_t many = 256; // evaluated in one go
    for (Index v = begin; v < end;) {
      tools.pairs.clear();
      for (; v < end && tools.pairs.size() < many; v += (std::min)(step, end - v)) {
        if (step > 1)
          prefetch(v, end, step, [](Index w) { return w; });
        else
          prefetch_next(v, end);
        find(tools, v, v + 1);
      }
      evaluator_.drop_above(limit, tools.pairs);
      visit_found(tools, visit);
    }
  }

private:
  // Asks for what the pairs of vertices that lie apart will read, one thing after the other.
  template <class VertexAt>
  QUADRILLE_ALWAYS_INLINE void prefetch(Index i, Index end, Index step, VertexAt vertex_at) const {
    const Index left = end - i;
    if (12 * step < left) {
      complex_.prefetch(vertex_at(i + 12 * step));
      evaluator_.prefetch_pair(vertex_at(i + 12 * step));
    }
    if (9 * step < left)
      complex_.prefetch_corners(vertex_at(i + 9 * step));
    if (6 * step < left)
      complex_.prefetch_faces(vertex_at(i + 6 * step));
    if (3 * step < left)
      complex_.for_each_next(vertex_at(i + 3 * step), [&](Index w) QUADRILLE_ALWAYS_INLINE_LAMBDA {
        evaluator_.prefetch_pair(w);
      });
  }

  // Prefetches consecutive vertices: their neighbourhoods have mostly been read before.
  QUADRILLE_ALWAYS_INLINE void prefetch_next(Index v, Index end) const {
    if (96 >= end - v)
      return;
    evaluator_.prefetch_pair(v + 96);
    complex_.prefetch_corners(v + 48);
  }

  // Adds the pairs of v with vertices from `least` on to the tools, each once.
  void find(PairTools& tools, Index v, Index least) {
    const std::size_t begin = tools.pairs.size();
    if (includes_edges_)
      find_edges(tools, v, least);
    if (has_others())
      find_listed(tools, v, least, begin);
  }

  // The pairs in the tools, with what they cost.
  template <class Visit>
  void visit_found(PairTools& tools, Visit visit) {
    evaluator_.evaluate_all(tools.pairs, tools.keys, tools.labels);
    for (std::size_t i = 0; i < tools.pairs.size(); ++i)
      visit(tools.pairs[i].first, tools.pairs[i].second, tools.keys[i]);
  }

  // There is no branch: whether a vertex has been met before, or which number it has, is hard to
  // predict.
  void find_edges(PairTools& tools, Index v, Index least) {
    VertexPair* const pairs = tools.pairs.extend(2 * complex_.degree_bound(v) + 1);
    std::size_t count = 0;
    const auto add = [&](Index w, bool is_new) {
      pairs[count] = {v, w};
      count += is_new & (w >= least);
    };
    if (link_condition_.is_oriented(v)) {
      complex_.prune_corners(
          v, [&](Index face, Index i) { add(star_face_at(complex_, face, i).second, true); });
    } else {
      VertexLabels& labels = tools.labels;
      labels.clear();
      complex_.prune_corners(v, [&](Index face, Index i) {
        const StarFace f = star_face_at(complex_, face, i);
        add(f.second, labels.insert(f.second));
        add(f.third, labels.insert(f.third));
      });
    }
    tools.pairs.add(count);
  }

  // The pairs from `begin` on are known.
  void find_listed(PairTools& tools, Index v, Index least, std::size_t begin) {
    constexpr Index by_edge = 0, by_list = 1;
    VertexLabels& labels = tools.labels;
    labels.clear(2);
    for (std::size_t i = begin; i < tools.pairs.size(); ++i)
      labels.set(tools.pairs[i].second, by_edge);
    labels.set(v, by_list);
    listed_.prune_partners(v, [&](Index w) {
      if (!complex_.has_faces(w) || labels.has_label(w, by_list))
        return false; // a leftover, or a pair that has become the same as another
      tools.pairs.add_if(!labels.is_labelled(w) && w >= least, {v, w});
      labels.set(w, by_list);
      return true;
    });
  }

  TriangleComplex& complex_;
  const LinkCondition& link_condition_;
  PairLists& listed_; // those of the policy that are not edges
  const PairEvaluator<Policies>& evaluator_;
  bool includes_edges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_FINDER_H
