#ifndef QUADRILLE_INTERNAL_PAIR_CONTRACTION_H
#define QUADRILLE_INTERNAL_PAIR_CONTRACTION_H

#include <quadrille/internal/link_condition.h>
#include <quadrille/internal/marks.h>
#include <quadrille/internal/policies.h>
#include <quadrille/internal/star.h>
#include <quadrille/internal/surface.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A surface with what its vertices remember, and the steps of contracting one pair of them: view,
/// place, check, contract. In which order pairs come is not its business.
template <class Policies>
class PairContraction {
public:
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Position = Vector<dimension>;
  using Memory = typename Cost::Memory;
  using Pair = PairOf<Cost>;

  /// A pair with the place of its contraction and the cost of that.
  struct Candidate {
    Pair pair;
    Position target;
    double cost;
  };

  PairContraction(SurfaceInput<dimension> input, const Policies& policies)
      : policies_(policies), positions_(std::move(input.positions)), unit_(positions_),
        complex_(positions_.size(), input.triangles), marks_(positions_.size()),
        link_condition_(complex_, marks_), memories_(positions_.size()),
        squared_reach_(positions_.size(), 0), is_moved_(positions_.size(), false) {
    unit_.scale(positions_);
    status_.faces = status_.initial_faces = complex_.live_faces();
    for (Index v = 0; v < positions_.size(); ++v)
      status_.vertices += complex_.has_faces(v);
    status_.initial_vertices = status_.vertices;
    status_.diagonal = unit_.diagonal();
    remember_faces();
    remember_boundaries();
  }

  /// Where the pair goes and what that costs.
  Candidate evaluate(Index a, Index b) const {
    const Pair pair = view(a, b);
    const Position target = policies_.placement(policies_.cost, pair);
    return {pair, target, policies_.cost(pair, target)};
  }

  /// Why this contraction must not be done, if so. The star of the pair is gathered by the way.
  std::optional<Rejection> rejection(Index a, Index b, const Candidate& candidate) {
    star_.gather(complex_, a, b);
    if (!is_finite(candidate.target) || !std::isfinite(candidate.cost))
      return Rejection::position;
    if (policies_.topology == Topology::kept && !link_condition_.holds(star_, a, b, marks_))
      return Rejection::topology;
    const ContractionView<dimension> contraction(star_, positions_, candidate.pair.first,
                                                 candidate.pair.second, candidate.target);
    std::optional<Rejection> cause;
    std::apply([&](const auto&... filter) { (refuses(filter, contraction, cause) || ...); },
               policies_.filters);
    return cause;
  }

  /// Would the contraction whose star was gathered last go beyond the target of the stop policy?
  bool overshoots() const {
    Status after = status_;
    after.faces -= star_.shared.size();
    --after.vertices;
    return is_passed(policies_.stop, after);
  }

  /// Contracts the pair whose star was gathered last, and returns the vertex that is left: an end
  /// that keeps its place, else the first.
  Index contract(Index a, Index b, const Candidate& candidate) {
    const bool b_stays = candidate.target == candidate.pair.second;
    const Index kept = b_stays ? b : a, gone = b_stays ? a : b;
    for (const StarFace& f : star_.shared)
      complex_.kill(f.face);
    complex_.merge(kept, gone);
    is_moved_[kept] = is_moved_[kept] || !(candidate.target == positions_[kept]);
    positions_[kept] = candidate.target;
    memories_[kept] = candidate.pair.memory;
    move_origin(memories_[kept], candidate.target - candidate.pair.first);
    link_condition_.merge(kept, gone);
    update_reach(kept);
    status_.faces = complex_.live_faces();
    --status_.vertices;
    ++status_.contractions;
    return kept;
  }

  /// Calls visit(w) once for each vertex w that makes a pair with v.
  template <class Visit>
  void for_each_neighbour(Index v, Visit visit) {
    marks_.clear();
    marks_.set(v);
    complex_.for_each_corner(v, [&](Index face, Index) {
      for (Index w : complex_.vertices(face)) {
        if (marks_.is_marked(w))
          continue;
        marks_.set(w);
        visit(w);
      }
    });
  }

  /// Tells the status of the contraction that comes next.
  void announce(const Candidate& candidate) {
    const double squared = squared_error(policies_.cost, candidate.pair, candidate.cost);
    status_.next_error = unit_.in_mesh_units(std::sqrt(std::max(0.0, squared)));
  }

  const Status& status() const { return status_; }
  const Policies& policies() const { return policies_; }
  std::size_t vertex_capacity() const { return positions_.size(); }

  /// Of a vertex, in the mesh's unit of length.
  Position position(Index v) const {
    Position p = positions_[v];
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = unit_.in_mesh_units(p[i]);
    return p;
  }
  TriangleComplex& complex() { return complex_; }
  const TriangleComplex& complex() const { return complex_; }
  bool is_moved(Index v) const { return is_moved_[v]; }

private:
  Pair view(Index a, Index b) const {
    Pair pair{positions_[a], positions_[b], memories_[b],
              std::max(squared_reach_[a], squared_reach_[b])};
    move_origin(pair.memory, pair.first - pair.second);
    pair.memory += memories_[a];
    return pair;
  }

  template <class Filter, class Contraction>
  static bool refuses(const Filter& filter, const Contraction& contraction,
                      std::optional<Rejection>& cause) {
    if (filter.allows(contraction))
      return false;
    if constexpr (requires { Filter::cause; })
      cause = Filter::cause;
    else
      cause = Rejection::filter;
    return true;
  }

  void remember_faces() {
    for (Index face = 0; face < complex_.face_capacity(); ++face) {
      if (complex_.is_dead(face))
        continue;
      const auto [p, q, r] = complex_.vertices(face);
      remember_face(p, q, r);
    }
  }

  void remember_face(Index p, Index q, Index r) {
    const Cost& cost = policies_.cost;
    const Memory memory = cost.face(positions_[p], positions_[q], positions_[r]);
    memories_[p] += memory;
    if constexpr (requires { requires Cost::face_is_alike_at_corners; }) {
      memories_[q] += memory;
      memories_[r] += memory;
    } else {
      memories_[q] += cost.face(positions_[q], positions_[r], positions_[p]);
      memories_[r] += cost.face(positions_[r], positions_[p], positions_[q]);
    }
  }

  // Each end of a boundary edge sees it by itself: one of its neighbours belongs to one face only.
  void remember_boundaries() {
    for (Index v = 0; v < positions_.size(); ++v) {
      update_reach(v);
      if constexpr (requires(Cost c, Position p) { c.boundary(p, p, p); })
        for_each_boundary_edge(v, [&](Index w, Index opposite) {
          memories_[v] +=
              policies_.cost.boundary(positions_[v], positions_[w], positions_[opposite]);
        });
    }
  }

  // Calls visit(w, opposite) for each edge vw of one face.
  template <class Visit>
  void for_each_boundary_edge(Index v, Visit visit) {
    constexpr Index once = 0, often = 1;
    marks_.clear(2);
    complex_.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex_, face, i);
      for (Index w : {f.second, f.third})
        marks_.set(w, marks_.is_marked(w) ? often : once);
    });
    complex_.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex_, face, i);
      if (marks_.is_marked_with(f.second, once))
        visit(f.second, f.third);
      if (marks_.is_marked_with(f.third, once))
        visit(f.third, f.second);
    });
  }

  // The reach of a vertex grows with its neighbours' moves and does not shrink when one is gone.
  void update_reach(Index v) {
    double longest = 0;
    const auto lengthen = [&](Index w) {
      const double squared = squared_distance(space(positions_[v]), space(positions_[w]));
      longest = std::max(longest, squared);
      squared_reach_[w] = std::max(squared_reach_[w], static_cast<float>(squared));
    };
    complex_.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex_, face, i);
      lengthen(f.second);
      lengthen(f.third);
    });
    squared_reach_[v] = static_cast<float>(longest);
  }

  const Policies& policies_;
  std::vector<Position> positions_;
  LengthUnit unit_;
  TriangleComplex complex_;
  Marks marks_;
  LinkCondition link_condition_;
  std::vector<Memory> memories_;
  std::vector<float> squared_reach_;
  std::vector<bool> is_moved_;
  PairStar star_;
  Status status_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PAIR_CONTRACTION_H
