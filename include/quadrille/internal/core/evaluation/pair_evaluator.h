#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_EVALUATOR_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_EVALUATOR_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/power_of_two.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/cost/no_local_terms.h>
#include <quadrille/internal/core/evaluation/cost_units.h>
#include <quadrille/internal/core/evaluation/pair_names.h>
#include <quadrille/internal/core/evaluation/two_lanes.h>
#include <quadrille/internal/core/memory/append_buffer.h>
#include <quadrille/internal/core/memory/vertex_arrays.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/policy/star_view.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace quadrille::internal {

/// Evaluates the cost of contracting a pair of vertices, and the position of the new vertex.
template <class Policies>
class PairEvaluator {
public:
  using Cost = typename Policies::Cost;
  using Placement = typename Policies::Placement;
  using Position = Vector<Cost::dimension>;
  using Candidate = internal::Candidate<Cost>;
  using Pair = PairOf<Cost>;
  using Geometry = internal::Geometry<Cost::dimension>;
  using State = SurfaceState<Policies>;
  using Terms = typename LocalTermsOf<Cost>::type;
  static constexpr bool counts_channels = Policies::has_channels;

  explicit PairEvaluator(State& state)
      : state_(state),
        terms_(policies().cost, state.geometry, state.complex, state.link_condition, state.shared),
        names_(state.numbering), cost_of_key_(cost_of_key(policies().cost, state.scale)) {}

  const State& state() const { return state_; }
  const Cost& cost() const { return policies().cost; }
  const Terms& terms() const { return terms_; }
  const PairNames<Policies>& names() const { return names_; }

  /// Sums up local terms again; the second function does so for one vertex that is or was a
  /// high-valence vertex.
  void sum_up(VertexLabels& labels) { terms_.sum_up(labels); }
  void sum_up(Index high_valence, VertexLabels& labels) { terms_.sum_up(high_valence, labels); }
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    if constexpr (has_local_terms<Cost>)
      terms_.before(event);
  }
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) {
    if constexpr (has_local_terms<Cost>)
      terms_.after(event);
  }
  static constexpr bool is_recomputed = true; // see sum_up()
  static auto vertex_arrays(auto& self) { return Terms::vertex_arrays(self.terms_); }

  /// Asks for what costs of pairs read of a vertex.
  QUADRILLE_ALWAYS_INLINE void prefetch_pair(Index v) const {
    geometry().prefetch(v);
    prefetch_vertex_arrays(state_.states, v);
    prefetch_vertex_arrays(terms_, v);
    if constexpr (counts_channels)
      state_.channels().prefetch(v);
  }

  /// Returns the position of the pair and its cost, before resolve(); `first` is below `second`.
  Candidate evaluate(Index first, Index second) const {
    Candidate candidate{first, second, view(first, second)};
    if constexpr (!looks_at_star<Placement>) {
      candidate.target = target(first, second, candidate.pair);
      set_cost(candidate);
    }
    return candidate;
  }

  /// Applies a placement that looks at the star of the pair. Returns false if it has no position.
  bool resolve(Candidate& candidate, const PairStar& star) const {
    if constexpr (looks_at_star<Placement>) {
      static_assert(is_scale_free<Placement>,
                    "A placement that uses the star has to be scale-free: see CostPolicy and "
                    "PlacementPolicy in <quadrille/concepts.h>.");
      const Index a = candidate.first, b = candidate.second;
      if (is_resolved(a, b)) {
        candidate.target = target(a, b, candidate.pair);
      } else {
        const auto x = policies().placement.resolve(
            policies().cost, names_.for_placement(candidate.pair, a, b), star_view(a, b, star));
        if (!x)
          return false;
        candidate.target = *x;
      }
      set_cost(candidate);
    }
    return true;
  }

  /// Returns the view that such a placement has of the star.
  auto star_view(Index first, Index second, const PairStar& star) const {
    return StarView<Cost::dimension>(star, first, second, geometry().positions().data(),
                                     state_.scale);
  }

  /// Sets the cost of the candidate's target, which may have changed.
  QUADRILLE_ALWAYS_INLINE void set_cost(Candidate& candidate) const {
    candidate.cost = policies().cost(candidate.pair, candidate.target);
    candidate.key = key(candidate.pair, candidate.target, candidate.cost);
    if (!state_.outlines.empty()) [[unlikely]]
      candidate.key += outline_cost(candidate.first, candidate.second, candidate.target);
    double squared = squared_error(policies().cost, candidate.pair, candidate.cost);
    if constexpr (counts_channels)
      squared *= state_.channels().error_factor(candidate.pair, candidate.first, candidate.second);
    candidate.error = state_.scale.length_of_mesh(std::sqrt((std::max)(0.0, squared)));
    if (state_.importance.is_any_given()) [[unlikely]]
      weigh(candidate);
  }

  /// Contractions of the same pair to its ends, the cheaper one first.
  std::array<Candidate, 2> at_ends(const Candidate& candidate) const {
    std::array<Candidate, 2> ends{candidate, candidate};
    ends[0].target = candidate.pair.first;
    ends[1].target = candidate.pair.second;
    for (Candidate& end : ends)
      set_cost(end);
    if (ends[1].key < ends[0].key)
      std::swap(ends[0], ends[1]);
    return ends;
  }

  /// The keys of many pairs, in their order; a negative or NaN key becomes 0. `labels` may be
  /// written to.
  void evaluate_all(const AppendBuffer<VertexPair>& pairs, AppendBuffer<float>& keys,
                    VertexLabels& labels) const {
    keys.clear();
    float* const values = keys.extend(pairs.size() + 1); // two at a time
    keys.add(pairs.size());
    evaluate_alike(pairs, values, labels);
    if (state_.importance.is_any_given()) [[unlikely]]
      weigh(pairs, values);
  }

  /// Leaves out pairs that are seen to cost more than a limit without all of their terms; the keys
  /// of the others are not known by that.
  void drop_above([[maybe_unused]] float limit,
                  [[maybe_unused]] AppendBuffer<VertexPair>& pairs) const {
    if constexpr (has_two_lanes<Cost, typename EstimateOf<Placement>::type>)
      if constexpr (TwoLanes<PairEvaluator>::has_bounds)
        if (limit < std::numeric_limits<float>::infinity() && is_optimal(policies().placement) &&
            !state_.importance.is_any_given() && state_.channels().are_costly())
          TwoLanes(*this).drop_above(limit, pairs);
  }

  /// The key of a pair, as a float.
  float key_of(const VertexPair& p) const {
    const float key = key_alike(p);
    return state_.importance.is_any_given() ? key * state_.importance.of_pair(p.first, p.second)
                                            : key;
  }
  /// Returns the key of a pair if all vertices are of the same importance.
  float key_alike(const VertexPair& p) const {
    const auto [a, b] = std::minmax(p.first, p.second);
    const Pair pair = view(a, b);
    const Position x = target(a, b, pair);
    double cost = key(pair, x, policies().cost(pair, x));
    if (!state_.outlines.empty()) [[unlikely]]
      cost += outline_cost(a, b, x);
    return as_key(cost);
  }
  static float as_key(double cost) {
    if constexpr (rise_of_estimate<Placement> != 1)
      cost *= rise_of_estimate<Placement>;
    return (std::max)(0.0f, static_cast<float>(cost));
  }

  /// Returns the key by which a cost is compared. A cost in the mesh's units may be a length, its
  /// square or its fourth power, so it is scaled to a range that floats can represent in each of
  /// these cases.
  double key_of_cost(double cost) const {
    if constexpr (is_scale_free<Cost>)
      return cost;
    else
      return (std::min)(PowerOfTwo(2 * state_.scale.exponent())(cost),
                        static_cast<double>((std::numeric_limits<float>::max)()));
  }

  /// A key as a cost in the mesh's units, for stop policies that ask for it.
  double cost_of_mesh(double key) const { return key * cost_of_key_; }

private:
  QUADRILLE_NOINLINE void weigh(Candidate& candidate) const {
    const double factor =
        static_cast<double>(state_.importance.of_pair(candidate.first, candidate.second));
    candidate.cost *= factor;
    candidate.key *= factor;
  }
  QUADRILLE_NOINLINE void weigh(const AppendBuffer<VertexPair>& pairs, float* keys) const {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      keys[i] *= state_.importance.of_pair(pairs[i].first, pairs[i].second);
  }

  // Evaluates pairs without regard to their importance.
  QUADRILLE_ALWAYS_INLINE void evaluate_alike(const AppendBuffer<VertexPair>& pairs, float* values,
                                              VertexLabels& labels) const {
    if constexpr (has_two_lanes<Cost, typename EstimateOf<Placement>::type>)
      if (is_optimal(policies().placement) && state_.planes.empty()) {
        TwoLanes(*this).evaluate_all(pairs, values, labels);
        if (high_valence_vertices().any())
          evaluate_at_high_valence(pairs, values);
        return;
      }
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = key_alike(pairs[i]);
  }

  // Is it known where the pair goes, whatever it costs there? To what is fixed, or to a
  // high-valence vertex.
  bool is_resolved(Index a, Index b) const {
    return geometry().is_fixed(a) || geometry().is_fixed(b) ||
           high_valence_vertices().of_pair(a, b) != none;
  }

  QUADRILLE_NOINLINE void evaluate_at_high_valence(const AppendBuffer<VertexPair>& pairs,
                                                   float* keys) const {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (high_valence_vertices().of_pair(pairs[i].first, pairs[i].second) != none)
        keys[i] = key_alike(pairs[i]);
  }

  // The pair as cost and placement see it.
  Pair view(Index a, Index b) const {
    const Position &p = geometry().position(a), &q = geometry().position(b);
    Pair pair{names_.of_cost(a, b), p, q,
              sum_about_first(state_.states[a], state_.states[b], q - p),
              static_cast<double>((std::max)(geometry().squared_ring_radius(a),
                                             geometry().squared_ring_radius(b)))};
    if constexpr (has_local_terms<Cost>)
      pair.current =
          policies().cost.join(terms_[a], terms_[b], terms_.shared(a, b), pair.second - pair.first);
    if constexpr (counts_channels)
      state_.channels().add_to(pair, a, b);
    return pair;
  }

  Position target(Index a, Index b, const Pair& pair) const {
    if (geometry().is_fixed(a) || geometry().is_fixed(b))
      return geometry().is_fixed(a) ? pair.first : pair.second;
    if (const Index high_valence = high_valence_vertices().of_pair(a, b); high_valence != none)
      return high_valence == a ? pair.first : pair.second;
    if (!state_.planes.empty()) [[unlikely]]
      return target_in_planes(pair, a, b);
    return placed(pair, a, b);
  }

  QUADRILLE_ALWAYS_INLINE Position placed(const Pair& pair, Index a, Index b) const {
    if constexpr (is_scale_free<Placement>)
      return policies().placement(policies().cost, names_.for_placement(pair, a, b));
    else
      return target_in_mesh_units(pair, a, b);
  }

  QUADRILLE_NOINLINE Position target_in_planes(const Pair& pair, Index a, Index b) const {
    Position x = placed(pair, a, b);
    state_.planes.move(x, a, b, pair.first, pair.second);
    const bool is_on_outlines = state_.outlines.empty() || !(outline_cost(a, b, x) > 0);
    return is_on_outlines ? x : next_to_outlines(x, pair, a, b);
  }

  // Returns the cheapest of a target in its planes and of targets nearer to the outlines, with
  // their cost. An end stays an end.
  Position next_to_outlines(const Position& x, const Pair& pair, Index a, Index b) const {
    const auto cost = [&](const Position& p) {
      return policies().cost(pair, p) + tie_break(policies().cost, pair, p) + outline_cost(a, b, p);
    };
    Position best = x;
    double least = cost(x);
    const auto look_at = [&](const Position& p) {
      if (!state_.planes.admit(a, b, p, state_.scale))
        return HUGE_VAL;
      const double value = cost(p);
      if (value < least)
        best = p, least = value;
      return value;
    };
    if (x == pair.first || x == pair.second) {
      look_at(x == pair.first ? pair.second : pair.first);
      return best;
    }
    const std::optional<Vector<3>> nearest = state_.outlines.nearest(a, b, space(x));
    if (!nearest)
      return best;
    const auto between = [&](double t) {
      Position p = x;
      for (std::size_t i = 0; i < 3; ++i)
        p[i] += t * ((*nearest)[i] - x[i]);
      state_.planes.move(p, a, b, pair.first, pair.second);
      return p;
    };
    const double here = least, there = look_at(between(1)), middle = look_at(between(0.5));
    const double bend = here - 2 * middle + there; // of the parabola through these
    if (bend > 0 && bend < HUGE_VAL)
      look_at(between(std::clamp((3 * here - 4 * middle + there) / (4 * bend), 0.0, 1.0)));
    return best;
  }

  // The cost of leaving the outlines of plane regions, if the degree of the cost is known.
  QUADRILLE_NOINLINE double outline_cost([[maybe_unused]] Index a, [[maybe_unused]] Index b,
                                         [[maybe_unused]] const Position& x) const {
    if constexpr (is_scale_free<Cost> && CountsDegree<Cost>)
      return state_.outlines.cost(a, b, space(x), static_cast<double>(policies().cost.degree()));
    else
      return 0;
  }

  QUADRILLE_NOINLINE Position target_in_mesh_units(const Pair& pair, Index a, Index b) const {
    const CostInMeshUnits<Cost> cost(policies().cost, state_.scale);
    const PairInMeshUnits<Cost> seen(pair, state_.scale);
    return seen.position_from_mesh(policies().placement(cost, names_.for_placement(seen, a, b)),
                                   state_.scale);
  }

  double key(const Pair& pair, const Position& target, double cost) const {
    return key_of_cost(cost + tie_break(policies().cost, pair, target));
  }

  const Policies& policies() const { return state_.policies; }
  const Geometry& geometry() const { return state_.geometry; }
  const HighValenceVertices& high_valence_vertices() const {
    return state_.complex.high_valence_vertices();
  }

  const State& state_;
  QUADRILLE_NO_UNIQUE_ADDRESS Terms terms_;
  QUADRILLE_NO_UNIQUE_ADDRESS PairNames<Policies> names_;
  double cost_of_key_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_PAIR_EVALUATOR_H
