#ifndef QUADRILLE_INTERNAL_CONTRACTION_DISTANCE_CHECK_H
#define QUADRILLE_INTERNAL_CONTRACTION_DISTANCE_CHECK_H

#include <quadrille/internal/complex/link_condition.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/checks.h>
#include <quadrille/internal/contraction/contraction.h>
#include <quadrille/internal/distance/distance_bounds.h>
#include <quadrille/internal/evaluation/pair_evaluator.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/internal/surface/scale.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

template <class Policies>
struct DistanceCalls;

/// Would a contraction take the surface so far from the input that the stop policy stops? At a
/// distance of 0 it does not.
template <class Policies>
class DistanceCheck {
public:
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Candidate = internal::Candidate<Cost>;
  using Contraction = internal::Contraction<Cost>;

  DistanceCheck(const Policies& policies, const Scale<dimension>& scale,
                const TriangleComplex& complex, const Geometry<dimension>& geometry,
                const LinkCondition& link_condition, const DistanceBounds& bounds,
                const PairEvaluator<Policies>& evaluator, const Checks<Policies>& checks)
      : policies_(policies), scale_(scale), complex_(complex), geometry_(geometry),
        link_condition_(link_condition), bounds_(bounds), evaluator_(evaluator), checks_(checks) {}

  /// If not, the status tells how far, and the bounds of the contraction are those of the faces
  /// that it changes.
  ///
  /// A target that leaves the surface by next to nothing gives way to an end that does not leave it
  /// at all: else such distances add up along straight creases and at corners.
  bool is_too_far(Contraction& contraction, Status& status) const {
    return policies_.optional.distances->is_too_far(*this, contraction, status);
  }

  /// What is known of the surface as it is. Does each point of the input have a place on it?
  void tell(Report& report, bool has_all_points) const {
    const double unit = bounds_.greatest_tolerance();
    report.distance_bound = scale_.length_of_mesh(unit * bounds_.greatest(complex_));
    if (policies_.stop.needs().distance_back && has_all_points)
      report.hausdorff_bound = (std::max)(
          report.distance_bound, scale_.length_of_mesh(unit * bounds_.greatest_back(complex_)));
    if (bounds_.has_tolerances() && has_all_points)
      tell_tolerance(report);
  }

  /// Is it certain, by a look at one of very many faces? Then the star need not be gathered.
  bool is_beyond_hub(const Candidate& candidate, Scratch& scratch, const Status& status) const {
    return policies_.optional.distances->is_beyond_hub(*this, candidate, scratch, status);
  }

private:
  template <class P, bool may_ask_both_ways>
  friend const DistanceCalls<P>* distance_calls();

  bool measure_too_far(Contraction& contraction, Status& status) const {
    StarTolerance& tolerance = contraction.scratch().distance.tolerance;
    tolerance = bounds_.tolerance_of(contraction.star());
    const auto stops = [&](const FaceDeviation& deviation) {
      tell_distance(status, deviation.from_input, tolerance);
      return policies_.stop(status);
    };
    const FaceDeviation deviation = measure(contraction, status);
    if (!is_next_to_nothing(deviation, contraction) || contraction.star().hub != none ||
        geometry_.is_fixed(contraction.first()) || geometry_.is_fixed(contraction.second()))
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

  // The same, and behind it, if both count, of the distance from the input to the surface.
  bool measure_too_far_both_ways(Contraction& contraction, Status& status) const {
    if (measure_too_far(contraction, status))
      return true;
    if (!policies_.stop.needs().distance_back)
      return false;
    auto& scratch = contraction.scratch().distance;
    const double used = status.next_tolerance;
    const auto stops = [&](double distance) {
      status.next_distance_back = told(distance, scratch.tolerance);
      if (scratch.tolerance.is_given)
        status.next_tolerance = (std::max)(used, scratch.tolerance.bound_of(distance));
      return policies_.stop(status);
    };
    return stops(bounds_.measure_back(contraction.star(),
                                      kind_of_star(contraction.first(), contraction.second()),
                                      scratch.tolerance, scratch.deviation, scratch.back, stops));
  }

  // How much of them is used, and in which face most.
  void tell_tolerance(Report& report) const {
    const Index face = bounds_.most_used(complex_);
    if (face == none)
      return;
    Vector<3> middle{};
    for (Index v : complex_.vertices(face))
      middle += 1. / 3 * space(scale_.position_of_mesh(geometry_.positions()[v]));
    report.used_tolerance = Report::UsedTolerance{bounds_.used(face), middle.coordinates};
  }

  bool look_beyond_hub(const Candidate& candidate, Scratch& scratch, const Status& status) const {
    return bounds_.is_beyond_hub(
        complex_, candidate.first, candidate.second, geometry_.positions(), space(candidate.target),
        scratch.distance.faces_too_far,
        [this](Index v) { return link_condition_.may_be_junction(v); },
        [this, after = status](double distance, const StarTolerance& tolerance) mutable {
          tell_distance(after, distance, tolerance);
          return policies_.stop(after);
        });
  }

  // In the engine's unit.
  FaceDeviation measure(const Contraction& contraction, const Status& status) const {
    const Index a = contraction.first(), b = contraction.second();
    auto& scratch = contraction.scratch().distance;
    const auto stops_beyond = [&, after = status](double distance) mutable {
      tell_distance(after, distance, scratch.tolerance);
      return policies_.stop(after);
    };
    return bounds_.measure(contraction.star(), a, b, geometry_.positions(),
                           space(contraction.target()), kind_of_star(a, b), scratch.tolerance,
                           scratch.deviation, contraction.bounds(), stops_beyond);
  }

  StarKind kind_of_star(Index a, Index b) const {
    const LinkCondition& link = link_condition_;
    if (!link.is_interior(a) || !link.is_interior(b))
      return StarKind::any;
    return link.is_oriented(a) && link.is_oriented(b) ? StarKind::oriented : StarKind::closed;
  }

  // How far the surface will be from the input.
  void tell_distance(Status& status, double distance, const StarTolerance& tolerance) const {
    status.next_distance = told(distance, tolerance);
    if (tolerance.is_given)
      status.next_tolerance = tolerance.bound_of(distance);
  }
  // What may be nothing but rounding is 0. Of a tolerance a part is known, and the distance is at
  // most that part of the greatest.
  double told(double distance, const StarTolerance& tolerance) const {
    if (distance <= bounds_.rounding())
      return 0;
    return scale_.length_of_mesh(tolerance.distance_of(tolerance.bound_of(distance)));
  }

  // Many of them do not add up to more than rounding.
  bool is_nothing(const FaceDeviation& deviation) const {
    return deviation.from_star <= bounds_.rounding() / 64;
  }
  bool is_next_to_nothing(const FaceDeviation& deviation, const Contraction& contraction) const {
    return !is_nothing(deviation) &&
           deviation.from_star <=
               next_to_nothing * contraction.scratch().distance.deviation.extent();
  }
  static constexpr double next_to_nothing = 0x1p-20;

  const Policies& policies_;
  const Scale<dimension>& scale_;
  const TriangleComplex& complex_;
  const Geometry<dimension>& geometry_;
  const LinkCondition& link_condition_;
  const DistanceBounds& bounds_;
  const PairEvaluator<Policies>& evaluator_;
  const Checks<Policies>& checks_;
};

/// What a DistanceCheck does is compiled where the type of a stop policy may ask for it.
template <class Policies>
struct DistanceCalls {
  using Check = DistanceCheck<Policies>;
  using Contraction = typename Check::Contraction;
  using Candidate = typename Check::Candidate;

  bool (*is_too_far)(const Check&, Contraction&, Status&);
  bool (*is_beyond_hub)(const Check&, const Candidate&, Scratch&, const Status&);
};

template <class Policies, bool may_ask_both_ways>
const DistanceCalls<Policies>* distance_calls() {
  using Calls = DistanceCalls<Policies>;
  static constexpr Calls calls{
      [](const typename Calls::Check& check, typename Calls::Contraction& contraction,
         Status& status) {
        if constexpr (may_ask_both_ways)
          return check.measure_too_far_both_ways(contraction, status);
        else
          return check.measure_too_far(contraction, status);
      },
      [](const typename Calls::Check& check, const typename Calls::Candidate& candidate,
         Scratch& scratch,
         const Status& status) { return check.look_beyond_hub(candidate, scratch, status); }};
  return &calls;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_DISTANCE_CHECK_H
