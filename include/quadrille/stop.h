#ifndef QUADRILLE_STOP_H
#define QUADRILLE_STOP_H

#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/report.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace quadrille {

namespace internal {

inline void require_ratio(const std::string& policy, double ratio) {
  if (!(ratio >= 0 && ratio <= 1))
    throw std::invalid_argument("quadrille::" + policy + ": the ratio " + text_of(ratio) +
                                " is not in [0, 1]");
}

struct NoEdgeProfile {}; // in the place of one of CGAL

} // namespace internal

/// Stops at `faces` faces: at exactly this number if topology allows it at a reasonable cost,
/// otherwise at the first number below, with StopReason::target_passed. On a surface without
/// boundary every contraction removes two faces. Elsewhere the engine looks for a pair that removes
/// one face, and contracts it if it costs at most four times as much as the next pair in the order.
struct FaceCount {
  std::size_t faces; ///< the target

  /// Returns true once the target is reached.
  bool operator()(const Status& status) const { return status.faces <= faces; }

  /// Returns true for a surface beyond the target: the engine looks for another pair first.
  bool is_passed(const Status& status) const { return status.faces < faces; }
};

/// Stops when at most `ratio` of the input's faces are left, not counting degenerate and doubled
/// ones. No pair is preferred to meet the number exactly. ratio lies in [0, 1].
struct FaceRatio {
  double ratio = 0.5; ///< a fraction of the faces, in [0, 1]

  /// Returns true once the target is reached.
  bool operator()(const Status& status) const {
    const double target = ratio * static_cast<double>(status.initial_faces);
    return status.faces <= static_cast<std::size_t>(std::llround(target));
  }

  /// Throws std::invalid_argument for a ratio that is not in [0, 1].
  void validate() const { internal::require_ratio("FaceRatio", ratio); }
};

/// Stops at `vertices` vertices.
struct VertexCount {
  std::size_t vertices; ///< the target

  /// Returns true once the target is reached.
  bool operator()(const Status& status) const { return status.vertices <= vertices; }
  /// Returns true if the surface is beyond the target, not just at it. See StopPolicy.
  bool is_passed(const Status& status) const { return status.vertices < vertices; }
};

/// Stops at the first number of edges that is at most `edges`: a contraction removes three edges,
/// or two at a boundary. An edge with several faces counts once. Counting takes 5 to 9 % more time.
struct EdgeCount {
  std::size_t edges; ///< the target

  static constexpr Needs needs = {.edges = true}; ///< looks at Status::edges: see StopPolicy

  /// Returns true once the target is reached.
  bool operator()(const Status& status) const { return status.edges <= edges; }
};

/// Stops when at most `ratio` of the input's edges are left: see EdgeCount. ratio lies in [0, 1].
struct EdgeRatio {
  double ratio = 0.5; ///< a fraction of the edges, in [0, 1]

  static constexpr Needs needs = {.edges = true}; ///< looks at Status::edges: see StopPolicy

  /// Returns true once the target is reached.
  bool operator()(const Status& status) const {
    return static_cast<double>(status.edges) <= ratio * static_cast<double>(status.initial_edges);
  }

  /// Throws std::invalid_argument for a ratio that is not in [0, 1].
  void validate() const { internal::require_ratio("EdgeRatio", ratio); }
};

/// A stop predicate of CGAL::Surface_mesh_simplification as a stop policy:
/// `simplify(mesh, CgalStop(Count_ratio_stop_predicate<Mesh>(0.1)))`. It is called as in CGAL, with
/// the cost of the next contraction and the initial and current numbers of edges. The cost comes
/// from this library's cost policy, in the mesh's units. There is no edge profile: a predicate that
/// reads one, as Edge_length_stop_predicate, does not compile.
template <class Predicate>
class CgalStop {
public:
  static constexpr Needs needs = {.cost = true, .edges = true}; ///< see StopPolicy

  /// Keeps a copy of the predicate.
  explicit CgalStop(Predicate predicate) : predicate_(std::move(predicate)) {}

  /// Returns true once the predicate does.
  bool operator()(const Status& status) const {
    return predicate_(status.next_cost, internal::NoEdgeProfile{}, status.initial_edges,
                      status.edges);
  }

private:
  Predicate predicate_;
};

/// Stops when the given seconds have passed since this policy was constructed: construct it in the
/// call itself, `simplify(mesh, AnyOf{FaceCount{1000}, TimeBudget{0.5}})`, and again for the next
/// call. The time includes reading the surface and costing pairs; but these stages, and writing,
/// are never cut short.
///
/// This is the only policy with which the same input may give different results: the number of
/// contractions depends on the clock.
class TimeBudget {
public:
  /// seconds is at least 0; throws std::invalid_argument otherwise.
  explicit TimeBudget(double seconds) : begin_(Clock::now()), seconds_(seconds) {
    if (!(seconds >= 0))
      throw std::invalid_argument("quadrille::TimeBudget: " + internal::text_of(seconds) +
                                  " seconds are negative or not a number");
  }

  /// Returns true once the time is over.
  bool operator()(const Status&) const {
    return std::chrono::duration<double>(Clock::now() - begin_).count() >= seconds_;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_;
  double seconds_;
};

namespace internal {

/// Several stop policies; it needs whatever any of them needs. Empty optionals among them are
/// ignored.
template <class... Stops>
class SeveralStops {
public:
  /// The union of the needs of all policies: see StopPolicy.
  static constexpr Needs needs = (internal::needs_of<Stops>() | ... | Needs{});
  /// Returns the union of the needs of these objects.
  Needs needs_now() const {
    return std::apply(
        [](const auto&... stop) { return (internal::needs_now(stop) | ... | Needs{}); }, stops_);
  }
  /// The policies, in the order in which they were given.
  const std::tuple<Stops...>& stops() const { return stops_; }
  /// Throws whatever invalid policies throw, and std::invalid_argument if all are empty optionals.
  void validate() const {
    if constexpr ((IsOptional<Stops> && ...))
      if (std::apply([](const auto&... stop) { return (!stop && ...); }, stops_))
        throw std::invalid_argument("quadrille: all stop policies of an AnyOf or AllOf are empty");
    std::apply([](const auto&... stop) { (internal::validate(stop), ...); }, stops_);
  }

protected:
  explicit SeveralStops(Stops... stops) : stops_(std::move(stops)...) {}

  template <class Is>
  bool is_any(Is is) const {
    return std::apply([&](const auto&... stop) -> bool { return (holds(stop, is, false) || ...); },
                      stops_);
  }
  template <class Are>
  bool are_all(Are are) const {
    return std::apply([&](const auto&... stop) -> bool { return (holds(stop, are, true) && ...); },
                      stops_);
  }

private:
  template <class Stop, class Is>
  static bool holds(const Stop& stop, Is is, [[maybe_unused]] bool if_absent) {
    if constexpr (IsOptional<Stop>)
      return stop ? is(*stop) : if_absent;
    else
      return is(stop);
  }

  std::tuple<Stops...> stops_;
};

} // namespace internal

/// Stops as soon as any of several stop policies does: `AnyOf{FaceCount{1000},
/// DistanceLimit{0.1}}`. Each may be a std::optional, but at least one must have a value.
template <class... Stops>
class AnyOf : public internal::SeveralStops<Stops...> {
public:
  /// Takes stop policies of any type.
  explicit AnyOf(Stops... stops) : internal::SeveralStops<Stops...>(std::move(stops)...) {}

  /// Returns true once any policy stops.
  bool operator()(const Status& status) const {
    return this->is_any([&](const auto& stop) -> bool { return stop(status); });
  }
  /// Returns true if the surface is beyond the target, not just at it. See StopPolicy.
  bool is_passed(const Status& status) const {
    return this->is_any([&](const auto& stop) { return internal::is_passed(stop, status); });
  }
};

/// Stops when all of several stop policies do. Each may be a std::optional, but at least one must
/// have a value.
template <class... Stops>
class AllOf : public internal::SeveralStops<Stops...> {
public:
  /// Takes stop policies of any type.
  explicit AllOf(Stops... stops) : internal::SeveralStops<Stops...>(std::move(stops)...) {}

  /// Returns true once all policies stop.
  bool operator()(const Status& status) const {
    return this->are_all([&](const auto& stop) -> bool { return stop(status); });
  }
  /// Returns true if the surface is beyond the target, not just at it. See StopPolicy.
  bool is_passed(const Status& status) const {
    return this->are_all([&](const auto& stop) { return internal::is_passed(stop, status); });
  }
};

/// Rejects contractions that cost more than a limit, and stops when all others are done. Greedy
/// order ends when the next pair in the order costs more, including the tie break; passes skip
/// pairs that cost more, and end when no cheaper pair can be contracted.
///
/// The limit is in the units in which the cost policy computes its values in the mesh's units: for
/// Quadric an area times a squared distance, so the fourth power of a length (the square with plain
/// weights); for MemorylessQuadric the power 4.5; for EdgeLength the square. A user's stop policy
/// reads such numbers from Status::next_cost.
///
/// Tiles of a surface that are simplified separately up to the same limit, in the scale of the same
/// box, get about the same density as a surface that is simplified as a whole, whatever their
/// sizes: see vertex_is_shared_map and bounding_box in parameters.h. A target of faces cannot do
/// this: it would destroy a tile that cannot reach its target with its shared vertices fixed.
///
/// Not checked: for lengths beyond about 10^±60 the limit exceeds the range of double.
class CostLimit {
public:
  /// `cost` is at least 0; infinity means no limit.
  explicit CostLimit(double cost) : cost_(cost) {}

  /// Looks at Status::next_cost: see StopPolicy.
  static constexpr Needs needs = {.cost = true};

  /// Returns true once the next contraction costs more than the limit.
  bool operator()(const Status& status) const { return status.next_cost > cost_; }

  double cost() const { return cost_; } ///< the limit

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const {
    if (!(cost_ >= 0))
      throw std::invalid_argument("quadrille::CostLimit: the limit " + internal::text_of(cost_) +
                                  " is negative or not a number");
  }

private:
  double cost_;
};

} // namespace quadrille

#endif // QUADRILLE_STOP_H
