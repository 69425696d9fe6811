#ifndef QUADRILLE_INTERNAL_VERIFY_DISTANCE_FINDINGS_H
#define QUADRILLE_INTERNAL_VERIFY_DISTANCE_FINDINGS_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/verdict.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace quadrille::internal {

/// Collects the findings on claimed distances, however these are measured.
class DistanceFindings {
public:
  /// `diagonal` is the diagonal of the box around both surfaces.
  DistanceFindings(Verdict& verdict, double diagonal) : verdict_(verdict), diagonal_(diagonal) {}

  static void require_sense(const Claims& claims) {
    if (!(claims.distance.value_or(0) >= 0 && claims.distance_both_ways.value_or(0) >= 0))
      throw std::invalid_argument(
          "quadrille::verify: the claimed distance is negative or not a number");
  }

  /// Returns the least distance that is claimed of the result.
  static double least(const Claims& claims) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return (std::min)(claims.distance.value_or(infinity),
                      claims.distance_both_ways.value_or(infinity));
  }

  /// Checks the claimed distances. Distance has diagonal_of_both(), of_result(error) and
  /// of_input(error), as CheckedDistance has.
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

  /// Checks whether the tolerances are kept. Distance must have least_tolerance() as well.
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

  /// `measure(error)` returns at most the true value, except for rounding, and is less than it by
  /// at most the error; this error is half of the inaccuracy that a finding may have. So a value
  /// that exceeds the promise by that error is a violation, and every violation of twice that size
  /// is found. A smaller error takes longer, so a small fraction of `small`, which may be the
  /// promise, is used.
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
