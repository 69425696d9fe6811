// It includes <quadrille/calibrated.h>, which includes GPL parts of CGAL.
#include "calibration.h"

#include <quadrille/calibrated.h>

#include <optional>

namespace quadrille_examples {

namespace {

using namespace quadrille;

SoupOptions times(SoupOptions options, double factor) {
  for (std::optional<double>* limit : {&options.error, &options.relative_error})
    if (*limit)
      **limit *= factor;
  return options;
}

} // namespace

SoupResult calibrated_soup(const SoupView& soup, const SoupOptions& options) {
  const internal::CheckedSurface input = internal::checked_surface(soup.points, soup.triangles);
  const double distance =
      internal::distance_of(options.error ? HausdorffLimit{*options.error}
                                          : HausdorffLimit::relative(*options.relative_error),
                            input);
  bool is_cancelled = false;
  const auto run = [&](double factor) {
    if (is_cancelled)
      return SoupResult{}; // of which nothing is proved
    SoupResult result = simplified_soup(soup, times(options, factor));
    is_cancelled = result.report.stop == StopReason::cancelled;
    return result;
  };
  return internal::calibrate(
      distance, Calibration{}, run, [&](const SoupResult& coarse, double error) {
        return internal::proved_distance(
            input, internal::checked_surface(coarse.points, coarse.triangles), distance, error);
      });
}

} // namespace quadrille_examples
