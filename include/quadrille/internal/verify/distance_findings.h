#ifndef QUADRILLE_INTERNAL_VERIFY_DISTANCE_FINDINGS_H
#define QUADRILLE_INTERNAL_VERIFY_DISTANCE_FINDINGS_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/verdict.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace quadrille::internal {

/// What is found of claimed distances, whatever measures them.
class DistanceFindings {
public:
  /// `diagonal` is that of both surfaces.
  DistanceFindings(Verdict& verdict, double diagonal) : verdict_(verdict), diagonal_(diagonal) {}

  static void require_sense(const Claims& claims) {
    if (!(claims.distance.value_or(0) >= 0 && claims.distance_both_ways.value_or(0) >= 0))
      throw std::invalid_argument("quadrille::verify: the claim is not a distance");
  }

  /// The least that is claimed, of the result.
  static double least(const Claims& claims) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return (std::min)(claims.distance.value_or(infinity),
                      claims.distance_both_ways.value_or(infinity));
  }

  /// Looks at what is claimed of distances. Distance has diagonal_of_both(), of_result(error) and
  /// of_input(error), as CheckedDistance.
  template <class Distance>
  static void look(const Claims& claims, const Distance& distance, CheckProgress& progress,
                   Verdict& verdict) {
    DistanceFindings findings(verdict, distance.diagonal_of_both());
    findings.add("distance of the result from the input", least(claims), least(claims),
                 [&](double error) { return distance.of_result(error); });
    progress.next_stage();
    if (!claims.distance_both_ways)
      return;
    const double promised = *claims.distance_both_ways;
    findings.add("distance of the input from the result", promised, promised,
                 [&](double error) { return distance.of_input(error); });
    progress.next_stage();
  }

  /// Looks whether tolerances are kept. Distance has least_tolerance() as well.
  template <class Distance>
  static void look_at_tolerances(const Distance& distance, CheckProgress& progress,
                                 Verdict& verdict) {
    DistanceFindings findings(verdict, distance.diagonal_of_both());
    findings.add("distance of the input from the result, beyond its tolerances", 0,
                 distance.least_tolerance(),
                 [&](double error) { return distance.of_input(error); });
    progress.next_stage();
    findings.add("distance of the result from the input, beyond its tolerances", 0,
                 distance.least_tolerance(),
                 [&](double error) { return distance.of_result(error); });
    progress.next_stage();
  }

  /// `measure(error)` tells no more than the truth but for roundings, and less by no more than the
  /// error, of which half of what a finding may be wrong is enough. So what is beyond the promise
  /// by that is broken, and what is broken by twice as much is found. It takes the longer the less
  /// it may be wrong, so a small part of `small`, the promise say, is enough.
  template <class Measure>
  void add(const char* claim, double promised, double small, Measure measure) {
    const double error = (std::max)((std::min)(small / 20, 1e-3 * diagonal_), 1e-5 * diagonal_);
    const auto [measured, place] = measure(error / 2);
    verdict_.findings.push_back(
        {claim, promised, measured, error, measured <= promised + error / 2, place});
  }

private:
  Verdict& verdict_;
  double diagonal_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_DISTANCE_FINDINGS_H
