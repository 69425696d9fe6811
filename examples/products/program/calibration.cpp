// SPDX-License-Identifier: MIT
#include "calibration.h"

#include "../mesh_io/attributes/soup_arrays.h"
#include "../mesh_io/mesh/bounding_box.h"
#include "simplify_mesh.h"

#include <quadrille/calibrated.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

struct Coarse {
  IndexedMesh mesh;
  quadrille::PreparedSurface begun;
  quadrille::Report report;
  double factor;
};

Options times(Options options, double factor) {
  options.target.error->value *= factor;
  return options;
}

/// Of what run(factor) makes.
template <class Run>
Coarse coarsest(const IndexedMesh& mesh, const Options& options, Run run) {
  namespace internal = quadrille::internal;
  const auto surface_of = [](const IndexedMesh& of) {
    return internal::checked_surface("quadrille::calibrated", of.points, of.triangles);
  };
  const double distance = length_of(*options.target.error, diagonal(mesh.points, mesh.triangles));
  return internal::calibrate(surface_of(mesh), distance, quadrille::Calibration{}, run,
                             [&](const Coarse& coarse) { return surface_of(coarse.mesh); });
}

} // namespace

quadrille::Report simplify_calibrated(IndexedMesh& mesh, const Options& options,
                                      quadrille::PreparedSurface* begun, const Simplify& simplify) {
  const IndexedMesh input = mesh_that_runs_begin_with(
      soup_points(mesh.points), mesh.triangles, soup_options(options, mesh.points, mesh.triangles));
  Coarse best = coarsest(input, options, [&](double factor) {
    Coarse next{mesh, {}, {}, factor};
    next.report = simplify(next.mesh, times(options, factor), begun ? &next.begun : nullptr);
    return next;
  });
  mesh = std::move(best.mesh);
  if (begun)
    *begun = std::move(best.begun);
  return best.report;
}

CalibratedLimit calibrated_limit(const IndexedMesh& input, const Options& options,
                                 const SimplifyCopy& simplify) {
  const Coarse best = coarsest(input, options, [&](double factor) {
    Coarse next{{}, {}, {}, factor};
    next.report = simplify(times(options, factor), next.mesh);
    return next;
  });
  CalibratedLimit limit{times(options, best.factor), {}};
  if (best.factor > 1)
    limit.bound = best.report.hausdorff_bound;
  return limit;
}

} // namespace quadrille_examples
