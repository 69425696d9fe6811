// SPDX-License-Identifier: MIT
#include "verification.h"

#include "../mesh_io/mesh/indexed_mesh.h"
#include "interruption.h"
#include "options.h"
#include "progress_line.h"

#include <quadrille/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

quadrille::Verdict looked_at(const IndexedMesh& input, const IndexedMesh& result,
                             quadrille::Claims claims, ProgressLine& progress) {
  claims.progress = [&progress](double part) {
    progress.show_part("verifying", part);
    return !Interruption::is_asked();
  };
  quadrille::Verdict verdict =
      quadrille::verify(input.points, input.triangles, result.points, result.triangles, claims);
  if (verdict.is_cancelled)
    throw Interrupted();
  return verdict;
}

/// What is claimed of distances, which are between the files.
quadrille::Claims distances_of(const Options& options, const quadrille::Report& report) {
  quadrille::Claims claims;
  if (!options.soup.tolerance.empty())
    claims.tolerances = options.soup.tolerance;
  else if (std::isfinite(report.hausdorff_bound))
    claims.distance_both_ways = report.hausdorff_bound;
  else if (std::isfinite(report.distance_bound))
    claims.distance = report.distance_bound;
  return claims;
}

} // namespace

quadrille::Verdict verify(const Options& options, const quadrille::Report& report,
                          const VerifiedMeshes& meshes, std::vector<std::size_t> vertex_map,
                          ProgressLine& progress) {
  quadrille::Verdict verdict =
      looked_at(meshes.file_in, meshes.file_out, distances_of(options, report), progress);
  quadrille::Claims claims;
  claims.no_self_intersection = options.soup.no_self_intersection || options.soup.keep_solid;
  claims.solid = options.soup.keep_solid;
  claims.normal_deviation = report.normal_bound_degrees;
  claims.vertex_map = std::move(vertex_map);
  for (quadrille::Finding& finding :
       looked_at(meshes.input, meshes.result, std::move(claims), progress).findings)
    verdict.findings.push_back(std::move(finding));
  return verdict;
}

double distance_between(const IndexedMesh& a, const IndexedMesh& b, ProgressLine& progress) {
  double bound = 0;
  quadrille::Claims claims;
  claims.distance_both_ways = 0;
  for (const quadrille::Finding& finding : looked_at(a, b, claims, progress).findings)
    bound = std::max(bound, finding.measured + finding.error);
  return bound;
}

} // namespace quadrille_examples
