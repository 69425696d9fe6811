#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_DISTANCE_CHECK_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_DISTANCE_CHECK_H

#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/checks.h>
#include <quadrille/internal/core/contraction/measured_distances.h>
#include <quadrille/internal/core/evaluation/pair_evaluator.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/face_bound.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/internal/guards/distance/distance_bounds.h>
#include <quadrille/internal/guards/distance/recent_faces.h>
#include <quadrille/internal/guards/distance/reverse_deviation.h>
#include <quadrille/internal/guards/distance/star_deviation.h>
#include <quadrille/internal/guards/distance/tolerances.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::internal {

/// The scratch space of a check of distances, for each thread.
struct DistanceScratch {
  StarDeviation deviation;
  ReverseDeviation reverse;
  RecentFaces faces_too_far;
  StarTolerance tolerance;   // of the star
  std::vector<float> bounds; // of the faces that the contraction changes, see DistanceBounds
};

/// Measures each contraction before it is done, and keeps what is known of each face. At a distance
/// of 0 the stop policy does not stop. `both_ways`: may the type of the stop policy need that?
template <class Policies, bool both_ways>
class DistanceCheck final : public MeasuredDistances<Policies> {
public:
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Candidate = internal::Candidate<Cost>;
  using Contraction = internal::Contraction<Cost>;

  explicit DistanceCheck(const DistanceNeeds<Policies>& needs)
      : state_(needs.state), evaluator_(needs.evaluator), checks_(needs.checks),
        bounds_(state_.complex.face_capacity(), greatest_coordinate(needs.box),
                state_.policies.stop.needs().reverse_distance, tolerances_of(needs.tolerances)),
        scratches_(state_.policies.threads) {
    if (state_.policies.optional.bounds)
      bounds_.take_given(*state_.policies.optional.bounds, given_tolerance(), state_.complex,
                         state_.numbering.faces);
  }

  /// A target that leaves the surface by next to nothing gives way to an end that does not leave it
  /// at all: else such distances add up along straight creases and at corners.
  bool is_too_far(Contraction& contraction, Status& status) override {
    if constexpr (both_ways)
      return measure_too_far_both_ways(contraction, status);
    else
      return measure_too_far(contraction, status);
  }

  bool is_beyond_high_valence(const Candidate& candidate, const Scratch& scratch,
                              const Status& status) override {
    return bounds_.is_beyond_high_valence(
        state_.complex, candidate.first, candidate.second, state_.geometry.positions(),
        space(candidate.target), scratches_[scratch.number].faces_too_far,
        [this](Index v) { return state_.link_condition.may_be_junction(v); },
        [this, after = status](double distance, const StarTolerance& tolerance) mutable {
          announce_distance(after, distance, tolerance);
          return state_.policies.stop(after);
        });
  }

  double bound_of(const Contraction& contraction) const override {
    const auto greatest = [](const std::vector<float>& values) {
      float result = 0;
      for (float value : values)
        result = (std::max)(result, value);
      return static_cast<double>(result);
    };
    const DistanceScratch& scratch = scratches_[contraction.scratch().number];
    double bound = greatest(scratch.bounds);
    if (state_.policies.stop.needs().reverse_distance)
      bound =
          scratch.reverse.is_any_lost()
              ? std::numeric_limits<double>::infinity()
              : (std::max)(bound, scratch.tolerance.bound_of(greatest(scratch.reverse.bounds())));
    return state_.scale.length_of_mesh(scratch.tolerance.distance_of(bound));
  }

  void follow(const Contraction& contraction) override {
    const DistanceScratch& scratch = scratch_of(contraction);
    bounds_.set(contraction.star(), scratch.bounds);
    if (state_.policies.stop.needs().reverse_distance) {
      bounds_.set_reverse(contraction.star(), scratch.reverse.bounds(), scratch.tolerance);
      contraction.scratch().counters.loses_points |= scratch.reverse.is_any_lost();
    }
  }
  void pack() override {
    bounds_.pack_if([this](Index face) { return !state_.complex.is_removed(face); });
  }

  void write_to(Report& report, bool has_all_points) const override {
    const double unit = bounds_.greatest_tolerance();
    report.distance_bound = state_.scale.length_of_mesh(unit * bounds_.greatest(state_.complex));
    if (state_.policies.stop.needs().reverse_distance && has_all_points)
      report.hausdorff_bound =
          (std::max)(report.distance_bound,
                     state_.scale.length_of_mesh(unit * bounds_.greatest_reverse(state_.complex)));
    if (bounds_.has_tolerances() && has_all_points)
      write_tolerance(report);
  }
  void write_bounds(std::vector<FaceBound>& bounds) const override {
    bounds_.write_to(bounds, state_.complex, state_.numbering.faces);
  }

private:
  // The greatest coordinate of a surface in a box, in the engine's unit.
  double greatest_coordinate(const Box<dimension>& box) const {
    double greatest = 0;
    for (const Vector<dimension>& p : state_.scale.scaled(std::array{box.low, box.high}))
      for (std::size_t i = 0; i < 3; ++i)
        greatest = (std::max)(greatest, std::abs(p[i]));
    return greatest;
  }
  // Returns the tolerances of faces, in the engine's unit; none if there are none.
  Tolerances tolerances_of(std::vector<double> of_vertex) const {
    if (of_vertex.empty())
      return {};
    for (double& tolerance : of_vertex)
      tolerance = state_.scale.length_from_mesh(tolerance);
    return {state_.complex, of_vertex, 2 * state_.scale.length_from_mesh(state_.scale.diagonal())};
  }
  // In the engine's unit, if bounds have tolerances.
  std::optional<double> given_tolerance() const {
    const std::optional<double>& greatest = state_.policies.optional.greatest_tolerance;
    return greatest ? std::optional(state_.scale.length_from_mesh(*greatest)) : std::nullopt;
  }

  DistanceScratch& scratch_of(const Contraction& contraction) {
    return scratches_[contraction.scratch().number];
  }

  bool measure_too_far(Contraction& contraction, Status& status) {
    StarTolerance& tolerance = scratch_of(contraction).tolerance;
    tolerance = bounds_.tolerance_of(contraction.star());
    const auto stops = [&](const FaceDeviation& deviation) {
      announce_distance(status, deviation.from_input, tolerance);
      return state_.policies.stop(status);
    };
    const FaceDeviation deviation = measure(contraction, status);
    if (!is_next_to_nothing(deviation, contraction) || contraction.star().high_valence != none ||
        state_.geometry.is_fixed(contraction.first()) ||
        state_.geometry.is_fixed(contraction.second()))
      return stops(deviation);
    const Candidate wanted = contraction.candidate();
    for (const Candidate& end : evaluator_.at_ends(wanted)) {
      contraction.replace(end);
      if (checks_.rejection(contraction))
        continue;
      if (const FaceDeviation of_end = measure(contraction, status);
          is_nothing(of_end) && !stops(of_end))
        return false;
    }
    contraction.replace(wanted);
    return stops(measure(contraction, status));
  }

  // Measures the same and, after it, the distance from the input to the surface, if both count.
  bool measure_too_far_both_ways(Contraction& contraction, Status& status) {
    if (measure_too_far(contraction, status))
      return true;
    if (!state_.policies.stop.needs().reverse_distance)
      return false;
    DistanceScratch& scratch = scratch_of(contraction);
    const double used = status.next_tolerance;
    const auto stops = [&](double distance) {
      status.next_reverse_distance = reported(distance, scratch.tolerance);
      if (scratch.tolerance.is_given)
        status.next_tolerance = (std::max)(used, scratch.tolerance.bound_of(distance));
      return state_.policies.stop(status);
    };
    return stops(bounds_.measure_reverse(
        contraction.star(), kind_of_star(contraction.first(), contraction.second()),
        scratch.tolerance, scratch.deviation, scratch.reverse, stops));
  }

  // How much of them is used, and in which face most.
  void write_tolerance(Report& report) const {
    const Index face = bounds_.most_used(state_.complex);
    if (face == none)
      return;
    Vector<3> middle{};
    for (Index v : state_.complex.vertices(face))
      middle += 1. / 3 * space(state_.scale.position_of_mesh(state_.geometry.positions()[v]));
    report.used_tolerance = Report::UsedTolerance{bounds_.used(face), middle.coordinates};
  }

  // In the engine's unit.
  FaceDeviation measure(const Contraction& contraction, const Status& status) {
    const Index a = contraction.first(), b = contraction.second();
    DistanceScratch& scratch = scratch_of(contraction);
    const auto stops_beyond = [&, after = status](double distance) mutable {
      announce_distance(after, distance, scratch.tolerance);
      return state_.policies.stop(after);
    };
    return bounds_.measure(contraction.star(), a, b, state_.geometry.positions(),
                           space(contraction.target()), kind_of_star(a, b), scratch.tolerance,
                           scratch.deviation, scratch.bounds, stops_beyond);
  }

  StarKind kind_of_star(Index a, Index b) const {
    const LinkCondition& link = state_.link_condition;
    if (!link.is_interior(a) || !link.is_interior(b))
      return StarKind::any;
    return link.is_oriented(a) && link.is_oriented(b) ? StarKind::oriented : StarKind::closed;
  }

  // How far the surface will be from the input.
  void announce_distance(Status& status, double distance, const StarTolerance& tolerance) const {
    status.next_distance = reported(distance, tolerance);
    if (tolerance.is_given)
      status.next_tolerance = tolerance.bound_of(distance);
  }
  // Returns a distance for reports: 0 if it may be nothing but rounding. If there are tolerances,
  // `distance` is a fraction, and the result is at most that fraction of the greatest.
  double reported(double distance, const StarTolerance& tolerance) const {
    if (distance <= bounds_.rounding())
      return 0;
    return state_.scale.length_of_mesh(tolerance.distance_of(tolerance.bound_of(distance)));
  }

  // Many of them do not add up to more than rounding.
  bool is_nothing(const FaceDeviation& deviation) const {
    return deviation.from_star <= bounds_.rounding() / 64;
  }
  bool is_next_to_nothing(const FaceDeviation& deviation, const Contraction& contraction) {
    return !is_nothing(deviation) &&
           deviation.from_star <= next_to_nothing * scratch_of(contraction).deviation.extent();
  }
  static constexpr double next_to_nothing = 0x1p-20;

  const SurfaceState<Policies>& state_;
  const PairEvaluator<Policies>& evaluator_;
  const Checks<Policies>& checks_;
  DistanceBounds bounds_;
  std::vector<DistanceScratch> scratches_; // one for each thread
};

/// For OptionalModules.
template <class Policies, bool both_ways>
std::unique_ptr<MeasuredDistances<Policies>> make_distances(const DistanceNeeds<Policies>& needs) {
  return std::make_unique<DistanceCheck<Policies, both_ways>>(needs);
}

struct DistanceHeader {}; // it has been included

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_DISTANCE_CHECK_H
