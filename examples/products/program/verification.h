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

/// What is looked at: what was simplified and what became of it; and what distances are between,
/// what the file IN is and what is read from the file OUT, of which parts may have other points.
struct VerifiedMeshes {
  const IndexedMesh& file_in;
  const IndexedMesh& input;
  const IndexedMesh& result;
  const IndexedMesh& file_out;
};

/// Looks at what was asked for, as the report says it was reached. `images`: of each point of the
/// input, the one of the result that it has become. Throws Interrupted.
quadrille::Verdict verify(const Options& options, const quadrille::Report& report,
                          const VerifiedMeshes& meshes, std::vector<std::size_t> vertex_map,
                          ProgressLine& progress);

/// A bound of how far two meshes are apart, either way. Throws Interrupted.
double distance_between(const IndexedMesh& a, const IndexedMesh& b, ProgressLine& progress);

} // namespace quadrille_examples

#endif
