#ifndef QUADRILLE_EXAMPLES_PROGRAM_CALIBRATION_H
#define QUADRILLE_EXAMPLES_PROGRAM_CALIBRATION_H

/// \file
/// As far as the distance of --error is measured to allow, both ways: --calibrated.

#include "../mesh_io.h"

#include <quadrille/report.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace quadrille_examples {

struct Options;

/// What simplifies a mesh as options say, and tells what became of each point, if that is asked.
using Simplify = std::function<quadrille::Report(IndexedMesh& mesh, const Options& options,
                                                 std::vector<std::size_t>* image)>;

/// Simplifies with multiples of --error, and leaves the coarsest that is proved to be within it.
quadrille::Report simplify_calibrated(IndexedMesh& mesh, const Options& options,
                                      std::vector<std::size_t>* image, const Simplify& simplify);

} // namespace quadrille_examples

#endif
