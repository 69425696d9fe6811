#ifndef QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_MESH_H
#define QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_MESH_H

/// \file
/// Simplifies a mesh as options say. Each function has a source of its own.

#include "../mesh_attributes.h"
#include "../mesh_io.h"
#include "options.h"
#include "recorder.h"

#include <quadrille/report.h>

#include <stdexcept>

namespace quadrille_examples {

/// With all that the mesh has.
quadrille::Report simplify_mesh(IndexedMesh& mesh, const Options& options);

/// The same to the same bits, recorded.
quadrille::Report simplify_mesh(IndexedMesh& mesh, const Options& options, Recorder& recorder);

/// Of a mesh without values at corners and without parts, attributes of vertices: by greedy order.
quadrille::Report simplify_attributes(const MeshAttributes& attributes, IndexedMesh& mesh,
                                      const Options& options);

/// By channels, whatever the mesh has.
quadrille::Report simplify_by_channels(IndexedMesh& mesh, const Options& options);

/// What is wrong with attributes that no weight makes comparable with positions is told of the
/// file.
quadrille::Report with_errors_of_file(const Options& options, const auto& simplify) {
  try {
    return simplify();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.input + ": " + error.what());
  }
}

} // namespace quadrille_examples

#endif
