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

} // namespace internal

/// Stops at `faces` faces: at exactly that many where topology allows and it is worth its price,
/// else at the first number below, and StopReason::target_passed says so. On a surface without
/// borders every contraction removes two faces. Elsewhere a pair that removes one is looked for; it
/// is taken if it costs at most four times what the next pair in the order does.
struct FaceCount {
  std::size_t faces; ///< how many are enough

  /// Is it enough?
  bool operator()(const Status& status) const { return status.faces <= faces; }

  /// True of a surface that has gone beyond the target: the engine looks for another pair first.
  bool is_passed(const Status& status) const { return status.faces < faces; }
};

/// Stops when `ratio` of the input's faces are left, degenerate and doubled ones not counted, or as
/// soon as fewer are: no pair is preferred for the sake of a number. ratio lies in [0, 1].
struct FaceRatio {
  double ratio = 0.5; ///< a part of the faces, in [0, 1]

  /// Is it enough?
  bool operator()(const Status& status) const {
    const double target = ratio * static_cast<double>(status.initial_faces);
    return status.faces <= static_cast<std::size_t>(std::llround(target));
  }

  /// Throws std::invalid_argument for a ratio that is not in [0, 1].
  void validate() const { internal::require_ratio("FaceRatio", ratio); }
};

/// Stops at `vertices` vertices.
struct VertexCount {
  std::size_t vertices; ///< how many are enough

  /// Is it enough?
  bool operator()(const Status& status) const { return status.vertices <= vertices; }
  /// Is the surface beyond the target and not just at it? See StopPolicy.
  bool is_passed(const Status& status) const { return status.vertices < vertices; }
};

/// Stops at `edges` edges, or at the first number below that contractions come to: one takes three,
/// two at a border. An edge of several faces is one. Counting takes 5 to 9 % more time.
struct EdgeCount {
  std::size_t edges; ///< how many are enough

  static constexpr Needs needs = {.edges = true}; ///< looks at Status::edges: see StopPolicy

  /// Is it enough?
  bool operator()(const Status& status) const { return status.edges <= edges; }
};

/// Stops when `ratio` of the input's edges are left, or as soon as fewer are: see EdgeCount. ratio
/// lies in [0, 1].
struct EdgeRatio {
  double ratio = 0.5; ///< a part of the edges, in [0, 1]

  static constexpr Needs needs = {.edges = true}; ///< looks at Status::edges: see StopPolicy

  /// Is it enough?
  bool operator()(const Status& status) const {
    return static_cast<double>(status.edges) <= ratio * static_cast<double>(status.initial_edges);
  }

  /// Throws std::invalid_argument for a ratio that is not in [0, 1].
  void validate() const { internal::require_ratio("EdgeRatio", ratio); }
};

/// A stop predicate of CGAL::Surface_mesh_simplification as a stop policy:
/// `simplify(mesh, CgalStop(Count_ratio_stop_predicate<Mesh>(0.1)))`. It is asked as CGAL asks it,
/// with the cost of the next contraction, the initial and the current number of edges. The cost is
/// that of this library's cost policy, in the mesh's units. There is no edge profile: a predicate
/// that reads one, as Edge_length_stop_predicate, does not compile.
template <class Predicate>
class CgalStop {
public:
  static constexpr Needs needs = {.cost = true, .edges = true}; ///< see StopPolicy

  /// Keeps a copy of the predicate.
  explicit CgalStop(Predicate predicate) : predicate_(std::move(predicate)) {}

  /// Does the predicate stop?
  bool operator()(const Status& status) const {
    return predicate_(status.next_cost, NoEdgeProfile{}, status.initial_edges, status.edges);
  }

private:
  struct NoEdgeProfile {};

  Predicate predicate_;
};

/// Stops when so many seconds have passed since this policy was made: make it in the call itself,
/// `simplify(mesh, AnyOf{FaceCount{1000}, TimeBudget{0.5}})`, and again for the next call. Reading
/// the surface and costing pairs are among them; what these and writing take is taken all the same.
///
/// This is the one policy with which the same input may give another output the next time: how far
/// it comes depends on the clock.
class TimeBudget {
public:
  /// seconds is at least 0; throws std::invalid_argument otherwise.
  explicit TimeBudget(double seconds) : begin_(Clock::now()), seconds_(seconds) {
    if (!(seconds >= 0))
      throw std::invalid_argument("quadrille::TimeBudget: " + internal::text_of(seconds) +
                                  " seconds are no time");
  }

  /// Is it enough?
  bool operator()(const Status&) const {
    return std::chrono::duration<double>(Clock::now() - begin_).count() >= seconds_;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_;
  double seconds_;
};

namespace internal {

/// Several stop policies, which need what any of them does. Those that are a std::optional which
/// holds nothing are not there.
template <class... Stops>
class SeveralStops {
public:
  /// What any of the policies may need: see StopPolicy.
  static constexpr Needs needs = (internal::needs_of<Stops>() | ... | Needs{});
  /// What any of them needs this time.
  Needs needs_now() const {
    return std::apply(
        [](const auto&... stop) { return (internal::needs_now(stop) | ... | Needs{}); }, stops_);
  }
  /// The policies, in the order in which they were given.
  const std::tuple<Stops...>& stops() const { return stops_; }
  /// Throws what the policies throw that make no sense, and std::invalid_argument if none is there.
  void validate() const {
    if constexpr ((IsOptional<Stops> && ...))
      if (std::apply([](const auto&... stop) { return (!stop && ...); }, stops_))
        throw std::invalid_argument("quadrille: none of the stop policies of an AnyOf or AllOf is "
                                    "there");
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

/// Stops as soon as any of several stop policies says so: `AnyOf{FaceCount{1000},
/// DistanceLimit{0.1}}`. Each may be a std::optional, and one has to be there.
template <class... Stops>
class AnyOf : public internal::SeveralStops<Stops...> {
public:
  /// Of stop policies of any type.
  explicit AnyOf(Stops... stops) : internal::SeveralStops<Stops...>(std::move(stops)...) {}

  /// Is it enough?
  bool operator()(const Status& status) const {
    return this->is_any([&](const auto& stop) -> bool { return stop(status); });
  }
  /// Is the surface beyond the target and not just at it? See StopPolicy.
  bool is_passed(const Status& status) const {
    return this->is_any([&](const auto& stop) { return internal::is_passed(stop, status); });
  }
};

/// Stops when all of several stop policies say so. Each may be a std::optional, and one has to be
/// there.
template <class... Stops>
class AllOf : public internal::SeveralStops<Stops...> {
public:
  /// Of stop policies of any type.
  explicit AllOf(Stops... stops) : internal::SeveralStops<Stops...>(std::move(stops)...) {}

  /// Is it enough?
  bool operator()(const Status& status) const {
    return this->are_all([&](const auto& stop) -> bool { return stop(status); });
  }
  /// Is the surface beyond the target and not just at it? See StopPolicy.
  bool is_passed(const Status& status) const {
    return this->are_all([&](const auto& stop) { return internal::is_passed(stop, status); });
  }
};

/// Takes no contraction that costs more than a limit, and stops when all others are done: greedy
/// order ends when the next pair in the order costs more, with what tells equal costs apart;
/// passes leave out what costs more, and end when nothing that costs less can be contracted.
///
/// The limit is in the units in which the cost policy computes its values in the mesh's units: of
/// Quadric an area times a squared distance, the fourth power of a length (of plain weights the
/// square of one); of MemorylessQuadric the power 4.5; of EdgeLength the square. A stop policy of
/// one's own learns such numbers from Status::next_cost.
///
/// Pieces of a surface that are simplified apart and up to the same limit, in the scale of the same
/// box, have about the density of one that is simplified whole, whatever their sizes: see
/// vertex_is_shared_map and bounding_box in parameters.h. A target of faces can't do that: what a
/// piece can't reach beside vertices that stay, it would destroy.
///
/// Not checked: the limit of a cost of lengths beyond about 10^±60 is no double any more.
class CostLimit {
public:
  /// `cost` is at least 0; infinity: no limit.
  explicit CostLimit(double cost) : cost_(cost) {}

  /// Looks at Status::next_cost: see StopPolicy.
  static constexpr Needs needs = {.cost = true};

  /// Is it enough?
  bool operator()(const Status& status) const { return status.next_cost > cost_; }

  double cost() const { return cost_; } ///< the limit

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const {
    if (!(cost_ >= 0))
      throw std::invalid_argument("quadrille::CostLimit: the limit " + internal::text_of(cost_) +
                                  " is not a cost");
  }

private:
  double cost_;
};

} // namespace quadrille

#endif // QUADRILLE_STOP_H
