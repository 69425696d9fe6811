#include <quadrille/calibrated.h>
#include <quadrille/compiled/joined_soup.h>
#include <quadrille/compiled/prepared_soup.h>
#include <quadrille/compiled/presets.h>
#include <quadrille/compiled/soup_job.h>
#include <quadrille/distance_limits.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/report.h>
#include <quadrille/triangle_soup.h>

#include <optional>
#include <stdexcept>

namespace quadrille::internal {

namespace {

// Throws std::invalid_argument for options that do not go with a calibration.
void check_calibrated(const SoupJob& job) {
  if (!job.both_ways || job.error.has_value() == job.relative_error.has_value())
    throw std::invalid_argument("calibrated needs either error or relative_error, and both_ways");
  if (!job.tolerance.empty())
    throw std::invalid_argument("calibrated does not go with a tolerance");
  if (job.recorder)
    throw std::invalid_argument(
        "calibrated does not go with levels or maps: it needs several runs");
}

SoupOptions times(SoupOptions options, double factor) {
  for (std::optional<double>* limit : {&options.error, &options.relative_error})
    if (*limit)
      **limit *= factor;
  return options;
}

} // namespace

SoupResult calibrated_soup(const SoupView& soup, const SoupJob& given) {
  check_calibrated(given);
  SoupJob job = given;
  if (given.preset)
    static_cast<SoupOptions&>(job) = with_preset(given, soup);
  if (has_preparation(job) && job.split_vertices) {
    const JoinedSoup joined(soup, job);
    static_cast<SoupOptions&>(job) = joined.options();
    SoupResult result = calibrated_soup(joined.view(), job);
    joined.restore(result);
    return result;
  }
  if (has_preparation(job)) { // once for all runs, which are measured from what it leaves
    PreparedSoup prepared(soup, job);
    static_cast<SoupOptions&>(job) = prepared.options();
    SoupResult result = calibrated_soup(prepared.view(), job);
    prepared.restore(result);
    return result;
  }
  const auto surface_of = [](const auto& of) {
    return checked_surface("quadrille::calibrated", of.points, of.triangles);
  };
  const TriangleSoup<> input = surface_of(soup);
  const HausdorffLimit limit =
      job.error ? HausdorffLimit{*job.error} : HausdorffLimit::relative(*job.relative_error);
  bool is_cancelled = false;
  const auto run = [&](double factor) {
    if (is_cancelled)
      return SoupResult{}; // nothing is proved of it
    SoupResult result = simplified_soup(soup, times(job, factor));
    is_cancelled = result.report.stop == StopReason::cancelled;
    return result;
  };
  return calibrate(input, allowed_distance(limit, input), {}, run, surface_of);
}

} // namespace quadrille::internal
