#ifndef QUADRILLE_EXAMPLES_PROGRAM_OPTIONS_H
#define QUADRILLE_EXAMPLES_PROGRAM_OPTIONS_H

/// \file
/// The command line of the program.

#include "../mesh_io.h"
#include "asked_levels.h"
#include "policies.h"

#include <quadrille/quadric.h>
#include <quadrille/stop.h>
#include <quadrille/topology.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

struct Options {
  std::string input, output;
  Target target;
  AskedLevels levels;                // empty: one result, by the target
  std::string record;                // the file of levels to write; empty: none
  std::string from;                  // the one to read instead of IN; empty: none
  std::string format, output_format; // empty: as their names say
  std::string cost;                  // empty: quadric with attributes
  std::string placement;             // empty: the best that the cost has
  double boundary_weight = quadrille::Quadric{}.boundary_weight;
  double pairs_closer_than = 0;
  std::string topology; // empty: free if there are pairs that are no edges
  bool drops_parts = false;
  bool welds = false;
  bool is_forced = false;
  bool is_quiet = false;
};

/// A finite number of the interval; CLI11's own checks let nan through.
inline CLI::Validator number_in(double least, double most, const std::string& what) {
  const auto complaint = [=](const std::string& word) {
    const std::optional<double> value = parse_number(word);
    const bool is_good = value && std::isfinite(*value) && *value >= least && *value <= most;
    return is_good ? "" : in_quotes(word) + " is not " + what;
  };
  return {complaint, ""};
}

/// CLI11 reads -1 as a very large count.
inline CLI::Validator count() {
  const auto complaint = [](const std::string& word) {
    const std::optional<std::int64_t> value = parse_integer(word);
    return value && *value >= 0 ? "" : in_quotes(word) + " is not a count";
  };
  return {complaint, ""};
}

inline void add_target(CLI::App& app, Options& options) {
  Target& target = options.target;
  const auto stop_at_faces = [&](std::size_t n) { target.chosen = quadrille::FaceCount{n}; };
  const auto stop_at_ratio = [&](double ratio) { target.chosen = quadrille::FaceRatio{ratio}; };
  const auto stop_at_vertices = [&](std::size_t n) { target.chosen = quadrille::VertexCount{n}; };
  const auto stop_at_error = [&](double error) {
    target.chosen = quadrille::ErrorLimit(error);
    target.distance = error;
  };
  CLI::Option_group* const group = app.add_option_group("Target", "half of the faces by default");
  group->require_option(0, 1);
  group->add_option_function<std::size_t>("--faces", stop_at_faces, "stop at so many faces")
      ->check(count());
  group->add_option_function<double>("--ratio", stop_at_ratio, "stop at this part of the faces")
      ->check(number_in(0, 1, "in [0, 1]"));
  group
      ->add_option_function<std::size_t>("--vertices", stop_at_vertices, "stop at so many vertices")
      ->check(count());
  group
      ->add_option_function<double>("--error", stop_at_error,
                                    "stay within that distance of the input")
      ->check(number_in(0, std::numeric_limits<double>::infinity(), "a distance"));
  group
      ->add_option_function<std::string>(
          "--levels", [&](const std::string& list) { options.levels = asked_levels(list); },
          "several results, each coarser than the one before it: parts of the faces or counts of "
          "them, 50%,25%,1000; written to OUT-1, OUT-2, ... with the extension of OUT, or of glTF "
          "as MSFT_lod of the one file OUT")
      ->check(list_of_levels());
}

inline void add_policies(CLI::App& app, Options& options) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  app.add_option(
         "--cost", options.cost,
         "which pair is contracted first: by distance to the planes of all faces so far, of the "
         "current faces, the same and of lost thin parts, with colours or texture coordinates as "
         "further dimensions, or the shortest (default: quadric, with all attributes of IN)")
      ->check(
          CLI::IsMember({"quadric", "memoryless", "thin-features", "color", "texture", "length"}));
  app.add_option("--placement", options.placement,
                 "where the vertex goes (default: optimal, or midpoint with --cost length)")
      ->check(CLI::IsMember({"optimal", "endpoint", "midpoint"}));
  app.add_option("--boundary-weight", options.boundary_weight, "how firmly boundaries hold")
      ->check(number_in(0, infinity, "a weight"))
      ->capture_default_str();
  app.add_option("--pairs-closer-than", options.pairs_closer_than,
                 "contract also vertices without an edge, if they are closer than this")
      ->check(number_in(0, infinity, "a distance"));
  app.add_option("--topology", options.topology,
                 "may holes close and parts join? (default: kept, or free with "
                 "--pairs-closer-than)")
      ->check(CLI::IsMember({"kept", "free"}));
  app.add_flag("--drop-parts", options.drops_parts,
               "small parts may vanish whole where that is the cheapest thing to do; else topology "
               "is kept");
}

inline void add_files(CLI::App& app, Options& options) {
  const CLI::IsMember is_format({"off", "obj", "ply", "stl", "ts", "gltf", "glb"});
  const std::string formats = " (.off .obj .ply .stl .ts, or .gltf .glb for both; - is standard ";
  app.add_option("IN", options.input, "the mesh to read" + formats + "input)")->required();
  app.add_option("OUT", options.output, "the mesh to write" + formats + "output)");
  app.add_option("--format", options.format,
                 "the format of IN and OUT where their names end in none")
      ->check(is_format);
  app.add_option("--out-format", options.output_format, "the format of OUT, whatever its name")
      ->check(is_format);
  app.add_flag("--force", options.is_forced, "replace OUT even if it is read-only");
}

/// Records of a run, of which levels are read later. Called last: it names other options.
inline void add_records(CLI::App& app, Options& options) {
  app.add_option("--record", options.record,
                 "write all levels from IN to the target to this file (.qlv), positions only")
      ->excludes("--levels");
  CLI::Option* const reads = app.add_option(
      "--from", options.from, "read the target's level from this record instead of IN");
  for (const char* const name :
       {"--record", "--levels", "--cost", "--placement", "--weld", "--boundary-weight",
        "--pairs-closer-than", "--topology", "--drop-parts"})
    reads->excludes(name);
  app.callback([&] {
    if (!options.from.empty() && !options.output.empty())
      throw CLI::ValidationError("--from", "there is an OUT, but no IN");
    if (!options.from.empty())
      options.output = std::exchange(options.input, options.from);
    if (options.output.empty())
      throw CLI::RequiredError("OUT");
  });
}

inline void add_options(CLI::App& app, Options& options) {
  add_files(app, options);
  add_target(app, options);
  add_policies(app, options);
  app.add_flag("--weld", options.welds,
               "make vertices at exactly the same place one; without this, that is done only if no "
               "two faces share a vertex, and to vertices of the same colour and texture "
               "coordinate");
  app.add_flag("--quiet", options.is_quiet, "print errors only");
  add_records(app, options);
}

inline Placement placement(const Options& options) {
  if (options.placement == "endpoint")
    return {Placement::endpoint};
  if (options.placement == "midpoint" || options.cost == "length")
    return {Placement::midpoint};
  return {Placement::optimal};
}

inline quadrille::Topology topology(const Options& options) {
  if (options.drops_parts)
    return quadrille::Topology::parts_may_vanish;
  const bool is_free =
      options.topology.empty() ? options.pairs_closer_than > 0 : options.topology == "free";
  return is_free ? quadrille::Topology::free : quadrille::Topology::kept;
}

inline bool is_gltf(const std::string& extension) {
  return equal_ignoring_case(extension, ".gltf") || equal_ignoring_case(extension, ".glb");
}

/// The extension that tells the format of a file: that of its name, else that of --format.
inline std::string extension_of(const std::string& file, const Options& options) {
  const std::string extension = std::filesystem::path(file).extension().string();
  const bool tells = options.format.empty() || find_format(extension) || is_gltf(extension);
  return tells ? extension : "." + options.format;
}

/// The format that the name of a file ends in, else that of --format.
inline const MeshFormat& format_of(const std::string& file, const Options& options) {
  if (const MeshFormat* named = find_format(std::filesystem::path(file).extension().string()))
    return *named;
  if (options.format.empty() && (is_standard_input(file) || is_standard_output(file)))
    throw std::runtime_error(file + ": its name tells no format: pass --format");
  return options.format.empty() ? mesh_format(file) : *find_format("." + options.format);
}

inline const MeshFormat& output_format(const Options& options) {
  return options.output_format.empty() ? format_of(options.output, options)
                                       : *find_format("." + options.output_format);
}

/// What concerns several options, or options and what the file has.
inline void require_fit(const Options& options, bool has_colors, bool has_textures) {
  if (options.cost == "length" && options.placement == "optimal")
    throw std::runtime_error("--placement optimal does not go with --cost length");
  if (options.drops_parts && (options.topology == "free" || options.pairs_closer_than > 0))
    throw std::runtime_error("--drop-parts does not go with --topology free or "
                             "--pairs-closer-than: all else of the topology is kept");
  if (options.cost == "color" && !has_colors)
    throw std::runtime_error(options.input + ": no colours for --cost color");
  if (options.cost == "texture" && !has_textures)
    throw std::runtime_error(options.input + ": no texture coordinates for --cost texture");
}

[[noreturn]] void refuse_without_faces(const Options& options, std::size_t vertices) {
  throw std::runtime_error(options.input + ": nothing to simplify: no face of three different " +
                           "vertices, " + std::to_string(vertices) + " vertices");
}

inline void require_fit(const Options& options, const IndexedMesh& mesh) {
  require_fit(options, !mesh.colors.empty(),
              !mesh.texture_coordinates.empty() || !mesh.corner_textures.empty());
  if (mesh.triangles.empty() && !mesh.is_blank)
    refuse_without_faces(options, mesh.points.size());
}

} // namespace quadrille_examples

#endif
