// SPDX-License-Identifier: MIT
// It includes <quadrille/verify.h>, which includes GPL parts of CGAL.
#include "verification.h"

#include "../mesh_io/indexed_mesh.h"
#include "interruption.h"
#include "options.h"
#include "progress_line.h"

#include <quadrille/verify.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille_examples {

quadrille::Verdict verify(const Options& options, const quadrille::Report& report,
                          const IndexedMesh& input, const IndexedMesh& result,
                          std::vector<std::size_t> images, ProgressLine& progress) {
  quadrille::Claims claims;
  if (!options.tolerances.empty())
    claims.tolerances = options.tolerances;
  else if (std::isfinite(report.hausdorff_bound))
    claims.distance_both_ways = report.hausdorff_bound;
  else if (std::isfinite(report.distance_bound))
    claims.distance = report.distance_bound;
  claims.no_self_intersection = options.forbids_intersections || options.keeps_solid;
  claims.solid = options.keeps_solid;
  claims.normal_deviation = report.normal_bound_degrees;
  claims.images = std::move(images);
  claims.progress = [&progress](double part) {
    progress.show_part("verifying", part);
    return !Interruption::is_asked();
  };
  const quadrille::Verdict verdict =
      quadrille::verify(input.points, input.triangles, result.points, result.triangles, claims);
  if (verdict.is_cancelled)
    throw Interrupted();
  return verdict;
}

} // namespace quadrille_examples
