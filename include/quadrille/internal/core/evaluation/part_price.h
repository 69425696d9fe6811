#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_PART_PRICE_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_PART_PRICE_H

#include <quadrille/internal/core/cost/vertex_importance.h>
#include <quadrille/internal/core/evaluation/pair_evaluator.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace quadrille::internal {

/// What it costs that a part of the surface vanishes, as a key of the queue.
///
/// It is what contracting the part to its centre would cost if each plane that its vertices
/// remember were as far from there as the radius of the part. That is no less than what the
/// contractions to that place cost, so as a rule a part shrinks as far as it can before it
/// vanishes; and it is no less for a thin or flat part, whose planes all pass through the centre.
/// Of a cost that looks at the surface as it is, what it sees counts in this way, and what vertices
/// remember is added as it costs it at the centre. The part counts as its most important vertex.
template <class Policies>
class PartPrice {
public:
  using Cost = typename Policies::Cost;
  using Position = Vector<Cost::dimension>;

  explicit PartPrice(const PairEvaluator<Policies>& evaluator) : evaluator_(evaluator) {}

  /// Of a part with these vertices, of which there is at least one; infinity if it is no number. In
  /// linear time.
  float operator()(std::span<const Index> vertices, const Position& centre,
                   double squared_radius) const {
    PairOf<Cost> part = as_pair(vertices, centre);
    const double of_radius = squared_radius * weight_of(part);
    double price = 0;
    if constexpr (has_local_terms<Cost>) {
      using Current = typename Cost::Current;
      part.current = cost().join(Current{}, Current{}, Current{}, Position{});
      price = of_radius + cost_of(part, centre);
    } else {
      price = (std::max)(of_radius, cost_of(part, centre));
    }
    if (std::isnan(price))
      return std::numeric_limits<float>::infinity();
    const float key = PairEvaluator<Policies>::as_key(evaluator_.key_of_cost(price));
    const VertexImportance& importance = evaluator_.state().importance;
    return importance.is_any_given() ? key * importance.greatest_of(vertices) : key;
  }

private:
  const Cost& cost() const { return evaluator_.cost(); }
  const Position& position(Index v) const { return evaluator_.state().geometry.position(v); }

  // A user's cost may give something that becomes a number.
  double cost_of(const PairOf<Cost>& pair, const Position& x) const { return cost()(pair, x); }

  // By which a squared distance becomes a cost. Local terms count a face at each of its three
  // vertices, and once in the cost of a pair.
  double weight_of(const PairOf<Cost>& part) const {
    const double squared = squared_error(cost(), part, 1.0);
    return squared > 0 ? 1 / squared / (has_local_terms<Cost> ? 3 : 1) : 0;
  }

  // The whole part as if it were a pair: its ends are vertices far apart, and it remembers all.
  PairOf<Cost> as_pair(std::span<const Index> vertices, const Position& centre) const {
    const Index a = farthest(vertices, centre), b = farthest(vertices, position(a));
    const Position first = position(a), second = position(b);
    PairOf<Cost> pair{evaluator_.names().of_cost(a, b),
                      first,
                      second,
                      {},
                      squared_distance(space(first), space(second))};
    for (Index v : vertices) {
      typename Cost::State state = evaluator_.state().states[v];
      move_origin(state, first - position(v));
      pair.state += state;
    }
    if constexpr (has_local_terms<Cost>) {
      typename Cost::Current sum{};
      for (Index v : vertices)
        sum += evaluator_.terms()[v];
      using Current = typename Cost::Current;
      pair.current = cost().join(sum, Current{}, Current{}, Position{});
    }
    return pair;
  }

  Index farthest(std::span<const Index> vertices, const Position& from) const {
    const auto is_nearer = [&](Index v, Index w) {
      return squared_distance(position(v), from) < squared_distance(position(w), from);
    };
    return *std::max_element(vertices.begin(), vertices.end(), is_nearer);
  }

  const PairEvaluator<Policies>& evaluator_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_PART_PRICE_H
