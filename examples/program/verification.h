#ifndef QUADRILLE_EXAMPLES_PROGRAM_VERIFICATION_H
#define QUADRILLE_EXAMPLES_PROGRAM_VERIFICATION_H

/// \file
/// Does a result keep what was promised of it? By code that shares nothing with the engine:
/// --verify.

#include <quadrille/report.h>
#include <quadrille/verdict.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace quadrille_examples {

struct IndexedMesh;
struct Options;
class ProgressLine;

/// What is thrown once all is written and told: a result does not keep what was promised.
struct BrokenPromise : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Looks at what was asked for, as the report says it was reached. `images`: of each point of the
/// input, the one of the result that it has become. Throws Interrupted.
quadrille::Verdict verify(const Options& options, const quadrille::Report& report,
                          const IndexedMesh& input, const IndexedMesh& result,
                          std::vector<std::size_t> images, ProgressLine& progress);

} // namespace quadrille_examples

#endif
