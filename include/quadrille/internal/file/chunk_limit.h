#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_LIMIT_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_LIMIT_H

#include <quadrille/distance_limits.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/report.h>
#include <quadrille/stop.h>

#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

/// \file
/// Distance limits for out-of-core surfaces: each chunk gets the limit in addition to the end of
/// its phase, and the distances that its faces have used are passed on from phase to phase.

namespace quadrille::internal {

/// A DistanceLimit, HausdorffLimit or ToleranceLimit that is chosen at run time.
class DistanceChoice {
public:
  enum class Kind { one_way, both_ways, tolerances };

  /// Tolerances have no number.
  explicit DistanceChoice(Kind kind, double number = 0, bool is_relative = false)
      : kind_(kind), number_(number), is_relative_(is_relative) {}

  static constexpr Needs needs = {.tolerance = true};
  Needs needs_now() const {
    return {.distance = true,
            .reverse_distance = kind_ == Kind::both_ways,
            .tolerance = kind_ == Kind::tolerances};
  }

  Kind kind() const { return kind_; }
  double distance(double diagonal) const { return is_relative_ ? number_ * diagonal : number_; }
  bool operator()(const Status& status) const {
    if (kind_ == Kind::tolerances)
      return ToleranceLimit{}(status);
    const double limit = distance(status.diagonal);
    return status.next_distance > limit ||
           (kind_ == Kind::both_ways && status.next_reverse_distance > limit);
  }

private:
  Kind kind_;
  double number_;
  bool is_relative_;
};

/// Returns a limit as a tuple of one element, or an empty tuple for any other policy. Policies may
/// include one limit, or a std::optional of one.
template <class Policy>
auto limit_as_tuple(const Policy& policy) {
  if constexpr (needs_of<Policy>().distance)
    return std::tuple<Policy>(policy);
  else
    return std::tuple<>();
}
template <class Policy>
auto other_as_tuple(const Policy& policy) {
  if constexpr (needs_of<Policy>().distance)
    return std::tuple<>();
  else
    return std::tuple<Policy>(policy);
}

/// A limit in a chunk, which applies with the size of the whole surface.
template <class Limit>
struct LimitInChunk {
  static constexpr Needs needs = needs_of<Limit>();

  Limit limit;
  double diagonal; ///< the diagonal of the whole surface

  Needs needs_now() const { return internal::needs_now(limit); }
  bool operator()(Status status) const {
    status.diagonal = diagonal;
    return limit(status);
  }
};

/// Returns a limit, if it is given, in a chunk of a surface with that diagonal.
template <class Limit>
auto limit_in_chunk(const Limit& limit, double diagonal) {
  if constexpr (IsOptional<Limit>)
    return limit ? std::optional(limit_in_chunk(*limit, diagonal)) : std::nullopt;
  else
    return LimitInChunk<Limit>{limit, diagonal};
}

/// Separates a target into its faces and its distances. The first is a FaceCount or a FaceRatio, of
/// no faces if the target does not mention faces; the second is a tuple of a limit, or an empty
/// one.
template <class Stop>
auto faces_and_limit(const Stop& stop) {
  static_assert(!IsOptional<Stop>,
                "quadrille::simplify_file: a std::optional alone is not a target: combine an "
                "optional limit with a count, as in AnyOf{FaceRatio{0.5}, limit}.");
  if constexpr (needs_of<Stop>().distance)
    return std::pair(FaceCount{0}, std::tuple<Stop>(stop));
  else
    return std::pair(stop, std::tuple<>());
}
template <class First, class Second>
auto faces_and_limit(const AnyOf<First, Second>& stop) {
  const auto& [first, second] = stop.stops();
  if constexpr (needs_of<First>().distance)
    return std::pair(second, std::tuple<First>(first));
  else
    return std::pair(first, std::tuple<Second>(second));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_LIMIT_H
