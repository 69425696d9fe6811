// SPDX-License-Identifier: MIT
// It includes <quadrille/calibrated.h>, which includes GPL parts of CGAL.
#include "calibration.h"

#include "../bounding_box.h"
#include "options.h"

#include <quadrille/calibrated.h>

#include <utility>

namespace quadrille_examples {

namespace {

struct Coarse {
  IndexedMesh mesh;
  std::vector<std::size_t> image;
  quadrille::Report report;
  double factor;
};

} // namespace

quadrille::Report simplify_calibrated(IndexedMesh& mesh, const Options& options,
                                      std::vector<std::size_t>* image, const Simplify& simplify) {
  namespace internal = quadrille::internal;
  const internal::CheckedSurface input = internal::checked_surface(mesh.points, mesh.triangles);
  const double distance = length_of(*options.target.error, diagonal(mesh.points, mesh.triangles));
  Coarse best = internal::calibrate(
      distance, quadrille::Calibration{},
      [&](double factor) {
        Coarse next{mesh, {}, {}, factor};
        Options coarser = options;
        coarser.target.error->value *= factor;
        next.report = simplify(next.mesh, coarser, image ? &next.image : nullptr);
        return next;
      },
      [&](const Coarse& coarse, double error) {
        return internal::proved_distance(
            input, internal::checked_surface(coarse.mesh.points, coarse.mesh.triangles), distance,
            error);
      });
  mesh = std::move(best.mesh);
  if (image)
    *image = std::move(best.image);
  return best.report;
}

} // namespace quadrille_examples
