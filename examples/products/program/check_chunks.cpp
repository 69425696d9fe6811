// SPDX-License-Identifier: MIT
#include "check_chunks.h"

#include <quadrille/file_distance.h>

#include <cmath>

namespace quadrille_examples {

Measurement measure_files(const quadrille::SurfaceFiles& input,
                          const quadrille::SurfaceFiles& result, const quadrille::OutOfCore& how) {
  const quadrille::SurfaceDistance distance = quadrille::file_distance(result, input, how);
  return {.rms = distance.rms,
          .greatest = distance.hausdorff,
          .to_input = distance.hausdorff_a_to_b,
          .from_input = distance.hausdorff_b_to_a,
          .texture = std::nullopt};
}

quadrille::Verdict verify_files(const quadrille::Report& report,
                                const quadrille::SurfaceFiles& input,
                                const quadrille::SurfaceFiles& result,
                                const quadrille::OutOfCore& how) {
  quadrille::Claims claims;
  if (!how.tolerance.empty())
    return quadrille::verify_files(input, result, claims, how);
  if (std::isfinite(report.hausdorff_bound))
    claims.distance_both_ways = report.hausdorff_bound;
  else if (std::isfinite(report.distance_bound))
    claims.distance = report.distance_bound;
  return quadrille::verify_files(input, result, claims, how);
}

} // namespace quadrille_examples
