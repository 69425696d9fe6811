#ifndef QUADRILLE_INTERNAL_CORE_POLICY_POLICIES_H
#define QUADRILLE_INTERNAL_CORE_POLICY_POLICIES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/policy/tie_break.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace quadrille::internal {

/// Does a cost or a placement want to know which vertices of the input a pair is about?
template <class Policy>
inline constexpr bool asks_for_indices = requires {
  requires Policy::asks_for_indices;
};

/// Does a cost accumulate values that it knows by the indices of input vertices?
template <class Cost>
concept AccumulatesByIndex = requires(const Cost& cost, typename Cost::State state) {
  state += cost.input_vertex(std::size_t{});
};

struct NoIndices {};

/// By the indices in the input, the ends of a pair, for who asks for them.
struct PairIndices {
  std::size_t first_index, second_index;
};

template <class Policy>
using IndicesFor = std::conditional_t<asks_for_indices<Policy>, PairIndices, NoIndices>;

/// The argument of a placement that asks for indices: a pair without indices, with them added.
template <class Pair>
struct IndexedPair : Pair, PairIndices {
  IndexedPair(const Pair& pair, const PairIndices& indices) : Pair(pair), PairIndices(indices) {}
};
template <class Placement, class Pair>
using PairFor =
    std::conditional_t<asks_for_indices<Placement> && !std::derived_from<Pair, PairIndices>,
                       IndexedPair<Pair>, Pair>;

/// Does a cost look at the current surface, in addition to the states of vertices?
template <class Cost>
concept has_local_terms = requires {
  typename Cost::Current;
};

/// How many times as costly as it was a pair may have become while it waited, and still be
/// contracted.
template <class Cost>
inline constexpr float tolerated_rise = 1;
template <class Cost>
requires requires {
  Cost::tolerated_rise;
}
inline constexpr float tolerated_rise<Cost> = static_cast<float>(Cost::tolerated_rise);

/// Does a cost measure how uneven the faces around a vertex are?
template <class Cost>
concept measures_unevenness = requires(const Cost& cost, const typename Cost::Current& current) {
  { cost.unevenness(current) } -> std::convertible_to<double>;
};

/// Returns the factor by which that may fall before the pairs of the vertex are costed again.
template <class Cost>
inline constexpr float tolerated_fall = 0;
template <class Cost>
requires measures_unevenness<Cost>
inline constexpr float tolerated_fall<Cost> = static_cast<float>(Cost::tolerated_fall);

/// Does a placement look at the star of a pair before it decides?
template <class Placement>
inline constexpr bool looks_at_star = requires {
  requires Placement::looks_at_star;
};

/// Does it want to know whether each edge of the surface has as many faces on one side as on the
/// other?
template <class Placement>
inline constexpr bool needs_closed_surface = requires {
  requires Placement::needs_closed_surface;
};

/// Does it promise anything about the volume that the surface encloses? Then the report includes
/// it.
template <class Placement>
inline constexpr bool asks_for_volume = requires {
  requires Placement::asks_for_volume;
};

/// By which placement pairs are ordered until their star is looked at.
template <class Placement>
struct EstimateOf {
  using type = Placement;
};
template <class Placement>
requires requires {
  typename Placement::Estimate;
}
struct EstimateOf<Placement> {
  using type = typename Placement::Estimate;
};

/// By which factor such a pair is more costly then, at least, as a rule.
template <class Placement>
inline constexpr double rise_of_estimate = 1;
template <class Placement>
requires requires {
  Placement::rise_of_estimate;
}
inline constexpr double rise_of_estimate<Placement> = Placement::rise_of_estimate;

/// Does a policy say that it does as well in any unit of length? A class says so for itself only:
/// one that is derived from it may not.
template <class Policy>
inline constexpr bool is_scale_free = requires {
  requires std::same_as<typename Policy::ScaleFree, std::remove_const_t<Policy>>;
};

struct NoCurrent {};

template <class Cost>
struct PairCurrentOf {
  using type = NoCurrent;
};
template <class Cost>
requires has_local_terms<Cost>
struct PairCurrentOf<Cost> {
  using type = typename Cost::PairCurrent;
};

/// A pair as cost and placement see it.
template <class Cost>
struct PairOf : IndicesFor<Cost> {
  Vector<Cost::dimension> first, second;
  typename Cost::State state;     ///< the state of both ends, about `first`
  double squared_ring_radius = 0; ///< the distance from an end to its farthest neighbour, as
                                  ///< each end had it when it took its place
  QUADRILLE_NO_UNIQUE_ADDRESS
  typename PairCurrentOf<Cost>::type current{}; ///< if the cost asks for it
};

/// Stands for labels if faces have none that are to be kept.
struct NoLabels {};

/// The types of the attributes that a call carries in addition to the shape: labels of faces, an
/// optional of such, or NoLabels; a tuple of Texture, Normals, …; is there a SplitVertices?
template <class Labels_, class Channels_, bool splits>
struct Carried {
  using Labels = Labels_;
  using Channels = Channels_;
  static constexpr bool has_labels = !std::same_as<Labels, NoLabels>;
  static constexpr bool has_channels = !std::same_as<Channels, std::tuple<>>;
  static constexpr bool splits_vertices = splits;

  Labels labels;
  Channels channels;
};

/// Expresses a state about the point d, if the cost keeps its state about its vertex.
template <class State, std::size_t N>
void move_origin(State& state, const Vector<N>& d) {
  if constexpr (requires { state.move_origin(d); })
    state.move_origin(d);
}

/// Returns the sum of the states of two vertices, about the first: the second is at d from it.
template <class State, std::size_t N>
State sum_about_first(const State& first, const State& second, const Vector<N>& d) {
  if constexpr (requires { State::sum_about_first(first, second, d); }) {
    return State::sum_about_first(first, second, d);
  } else {
    State sum = second;
    move_origin(sum, -1.0 * d);
    sum += first;
    return sum;
  }
}

/// The tie break of pairs of equal costs, for costs that have one.
template <class Cost>
double tie_break(const Cost& cost, const PairOf<Cost>& pair, const Vector<Cost::dimension>& x) {
  if constexpr (BreaksTies<Cost, PairOf<Cost>, Vector<Cost::dimension>>)
    return cost.tie_break(pair, x);
  else
    return 0;
}

/// The square of the error of a contraction as a distance, in the engine's unit.
template <class Cost>
double squared_error(const Cost& cost, const PairOf<Cost>& pair, double value) {
  if constexpr (requires { cost.squared_error(pair, value); })
    return cost.squared_error(pair, value);
  else
    return value;
}

/// True if a surface of this status lies beyond the target and not just at it.
template <class Stop>
bool is_passed(const Stop& stop, const Status& status) {
  if constexpr (requires { stop.is_passed(status); })
    return stop.is_passed(status);
  else
    return false;
}

/// With what the needs imply: a tolerance is one of distances both ways, these are looked for after
/// the one way.
constexpr Needs with_implied(Needs needs) {
  needs.reverse_distance = needs.reverse_distance || needs.tolerance;
  needs.distance = needs.distance || needs.reverse_distance;
  return needs;
}

/// The data that stop policies of a type may need.
template <class Stop>
constexpr Needs needs_of() {
  if constexpr (IsOptional<Stop>)
    return needs_of<Contained<Stop>>();
  else if constexpr (requires { Stop::needs; })
    return with_implied(Stop::needs);
  else
    return {};
}

/// And what this one needs.
template <class Stop>
Needs needs_now(const Stop& stop) {
  if constexpr (IsOptional<Stop>) {
    return stop ? needs_now(*stop) : Needs{};
  } else if constexpr (requires { stop.needs_now(); }) {
    static_assert(
        requires { Stop::needs; },
        "A stop policy with needs_now() also has to have `static constexpr Needs needs`: "
        "everything that its type may need.");
    return with_implied(stop.needs_now()) & needs_of<Stop>();
  } else {
    return needs_of<Stop>();
  }
}

/// By which power of lengths the values of a cost grow, if that is known.
template <class Cost>
concept CountsDegree = requires(const Cost& cost) {
  { cost.degree() } -> std::convertible_to<double>;
};

/// Can the values of a cost be reported in the mesh's units?
template <class Cost>
inline constexpr bool has_cost_in_mesh_units = !is_scale_free<Cost> || CountsDegree<Cost>;

/// Is every edge a pair at any time, for this pair policy?
template <class Pairs>
inline constexpr bool includes_edges = requires {
  requires Pairs::includes_edges;
};

/// Does a pair policy look at points and not at their indices? Then they may be renumbered.
template <class Pairs>
inline constexpr bool ignores_indices = requires {
  requires Pairs::ignores_indices;
};

/// Throws what a policy throws that makes no sense.
/// As what it counts that a filter or a guard says no.
template <class Policy>
inline constexpr Rejection cause_of = Rejection::filter;
template <class Policy>
requires requires {
  Policy::cause;
}
inline constexpr Rejection cause_of<Policy> = Policy::cause;

template <class Policy>
void validate(const Policy& policy) {
  if constexpr (IsOptional<Policy>)
    if_given(policy, [](const auto& given) { validate(given); });
  else if constexpr (requires { policy.validate(); })
    policy.validate();
}

template <class... Policies>
void validate_all(const Policies&... policies) {
  (validate(policies), ...);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_POLICIES_H
