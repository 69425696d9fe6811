#ifndef QUADRILLE_EXAMPLES_PROGRAM_CHECK_CHUNKS_H
#define QUADRILLE_EXAMPLES_PROGRAM_CHECK_CHUNKS_H

/// \file
/// How far a result is from the input where both are in files, and does it keep what was promised
/// of it: --measure and --verify of runs by parts.

#include "measure.h"

#include <quadrille/file_report.h>
#include <quadrille/report.h>
#include <quadrille/verdict.h>

namespace quadrille_examples {

/// The same as measure(), but for the area and textures.
Measurement measure_files(const quadrille::SurfaceFiles& input,
                          const quadrille::SurfaceFiles& result, const quadrille::OutOfCore& how);

/// Looks at the distances that the report says were kept.
quadrille::Verdict verify_files(const quadrille::Report& report,
                                const quadrille::SurfaceFiles& input,
                                const quadrille::SurfaceFiles& result,
                                const quadrille::OutOfCore& how);

} // namespace quadrille_examples

#endif
