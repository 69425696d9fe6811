#ifndef QUADRILLE_EXAMPLES_PROGRAM_CALIBRATION_H
#define QUADRILLE_EXAMPLES_PROGRAM_CALIBRATION_H

/// \file
/// As far as the distance of --error is measured to allow, both ways: --calibrated.

#include "../mesh_io/mesh_io.h"
#include "options.h"

#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace quadrille_examples {

/// What simplifies a mesh as options say, and tells with which surface it has begun, if that is
/// asked.
using Simplify = std::function<quadrille::Report(IndexedMesh& mesh, const Options& options,
                                                 quadrille::PreparedSurface* begun)>;

/// Simplifies with multiples of --error, and leaves the coarsest that is proved to be within it.
quadrille::Report simplify_calibrated(IndexedMesh& mesh, const Options& options,
                                      quadrille::PreparedSurface* begun, const Simplify& simplify);

/// The options that leave the coarsest, and its distance both ways as it is proved; none where the
/// limit itself does.
struct CalibratedLimit {
  Options options;
  std::optional<double> bound;
};

/// What simplifies a copy as options say, and gives the surface that is left.
using SimplifyCopy = std::function<quadrille::Report(const Options& options, IndexedMesh& left)>;

/// For what is no single mesh: looks for the options, and keeps nothing of the runs.
CalibratedLimit calibrated_limit(const IndexedMesh& input, const Options& options,
                                 const SimplifyCopy& simplify);

} // namespace quadrille_examples

#endif
