#ifndef QUADRILLE_INTERNAL_CONTRACTION_PAIR_CONTRACTION_H
#define QUADRILLE_INTERNAL_CONTRACTION_PAIR_CONTRACTION_H

#include <quadrille/internal/adapter/attributes.h>
#include <quadrille/internal/base/parallel.h>
#include <quadrille/internal/base/prefetch.h>
#include <quadrille/internal/complex/least_surface.h>
#include <quadrille/internal/complex/link_condition.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/topology_count.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/allowance.h>
#include <quadrille/internal/contraction/leftovers.h>
#include <quadrille/internal/contraction/progress.h>
#include <quadrille/internal/contraction/scratch.h>
#include <quadrille/internal/cost/pair_costs.h>
#include <quadrille/internal/distance/distance_bounds.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>
#include <quadrille/internal/pairs/pair_finder.h>
#include <quadrille/internal/pairs/pair_selection.h>
#include <quadrille/internal/policy/contraction_view.h>
#include <quadrille/internal/policy/mesh_units.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/internal/surface/surface_input.h>
#include <quadrille/order.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>
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
  using Pair = PairOf<Cost>;

  /// A pair with the place of its contraction, the cost of that, the key by which it is ordered,
  /// and the error as a distance in the mesh's units.
  struct Candidate {
    Pair pair;
    Position target;
    double cost, key, error;
  };

  PairContraction(SurfaceInput<dimension> input, const Box<dimension>& box,
                  const Policies& policies)
      : policies_(policies), scale_(scale_of(box, policies.cost)),
        complex_(input.positions.size(), take_triangles(input), merges_at_once, policies.threads),
        scratches_(scratches_for(policies.threads, complex_)),
        pairs_(complex_, link_condition_, costs_,
               select_pairs(policies.pairs, input, complex_, scratch().marks)),
        is_topology_kept_(keeps_topology()),
        is_moved_(input.positions.size(), 0, complex_.workspace()),
        creases_(std::move(input.creases)),
        numbering_({input.positions.size(), std::move(input.vertex_origins)},
                   {complex_.face_capacity(), std::move(input.face_origins)}, !merges_at_once),
        costs_(policies, scale_, complex_, scaled(std::move(input.positions)),
               std::move(input.is_fixed)) {
    if (!is_topology_kept_ || input.has_doubled_faces)
      drop_doubled_faces();
    progress_.start(complex_.live_faces(), complex_.live_vertices(), scale_.diagonal());
    if (!proceed())
      return;
    if (is_topology_kept_)
      link_condition_ = LinkCondition(complex_, scratches_, policies.threads);
    else
      initial_components_ = count_components(complex_);
    if constexpr (asks_for_distance) {
      distances_ = DistanceBounds(complex_.face_capacity(), greatest_coordinate(box));
      announce_distance(0);
    }
    if (!proceed())
      return;
    remember();
    if constexpr (has_visitor())
      expected_contractions_ =
          Allowance(is_topology_kept_).contractions(policies_.stop, progress_.status);
  }
  PairContraction(const PairContraction&) = delete; // members refer to each other
  PairContraction& operator=(const PairContraction&) = delete;

  /// Asks for what contracting the pairs that come next will read, one thing after the other: what
  /// is told of their ends and where their corners are, the corners, the faces, what is told of
  /// their neighbours. peek(n) points to the pair that comes n pairs later, or nowhere; also(w)
  /// asks for what the caller will read of a neighbour.
  template <class Peek, class Also>
  [[gnu::always_inline]] void prefetch(Peek peek, Also also) const {
    if (const auto* last = peek(12))
      for (Index v : {last->first, last->second}) {
        complex_.prefetch(v);
        costs_.prefetch(v);
        if (is_topology_kept_)
          link_condition_.prefetch(v);
        internal::prefetch(&is_moved_[v]);
        numbering_.prefetch(v);
      }
    if (const auto* later = peek(8))
      for (Index v : {later->first, later->second})
        complex_.prefetch_corners(v);
    if (const auto* soon = peek(4))
      for (Index v : {soon->first, soon->second})
        complex_.prefetch_faces(v);
    if (const auto* next = peek(2))
      for (Index v : {next->first, next->second})
        complex_.for_each_next(
            v, [&](Index w) __attribute__((always_inline)) {
              costs_.prefetch(w);
              scratches_.front().marks.prefetch(w);
              also(w);
            });
  }

  /// Where the pair goes and what that costs.
  Candidate evaluate(Index a, Index b) const {
    Candidate candidate{costs_.view(a, b), {}, 0, 0, 0};
    candidate.target = costs_.target(a, b, candidate.pair);
    set_cost(candidate);
    return candidate;
  }

  /// Gathers the star of a pair, for the three functions that follow.
  void gather(Scratch& scratch, Index a, Index b) { scratch.star.gather(complex_, a, b); }

  /// Why this contraction must not be done, if so. Where only filters refuse it, and another place
  /// that costs the same suits them, the candidate goes there.
  std::optional<Rejection> rejection(Scratch& scratch, Index a, Index b,
                                     Candidate& candidate) const {
    if ((is_fixed(a) && is_fixed(b)) || takes_a_fixed_vertex_away(scratch.star, a, b))
      return Rejection::constraint;
    if (!is_finite(candidate.target) || !std::isfinite(candidate.cost))
      return Rejection::position;
    if (is_topology_kept_ && !link_condition_.holds(scratch.star, a, b, scratch.marks))
      return Rejection::topology;
    const std::optional<Rejection> cause = refusal(scratch.star, candidate, candidate.target);
    if (cause && !is_fixed(a) && !is_fixed(b) && finds_equal_place(scratch.star, candidate))
      return std::nullopt;
    return cause;
  }

  /// Would the contraction go beyond the target of the stop policy, where another one might not?
  bool overshoots(Scratch& scratch, Index b) {
    if (is_closed())
      return false; // each contraction takes two faces
    if (is_topology_kept_)
      return is_passed_without({scratch.star.shared.size(), 1});
    return is_passed_without(most_loss(scratch.star)) &&
           is_passed_without(Leftovers(complex_, scratch).loss(b));
  }

  /// Contracts the pair and returns the vertex that is left: an end that keeps its place, else the
  /// first. What has changed is tallied, to be counted.
  Index contract(Scratch& scratch, Index a, Index b, const Candidate& candidate) {
    const auto [kept, gone] = choose(a, b, candidate);
    if constexpr (asks_for_current<Cost>)
      costs_.forget(scratch.star, a, b, [](Index) { return true; });
    complex_.make_room_to_merge(kept, gone);
    kill_shared(scratch);
    complex_.merge(kept, gone);
    move(scratch, kept, gone, candidate);
    if (!is_topology_kept_)
      Leftovers(complex_, scratch).drop_bare_vertices(b);
    if constexpr (asks_for_current<Cost>)
      update_current(scratch, kept);
    return kept;
  }

  /// The same, for any number of pairs that have no end in common; then end_pass() is called.
  /// Pairs whose stars have no vertex in common may be contracted at the same time. Where topology
  /// is free, no end of an earlier pair may be cut off: see any_cut_off(). A cost that looks at the
  /// surface as it is sees the change at the vertices around for which is_seen(v) holds.
  template <class IsSeen>
  void contract_in_pass(Scratch& scratch, Index a, Index b, const Candidate& candidate,
                        [[maybe_unused]] IsSeen is_seen) {
    const auto [kept, gone] = choose(a, b, candidate);
    if constexpr (asks_for_current<Cost>)
      costs_.forget(scratch.star, a, b, is_seen);
    complex_.relabel(kept, gone);
    kill_shared(scratch);
    move(scratch, kept, gone, candidate);
    if constexpr (asks_for_current<Cost>)
      costs_.learn_around(scratch.star, kept, is_seen);
    if (!is_topology_kept_)
      Leftovers(complex_, scratch).drop_bare_vertices(b);
  }

  /// Vertices remember the surface as it is now instead of as it was, if `refresh` is true. If
  /// enough of them are gone, those that are left get new numbers, in the same order.
  void end_pass(bool refresh) {
    if (progress_.status.faces > 0 && pairs_.are_edges() &&
        4 * progress_.status.vertices < 3 * vertex_capacity())
      pack();
    else
      complex_.build_lists(threads());
    if (refresh) {
      for (auto& [v, w] : creases_)
        v = numbering_.image(v), w = numbering_.image(w);
      std::erase_if(creases_, [](const auto& crease) { return crease[0] == crease[1]; });
      remember();
    } else {
      costs_.see(complex_, scratch().marks, interior());
    }
  }

  /// Adds what contractions have changed to the status, and forgets it.
  void count(Tally& tally) { progress_.count(tally); }

  PairFinder<Policies>& pairs() { return pairs_; }

  /// Tells the status of the contraction that comes next.
  void announce(const Candidate& candidate) { progress_.status.next_error = candidate.error; }

  /// Would the contraction take the surface so far from the input that the stop policy stops? At a
  /// distance of 0 it does not. If not, the status tells how far, and the faces will be bound by
  /// it.
  ///
  /// A target that leaves the surface by next to nothing gives way to an end that does not leave it
  /// at all: else such distances add up along straight creases and at corners.
  bool is_too_far(Scratch& scratch, Index a, Index b, Candidate& candidate, Status& status) const {
    const auto stops = [&](const FaceDeviation& deviation) {
      status.next_distance = distance_of_mesh(deviation.from_input);
      return policies_.stop(status);
    };
    const FaceDeviation deviation = measure(scratch, a, b, candidate, status);
    if (!is_next_to_nothing(deviation, scratch) || is_fixed(a) || is_fixed(b))
      return stops(deviation);
    for (Candidate& end : ends(candidate)) {
      if (rejection(scratch, a, b, end))
        continue;
      if (const FaceDeviation of_end = measure(scratch, a, b, end, status);
          is_nothing(of_end) && !stops(of_end)) {
        candidate = end;
        return false;
      }
    }
    return stops(measure(scratch, a, b, candidate, status));
  }
  /// Is it certain, by a look at one of very many faces? Then the star need not be gathered.
  bool is_beyond_hub(Scratch& scratch, Index a, Index b, const Candidate& candidate) const {
    return distances_.is_beyond_hub(complex_, a, b, costs_.positions(), space(candidate.target),
                                    scratch.faces_too_far, stops_beyond(progress_.status));
  }
  /// The same, and tells the status.
  bool is_too_far(Scratch& scratch, Index a, Index b, Candidate& candidate) {
    return is_too_far(scratch, a, b, candidate, progress_.status);
  }
  void announce_distance(double distance) { progress_.status.next_distance = distance; }

  /// Asks the visitor, which may cancel the simplification, and does until now.
  bool proceed() { return is_cancelled_ ? false : !(is_cancelled_ = !ask_visitor(part_done())); }
  /// Tells it that nothing more is to come.
  void tell_end() const { ask_visitor(1); }
  bool is_cancelled() const { return is_cancelled_; }
  static constexpr bool has_visitor() { return Policies::Visitor::is_given; }

  /// Does the stop policy say so?
  bool is_enough() const { return policies_.stop(progress_.status); }
  /// In which way, if it does: have contractions gone beyond its target?
  StopReason reason_of_target() const {
    const bool is_passed =
        status().contractions > 0 && internal::is_passed(policies_.stop, progress_.status);
    return is_passed ? StopReason::target_passed : StopReason::target_met;
  }

  /// Would the contraction spoil the shape of what is around it: is its error more than a tenth of
  /// the distance to the farthest neighbour? An edge of a cube of twelve faces is, a corner of a
  /// sheet of two. Only a cost that tells its error as a distance to the surface can say so.
  bool is_destructive(const Candidate& candidate) const {
    if constexpr (requires { policies_.cost.squared_error(candidate.pair, 0.0); })
      return candidate.error > 0.1 * scale_.length_of_mesh(std::sqrt(candidate.pair.squared_reach));
    else
      return false;
  }

  /// Might contractions satisfy the stop policy? Not if the topology of several parts is kept and
  /// even the smallest ones that have it are too large; one part alone may go as far as it can.
  /// Takes linear time.
  bool is_target_reachable() const {
    if (!is_topology_kept_)
      return true;
    const auto [faces, vertices, parts] =
        least_surface(complex_, link_condition_, [this](Index v) { return is_fixed(v); });
    if (parts == 1)
      return true;
    Status least = progress_.status;
    std::size_t contractions = least.vertices - std::min(least.vertices, vertices);
    least.faces = std::min(least.faces, faces);
    least.vertices = std::min(least.vertices, vertices);
    least.next_error = least.next_distance = std::numeric_limits<double>::infinity();
    for (; !policies_.stop(least); ++least.contractions) // it may look at their number
      if (contractions-- == 0)
        return false;
    return true;
  }

  /// Tells what became of the surface.
  void complete(Report& report) {
    progress_.tell(report);
    if constexpr (asks_for_distance)
      report.distance_bound = scale_.length_of_mesh(distances_.greatest(complex_));
    const TopologyCount count = count_topology(complex_, scratch().marks);
    report.components_after = count.components;
    report.components_before = is_topology_kept_ ? count.components : initial_components_;
    report.non_manifold_edges = count.non_manifold_edges;
    report.non_manifold_vertices = count.non_manifold_vertices;
  }

  /// Gives memory back that only contractions need, and unless `keeps_memories` what vertices
  /// remember, and returns the numbering.
  Numbering release(bool keeps_memories) {
    complex_.release();
    costs_.release(keeps_memories);
    scratches_.clear();
    distances_ = DistanceBounds(0);
    numbering_.use_origins();
    numbering_.vertices.shrink_to_fit();
    return std::move(numbering_);
  }

  const Status& status() const { return progress_.status; }
  const Policies& policies() const { return policies_; }
  TriangleComplex& complex() { return complex_; }
  const TriangleComplex& complex() const { return complex_; }

  /// One for each thread.
  std::vector<Scratch>& scratches() { return scratches_; }
  Scratch& scratch() { return scratches_.front(); }

  std::size_t vertex_capacity() const { return complex_.vertex_capacity(); }
  /// Had the surface no border, nor will it have one?
  bool is_closed() const { return link_condition_.is_closed(); }
  double unevenness(Index v) const { return costs_.unevenness(v); }
  bool is_moved(Index v) const { return is_moved_[v] != 0; }
  bool is_topology_kept() const { return is_topology_kept_; }
  /// Of a vertex, in the units of the mesh and its attributes.
  Position position(Index v) const { return scale_.position_of_mesh(costs_.positions()[v]); }
  /// What a vertex remembers, as vertex_quadric_map tells it.
  auto mean_quadric(Index v) const { return scale_.mean_of_mesh(costs_.memory(v)); }

private:
  static Scale<dimension> scale_of(const Box<dimension>& box, const Cost& cost) {
    Scale<dimension> scale(box, is_scale_free<Cost>);
    if constexpr (requires {
                    cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), 1.0);
                  })
      scale.set_attribute_weights(
          cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), box.diagonal()),
          box);
    return scale;
  }

  static std::vector<Scratch> scratches_for(unsigned threads, const TriangleComplex& complex) {
    std::vector<Scratch> scratches;
    scratches.reserve(threads);
    for (unsigned i = 0; i < threads; ++i)
      scratches.emplace_back(complex.vertex_capacity(), complex.workspace());
    return scratches;
  }

  // Passes merge nothing before few faces are left.
  static constexpr bool merges_at_once = !std::same_as<typename Policies::Order, RelaxedOrder>;

  // A pair policy of the user's wants to see them once more.
  static Array<TriangleComplex::Triangle> take_triangles(SurfaceInput<dimension>& input) {
    if constexpr (std::same_as<typename Policies::Pairs, EdgePairs>)
      return std::move(input.triangles);
    else
      return input.triangles;
  }

  // Unless the user says, free if there are pairs that are not edges.
  bool keeps_topology() const {
    const Topology by_default = pairs_.has_others() ? Topology::free : Topology::kept;
    return policies_.topology.value_or(by_default) == Topology::kept;
  }

  typename Policies::Threads threads() const { return policies_.threads; }

  static constexpr bool asks_for_distance = internal::asks_for_distance<typename Policies::Stop>;

  bool ask_visitor([[maybe_unused]] double progress) const {
    if constexpr (has_visitor()) {
      Status now = progress_.status;
      now.progress = progress;
      return policies_.visitor.proceed(now);
    } else {
      return true;
    }
  }

  // Less than all: something may always come.
  double part_done() const {
    const auto done = static_cast<double>(progress_.status.contractions);
    const auto all = static_cast<double>(std::max<std::size_t>(expected_contractions_, 1));
    return std::min(done / all, most_part_done);
  }
  static constexpr double most_part_done = 0.999;

  Array<Position> scaled(Array<Position> positions) const {
    scale_.apply(positions);
    return positions;
  }

  bool is_fixed(Index v) const { return costs_.is_fixed(v); }

  // Inside the surface the faces of the star are exchanged one by one. Constraint planes of
  // boundary edges lean on faces, so vertices that may have any are summed up anew.
  void update_current(Scratch& scratch, Index kept) requires asks_for_current<Cost> {
    costs_.learn(kept, complex_);
    const auto renew = [&](Index v) {
      if (!link_condition_.is_interior(v))
        costs_.recompute(v, complex_, scratch.marks);
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

  [[gnu::always_inline]] void set_cost(Candidate& candidate) const {
    candidate.cost = costs_(candidate.pair, candidate.target);
    candidate.key = costs_.key(candidate.pair, candidate.target, candidate.cost);
    const double squared = squared_error(policies_.cost, candidate.pair, candidate.cost);
    candidate.error = scale_.length_of_mesh(std::sqrt(std::max(0.0, squared)));
  }

  // Contractions of the same pair to its ends, the cheaper one first.
  std::array<Candidate, 2> ends(const Candidate& candidate) const {
    std::array<Candidate, 2> ends{candidate, candidate};
    ends[0].target = candidate.pair.first;
    ends[1].target = candidate.pair.second;
    for (Candidate& end : ends)
      set_cost(end);
    if (ends[1].key < ends[0].key)
      std::swap(ends[0], ends[1]);
    return ends;
  }

  // In the engine's unit.
  FaceDeviation measure(Scratch& scratch, Index a, Index b, const Candidate& candidate,
                        const Status& status) const {
    const bool may_have_border = !link_condition_.is_interior(a) || !link_condition_.is_interior(b);
    return distances_.after(scratch.star, a, b, costs_.positions(), space(candidate.target),
                            may_have_border, scratch.deviation, scratch.bounds,
                            stops_beyond(status));
  }

  // Does the stop policy stop if nothing but the distance changes?
  auto stops_beyond(const Status& status) const {
    return [this, after = status](double distance) mutable {
      after.next_distance = distance_of_mesh(distance);
      return policies_.stop(after);
    };
  }

  // What may be nothing but rounding is 0.
  double distance_of_mesh(double distance) const {
    return distance <= distances_.rounding() ? 0 : scale_.length_of_mesh(distance);
  }

  // Many of them do not add up to more than rounding.
  bool is_nothing(const FaceDeviation& deviation) const {
    return deviation.from_star <= distances_.rounding() / 64;
  }
  bool is_next_to_nothing(const FaceDeviation& deviation, const Scratch& scratch) const {
    return !is_nothing(deviation) &&
           deviation.from_star <= next_to_nothing * scratch.deviation.extent();
  }
  static constexpr double next_to_nothing = 0x1p-20;

  // The greatest of a surface in a box, in the engine's unit.
  double greatest_coordinate(const Box<dimension>& box) const {
    double greatest = 0;
    for (const Position& p : scaled({box.low, box.high}))
      for (std::size_t i = 0; i < 3; ++i)
        greatest = std::max(greatest, std::abs(p[i]));
    return greatest;
  }

  auto interior() const {
    return [this](Index v) { return link_condition_.is_interior(v); };
  }

  // Does the surface lie beyond the target of the stop policy, once it has lost that?
  bool is_passed_without(const Loss& loss) const {
    Status after = progress_.status;
    after.faces -= std::min(after.faces, loss.faces);
    after.vertices -= std::min(after.vertices, loss.vertices);
    return internal::is_passed(policies_.stop, after);
  }

  bool takes_a_fixed_vertex_away(const PairStar& star, Index a, Index b) const {
    return costs_.is_any_fixed() && !is_topology_kept_ &&
           internal::takes_a_fixed_vertex_away(star, a, b, [this](Index v) { return is_fixed(v); });
  }

  // Why a filter refuses a target, if one does.
  std::optional<Rejection> refusal(const PairStar& star, const Candidate& candidate,
                                   const Position& target) const {
    const ContractionView<dimension> contraction(
        star, complex_, costs_.positions(), candidate.pair.first, candidate.pair.second, target);
    const ContractionInMeshUnits<dimension> in_mesh_units(contraction, scale_);
    std::optional<Rejection> cause;
    const auto looks_and_refuses = [&](const auto& filter) {
      if constexpr (is_scale_free<std::remove_cvref_t<decltype(filter)>>)
        return refuses(filter, contraction, cause);
      else
        return refuses(filter, in_mesh_units, cause);
    };
    std::apply([&](const auto&... filter) { (looks_and_refuses(filter) || ...); },
               policies_.filters);
    return cause;
  }

  [[gnu::noinline]] bool finds_equal_place(const PairStar& star, // seldom
                                           Candidate& candidate) const {
    const auto takes = [&](const Position& x) {
      if (refusal(star, candidate, x))
        return false;
      candidate.target = x;
      return true;
    };
    const auto& placement = policies_.placement; // a derived one may want none of these places
    if constexpr (is_scale_free<typename Policies::Placement> && requires {
                    placement.any_equal(policies_.cost, candidate.pair, Position{}, takes);
                  })
      return placement.any_equal(policies_.cost, candidate.pair, Position(candidate.target), takes);
    else
      return false;
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

  void remember() {
    std::vector<std::array<Index, 2>> creases;
    if (!creases_.empty()) {
      const Origins numbers = numbering_.vertices.inverse();
      for (const auto& [v, w] : creases_)
        if (const Index p = numbers[v], q = numbers[w]; p != none && q != none)
          creases.push_back({p, q}); // else it has lost its faces
    }
    costs_.remember(complex_, scratch().marks, creases, interior(), threads());
  }

  // What is gone takes no more time or room in a cache.
  void pack() {
    Array<Index> vertices = complex_.left_vertices();
    const auto is_left = [this](Index face) { return !complex_.is_dead(face); };
    numbering_.faces.pack_if(is_left);
    distances_.pack_if(is_left);
    parallel_for(threads(), 2, [&](std::size_t part, std::size_t) {
      if (part == 0) {
        complex_.pack(vertices);
        return;
      }
      costs_.pack(vertices);
      link_condition_.pack(vertices);
      internal::pack(is_moved_, vertices);
    });
    complex_.fill_lists(threads());
    numbering_.vertices.pack(std::move(vertices));
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
      distances_.set(scratch.star, scratch.bounds);
    pairs_.merge(kept, gone);
    numbering_.merge(kept, gone);
    is_moved_[kept] |= candidate.target != costs_.positions()[kept];
    costs_.move(scratch.star, kept, candidate.target, candidate.pair);
    if (is_topology_kept_)
      link_condition_.merge(kept, gone);
    else
      Leftovers(complex_, scratch).drop_doubled_faces();
    ++scratch.tally.contractions;
    ++scratch.tally.vertices;
    scratch.tally.error = std::max(scratch.tally.error, candidate.error);
  }

  void drop_doubled_faces() {
    for (Index v = 0; v < vertex_capacity(); ++v)
      Leftovers(complex_, scratch()).drop_doubled_faces(v);
    scratch().tally = {};
  }

  const Policies& policies_;
  Scale<dimension> scale_;
  TriangleComplex complex_;
  std::vector<Scratch> scratches_;
  PairFinder<Policies> pairs_;
  bool is_topology_kept_;
  LinkCondition link_condition_;
  DistanceBounds distances_{0};               // of no face where nobody asks
  Array<unsigned char> is_moved_;             // no bits: threads write to it
  std::vector<std::array<Index, 2>> creases_; // edges that the user named, by origins
  Numbering numbering_;
  PairCosts<Policies> costs_;
  Progress progress_;
  std::size_t initial_components_ = 0;
  std::size_t expected_contractions_ = 0; // if there is a visitor
  bool is_cancelled_ = false;             // by it
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_PAIR_CONTRACTION_H
