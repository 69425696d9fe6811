#ifndef QUADRILLE_INTERNAL_PAIR_CONTRACTION_H
#define QUADRILLE_INTERNAL_PAIR_CONTRACTION_H

#include <quadrille/internal/attributes.h>
#include <quadrille/internal/current_memories.h>
#include <quadrille/internal/distance_bound.h>
#include <quadrille/internal/link_condition.h>
#include <quadrille/internal/marks.h>
#include <quadrille/internal/memories.h>
#include <quadrille/internal/pair_lists.h>
#include <quadrille/internal/pair_selection.h>
#include <quadrille/internal/policies.h>
#include <quadrille/internal/scratch.h>
#include <quadrille/internal/star.h>
#include <quadrille/internal/surface.h>
#include <quadrille/internal/topology_count.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/internal/two_quadrics.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
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

  /// A pair with the place of its contraction, the cost of that, and the error as a distance in the
  /// mesh's units.
  struct Candidate {
    Pair pair;
    Position target;
    double cost, error;
  };

  PairContraction(SurfaceInput<dimension> input, const Policies& policies)
      : policies_(policies), scale_(scale_of(input, policies.cost)),
        complex_(input.positions.size(), take_triangles(input)), scratch_(input.positions.size()),
        pairs_(select_pairs(policies.pairs, input, complex_, scratch_.marks)),
        is_topology_kept_(keeps_topology(input)), positions_(std::move(input.positions)),
        is_fixed_(std::move(input.is_fixed)), squared_reach_(positions_.size(), 0),
        is_moved_(positions_.size(), 0), creases_(std::move(input.creases)),
        merged_into_(positions_.size(), none) {
    scale_.apply(positions_);
    if (!is_topology_kept_ || input.has_doubled_faces)
      for (Index v = 0; v < positions_.size(); ++v)
        drop_doubled_faces_at(v);
    if (is_topology_kept_)
      link_condition_ = LinkCondition(complex_, scratch_.marks);
    else
      initial_components_ = count_components(complex_);
    start_status();
    if constexpr (asks_for_distance)
      distances_ = DistanceBounds(complex_.face_capacity());
    memories_.resize(positions_.size());
    remember();
    start_reach();
  }

  /// Asks for what contracting the pairs that come next will read, one thing after the other: what
  /// costs look at and where the corners of a vertex are, the corners, the faces. peek(n) points to
  /// the pair that comes n pairs later, or nowhere.
  template <class Peek>
  void prefetch(Peek peek) const {
    if (const auto* last = peek(12))
      for (Index v : {last->first, last->second}) {
        complex_.prefetch(v);
        __builtin_prefetch(&positions_[v]);
        prefetch_memory(v);
      }
    if (const auto* later = peek(8))
      for (Index v : {later->first, later->second})
        complex_.prefetch_corners(v);
    if (const auto* soon = peek(4))
      for (Index v : {soon->first, soon->second})
        complex_.prefetch_faces(v);
  }

  /// Where the pair goes and what that costs.
  Candidate evaluate(Index a, Index b) const {
    const Pair pair = view(a, b);
    const Position target = target_of(a, b, pair);
    const double cost = policies_.cost(pair, target);
    return {pair, target, cost, error_of(pair, cost)};
  }

  /// What the pairs of a vertex and each of its partners in the scratch cost, in its `costs`; 0 for
  /// what is below, or no number.
  void evaluate_all(Scratch& scratch, Index v) const {
    const std::vector<Index>& partners = scratch.partners;
    scratch.costs.resize(partners.size());
    std::size_t i = 0;
    if constexpr (has_fast_costs)
      if (is_fixed_.empty())
        for (; i + 1 < partners.size(); i += 2)
          evaluate_two(v, &partners[i], &scratch.costs[i]);
    for (; i < partners.size(); ++i)
      scratch.costs[i] = as_key(cost_of(v, partners[i]));
  }

  /// Gathers the star of a pair, for the three functions that follow.
  void gather(Scratch& scratch, Index a, Index b) {
    scratch.star.gather(complex_, a, b);
    for (const auto* faces : {&scratch.star.first, &scratch.star.second})
      for (const StarFace& f : *faces)
        prefetch_memory(f.second);
  }

  /// Why this contraction must not be done, if so.
  std::optional<Rejection> rejection(Scratch& scratch, Index a, Index b,
                                     const Candidate& candidate) const {
    if ((is_fixed(a) && is_fixed(b)) || takes_a_fixed_vertex_away(scratch.star, a, b))
      return Rejection::constraint;
    if (!is_finite(candidate.target) || !std::isfinite(candidate.cost))
      return Rejection::position;
    if (is_topology_kept_ && !link_condition_.holds(scratch.star, a, b, scratch.marks))
      return Rejection::topology;
    const ContractionView<dimension> contraction(scratch.star, positions_, candidate.pair.first,
                                                 candidate.pair.second, candidate.target);
    std::optional<Rejection> cause;
    std::apply([&](const auto&... filter) { (refuses(filter, contraction, cause) || ...); },
               policies_.filters);
    return cause;
  }

  /// Would the contraction go beyond the target of the stop policy, where another one might not?
  bool overshoots(const Scratch& scratch) const {
    if (is_closed())
      return false; // each contraction takes two faces
    Status after = status_;
    after.faces -= scratch.star.shared.size();
    --after.vertices;
    return is_passed(policies_.stop, after);
  }

  /// Contracts the pair and returns the vertex that is left: an end that keeps its place, else the
  /// first. What has changed is tallied, to be counted.
  Index contract(Scratch& scratch, Index a, Index b, const Candidate& candidate) {
    const auto [kept, gone] = choose(a, b, candidate);
    if constexpr (asks_for_current<Cost>)
      current_.forget(scratch.star, a, b, policies_.cost, positions_);
    complex_.merge(kept, gone);
    kill_shared(scratch);
    move(scratch, kept, gone, candidate);
    if (!is_topology_kept_)
      drop_bare(scratch, kept);
    if constexpr (asks_for_current<Cost>)
      update_current(scratch, kept);
    return kept;
  }

  /// The same, for any number of pairs that have no end in common; then end_pass() is called.
  /// Pairs whose stars have no vertex in common may be contracted at the same time.
  void contract_in_pass(Scratch& scratch, Index a, Index b, const Candidate& candidate) {
    const auto [kept, gone] = choose(a, b, candidate);
    complex_.relabel(kept, gone);
    kill_shared(scratch);
    move(scratch, kept, gone, candidate);
  }

  /// Vertices remember the surface as it is now instead of as it was, if `refresh` is true.
  void end_pass(bool refresh) {
    complex_.build_lists();
    if (!is_topology_kept_)
      status_.vertices = count_vertices();
    if (refresh) {
      for (auto& [v, w] : creases_)
        v = image(v), w = image(w);
      std::erase_if(creases_, [](const auto& crease) { return crease[0] == crease[1]; });
      remember();
    } else if constexpr (asks_for_current<Cost>) {
      current_ = CurrentMemories<Cost>(policies_.cost, positions_, complex_, scratch_.marks);
    }
  }

  /// Adds what contractions have changed to the status, and forgets it.
  void count(Tally& tally) {
    status_.faces -= tally.faces;
    status_.vertices -= tally.vertices;
    status_.contractions += tally.contractions;
    total_.non_edge_contractions += tally.non_edge_contractions;
    total_.error = std::max(total_.error, tally.error);
    for (std::size_t cause = 0; cause < rejection_causes; ++cause)
      total_.rejections[cause] += tally.rejections[cause];
    tally = {};
  }

  /// The vertices that make a pair with v, each once. Valid until the scratch is used again.
  const std::vector<Index>& partners(Scratch& scratch, Index v) {
    Marks& marks = scratch.marks;
    std::vector<Index>& partners = scratch.partners;
    partners.clear();
    marks.clear();
    marks.insert(v);
    if constexpr (includes_edges<typename Policies::Pairs>) {
      partners.resize(2 * complex_.degree_bound(v) + 1);
      std::size_t count = 0; // no branch: whether a vertex has been met before is hard to guess
      complex_.for_each_corner(v, [&](Index face, Index i) {
        const StarFace f = PairStar::star_face(complex_, face, i);
        partners[count] = f.second;
        count += marks.insert(f.second);
        partners[count] = f.third;
        count += marks.insert(f.third);
      });
      partners.resize(count);
    }
    if (pairs_.size() > 0)
      add_listed_partners(scratch, v);
    return partners;
  }

  /// Calls visit(w, cost) for each pair of v with a vertex w of a higher number.
  template <class Visit>
  void for_each_pair_above(Scratch& scratch, Index v, Visit visit) {
    if (!complex_.has_faces(v))
      return;
    partners(scratch, v);
    std::size_t above = 0; // no branch here either
    for (Index w : scratch.partners) {
      scratch.partners[above] = w;
      above += v < w;
    }
    scratch.partners.resize(above);
    evaluate_all(scratch, v);
    for (std::size_t i = 0; i < above; ++i)
      visit(scratch.partners[i], scratch.costs[i]);
  }

  std::size_t pair_count() const {
    return pairs_.size() + (includes_edges<typename Policies::Pairs> ? 3 * status_.faces / 2 : 0);
  }
  bool has_other_pairs() const { return pairs_.size() > 0; } // than edges

  /// Tells the status of the contraction that comes next.
  void announce(const Candidate& candidate) { status_.next_error = candidate.error; }

  /// Tells how far from the input the surface may be after the contraction, in the mesh's units.
  /// The faces will be bound by that.
  double bound_distance(Scratch& scratch, Index a, Index b, const Candidate& candidate) const {
    const bool is_inside = is_interior(a) && is_interior(b);
    return scale_.length_of_mesh(distances_.after(
        scratch.star, a, b, positions_, space(candidate.target), is_inside, scratch.bounds));
  }
  void announce_distance(double distance) { status_.next_distance = distance; }

  /// Does the stop policy say so?
  bool is_enough() const { return policies_.stop(status_); }

  /// Tells what became of the surface.
  void complete(Report& report) {
    report.faces_after = status_.faces;
    report.vertices_after = status_.vertices;
    report.contractions = status_.contractions;
    report.non_edge_contractions = total_.non_edge_contractions;
    report.rejections = total_.rejections;
    report.error = total_.error;
    if constexpr (asks_for_distance)
      report.distance_bound = scale_.length_of_mesh(greatest_bound());
    const TopologyCount count = count_topology(complex_, scratch_.marks);
    report.components_after = count.components;
    report.components_before = is_topology_kept_ ? count.components : initial_components_;
    report.non_manifold_edges = count.non_manifold_edges;
    report.non_manifold_vertices = count.non_manifold_vertices;
  }

  const Status& status() const { return status_; }
  const Policies& policies() const { return policies_; }
  TriangleComplex& complex() { return complex_; }
  const TriangleComplex& complex() const { return complex_; }

  Scratch& scratch() { return scratch_; }

  std::size_t vertex_capacity() const { return positions_.size(); }
  /// What a vertex of the beginning has become part of.
  Index image(Index v) const {
    while (merged_into_[v] != none)
      v = merged_into_[v];
    return v;
  }
  /// Had the surface no border, nor will it have one?
  bool is_closed() const { return is_topology_kept_ && link_condition_.is_closed(); }
  bool is_moved(Index v) const { return is_moved_[v] != 0; }
  bool is_fixed(Index v) const { return !is_fixed_.empty() && is_fixed_[v]; }
  bool is_topology_kept() const { return is_topology_kept_; }
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

  static constexpr bool asks_for_distance = internal::asks_for_distance<typename Policies::Stop>;
  static constexpr bool has_fast_costs =
      std::same_as<Cost, Quadric> && std::same_as<typename Policies::Placement, OptimalPlacement>;

  double error_of(const Pair& pair, double cost) const {
    const double squared = squared_error(policies_.cost, pair, cost);
    return scale_.length_of_mesh(std::sqrt(std::max(0.0, squared)));
  }

  static float as_key(double cost) { return std::max(0.0f, static_cast<float>(cost)); }

  double cost_of(Index a, Index b) const {
    const Pair pair = view(std::min(a, b), std::max(a, b));
    return policies_.cost(pair, target_of(std::min(a, b), std::max(a, b), pair));
  }

  void evaluate_two(Index v, const Index* partners, float* costs) const requires has_fast_costs {
    const Index w0 = partners[0], w1 = partners[1];
    const Lanes reach = {std::max(squared_reach_[v], squared_reach_[w0]),
                         std::max(squared_reach_[v], squared_reach_[w1])};
    const Lanes values =
        least_values(memories_[v], {&memories_[w0], &memories_[w1]},
                     {positions_[w0] - positions_[v], positions_[w1] - positions_[v]}, reach);
    for (int i = 0; i < 2; ++i)
      costs[i] = as_key(std::isnan(values[i]) ? cost_of(v, partners[i]) : values[i]);
  }

  Position target_of(Index a, Index b, const Pair& pair) const {
    if (is_fixed(a) || is_fixed(b))
      return is_fixed(a) ? pair.first : pair.second;
    return policies_.placement(policies_.cost, pair);
  }

  Pair view(Index a, Index b) const {
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
  auto shared(Index a, Index b) const requires asks_for_current<Cost> {
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
  void update_current(const Scratch& scratch, Index kept) requires asks_for_current<Cost> {
    current_.learn(kept, policies_.cost, positions_, complex_);
    const auto renew = [&](Index v) {
      if (!is_interior(v))
        current_.recompute(v, policies_.cost, positions_, complex_, scratch_.marks);
    };
    if (is_closed())
      return;
    renew(kept);
    const PairStar& star = scratch.star;
    for (const auto* faces : {&star.first, &star.second, &star.shared})
      for (const StarFace& f : *faces)
        for (Index v : {f.second, f.third})
          if (complex_.has_faces(v))
            renew(v);
  }

  // Known to be inside the surface: without the link condition nothing is.
  bool is_interior(Index v) const { return is_topology_kept_ && link_condition_.is_interior(v); }

  // When topology is free, the faces that vanish may be the last of the pair, or of their third
  // vertex and its edge to the pair.
  bool takes_a_fixed_vertex_away(const PairStar& star, Index a, Index b) const {
    if (is_fixed_.empty() || is_topology_kept_)
      return false;
    if (star.first.empty() && star.second.empty() && (is_fixed(a) || is_fixed(b)))
      return true;
    const auto is_at = [](Index v) {
      return [v](const StarFace& f) { return f.second == v || f.third == v; };
    };
    return std::any_of(star.shared.begin(), star.shared.end(), [&](const StarFace& f) {
      const Index v = f.second == b ? f.third : f.second;
      return is_fixed(v) && std::none_of(star.first.begin(), star.first.end(), is_at(v)) &&
             std::none_of(star.second.begin(), star.second.end(), is_at(v));
    });
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

  void add_listed_partners(Scratch& scratch, Index v) {
    constexpr Index by_list = 1;
    Marks& marks = scratch.marks;
    marks.set(v, by_list);
    pairs_.for_each_partner(v, [&](Index w) {
      if (!complex_.has_faces(w) || marks.is_marked_with(w, by_list))
        return false; // a leftover, or a pair that has become the same as another
      if (!marks.is_marked(w))
        scratch.partners.push_back(w);
      marks.set(w, by_list);
      return true;
    });
  }

  void start_status() {
    status_.faces = status_.initial_faces = complex_.live_faces();
    status_.vertices = status_.initial_vertices = count_vertices();
    status_.diagonal = scale_.diagonal();
  }

  std::size_t count_vertices() const {
    std::size_t count = 0;
    for (Index v = 0; v < positions_.size(); ++v)
      count += complex_.has_faces(v);
    return count;
  }

  // Vertices remember the surface as it is now.
  void remember() {
    InitialMemories<Cost>::compute(memories_, policies_.cost, positions_, complex_, scratch_.marks,
                                   creases_, [this](Index v) { return is_interior(v); });
    if constexpr (asks_for_current<Cost>)
      current_ = CurrentMemories<Cost>(policies_.cost, positions_, complex_, scratch_.marks);
  }

  double greatest_bound() const {
    float greatest = 0;
    for (Index face = 0; face < complex_.face_capacity(); ++face)
      if (!complex_.is_dead(face))
        greatest = std::max(greatest, distances_[face]);
    return greatest;
  }

  // Which end is kept, and which is gone.
  std::pair<Index, Index> choose(Index a, Index b, const Candidate& candidate) const {
    const bool b_stays =
        !is_fixed(a) && (is_fixed(b) || (candidate.target == candidate.pair.second &&
                                         candidate.target != candidate.pair.first));
    return b_stays ? std::pair(b, a) : std::pair(a, b);
  }

  void kill_shared(Scratch& scratch) {
    for (const StarFace& f : scratch.star.shared)
      complex_.kill(f.face);
    scratch.tally.faces += scratch.star.shared.size();
    scratch.tally.non_edge_contractions += scratch.star.shared.empty();
  }

  // All of a contraction but the faces.
  void move(Scratch& scratch, Index kept, Index gone, const Candidate& candidate) {
    if constexpr (asks_for_distance)
      bound_faces(scratch);
    pairs_.merge(kept, gone);
    merged_into_[gone] = kept;
    is_moved_[kept] |= candidate.target != positions_[kept];
    positions_[kept] = candidate.target;
    memories_[kept] = candidate.pair.memory;
    move_origin(memories_[kept], candidate.target - candidate.pair.first);
    if (is_topology_kept_)
      link_condition_.merge(kept, gone);
    else
      drop_doubled_faces(scratch);
    update_reach(scratch.star, kept);
    ++scratch.tally.contractions;
    ++scratch.tally.vertices;
    scratch.tally.error = std::max(scratch.tally.error, candidate.error);
  }

  void bound_faces(const Scratch& scratch) {
    auto bound = scratch.bounds.begin();
    for (const auto* faces : {&scratch.star.first, &scratch.star.second})
      for (const StarFace& f : *faces)
        distances_.set(f.face, *bound++);
  }

  // Of the faces that a contraction has changed, those that are doubled now.
  void drop_doubled_faces(Scratch& scratch) {
    scratch.faces = scratch.star.first;
    scratch.faces.insert(scratch.faces.end(), scratch.star.second.begin(),
                         scratch.star.second.end());
    drop_doubled_of(scratch);
  }

  void drop_doubled_faces_at(Index v) {
    scratch_.faces.clear();
    complex_.for_each_corner(v, [&](Index face, Index i) {
      scratch_.faces.push_back(PairStar::star_face(complex_, face, i));
    });
    drop_doubled_of(scratch_);
    scratch_.tally = {};
  }

  // Of faces at one vertex with the same two others, the first is left.
  void drop_doubled_of(Scratch& scratch) {
    std::vector<StarFace>& faces = scratch.faces;
    for (StarFace& f : faces)
      if (f.third < f.second)
        std::swap(f.second, f.third);
    std::sort(faces.begin(), faces.end(), [](const StarFace& a, const StarFace& b) {
      return std::tie(a.second, a.third, a.face) < std::tie(b.second, b.third, b.face);
    });
    for (std::size_t i = 1; i < faces.size(); ++i)
      if (faces[i - 1].second == faces[i].second && faces[i - 1].third == faces[i].third) {
        complex_.kill(faces[i].face);
        ++scratch.tally.faces;
      }
  }

  // A vertex whose last face is gone is gone too.
  void drop_bare(Scratch& scratch, Index kept) {
    for (const StarFace& f : scratch.star.shared)
      for (Index v : {f.second, f.third})
        drop_if_bare(scratch, v);
    drop_if_bare(scratch, kept);
  }

  void drop_if_bare(Scratch& scratch, Index v) {
    if (!complex_.has_faces(v))
      return;
    complex_.for_each_corner(v, [](Index, Index) {});
    scratch.tally.vertices += !complex_.has_faces(v);
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
  void update_reach(const PairStar& star, Index kept) {
    squared_reach_[kept] = 0;
    for (const auto* faces : {&star.first, &star.second})
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
  Scratch scratch_;
  PairLists pairs_; // those of the policy that are not edges
  bool is_topology_kept_;
  LinkCondition link_condition_;
  std::vector<Position> positions_;
  std::vector<bool> is_fixed_; // empty if none is
  std::vector<Memory> memories_;
  [[no_unique_address]] typename CurrentMemoriesOf<Cost>::type current_;
  DistanceBounds distances_{0}; // of no face where nobody asks
  std::vector<float> squared_reach_;
  std::vector<unsigned char> is_moved_;       // no bits: threads write to it
  std::vector<std::array<Index, 2>> creases_; // edges that the user named
  std::vector<Index> merged_into_;            // of each vertex that is gone
  Status status_;
  Tally total_;
  std::size_t initial_components_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PAIR_CONTRACTION_H
