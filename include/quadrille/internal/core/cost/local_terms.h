#ifndef QUADRILLE_INTERNAL_CORE_COST_LOCAL_TERMS_H
#define QUADRILLE_INTERNAL_CORE_COST_LOCAL_TERMS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/edge_star.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/cost/local_star.h>
#include <quadrille/internal/core/cost/no_local_terms.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/shared_vertices.h>

#include <cstddef>
#include <tuple>

namespace quadrille::internal {

/// The local terms of each vertex, for a cost that looks at the surface as it is now: the sum over
/// its faces and boundary edges, kept up to date through contractions.
template <class Cost>
class LocalTerms {
public:
  using Geometry = internal::Geometry<Cost::dimension>;
  using Current = typename Cost::Current;

  LocalTerms(const Cost& cost, const Geometry& geometry, TriangleComplex& complex,
             const LinkCondition& link_condition, const SharedVertices& shared)
      : cost_(cost), geometry_(geometry), complex_(complex), link_condition_(link_condition),
        shared_(shared), terms_(complex.arena()), on_boundary_(complex.arena()) {}

  const Current& operator[](Index v) const { return terms_[v]; }

  /// Returns how uneven the current faces around a vertex are; 0 if the cost does not measure it.
  double unevenness(Index v) const {
    if constexpr (measures_unevenness<Cost>)
      return cost_.unevenness(terms_[v]);
    else
      return 0;
  }

  /// See SharedTerms.
  Current shared(Index a, Index b) const {
    if (complex_.high_valence_vertices().has(a))
      return shared_with_high_valence(a, b);
    SharedTerms<Cost> shared;
    complex_.for_each_corner(a, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex_, face, i);
      if (f.has(b))
        shared.add(term(a, f), f.other_than(b));
    });
    return shared.sum(a, b, cost_, geometry_.positions());
  }

  /// Returns the current star of the vertex that was contracted last, if its faces are few.
  const LocalStar<Cost>& last_star() const { return last_star_; }

  /// Computes the terms of all vertices again.
  void sum_up(VertexLabels& labels) {
    last_star_.clear();
    terms_ = Array<Current>(terms_.get_allocator()); // gives memory back where vertices are gone
    terms_.resize(geometry_.positions().size());
    for (Index face = 0; face < complex_.face_capacity(); ++face) {
      if (complex_.is_removed(face))
        continue;
      const auto [p, q, r] = complex_.vertices(face);
      const auto& positions = geometry_.positions();
      const Current now = cost_.current_face(positions[p], positions[q], positions[r]);
      for (Index v : {p, q, r})
        terms_[v] += now;
    }
    const bool is_known = link_condition_.knows_kinds();
    on_boundary_.assign(is_known ? 0 : terms_.size(), 0);
    for (Index v = 0; v < terms_.size(); ++v)
      if (!link_condition_.is_interior(v) && add_boundary(v, labels) && !is_known)
        on_boundary_[v] = 1;
  }

  static constexpr bool is_recomputed = true; // see sum_up()
  static auto vertex_arrays(auto& self) { return std::tie(self.terms_); }

  /// Takes the faces that a contraction changes or removes out of the vertices around it that may
  /// be written to.
  template <class Event>
  void before(const Event& event) {
    const auto take_out = [&](const AppendBuffer<StarFace>& faces, Index corner) {
      for (const StarFace& f : faces) {
        const Current old = term(corner, f);
        for (Index v : {f.second, f.third})
          if (event.mode.may_write_to(v))
            terms_[v] -= old;
      }
    };
    const auto& contraction = event.contraction;
    take_out(contraction.star().first, contraction.first());
    take_out(contraction.star().second, contraction.second());
    take_out(contraction.star().shared, contraction.first());
    if constexpr (!Event::is_in_pass)
      if (contraction.star().high_valence != none)
        subtract_from_high_valence(contraction.star(), contraction.first());
  }

  /// Adds the faces that the contraction has left. In a pass the remaining vertex is not used again
  /// until all terms are summed up.
  template <class Event>
  void after(const Event& event) {
    if constexpr (Event::is_in_pass) {
      add_star(event.contraction.star(), event.kept, event.mode);
    } else {
      if (event.contraction.star().high_valence == event.kept)
        add_to_high_valence(event.contraction.star(), event.kept,
                            event.kept == event.contraction.first());
      else
        add_contracted(event.kept);
      renew_boundary(event);
    }
  }

  /// Visits all faces of a vertex again that is or was a high-valence vertex: the terms of its
  /// boundary edges have not changed since the last time.
  QUADRILLE_NOINLINE void sum_up(Index high_valence, VertexLabels& labels) {
    const bool is_on_boundary = may_be_on_boundary(high_valence);
    terms_[high_valence] = sum_of_faces(high_valence);
    if (is_on_boundary)
      add_boundary(high_valence, labels);
  }

private:
  // The other end has fewer faces, as a rule.
  QUADRILLE_NOINLINE Current shared_with_high_valence(Index high_valence, Index other) const {
    SharedTerms<Cost> shared;
    complex_.for_each_corner(other, [&](Index face, Index i) {
      if (!star_face_at(complex_, face, i).has(high_valence))
        return;
      const StarFace f = star_face_from(complex_, face, high_valence);
      shared.add(term(high_valence, f), f.other_than(other));
    });
    return shared.sum(high_valence, other, cost_, geometry_.positions());
  }

  Current term(Index corner, const StarFace& f) const {
    return cost_.current_face(geometry_.position(corner), geometry_.position(f.second),
                              geometry_.position(f.third));
  }

  template <class Mode>
  void add_star(const PairStar& star, Index kept, const Mode& mode) {
    star.for_each_changed([&](const StarFace& f) {
      if (complex_.is_removed(f.face))
        return;
      const Current now = term(kept, f);
      for (Index v : {f.second, f.third})
        if (mode.may_write_to(v))
          terms_[v] += now;
    });
  }

  QUADRILLE_NOINLINE void subtract_from_high_valence(const PairStar& star, Index first) {
    for (const StarFace& f : star.shared)
      terms_[star.high_valence] -= term(first, f);
  }

  // The faces of a high-valence vertex do not change, but for those that come from the other end of
  // the pair.
  QUADRILLE_NOINLINE void add_to_high_valence(const PairStar& star, Index high_valence,
                                              bool is_first) {
    last_star_.clear();
    const auto add = [&](const AppendBuffer<StarFace>& faces, bool are_new) {
      for (const StarFace& f : faces) {
        const Current now = term(high_valence, f);
        const bool is_there = !complex_.is_removed(f.face); // else it was a duplicate
        if (is_there) {
          terms_[f.second] += now;
          terms_[f.third] += now;
        }
        if (is_there && are_new)
          terms_[high_valence] += now;
        else if (!is_there && !are_new)
          terms_[high_valence] -= now;
      }
    };
    add(is_first ? star.first : star.second, false);
    add(is_first ? star.second : star.first, true);
  }

  void add_contracted(Index kept) {
    Current sum{};
    const auto add = [&](Index second, Index third, const Current& now) {
      sum += now;
      terms_[second] += now;
      terms_[third] += now;
    };
    if (complex_.degree_bound(kept) <= LocalStar<Cost>::most_faces) {
      last_star_.clear(kept);
      complex_.prune_corners(kept, [&](Index face, Index i) {
        last_star_.add(star_face_at(complex_, face, i), cost_, geometry_.positions());
      });
      last_star_.for_each_face(add);
    } else {
      last_star_.clear();
      complex_.prune_corners(kept, [&](Index face, Index i) {
        const StarFace f = star_face_at(complex_, face, i);
        add(f.second, f.third, term(kept, f));
      });
    }
    terms_[kept] = sum;
  }

  // Inside the surface the faces of the star are exchanged one by one. Boundary terms depend on
  // faces, so vertices that may have any are summed up again.
  template <class Event>
  void renew_boundary(const Event& event) {
    if (link_condition_.is_closed())
      return;
    VertexLabels& labels = event.contraction.scratch().labels;
    const PairStar& star = event.contraction.star();
    if (!on_boundary_.empty())
      note_boundary(star, event.kept, event.gone);
    renew(event.kept, labels);
    for (const auto* faces : {&star.first, &star.second, &star.shared})
      for (const StarFace& f : *faces)
        for (Index v : {f.second, f.third})
          if (complex_.has_faces(v))
            renew(v, labels);
  }

  // With free topology, an edge drops to one face in two cases only: a duplicate face is gone, or
  // its end was on a boundary before.
  void note_boundary(const PairStar& star, Index kept, Index gone) {
    on_boundary_[kept] |= on_boundary_[gone];
    star.for_each_changed([&](const StarFace& f) {
      if (complex_.is_removed(f.face))
        on_boundary_[kept] = on_boundary_[f.second] = on_boundary_[f.third] = 1;
    });
  }

  bool may_be_on_boundary(Index v) const {
    return on_boundary_.empty() ? !link_condition_.is_interior(v) : on_boundary_[v] != 0;
  }

  void renew(Index v, VertexLabels& labels) {
    if (!may_be_on_boundary(v) || complex_.high_valence_vertices().has(v))
      return;
    terms_[v] = sum_of_faces(v);
    add_boundary(v, labels);
  }

  Current sum_of_faces(Index v) {
    Current sum{};
    complex_.prune_corners(
        v, [&](Index face, Index i) { sum += term(v, star_face_at(complex_, face, i)); });
    return sum;
  }

  // Returns whether there is any.
  bool add_boundary(Index v, VertexLabels& labels) {
    const auto& positions = geometry_.positions();
    bool has_any = false;
    for (const EdgeAt& edge : edges_.gather(complex_, v, labels))
      if (edge.faces == 1 && !shared_.is_seam(v, edge.other)) {
        terms_[v] += cost_.current_boundary(positions[v], positions[edge.other],
                                            positions[edge.opposite[0]]);
        has_any = true;
      }
    return has_any;
  }

  const Cost& cost_;
  const Geometry& geometry_;
  TriangleComplex& complex_;
  const LinkCondition& link_condition_;
  const SharedVertices& shared_;
  Array<Current> terms_;
  Array<unsigned char> on_boundary_; // may a vertex be on a boundary? for topologies in which the
                                     // link condition does not show it
  LocalStar<Cost> last_star_;
  EdgeStar edges_;
};

template <class Cost>
requires has_local_terms<Cost>
struct LocalTermsOf<Cost> {
  using type = LocalTerms<Cost>;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COST_LOCAL_TERMS_H
