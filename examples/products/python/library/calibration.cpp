#include "package.h"

#include "../../program/calibrated.h"

#include <quadrille/c/call.h>
#include <quadrille/distance_limits.h>

#include <optional>

namespace {

using namespace quadrille;

SoupOptions times(SoupOptions options, double factor) {
  for (std::optional<double>* limit : {&options.error, &options.relative_error})
    if (*limit)
      **limit *= factor;
  return options;
}

/// Simplifies with multiples of the limit, of which one is given, and returns the coarsest result
/// that is proved to be within it; if options.proceed says no, the coarsest until then.
SoupResult calibrated_soup(const SoupView& soup, const SoupOptions& options) {
  namespace calibrations = quadrille_examples::calibrations;
  const auto surface_of = [](const auto& of) {
    return internal::checked_surface("quadrille::calibrated", of.points, of.triangles);
  };
  const TriangleSoup<> input = surface_of(soup);
  const HausdorffLimit limit = options.error ? HausdorffLimit{*options.error}
                                             : HausdorffLimit::relative(*options.relative_error);
  bool is_cancelled = false;
  const auto run = [&](double factor) {
    if (is_cancelled)
      return SoupResult{}; // of which nothing is proved
    SoupResult result = simplified_soup(soup, times(options, factor));
    is_cancelled = result.report.stop == StopReason::cancelled;
    return result;
  };
  return calibrations::calibrate(input, calibrations::distance_of(limit, input), {}, run,
                                 surface_of);
}

} // namespace

extern "C" int32_t quadrille_simplify_calibrated(quadrille_call* call) {
  return internal::run_call(*call, calibrated_soup);
}
