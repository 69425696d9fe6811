#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_CUT_PRICE_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_CUT_PRICE_H

#include <quadrille/internal/core/complex/edge_cycle.h>
#include <quadrille/internal/core/evaluation/pair_evaluator.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace quadrille::internal {

/// Computes the cost of a cut along a cycle of three edges, as a key of the queue, and its width.
///
/// Nothing of the surface moves; two faces come, one on each side. Their points lie off the surface
/// as it was, by the distance from the cycle: the mean of its square over a triangle is r²/6, where
/// r is the radius of its inscribed circle. The cost is that mean, times the weight that the planes
/// of both faces get in the states of their vertices: with Quadric, six times the area of one. So
/// it is what a contraction costs that moves as much surface as far.
template <class Policies>
class CutPrice {
public:
  using Cost = typename Policies::Cost;

  CutPrice(const PairEvaluator<Policies>& evaluator, const SurfaceState<Policies>& state)
      : evaluator_(evaluator), state_(state) {}

  /// Infinity, if it is not a number.
  float operator()(const EdgeCycle& cycle) const {
    const double price = weight(cycle) * squared_distance_of_faces(cycle);
    if (std::isnan(price))
      return std::numeric_limits<float>::infinity();
    const float key = PairEvaluator<Policies>::as_key(evaluator_.key_of_cost(price));
    const VertexImportance& importance = state_.importance;
    return importance.is_any_given() ? key * importance.greatest_of(cycle) : key;
  }

  /// The root mean square distance of both faces from the surface, in the mesh's unit.
  double error(const EdgeCycle& cycle) const {
    return state_.scale.length_of_mesh(std::sqrt(squared_distance_of_faces(cycle)));
  }

  /// A third of the length of the cycle, and by how much it may be too short: the greatest error at
  /// one of its vertices. In the engine's unit.
  double width(const EdgeCycle& cycle) const {
    double greatest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      greatest = (std::max)(greatest, squared_error_at(cycle[i], cycle[(i + 1) % 3]));
    return lengths(cycle).sum() / 3 + std::sqrt(greatest);
  }

private:
  struct Lengths {
    double a, b, c;
    double sum() const { return a + b + c; }
  };
  Vector<3> point(Index v) const { return space(state_.geometry.position(v)); }
  double length(Index v, Index w) const { return std::sqrt(squared_distance(point(v), point(w))); }
  Lengths lengths(const EdgeCycle& v) const {
    return {length(v[0], v[1]), length(v[1], v[2]), length(v[2], v[0])};
  }

  // r²/6, where r is twice the area over the length of the cycle.
  double squared_distance_of_faces(const EdgeCycle& v) const {
    const double around = lengths(v).sum();
    const double squared =
        squared_length(double_area_vector(point(v[0]), point(v[1]), point(v[2])));
    return around > 0 ? squared / (around * around) / 6 : 0;
  }

  // By which a squared distance becomes a cost: see ComponentPrice.
  double weight(const EdgeCycle& v) const {
    const auto& cost = with_engine_lengths(evaluator_.cost(), state_.scale);
    PairOf<Cost> pair = pair_of(v[0], v[1]);
    pair.state = {};
    const auto at = [&](std::size_t i) { return state_.geometry.position(v[i % 3]); };
    for (std::size_t i = 0; i < 3; ++i) {
      auto state = cost.face(at(i), at(i + 1), at(i + 2));
      move_origin(state, at(0) - at(i));
      pair.state += state;
      pair.state += state; // of the other face
    }
    if constexpr (has_local_terms<Cost>) {
      using Current = typename Cost::Current;
      Current now = cost.current_face(at(0), at(1), at(2));
      now += cost.current_face(at(0), at(1), at(2));
      pair.current = cost.join(now, Current{}, Current{}, {});
    }
    const double squared = squared_error(cost, pair, 1.0);
    return squared > 0 ? 1 / squared : 0;
  }

  // In a cost that looks at the surface as it is, no vertex has an error.
  double squared_error_at(Index v, Index w) const {
    if constexpr (has_local_terms<Cost>) {
      return 0;
    } else {
      PairOf<Cost> pair = pair_of(v, w);
      pair.state = state_.states[v];
      const double cost = evaluator_.cost()(pair, pair.first);
      return (std::max)(0.0, squared_error(evaluator_.cost(), pair, cost));
    }
  }

  // Without a state.
  PairOf<Cost> pair_of(Index v, Index w) const {
    const auto &p = state_.geometry.position(v), &q = state_.geometry.position(w);
    return {evaluator_.names().of_cost(v, w), p, q, {}, squared_distance(space(p), space(q))};
  }

  const PairEvaluator<Policies>& evaluator_;
  const SurfaceState<Policies>& state_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_CUT_PRICE_H
