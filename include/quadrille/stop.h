#ifndef QUADRILLE_STOP_H
#define QUADRILLE_STOP_H

#include <quadrille/cost_limit.h>
#include <quadrille/internal/base/text.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/report.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace quadrille {

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
  void validate() const {
    if (!(ratio >= 0 && ratio <= 1))
      throw std::invalid_argument("quadrille::FaceRatio: the ratio " + internal::text_of(ratio) +
                                  " is not in [0, 1]");
  }
};

/// Stops at `vertices` vertices.
struct VertexCount {
  std::size_t vertices; ///< how many are enough

  /// Is it enough?
  bool operator()(const Status& status) const { return status.vertices <= vertices; }
  /// Is the surface beyond the target and not just at it? See StopPolicy.
  bool is_passed(const Status& status) const { return status.vertices < vertices; }
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

/// Takes no contraction that might leave a point of the surface further from the input than a
/// limit, and stops when there is none left that does not. The result is within the limit:
/// Report::distance_bound says how far at most.
///
/// The bound is conservative. It adds up what each contraction moves the surface, so a result is
/// often twice as close to the input as it says, or more. A border counts by how far it moves away
/// from itself, to either side: to slide along a straight one costs nothing, and none recedes
/// further than the limit.
///
/// Distances up to 2⁻⁴⁰ of the greatest coordinate, about 10⁻¹², may be nothing but the sum of
/// roundings, and pass any limit: ErrorLimit{0} contracts what is exact but for these, as on flat
/// parts and along straight creases. Report::distance_bound tells them nevertheless.
///
/// A stop policy that asks one of these has to say asks_for_distance as well, else nothing is known
/// to be within the limit and not one contraction is done. A policy of one's own that looks at
/// Status::next_distance may be asked several times for one contraction, with distances that it has
/// at least; where it stops at one it has to stop at all greater ones. Source: the projection along
/// the mean normal is that of Bajaj and Schikore 1996.
class ErrorLimit {
public:
  /// `distance` is in the mesh's units.
  explicit ErrorLimit(double distance) : distance_(distance) {}

  /// The limit as a fraction of the diagonal of the bounding box.
  static ErrorLimit relative(double fraction) {
    ErrorLimit limit(fraction);
    limit.is_relative_ = true;
    return limit;
  }

  /// Looks at Status::next_distance: see StopPolicy.
  static constexpr bool asks_for_distance = true;

  /// Is it enough?
  bool operator()(const Status& status) const {
    return status.next_distance > (is_relative_ ? distance_ * status.diagonal : distance_);
  }

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const {
    if (!(distance_ >= 0))
      throw std::invalid_argument("quadrille::ErrorLimit: the limit " +
                                  internal::text_of(distance_) + " is not a distance");
  }

private:
  double distance_;
  bool is_relative_ = false;
};

/// The same both ways: no point of the result will be further from the input than the limit, and no
/// point of the input further from the result. Nothing within the limit of the result is lost,
/// neither spikes nor borders; and their Hausdorff distance is within it, as
/// Report::hausdorff_bound says.
///
/// Beside what ErrorLimit does each face knows how far the input points may be that have come to
/// lie in it, which takes 4 bytes more for each. That adds up, too, and what is exact costs
/// nothing: flat parts, straight borders and creases. A contraction that leaves points of the input
/// without any face, which only a free topology allows, is refused, and so is a part that would
/// vanish. Of the input, faces that have a vertex twice are no part.
///
/// One of ErrorLimit's roundings passes any limit here as well. A stop policy that asks this one
/// has to say asks_both_ways beside asks_for_distance.
class HausdorffLimit {
public:
  /// `distance` is in the mesh's units.
  explicit HausdorffLimit(double distance) : distance_(distance) {}

  /// The limit as a fraction of the diagonal of the bounding box.
  static HausdorffLimit relative(double fraction) {
    HausdorffLimit limit(fraction);
    limit.is_relative_ = true;
    return limit;
  }

  /// Looks at Status::next_distance: see StopPolicy.
  static constexpr bool asks_for_distance = true;
  /// And at Status::next_distance_back.
  static constexpr bool asks_both_ways = true;

  /// Is it enough?
  bool operator()(const Status& status) const {
    const double limit = distance(status.diagonal);
    return status.next_distance > limit || status.next_distance_back > limit;
  }

  /// In the mesh's units, for a bounding box of that diagonal.
  double distance(double diagonal) const { return is_relative_ ? distance_ * diagonal : distance_; }
  /// Another limit, so many times as large.
  HausdorffLimit times(double factor) const {
    HausdorffLimit limit = *this;
    limit.distance_ *= factor;
    return limit;
  }

  /// Throws std::invalid_argument for a limit that is negative or not a number.
  void validate() const {
    if (!(distance_ >= 0))
      throw std::invalid_argument("quadrille::HausdorffLimit: the limit " +
                                  internal::text_of(distance_) + " is not a distance");
  }

private:
  double distance_;
  bool is_relative_ = false;
};

/// The same where the limit varies: each face of the input has a tolerance, the least of those of
/// its corners, which the named parameter vertex_tolerance_map tells (SoupOptions::tolerance). No
/// point of an input face will be further than its tolerance from the result, and each point of the
/// result is near to some input face, within the tolerance of that. Where it is 0 nothing moves but
/// within its plane, or along its straight crease or border.
///
/// What counts is the part of its tolerance that each face has used: a contraction that moves the
/// surface by h uses h/τ more of it, where τ is the least tolerance around, so a small tolerance
/// reaches a few faces of the result beyond its own. As conservative as HausdorffLimit, which is
/// the case that all tolerances are the same; source of the sum: the composition of mappings,
/// Cohen, Manocha and Olano 1997.
///
/// In a call with it, Status::next_distance and Report::distance_bound are that part of the
/// greatest tolerance of all, which is a bound, and a coarse one: for a limit beside it, lower the
/// tolerances. It needs vertex_tolerance_map, and that needs it, else simplify throws
/// std::invalid_argument. 4 bytes a face more than HausdorffLimit.
class ToleranceLimit {
public:
  /// Looks at Status::next_distance: see StopPolicy.
  static constexpr bool asks_for_distance = true;
  /// And at Status::next_distance_back.
  static constexpr bool asks_both_ways = true;
  /// And at Status::next_tolerance.
  static constexpr bool asks_for_tolerance = true;

  /// Is it enough?
  bool operator()(const Status& status) const { return status.next_tolerance > 1; }
};

/// Stops as soon as any of several stop policies says so: `AnyOf{FaceCount{1000},
/// ErrorLimit{0.1}}`.
template <class... Stops>
class AnyOf {
public:
  /// Looks at Status::next_distance: see StopPolicy.
  static constexpr bool asks_for_distance = (internal::asks_for_distance<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_for_distance() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_for_distance(stop) || ...); },
        stops_);
  }
  /// Looks at Status::next_cost: see StopPolicy.
  static constexpr bool asks_for_cost = (internal::asks_for_cost<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_for_cost() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_for_cost(stop) || ...); }, stops_);
  }
  /// And at Status::next_distance_back.
  static constexpr bool asks_both_ways = (internal::asks_both_ways<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_both_ways() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_both_ways(stop) || ...); }, stops_);
  }
  /// And at Status::next_tolerance.
  static constexpr bool asks_for_tolerance = (internal::asks_for_tolerance<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_for_tolerance() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_for_tolerance(stop) || ...); },
        stops_);
  }

  explicit AnyOf(Stops... stops) : stops_(std::move(stops)...) {} ///< stop policies of any type

  /// Is it enough?
  bool operator()(const Status& status) const {
    return std::apply([&](const auto&... stop) -> bool { return (stop(status) || ...); }, stops_);
  }
  /// Is the surface beyond the target and not just at it? See StopPolicy.
  bool is_passed(const Status& status) const {
    return std::apply(
        [&](const auto&... stop) { return (internal::is_passed(stop, status) || ...); }, stops_);
  }
  /// Throws what the policies throw that make no sense.
  void validate() const {
    std::apply([](const auto&... stop) { (internal::validate(stop), ...); }, stops_);
  }

private:
  std::tuple<Stops...> stops_;
};

/// Stops when all of several stop policies say so.
template <class... Stops>
class AllOf {
public:
  /// Looks at Status::next_distance: see StopPolicy.
  static constexpr bool asks_for_distance = (internal::asks_for_distance<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_for_distance() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_for_distance(stop) || ...); },
        stops_);
  }
  /// Looks at Status::next_cost: see StopPolicy.
  static constexpr bool asks_for_cost = (internal::asks_for_cost<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_for_cost() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_for_cost(stop) || ...); }, stops_);
  }
  /// And at Status::next_distance_back.
  static constexpr bool asks_both_ways = (internal::asks_both_ways<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_both_ways() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_both_ways(stop) || ...); }, stops_);
  }
  /// And at Status::next_tolerance.
  static constexpr bool asks_for_tolerance = (internal::asks_for_tolerance<Stops> || ...);
  /// Does one of the policies do so this time?
  bool is_asking_for_tolerance() const {
    return std::apply(
        [](const auto&... stop) { return (internal::is_asking_for_tolerance(stop) || ...); },
        stops_);
  }

  explicit AllOf(Stops... stops) : stops_(std::move(stops)...) {} ///< stop policies of any type

  /// Is it enough?
  bool operator()(const Status& status) const {
    return std::apply([&](const auto&... stop) -> bool { return (stop(status) && ...); }, stops_);
  }
  /// Is the surface beyond the target and not just at it? See StopPolicy.
  bool is_passed(const Status& status) const {
    return std::apply(
        [&](const auto&... stop) { return (internal::is_passed(stop, status) && ...); }, stops_);
  }
  /// Throws what the policies throw that make no sense.
  void validate() const {
    std::apply([](const auto&... stop) { (internal::validate(stop), ...); }, stops_);
  }

private:
  std::tuple<Stops...> stops_;
};

} // namespace quadrille

#endif // QUADRILLE_STOP_H
