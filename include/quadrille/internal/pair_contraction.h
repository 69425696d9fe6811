#ifndef QUADRILLE_INTERNAL_PAIR_CONTRACTION_H
#define QUADRILLE_INTERNAL_PAIR_CONTRACTION_H

#include <quadrille/internal/attributes.h>
#include <quadrille/internal/current_memories.h>
#include <quadrille/internal/link_condition.h>
#include <quadrille/internal/marks.h>
#include <quadrille/internal/memories.h>
#include <quadrille/internal/pair_lists.h>
#include <quadrille/internal/pair_selection.h>
#include <quadrille/internal/policies.h>
#include <quadrille/internal/star.h>
#include <quadrille/internal/surface.h>
#include <quadrille/internal/topology_count.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
      : policies_(policies), scale_(scale_of(input, policies.cost)),
        complex_(input.positions.size(), take_triangles(input)), marks_(input.positions.size()),
        pairs_(select_pairs(policies.pairs, input, complex_, marks_)),
        is_topology_kept_(keeps_topology(input)), positions_(std::move(input.positions)),
        is_fixed_(std::move(input.is_fixed)), squared_reach_(positions_.size(), 0),
        is_moved_(positions_.size(), false), merged_into_(positions_.size(), none) {
    scale_.apply(positions_);
    if (!is_topology_kept_ || input.has_doubled_faces)
      for (Index v = 0; v < positions_.size(); ++v)
        drop_doubled_faces(v);
    if (is_topology_kept_)
      link_condition_ = LinkCondition(complex_, marks_);
    else
      initial_components_ = count_components(complex_);
    start_status();
    memories_ =
        InitialMemories<Cost>::compute(policies_.cost, positions_, complex_, marks_, input.creases,
                                       [this](Index v) { return is_interior(v); });
    if constexpr (asks_for_current<Cost>)
      current_ = CurrentMemories<Cost>(policies_.cost, positions_, complex_, marks_);
    start_reach();
  }

  /// Asks for what evaluating a pair of this vertex will read, and then for its faces.
  void prefetch(Index v) const {
    complex_.prefetch(v);
    __builtin_prefetch(&positions_[v]);
    prefetch_memory(v);
  }
  void prefetch_corners(Index v) const { complex_.prefetch_corners(v); }
  void prefetch_faces(Index v) const { complex_.prefetch_faces(v); }

  /// Where the pair goes and what that costs.
  Candidate evaluate(Index a, Index b) {
    const Pair pair = view(a, b);
    const Position target = target_of(a, b, pair);
    return {pair, target, policies_.cost(pair, target)};
  }

  /// Only what it costs.
  double cost_of(Index a, Index b) {
    const Pair pair = view(a, b);
    return policies_.cost(pair, target_of(a, b, pair));
  }

  /// Why this contraction must not be done, if so. The star of the pair is gathered by the way.
  std::optional<Rejection> rejection(Index a, Index b, const Candidate& candidate) {
    star_.gather(complex_, a, b);
    for (const auto* faces : {&star_.first, &star_.second})
      for (const StarFace& f : *faces)
        prefetch_memory(f.second);
    if (is_fixed(a) && is_fixed(b))
      return Rejection::constraint;
    if (!is_finite(candidate.target) || !std::isfinite(candidate.cost))
      return Rejection::position;
    if (is_topology_kept_ && !link_condition_.holds(star_, a, b, marks_))
      return Rejection::topology;
    const ContractionView<dimension> contraction(star_, positions_, candidate.pair.first,
                                                 candidate.pair.second, candidate.target);
    std::optional<Rejection> cause;
    std::apply([&](const auto&... filter) { (refuses(filter, contraction, cause) || ...); },
               policies_.filters);
    return cause;
  }

  /// Would the contraction whose star was gathered last go beyond the target of the stop policy,
  /// where another one might not?
  bool overshoots() const {
    if (is_closed())
      return false; // each contraction takes two faces
    Status after = status_;
    after.faces -= star_.shared.size();
    --after.vertices;
    return is_passed(policies_.stop, after);
  }

  /// Contracts the pair whose star was gathered last, and returns the vertex that is left: an end
  /// that keeps its place, else the first.
  Index contract(Index a, Index b, const Candidate& candidate) {
    const bool b_stays =
        !is_fixed(a) && (is_fixed(b) || (candidate.target == candidate.pair.second &&
                                         candidate.target != candidate.pair.first));
    const Index kept = b_stays ? b : a, gone = b_stays ? a : b;
    non_edge_contractions_ += star_.shared.empty();
    if constexpr (asks_for_current<Cost>)
      current_.forget(star_, a, b, policies_.cost, positions_);
    complex_.merge(kept, gone);
    for (const StarFace& f : star_.shared)
      complex_.kill(f.face);
    pairs_.merge(kept, gone);
    merged_into_[gone] = kept;
    --status_.vertices;
    place(kept, candidate);
    if (is_topology_kept_)
      link_condition_.merge(kept, gone);
    else
      drop_leftovers(kept);
    if constexpr (asks_for_current<Cost>)
      update_current(kept);
    update_reach(kept);
    status_.faces = complex_.live_faces();
    ++status_.contractions;
    return kept;
  }

  /// Calls visit(w) once for each vertex w that makes a pair with v.
  template <class Visit>
  void for_each_partner(Index v, Visit visit) {
    constexpr Index by_edge = 0, by_list = 1;
    marks_.clear();
    marks_.set(v, by_list);
    if constexpr (includes_edges<typename Policies::Pairs>)
      complex_.for_each_corner(v, [&](Index face, Index) {
        for (Index w : complex_.vertices(face)) {
          if (marks_.is_marked(w))
            continue;
          marks_.set(w, by_edge);
          visit(w);
        }
      });
    if (pairs_.size() == 0)
      return;
    pairs_.for_each_partner(v, [&](Index w) {
      if (!complex_.has_faces(w) || marks_.is_marked_with(w, by_list))
        return false; // a leftover, or a pair that has become the same as another
      if (!marks_.is_marked(w))
        visit(w);
      marks_.set(w, by_list);
      return true;
    });
  }

  std::size_t pair_count() const {
    return pairs_.size() +
           (includes_edges<typename Policies::Pairs> ? 3 * complex_.live_faces() / 2 : 0);
  }

  /// Tells the status of the contraction that comes next.
  void announce(const Candidate& candidate) {
    const double squared = squared_error(policies_.cost, candidate.pair, candidate.cost);
    status_.next_error = scale_.length_of_mesh(std::sqrt(std::max(0.0, squared)));
  }

  /// Tells what became of the surface.
  void complete(Report& report) {
    report.faces_after = status_.faces;
    report.vertices_after = status_.vertices;
    report.contractions = status_.contractions;
    report.non_edge_contractions = non_edge_contractions_;
    const TopologyCount count = count_topology(complex_, marks_);
    report.components_after = count.components;
    report.components_before = is_topology_kept_ ? count.components : initial_components_;
    report.non_manifold_edges = count.non_manifold_edges;
    report.non_manifold_vertices = count.non_manifold_vertices;
  }

  const Status& status() const { return status_; }
  const Policies& policies() const { return policies_; }
  TriangleComplex& complex() { return complex_; }
  const TriangleComplex& complex() const { return complex_; }

  std::size_t vertex_capacity() const { return positions_.size(); }
  /// What a vertex of the beginning has become part of.
  Index image(Index v) const {
    while (merged_into_[v] != none)
      v = merged_into_[v];
    return v;
  }
  /// Had the surface no border, nor will it have one?
  bool is_closed() const { return is_topology_kept_ && link_condition_.is_closed(); }
  bool is_moved(Index v) const { return is_moved_[v]; }
  /// Of a vertex, in the units of the mesh and its attributes.
  Position position(Index v) const { return scale_.position_of_mesh(positions_[v]); }
  /// What a vertex remembers, as vertex_quadric_map tells it.
  auto mean_quadric(Index v) const { return scale_.mean_of_mesh(memories_[v]); }

private:
  static Scale<dimension> scale_of(const SurfaceInput<dimension>& input, const Cost& cost) {
    const Box<dimension> box(input.positions);
    Scale<dimension> scale(box);
    if constexpr (requires {
                    cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), 1.0);
                  })
      scale.set_attribute_weights(
          cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), box.diagonal()));
    return scale;
  }

  void prefetch_memory(Index v) const {
    const char* memory = reinterpret_cast<const char*>(&memories_[v]);
    for (std::size_t line = 0; line < sizeof(Memory); line += 64)
      __builtin_prefetch(memory + line);
  }

  // A pair policy of the user's wants to see them once more.
  static std::vector<TriangleComplex::Triangle> take_triangles(SurfaceInput<dimension>& input) {
    if constexpr (std::same_as<typename Policies::Pairs, EdgePairs>)
      return std::move(input.triangles);
    else
      return input.triangles;
  }

  // Unless the user says, an adapter's default, or free if there are pairs that are not edges.
  bool keeps_topology(const SurfaceInput<dimension>& input) const {
    const Topology by_default = pairs_.size() > 0 ? Topology::free : input.default_topology;
    return policies_.topology.value_or(by_default) == Topology::kept;
  }

  Position target_of(Index a, Index b, const Pair& pair) const {
    if (is_fixed(a) || is_fixed(b))
      return is_fixed(a) ? pair.first : pair.second;
    return policies_.placement(policies_.cost, pair);
  }

  Pair view(Index a, Index b) {
    Pair pair{positions_[a], positions_[b],
              sum_about_first(memories_[a], memories_[b], positions_[b] - positions_[a]),
              std::max(squared_reach_[a], squared_reach_[b])};
    if constexpr (asks_for_current<Cost>)
      pair.current =
          policies_.cost.join(current_[a], current_[b], shared(a, b), pair.second - pair.first);
    return pair;
  }

  // What both ends see now, about the first: the faces of the edge, and the edge itself if it is on
  // the boundary.
  auto shared(Index a, Index b) requires asks_for_current<Cost> {
    const Cost& cost = policies_.cost;
    typename Cost::Current sum{};
    std::size_t faces = 0;
    Index opposite = none;
    complex_.for_each_corner(a, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(complex_, face, i);
      if (f.second != b && f.third != b)
        return;
      sum += cost.current_face(positions_[a], positions_[f.second], positions_[f.third]);
      opposite = f.second == b ? f.third : f.second;
      ++faces;
    });
    if (faces == 1)
      sum += cost.current_boundary(positions_[a], positions_[b], positions_[opposite]);
    return sum;
  }

  // Inside the surface the faces of the star are exchanged one by one. Constraint planes of
  // boundary edges lean on faces, so vertices that may have any are summed up anew.
  void update_current(Index kept) requires asks_for_current<Cost> {
    current_.learn(kept, policies_.cost, positions_, complex_);
    const auto renew = [&](Index v) {
      if (!is_interior(v))
        current_.recompute(v, policies_.cost, positions_, complex_, marks_);
    };
    if (is_closed())
      return;
    renew(kept);
    for (const auto* faces : {&star_.first, &star_.second, &star_.shared})
      for (const StarFace& f : *faces)
        for (Index v : {f.second, f.third})
          if (complex_.has_faces(v))
            renew(v);
  }

  // Known to be inside the surface: without the link condition nothing is.
  bool is_interior(Index v) const { return is_topology_kept_ && link_condition_.is_interior(v); }

  bool is_fixed(Index v) const { return !is_fixed_.empty() && is_fixed_[v]; }

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

  void start_status() {
    status_.faces = status_.initial_faces = complex_.live_faces();
    for (Index v = 0; v < positions_.size(); ++v)
      status_.vertices += complex_.has_faces(v);
    status_.initial_vertices = status_.vertices;
    status_.diagonal = scale_.diagonal();
  }

  void place(Index kept, const Candidate& candidate) {
    is_moved_[kept] = is_moved_[kept] || candidate.target != positions_[kept];
    positions_[kept] = candidate.target;
    memories_[kept] = candidate.pair.memory;
    move_origin(memories_[kept], candidate.target - candidate.pair.first);
  }

  // What contractions that change the topology leave behind: doubled faces, vertices without a
  // face.
  void drop_leftovers(Index kept) {
    drop_doubled_faces(kept);
    for (const StarFace& f : star_.shared)
      for (Index v : {f.second, f.third})
        drop_if_bare(v);
    drop_if_bare(kept);
  }

  // Of faces with the same three vertices the first is left.
  void drop_doubled_faces(Index v) {
    const auto is_same = [](const StarFace& a, const StarFace& b) {
      return a.second == b.second && a.third == b.third;
    };
    doubles_.clear();
    complex_.for_each_corner(v, [&](Index face, Index i) {
      StarFace f = PairStar::star_face(complex_, face, i);
      if (f.third < f.second)
        std::swap(f.second, f.third);
      doubles_.push_back(f);
    });
    std::sort(doubles_.begin(), doubles_.end(), [](const StarFace& a, const StarFace& b) {
      return std::tie(a.second, a.third, a.face) < std::tie(b.second, b.third, b.face);
    });
    for (std::size_t i = 1; i < doubles_.size(); ++i)
      if (is_same(doubles_[i - 1], doubles_[i]))
        complex_.kill(doubles_[i].face);
  }

  void drop_if_bare(Index v) {
    if (!complex_.has_faces(v))
      return;
    complex_.for_each_corner(v, [](Index, Index) {});
    if (!complex_.has_faces(v))
      --status_.vertices;
  }

  void start_reach() {
    for (Index face = 0; face < complex_.face_capacity(); ++face) {
      if (complex_.is_dead(face))
        continue;
      const auto [p, q, r] = complex_.vertices(face);
      for (const auto& [v, w] : {std::pair(p, q), std::pair(q, r), std::pair(r, p)}) {
        lengthen_reach(v, w);
        lengthen_reach(w, v);
      }
    }
  }

  // The reach of a vertex stays as it is while others move: the cost of a pair depends on nothing
  // that can change while the pair waits in the queue.
  void update_reach(Index kept) {
    squared_reach_[kept] = 0;
    for (const auto* faces : {&star_.first, &star_.second})
      for (const StarFace& f : *faces)
        for (Index w : {f.second, f.third})
          lengthen_reach(kept, w);
  }

  void lengthen_reach(Index v, Index w) {
    const double squared = squared_distance(space(positions_[v]), space(positions_[w]));
    squared_reach_[v] = std::max(squared_reach_[v], static_cast<float>(squared));
  }

  const Policies& policies_;
  Scale<dimension> scale_;
  TriangleComplex complex_;
  Marks marks_;
  PairLists pairs_; // those of the policy that are not edges
  bool is_topology_kept_;
  LinkCondition link_condition_;
  std::vector<Position> positions_;
  std::vector<bool> is_fixed_; // empty if none is
  std::vector<Memory> memories_;
  [[no_unique_address]] typename CurrentMemoriesOf<Cost>::type current_;
  std::vector<float> squared_reach_;
  std::vector<bool> is_moved_;
  std::vector<Index> merged_into_; // of each vertex that is gone
  PairStar star_;
  std::vector<StarFace> doubles_;
  Status status_;
  std::size_t non_edge_contractions_ = 0;
  std::size_t initial_components_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PAIR_CONTRACTION_H
