#ifndef QUADRILLE_INTERNAL_COST_PAIR_COSTS_H
#define QUADRILLE_INTERNAL_COST_PAIR_COSTS_H

#include <quadrille/internal/base/power_of_two.h>
#include <quadrille/internal/base/prefetch.h>
#include <quadrille/internal/base/ranges.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/complex/vertex_labels.h>
#include <quadrille/internal/contraction/scratch.h>
#include <quadrille/internal/cost/initial_memories.h>
#include <quadrille/internal/cost/local_terms.h>
#include <quadrille/internal/cost/two_quadrics.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>
#include <quadrille/internal/policy/mesh_units.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/internal/surface/surface_input.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/thin_feature_quadric.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Where the vertices of a surface lie, what they remember and how far their neighbours are: all
/// that costs look at; and what contracting a pair of them costs.
template <class Policies>
class PairCosts {
public:
  using Cost = typename Policies::Cost;
  using Position = Vector<Cost::dimension>;
  using Memory = typename Cost::Memory;
  using Pair = PairOf<Cost>;

  static constexpr std::size_t bytes_a_vertex =
      sizeof(Position) + sizeof(Memory) + CurrentMemoriesOf<Cost>::bytes_a_vertex + sizeof(float);

  PairCosts(const Policies& policies, const Scale<Cost::dimension>& scale,
            const TriangleComplex& complex, Array<Position> positions, std::vector<bool> is_fixed)
      : policies_(policies), scale_(scale), complex_(complex), positions_(std::move(positions)),
        is_fixed_(std::move(is_fixed)), memories_(complex.workspace()),
        squared_reach_(positions_.size(), 0, complex.workspace()) {
    for_each_range(policies.threads, positions_.size(),
                   [this](const auto& range, std::size_t) { this->measure_reach(range); });
  }

  const Array<Position>& positions() const { return positions_; }
  const Memory& memory(Index v) const { return memories_[v]; }
  bool is_fixed(Index v) const { return !is_fixed_.empty() && is_fixed_[v]; }
  bool is_any_fixed() const { return !is_fixed_.empty(); }

  /// Vertices remember the surface as it is now.
  template <class IsInterior>
  void remember(TriangleComplex& complex, Marks& marks,
                const std::vector<std::array<Index, 2>>& creases, IsInterior is_interior,
                typename Policies::Threads threads) {
    InitialMemories<Cost>::compute(memories_, policies_.cost, positions_, complex, marks, creases,
                                   is_interior, threads);
    see(complex, marks, is_interior);
  }
  /// A cost that looks at the surface as it is now sees all of it anew.
  template <class IsInterior>
  void see(TriangleComplex& complex, Marks& marks, IsInterior is_interior) {
    if constexpr (asks_for_current<Cost>)
      current_ = CurrentMemories<Cost>(policies_.cost, positions_, complex, marks, is_interior);
  }
  /// Of the faces around a vertex as they are now; 0 if the cost does not tell.
  double unevenness(Index v) const {
    if constexpr (tells_unevenness<Cost>)
      return policies_.cost.unevenness(current_[v]);
    else
      return 0;
  }
  /// The same around a contraction: before, and after, or after one in a pass; at the vertices for
  /// which is_wanted(v) holds.
  template <class IsWanted>
  void forget(const PairStar& star, Index a, Index b,
              IsWanted is_wanted) requires asks_for_current<Cost> {
    current_.forget(star, a, b, policies_.cost, positions_, is_wanted);
  }
  void learn(Index kept, TriangleComplex& complex) requires asks_for_current<Cost> {
    current_.learn(kept, policies_.cost, positions_, complex);
  }
  template <class IsWanted>
  void learn_around(const PairStar& star, Index kept,
                    IsWanted is_wanted) requires asks_for_current<Cost> {
    current_.learn_around(star, kept, policies_.cost, positions_, complex_, is_wanted);
  }
  void recompute(Index v, TriangleComplex& complex, Marks& marks) requires asks_for_current<Cost> {
    current_.recompute(v, policies_.cost, positions_, complex, marks);
  }

  [[gnu::always_inline]] void prefetch(Index v) const {
    internal::prefetch(&positions_[v]);
    internal::prefetch(&memories_[v]);
    internal::prefetch(&squared_reach_[v]);
    if constexpr (asks_for_current<Cost>)
      internal::prefetch(&current_[v]);
  }

  /// The pair as cost and placement see it.
  Pair view(Index a, Index b) const {
    Pair pair{positions_[a], positions_[b],
              sum_about_first(memories_[a], memories_[b], positions_[b] - positions_[a]),
              std::max(squared_reach_[a], squared_reach_[b])};
    if constexpr (asks_for_current<Cost>)
      pair.current = policies_.cost.join(
          current_[a], current_[b], current_.shared(a, b, policies_.cost, positions_, complex_),
          pair.second - pair.first);
    return pair;
  }

  /// Where the pair goes.
  Position target(Index a, Index b, const Pair& pair) const {
    if (is_fixed(a) || is_fixed(b))
      return is_fixed(a) ? pair.first : pair.second;
    if constexpr (is_scale_free<typename Policies::Placement>)
      return policies_.placement(policies_.cost, pair);
    else
      return target_in_mesh_units(pair);
  }

  double operator()(const Pair& pair, const Position& target) const {
    return policies_.cost(pair, target);
  }

  /// What a cost at a position is compared by, as a float. One in the mesh's units, of which nobody
  /// knows whether it is a length, its square or its fourth power, is taken to where floats hold it
  /// in each of these cases.
  double key(const Pair& pair, const Position& target, double cost) const {
    const double key = cost + tie_break(policies_.cost, pair, target);
    if constexpr (is_scale_free<Cost>)
      return key;
    else
      return std::min(PowerOfTwo(2 * scale_.exponent())(key),
                      double{std::numeric_limits<float>::max()});
  }

  /// What the pairs in the scratch cost, in its `costs`; 0 for what is below, or no number.
  void evaluate_all(Scratch& scratch) const {
    const Room<VertexPair>& pairs = scratch.pairs;
    scratch.costs.clear();
    float* const costs = scratch.costs.extend(pairs.size() + 1); // two at a time
    scratch.costs.add(pairs.size());
    if constexpr (has_fast_costs)
      if (!is_any_fixed()) {
        evaluate_in_twos(pairs, costs, scratch.marks);
        return;
      }
    for (std::size_t i = 0; i < pairs.size(); ++i)
      costs[i] = cost_of(pairs[i]);
  }

  /// A vertex that a contraction has left takes its place.
  void move(const PairStar& star, Index kept, const Position& target, const Pair& pair) {
    positions_[kept] = target;
    memories_[kept] = pair.memory;
    move_origin(memories_[kept], target - pair.first);
    update_reach(star, kept);
  }

  /// Leaves out all vertices but some, and sees nothing until it is told to.
  void pack(const Array<Index>& vertices) {
    internal::pack(positions_, vertices);
    internal::pack(memories_, vertices);
    internal::pack(is_fixed_, vertices);
    internal::pack(squared_reach_, vertices);
  }

  /// Gives memory back that only costs need, and unless `keeps_memories` what vertices remember.
  void release(bool keeps_memories) {
    current_ = {};
    squared_reach_ = Array<float>();
    positions_.shrink_to_fit();
    if (!keeps_memories)
      memories_ = UninitializedArray<Memory>();
  }

private:
  static constexpr bool has_fast_costs =
      std::same_as<typename Policies::Placement, OptimalPlacement> &&
      (std::same_as<Cost, Quadric> || std::same_as<Cost, MemorylessQuadric> ||
       std::same_as<Cost, ThinFeatureQuadric>);

  static float as_key(double cost) { return std::max(0.0f, static_cast<float>(cost)); }

  [[gnu::noinline]] Position target_in_mesh_units(const Pair& pair) const {
    const CostInMeshUnits<Cost> cost(policies_.cost, scale_);
    const PairInMeshUnits<Cost> seen(pair, scale_);
    return seen.position_from_mesh(policies_.placement(cost, seen), scale_);
  }

  float cost_of(const VertexPair& p) const {
    const auto [a, b] = std::minmax(p.first, p.second);
    const Pair pair = view(a, b);
    const Position x = target(a, b, pair);
    return as_key(key(pair, x, policies_.cost(pair, x)));
  }

  using Two = std::array<VertexPair, 2>;

  // The last one alone twice, if need be.
  void evaluate_in_twos(const Room<VertexPair>& pairs, float* costs, Marks&) const {
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
      const Two two = {pairs[i], pairs[std::min(i + 1, pairs.size() - 1)]};
      const auto& [p, q] = two;
      const Lanes values = least_values({&memories_[p.first], &memories_[q.first]},
                                        {&memories_[p.second], &memories_[q.second]}, ways(two),
                                        squared_reaches(two));
      write(two, values, costs + i);
    }
  }

  // One vertex after the other, since its pairs share what its faces say.
  void evaluate_in_twos(const Room<VertexPair>& pairs, float* costs,
                        Marks& marks) const requires asks_for_current<Cost> {
    const Cost& cost = policies_.cost;
    for (std::size_t i = 0, end = 0; i < pairs.size(); i = end) {
      const Index v = pairs[i].first;
      while (end < pairs.size() && pairs[end].first == v)
        ++end;
      if (current_.learned().vertex() == v)
        evaluate_around(current_.learned(), pairs, i, end, costs);
      else if (complex_.degree_bound(v) <= CurrentStar<Cost>::most_faces)
        evaluate_around(CurrentStar<Cost>(v, cost, positions_, complex_), pairs, i, end, costs);
      else
        evaluate_around(CurrentHub<Cost>(v, cost, positions_, complex_, marks), pairs, i, end,
                        costs);
    }
  }
  template <class Star>
  void evaluate_around(const Star& star, const Room<VertexPair>& pairs, std::size_t i,
                       std::size_t end, float* costs) const {
    for (; i < end; i += 2) {
      const Two two = {pairs[i], pairs[std::min(i + 1, end - 1)]};
      const auto& [p, q] = two;
      auto [values, positions] =
          minima(current_[p.first], {&current_[p.second], &current_[q.second]},
                 {star.shared_with(p.second, policies_.cost, positions_),
                  star.shared_with(q.second, policies_.cost, positions_)},
                 ways(two), squared_reaches(two));
      if constexpr (std::same_as<Cost, ThinFeatureQuadric>)
        values += losses(two, positions);
      write(two, values, costs + i);
    }
  }

  // Both pairs have their first vertex in common.
  Lanes losses(const Two& two, const LaneVector& positions) const {
    const auto& [p, q] = two;
    const auto planes = [&](Index v) -> const auto& {
      return memories_[v].planes;
    };
    const Lanes trace =
        planes(p.first).trace() + Lanes{planes(p.second).trace(), planes(q.second).trace()};
    return policies_.cost.loss(
        growth(planes(p.first), {&planes(p.second), &planes(q.second)}, ways(two), positions),
        trace);
  }

  void write(const Two& two, Lanes values, float* costs) const {
    for (std::size_t k = 0; k < 2; ++k)
      costs[k] = std::isnan(values[k]) ? cost_of(two[k]) : as_key(values[k]);
  }

  std::array<Vector<3>, 2> ways(const Two& two) const {
    const auto& [p, q] = two;
    return {positions_[p.second] - positions_[p.first], positions_[q.second] - positions_[q.first]};
  }
  Lanes squared_reaches(const Two& two) const {
    const auto& [p, q] = two;
    return Lanes{std::max(squared_reach_[p.first], squared_reach_[p.second]),
                 std::max(squared_reach_[q.first], squared_reach_[q.second])};
  }

  template <class R>
  void measure_reach(const R& range) {
    complex_.for_each_face_at(range, [&](const TriangleComplex::Triangle& corners) {
      const auto [p, q, r] = corners;
      const float pq = squared_length_of(p, q), qr = squared_length_of(q, r),
                  rp = squared_length_of(r, p);
      const auto reaches = [&](Index v, float a, float b) {
        if (range.contains(v))
          squared_reach_[v] = std::max({squared_reach_[v], a, b});
      };
      reaches(p, pq, rp);
      reaches(q, pq, qr);
      reaches(r, qr, rp);
    });
  }

  // The reach of a vertex stays as it is while others move: the cost of a pair depends on nothing
  // that can change while the pair waits in the queue.
  void update_reach(const PairStar& star, Index kept) {
    float reach = 0;
    for (const auto* faces : {&star.first, &star.second})
      for (const StarFace& f : *faces)
        for (Index w : {f.second, f.third})
          reach = std::max(reach, squared_length_of(kept, w));
    squared_reach_[kept] = reach;
  }

  float squared_length_of(Index v, Index w) const {
    return static_cast<float>(squared_distance(space(positions_[v]), space(positions_[w])));
  }

  const Policies& policies_;
  const Scale<Cost::dimension>& scale_;
  const TriangleComplex& complex_;
  Array<Position> positions_;
  std::vector<bool> is_fixed_; // empty if none is
  UninitializedArray<Memory> memories_;
  [[no_unique_address]] typename CurrentMemoriesOf<Cost>::type current_;
  Array<float> squared_reach_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COST_PAIR_COSTS_H
