#ifndef QUADRILLE_EXAMPLES_PROGRAM_RUNS_H
#define QUADRILLE_EXAMPLES_PROGRAM_RUNS_H

/// \file
/// The runs that the program does: each reads, simplifies and writes, and returns false if a target
/// was not reached. They throw std::runtime_error with a line for the user, and Interrupted; files
/// that are not written then are as they were.

#include "interruption.h"
#include "options.h"
#include "progress_line.h"

#include <quadrille/report.h>

#include <iostream>
#include <string>
#include <vector>

namespace quadrille_examples {

struct IndexedMesh;
class Winding;

/// Of a mesh in any format but glTF: to one result, with a record, or to several levels.
bool run_mesh(const Options& options, ProgressLine& progress);

/// Of the meshes of a glTF document.
bool run_gltf(const Options& options, ProgressLine& progress);

/// A level of a record.
bool run_from_record(const Options& options, ProgressLine& progress);

/// Of a file that does not fit into memory, or a step of it.
bool run_out_of_core(const Options& options, ProgressLine& progress);

/// Remarks it if a file will hardly fit into the memory of this computer, or of this process.
void print_remark_of_memory(const Options& options);

/// Of any of these, to a page that shows all levels.
bool run_page(const Options& options, ProgressLine& progress);

/// Throws for a mesh that has no faces, or not what the cost looks at.
void require_fit(const Options& options, const IndexedMesh& mesh);

/// Takes the scalars of vertices that --importance and --tolerance name. Throws where there are
/// none.
void take_scalars(Options& options, const IndexedMesh& mesh);

/// Winds the faces alike where --orient asks for it, else tells of those that are not. What has but
/// one side is told.
void orient(const Options& options, IndexedMesh& mesh);

/// Prints which preset goes with a surface, where it stands out and nothing of the kind is asked
/// for.
void print_hint(const Options& options, const IndexedMesh& mesh, const Winding& winding);

/// Prints the options of a preset, where everything is printed.
void print_preset(const Options& options);

/// Whatever of the file the result will not have, and what a user may not expect.
void print_remarks(const Options& options, const IndexedMesh& mesh);

/// Throws Interrupted if the program was, unless what is there shall be kept.
inline void require_not_interrupted(const Options& options) {
  if (Interruption::is_asked() && !options.keeps_partial)
    throw Interrupted();
}

/// The options of a run to one of the levels.
inline Options options_of_level(const Options& options, const AskedLevel& level) {
  Options result = options;
  result.target = level.target;
  return result;
}

inline void print_remark(const Options& options, const std::string& remark) {
  if (!options.is_quiet)
    std::cerr << options.input << ": " << remark << '\n';
}

} // namespace quadrille_examples

#endif
