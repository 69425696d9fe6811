#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_TWO_LANES_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_TWO_LANES_H

#include <quadrille/internal/core/appearance/no_channels.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/cost/local_star.h>
#include <quadrille/internal/core/evaluation/two_quadrics.h>
#include <quadrille/internal/core/memory/append_buffer.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/internal/core/policy/built_in_placement.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/placement.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace quadrille::internal {

/// Does a class say of itself that pairs may be costed two at a time? See CostPolicy.
template <class Cost>
inline constexpr bool says_two_lanes = requires {
  requires std::same_as<typename Cost::TwoLanes, std::remove_const_t<Cost>>;
};

/// Is there a kernel that costs two pairs at the price of one, for this cost and placement?
template <class Cost, class Placement>
inline constexpr bool
    has_two_lanes = (std::same_as<Placement, OptimalPlacement> ||
                     std::same_as<Placement, BuiltInPlacement>)&&says_two_lanes<Cost>;

/// Does a cost of that kind count losses of accumulated planes, as ThinFeatureQuadric does?
template <class Cost>
concept CountsLosses = requires(const Cost& cost, const typename Cost::State& state,
                                const Lanes& lanes) {
  { state.planes } -> std::convertible_to<const QuadricForm<3>&>;
  { cost.loss(lanes, lanes) } -> std::convertible_to<Lanes>;
};

/// Does one of those placements, or one whose first candidate comes from those, take the position
/// of least cost?
template <class Placement>
bool is_optimal(const Placement& placement) {
  if constexpr (requires { placement.is_optimal(); })
    return placement.is_optimal();
  else
    return true;
}

/// The terms that channels add to two pairs: see two_channel_forms.h, which calls with channels
/// include.
template <class Cost>
auto two_channel_forms(const Channels<Cost>& channels, const TwoPairs& two,
                       const std::array<Vector<3>, 2>& to_seconds);

/// Costs pairs two at a time. Pairs that the kernel cannot solve are left to the evaluator, which
/// gives the same keys up to the rounding of a float.
template <class Evaluator>
class TwoLanes {
public:
  using Cost = typename Evaluator::Cost;
  static_assert(
      is_scale_free<Cost>,
      "A cost with TwoLanes has to be scale-free: see CostPolicy in <quadrille/concepts.h>.");

  explicit TwoLanes(const Evaluator& evaluator) : evaluator_(evaluator) {}

  /// The last pair is taken alone twice, if need be: there is room for one key more.
  void evaluate_all(const AppendBuffer<VertexPair>& pairs, float* keys, VertexLabels&) const {
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
      const TwoPairs two = {pairs[i], pairs[(std::min)(i + 1, pairs.size() - 1)]};
      const std::array<Vector<3>, 2> to_seconds = displacements(two);
      write(two, values_of(two, to_seconds, channel_forms(two, to_seconds)), keys + i);
    }
    rewrite_fixed(pairs, keys);
  }

  /// Is it cheaper to know what pairs cost at least, without what only channels add to them?
  static constexpr bool has_bounds = Evaluator::counts_channels && !has_local_terms<Cost>;

  /// Leaves out pairs of which the state alone costs more than a limit: what channels add to it is
  /// a sum of squares. There is a margin for rounding.
  void drop_above(float limit, AppendBuffer<VertexPair>& pairs) const requires has_bounds {
    constexpr float margin = 1.001f;
    std::size_t left = 0;
    const std::size_t count = pairs.size();
    for (std::size_t i = 0; i < count; i += 2) {
      const TwoPairs two = {pairs[i], pairs[(std::min)(i + 1, count - 1)]};
      const Lanes values = values_of(two, displacements(two), NothingAdded{});
      for (std::size_t k = 0; k < (std::min)(count - i, std::size_t{2}); ++k) {
        pairs[left] = two[k];
        left += !(Evaluator::as_key(values[k]) > margin * limit); // without a branch
      }
    }
    pairs.resize(left);
  }

  /// One vertex after the other, since its pairs share what its faces say.
  void evaluate_all(const AppendBuffer<VertexPair>& pairs, float* keys,
                    VertexLabels& labels) const requires has_local_terms<Cost> {
    const auto& terms = evaluator_.terms();
    const auto& complex = evaluator_.state().complex;
    for (std::size_t i = 0, end = 0; i < pairs.size(); i = end) {
      const Index v = pairs[i].first;
      while (end < pairs.size() && pairs[end].first == v)
        ++end;
      if (terms.last_star().vertex() == v)
        evaluate_around(terms.last_star(), pairs, i, end, keys);
      else if (complex.degree_bound(v) <= LocalStar<Cost>::most_faces)
        evaluate_around(LocalStar<Cost>(v, evaluator_.cost(), positions(), complex), pairs, i, end,
                        keys);
      else
        evaluate_around(LocalHighValence<Cost>(v, evaluator_.cost(), positions(), complex, labels),
                        pairs, i, end, keys);
    }
    rewrite_fixed(pairs, keys);
  }

private:
  const auto& positions() const { return evaluator_.state().geometry.positions(); }

  // Returns the terms that channels add to the state of each pair, or to its local terms.
  auto channel_forms(const TwoPairs& two, const std::array<Vector<3>, 2>& displacements) const {
    if constexpr (Evaluator::counts_channels)
      return two_channel_forms(evaluator_.state().channels(), two, displacements);
    else
      return NothingAdded{};
  }

  // Returns the least values of the states of two pairs with what is added to them.
  template <class Added>
  QUADRILLE_ALWAYS_INLINE Lanes values_of(const TwoPairs& two,
                                          const std::array<Vector<3>, 2>& to_seconds,
                                          const Added& added) const {
    const auto& states = evaluator_.state().states;
    const auto& [p, q] = two;
    return least_values({&states[p.first], &states[q.first]},
                        {&states[p.second], &states[q.second]}, to_seconds, squared_ring_radii(two),
                        added);
  }

  template <class Star>
  void evaluate_around(const Star& star, const AppendBuffer<VertexPair>& pairs, std::size_t i,
                       std::size_t end, float* keys) const {
    const auto& terms = evaluator_.terms();
    for (; i < end; i += 2) {
      const TwoPairs two = {pairs[i], pairs[(std::min)(i + 1, end - 1)]};
      const auto& [p, q] = two;
      const std::array<Vector<3>, 2> to_seconds = displacements(two);
      auto [values, minimizers] =
          minima(terms[p.first], {&terms[p.second], &terms[q.second]},
                 {star.shared_with(p.second, evaluator_.cost(), positions()),
                  star.shared_with(q.second, evaluator_.cost(), positions())},
                 to_seconds, squared_ring_radii(two), channel_forms(two, to_seconds));
      if constexpr (CountsLosses<Cost>)
        values += losses(two, minimizers);
      write(two, values, keys + i);
    }
  }

  // Both pairs have their first vertex in common.
  Lanes losses(const TwoPairs& two, const LaneVector& minimizers) const {
    const auto& [p, q] = two;
    const auto planes = [&](Index v) -> const auto& {
      return evaluator_.state().states[v].planes;
    };
    const Lanes trace =
        planes(p.first).trace() + Lanes{planes(p.second).trace(), planes(q.second).trace()};
    return evaluator_.cost().loss(growth(planes(p.first), {&planes(p.second), &planes(q.second)},
                                         displacements(two), minimizers),
                                  trace);
  }

  void write(const TwoPairs& two, Lanes values, float* keys) const {
    for (std::size_t k = 0; k < 2; ++k)
      keys[k] = std::isnan(values[k]) ? evaluator_.key_alike(two[k]) : Evaluator::as_key(values[k]);
  }

  // If seams are kept, the corners of their graph are fixed: such pairs are few, and the kernel has
  // costed them as if they were free.
  void rewrite_fixed(const AppendBuffer<VertexPair>& pairs, float* keys) const {
    const auto& geometry = evaluator_.state().geometry;
    if (!geometry.is_any_fixed())
      return;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (geometry.is_fixed(pairs[i].first) || geometry.is_fixed(pairs[i].second))
        keys[i] = evaluator_.key_alike(pairs[i]);
  }

  std::array<Vector<3>, 2> displacements(const TwoPairs& two) const {
    const auto& [p, q] = two;
    const auto& at = positions();
    return {at[p.second] - at[p.first], at[q.second] - at[q.first]};
  }
  Lanes squared_ring_radii(const TwoPairs& two) const {
    const auto ring_radius = [&](const VertexPair& p) {
      const auto& geometry = evaluator_.state().geometry;
      return static_cast<double>((std::max)(geometry.squared_ring_radius(p.first),
                                            geometry.squared_ring_radius(p.second)));
    };
    return Lanes{ring_radius(two[0]), ring_radius(two[1])};
  }

  const Evaluator& evaluator_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_TWO_LANES_H
