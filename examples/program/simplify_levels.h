#ifndef QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_LEVELS_H
#define QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_LEVELS_H

/// \file
/// Several results of one mesh: --levels.

#include "../mesh_io.h"
#include "asked_levels.h"
#include "options.h"
#include "report.h"
#include "simplify_mesh.h"

#include <quadrille/report.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille_examples {

/// The options of a run to one of the levels.
inline Options options_of_level(const Options& options, const AskedLevel& level) {
  Options result = options;
  result.target = level.target;
  return result;
}

/// The files that a run writes its results to, all of which may be written, else it throws.
inline std::vector<std::string> files_of_results(const Options& options) {
  std::vector<std::string> files;
  if (options.levels.empty())
    files.push_back(options.output);
  else if (is_standard_output(options.output))
    throw std::runtime_error(options.output + ": --levels writes a file for each level, so OUT " +
                             "cannot be standard output");
  for (std::size_t number = 1; number <= options.levels.size(); ++number)
    files.push_back(file_of_level(options.output, number));
  for (const std::string& file : files)
    require_replaceable(file, options.is_forced);
  return files;
}

/// Simplifies the mesh to each of the levels, and then writes them to files. False if one was not
/// reached.
inline bool run_levels(const IndexedMesh& mesh, const Options& options, const MeshFormat& format,
                       const std::vector<std::string>& files) {
  require_descending(options.levels, mesh.triangles.size());
  std::vector<std::string> contents;
  std::vector<quadrille::Report> reports;
  for (std::size_t i = 0; i < files.size(); ++i) {
    IndexedMesh level = mesh;
    reports.push_back(with_errors_of_file(options, [&] {
      return simplify_by_cost(level, options_of_level(options, options.levels[i]));
    }));
    contents.push_back(encoded(files[i], level, format));
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    replace_file(files[i], contents[i], options.is_forced);
  bool is_reached = true;
  for (std::size_t i = 0; i < files.size(); ++i)
    is_reached &= tell(options_of_level(options, options.levels[i]), reports[i], files[i]);
  return is_reached;
}

} // namespace quadrille_examples

#endif
