// The command-line program: reads a mesh, simplifies it and writes it.
//
//   simplify IN OUT [--faces N | --ratio R | --vertices N | --error D | --levels LIST] [options]
//   simplify --from RECORD OUT [--faces N | --ratio R | --vertices N | --error D] [options]
//
// Exit status: 0 done; 1 the target was not reached, OUT holds how far it went; 2 bad usage or
// file, or nothing to simplify, OUT is as it was.

#include "mesh_io.h"
#include "program/options.h"
#include "program/record.h"
#include "program/report.h"
#include "program/simplify_gltf.h"
#include "program/simplify_levels.h"
#include "program/simplify_mesh.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille_examples;

/// False if the target was not reached.
bool run_mesh(const Options& options) {
  const MeshFormat& format = output_format(options); // complains before the work, not after
  const std::vector<std::string> files = files_of_results(options);
  IndexedMesh mesh = read_mesh(options.input, format_of(options.input, options),
                               options.welds ? Weld::always : Weld::loose_faces);
  require_fit(options, mesh);
  fit_to_format(mesh, format);
  if (!options.is_quiet)
    print_remarks(options, mesh);
  if (!options.levels.empty())
    return run_levels(mesh, options, format, files);
  if (!options.record.empty())
    return run_recorded(mesh, options, format);
  const quadrille::Report report =
      with_errors_of_file(options, [&] { return simplify_by_cost(mesh, options); });
  write_mesh(options.output, mesh, format, options.is_forced);
  return tell(options, report);
}

bool run(const Options& options) {
  const std::string output_extension = options.output_format.empty()
                                           ? extension_of(options.output, options)
                                           : "." + options.output_format;
  if (!options.from.empty() && is_gltf(output_extension))
    throw std::runtime_error(options.output + ": a level of a record is not written as glTF");
  if (!options.from.empty())
    return run_from_record(options);
  const bool reads_gltf = is_gltf(extension_of(options.input, options));
  if (reads_gltf != is_gltf(output_extension))
    throw std::runtime_error(options.input + ": glTF goes to glTF only (.gltf, .glb), and no " +
                             "other format does");
  if (!reads_gltf)
    return run_mesh(options);
  if (!options.record.empty())
    throw std::runtime_error(options.input + ": --record is not for glTF");
  require_replaceable(options.output, options.is_forced);
  return run_gltf(options, output_extension);
}

} // namespace

int main(int argc, char** argv) {
  enum ExitStatus { done, target_not_reached, failure };
  CLI::App app("Simplifies a triangle surface by contracting vertex pairs.", "simplify");
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : failure; // --help is an error to CLI11, but not here
  }
  try {
    return run(options) ? done : target_not_reached;
  } catch (const std::bad_alloc&) {
    std::cerr << options.input << ": out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return failure;
}
