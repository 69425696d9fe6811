#ifndef QUADRILLE_INTERNAL_FILE_PART_LIMIT_H
#define QUADRILLE_INTERNAL_FILE_PART_LIMIT_H

#include <quadrille/distance_limits.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/report.h>
#include <quadrille/stop.h>

#include <tuple>
#include <type_traits>
#include <utility>

/// \file
/// Limits of distances for surfaces in parts: they are told each part beside where its phase ends,
/// and what faces have used of them goes along from phase to phase.

namespace quadrille::internal {

/// ErrorLimit, HausdorffLimit, ToleranceLimit, or no limit, as is told at run time.
class DistanceChoice {
public:
  enum class Kind { unlimited, one_way, both_ways, tolerances };

  DistanceChoice() = default; ///< no limit
  /// Tolerances have no number.
  explicit DistanceChoice(Kind kind, double number = 0, bool is_relative = false)
      : kind_(kind), number_(number), is_relative_(is_relative) {}

  static constexpr bool asks_for_distance = true;
  static constexpr bool asks_both_ways = true;
  static constexpr bool asks_for_tolerance = true;
  bool is_asking_for_distance() const { return kind_ != Kind::unlimited; }
  bool is_asking_both_ways() const { return kind_ == Kind::both_ways || is_asking_for_tolerance(); }
  bool is_asking_for_tolerance() const { return kind_ == Kind::tolerances; }

  Kind kind() const { return kind_; }
  double distance(double diagonal) const { return is_relative_ ? number_ * diagonal : number_; }
  bool operator()(const Status& status) const {
    if (is_asking_for_tolerance())
      return ToleranceLimit{}(status);
    const double limit = distance(status.diagonal);
    return (is_asking_for_distance() && status.next_distance > limit) ||
           (is_asking_both_ways() && status.next_distance_back > limit);
  }

private:
  Kind kind_ = Kind::unlimited;
  double number_ = 0;
  bool is_relative_ = false;
};

/// Among policies there may be one limit; each of them as a tuple of what it is, or of nothing.
template <class Policy>
auto limit_as_tuple(const Policy& policy) {
  if constexpr (asks_for_distance<Policy>)
    return std::tuple<Policy>(policy);
  else
    return std::tuple<>();
}
template <class Policy>
auto other_as_tuple(const Policy& policy) {
  if constexpr (asks_for_distance<Policy>)
    return std::tuple<>();
  else
    return std::tuple<Policy>(policy);
}

/// A limit in a part, which is as large as the whole.
template <class Limit>
struct LimitInPart {
  static constexpr bool asks_for_distance = true;
  static constexpr bool asks_both_ways = internal::asks_both_ways<Limit>;
  static constexpr bool asks_for_tolerance = internal::asks_for_tolerance<Limit>;

  Limit limit;
  double diagonal; ///< of the whole

  bool is_asking_for_distance() const { return internal::is_asking_for_distance(limit); }
  bool is_asking_both_ways() const { return internal::is_asking_both_ways(limit); }
  bool is_asking_for_tolerance() const { return internal::is_asking_for_tolerance(limit); }
  bool operator()(Status status) const {
    status.diagonal = diagonal;
    return limit(status);
  }
};

/// What a target says of faces, and what of distances: the one is a FaceCount or a FaceRatio, of
/// no faces if nothing is said of them; the other a tuple of a limit, or of nothing.
template <class Stop>
auto faces_and_limit(const Stop& stop) {
  if constexpr (asks_for_distance<Stop>)
    return std::pair(FaceCount{0}, std::tuple<Stop>(stop));
  else
    return std::pair(stop, std::tuple<>());
}
template <class First, class Second>
auto faces_and_limit(const AnyOf<First, Second>& stop) {
  const auto& [first, second] = stop.stops();
  if constexpr (asks_for_distance<First>)
    return std::pair(second, std::tuple<First>(first));
  else
    return std::pair(first, std::tuple<Second>(second));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PART_LIMIT_H
