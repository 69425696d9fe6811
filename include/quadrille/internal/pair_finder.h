#ifndef QUADRILLE_INTERNAL_PAIR_FINDER_H
#define QUADRILLE_INTERNAL_PAIR_FINDER_H

#include <quadrille/internal/marks.h>
#include <quadrille/internal/pair_lists.h>
#include <quadrille/internal/policies.h>
#include <quadrille/internal/scratch.h>
#include <quadrille/internal/star.h>
#include <quadrille/internal/triangle_complex.h>

#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// The pairs at a vertex: edges, if the policy includes them, and those that it has listed.
template <class Pairs>
class PairFinder {
public:
  PairFinder(TriangleComplex& complex, PairLists listed)
      : complex_(complex), listed_(std::move(listed)) {}

  std::size_t listed_count() const { return listed_.size(); }
  void merge(Index kept, Index gone) { listed_.merge(kept, gone); }

  /// Adds the pairs of v with vertices from `least` on to those of the scratch, each once. Where
  /// `is_oriented`, each neighbour of v is the second vertex of just one of its faces.
  void find(Scratch& scratch, Index v, Index least, bool is_oriented) {
    const std::size_t begin = scratch.pairs.size();
    if constexpr (includes_edges<Pairs>)
      find_edges(scratch, v, least, is_oriented);
    if (listed_.size() > 0)
      find_listed(scratch, v, least, begin);
  }

private:
  // No branch: whether a vertex has been met before, or what its number is, is hard to guess.
  void find_edges(Scratch& scratch, Index v, Index least, bool is_oriented) {
    VertexPair* const pairs = scratch.pairs.extend(2 * complex_.degree_bound(v) + 1);
    std::size_t count = 0;
    const auto add = [&](Index w, bool is_new) {
      pairs[count] = {v, w};
      count += is_new & (w >= least);
    };
    if (is_oriented) {
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
  PairLists listed_; // those of the policy that are not edges
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PAIR_FINDER_H
