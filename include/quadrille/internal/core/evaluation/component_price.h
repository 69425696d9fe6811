#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_COMPONENT_PRICE_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_COMPONENT_PRICE_H

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

/// The cost at which a component of the surface vanishes, as a key of the queue.
///
/// It is the cost of contracting the component to its centre if each plane in the states of its
/// vertices were as far from there as the radius of the component. That is no less than the cost of
/// the contractions to that place, so as a rule a component shrinks as far as it can before it
/// vanishes; and it is no less for a thin or flat component, whose planes all pass through the
/// centre. For a cost that looks at the current surface, local terms count in this way, and the
/// states of vertices are added with their cost at the centre. The component has the importance of
/// its most important vertex.
template <class Policies>
class ComponentPrice {
public:
  using Cost = typename Policies::Cost;
  using Position = Vector<Cost::dimension>;

  explicit ComponentPrice(const PairEvaluator<Policies>& evaluator) : evaluator_(evaluator) {}

  /// Returns the cost of a component with these vertices, of which there is at least one; infinity
  /// if it is not a number. In linear time.
  float operator()(std::span<const Index> vertices, const Position& centre,
                   double squared_radius) const {
    PairOf<Cost> component = as_pair(vertices, centre);
    const double of_radius = squared_radius * weight_of(component);
    double price = 0;
    if constexpr (has_local_terms<Cost>) {
      using Current = typename Cost::Current;
      component.current = cost().join(Current{}, Current{}, Current{}, Position{});
      price = of_radius + cost_of(component, centre);
    } else {
      price = (std::max)(of_radius, cost_of(component, centre));
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
  double weight_of(const PairOf<Cost>& component) const {
    const double squared = squared_error(cost(), component, 1.0);
    return squared > 0 ? 1 / squared / (has_local_terms<Cost> ? 3 : 1) : 0;
  }

  // Represents the whole component as a pair: its ends are vertices far apart, and its state is the
  // sum of all.
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

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_COMPONENT_PRICE_H
