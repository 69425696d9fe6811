#ifndef QUADRILLE_EXAMPLES_PROGRAM_COMMAND_LINE_H
#define QUADRILLE_EXAMPLES_PROGRAM_COMMAND_LINE_H

/// \file
/// From the words of the command line to options.

#include "checked_words.h"
#include "exclusions.h"
#include "help_formatter.h"
#include "options.h"
#include "out_of_core_options.h"
#include "policy_options.h"

#include <quadrille/version.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

/// Options that are for a mesh that is read, and not for a record.
inline constexpr const char* target_group =
    "Target: the run stops at the first one that is met; if there is none, at half of "
    "the faces";

inline void add_target(CLI::App& app, Options& options) {
  Target& target = options.target;
  const auto in_group = [](CLI::Option* option, const CLI::Validator& check, const char* type) {
    return option->check(check)->type_name(type)->group(target_group);
  };
  in_group(app.add_option("--faces", target.faces, "stop at N faces"), count(), "N");
  in_group(app.add_option_function<std::string>(
               "--keep,--ratio",
               [&](const std::string& word) { target.ratio = amount_of(word).value; },
               "stop at this fraction of the faces, such as 10% or 0.1"),
           amount("a fraction from 0 to 1 or from 0% to 100%, such as 0.1 or 10%", 1), "FRACTION");
  in_group(app.add_option("--vertices", target.vertices, "stop at N vertices"), count(), "N");
  in_group(
      app.add_option_function<std::string>(
          "--error", [&](const std::string& word) { target.error = amount_of(word); },
          "no point of OUT is further than this from IN, in the units of IN or as a percentage "
          "of the diagonal of its bounding box; features of IN that are lost, such as thin "
          "spikes, may be further from OUT unless --both-ways is given (see --measure)"),
      distance(), "D|P%");
  app.add_flag("--both-ways", target.both_ways,
               "apply --error both ways: no point of IN is further than that from OUT either, so "
               "thin spikes stay")
      ->group(target_group)
      ->needs("--error");
  app.add_flag(
         "--calibrated", target.is_calibrated,
         "continue until the measured distance reaches --error, both ways: half as many faces "
         "or fewer, in several runs that take many times as long")
      ->group(target_group)
      ->needs("--both-ways");
  app.add_option(
         "--tolerance", target.tolerance,
         "a limit that varies over the surface: no face of IN is further from OUT than the "
         "smallest value of this scalar at its vertices, in the units of IN (PLY files have "
         "such scalars)")
      ->type_name("NAME")
      ->group(target_group);
  in_group(
      app.add_option_function<std::string>(
          "--levels", [&](const std::string& list) { options.levels = asked_levels(list); },
          "several results, each coarser than the one before: fractions or counts of the faces "
          "(50%,25%,1000) or distances (error=0.1%,error=0.5%); they are written to OUT-1, "
          "OUT-2, ... with the extension of OUT, or for glTF into the one file OUT, as MSFT_lod"),
      {complaint_of_levels, ""}, "LIST");
}

inline void add_files(CLI::App& app, Options& options) {
  const std::string formats = " (.off .obj .ply .stl .ts .gltf .glb; - is standard ";
  app.add_option("IN", options.input, "the mesh to read" + formats + "input)")->required();
  app.add_option("OUT", options.output,
                 "the mesh to write" + formats +
                     "output), or a page that shows it (.html); -i IN and -o OUT work as well");
  take_one_of(app.add_option("--format", options.format,
                             "the format of IN and OUT if their names do not show it"),
              {"off", "obj", "ply", "stl", "ts", "gltf", "glb"})
      ->group("Files");
  take_one_of(app.add_option("--out-format", options.output_format,
                             "the format of OUT, whatever its name is"),
              {"off", "obj", "ply", "stl", "ts", "gltf", "glb", "html"})
      ->group("Files");
  app.add_option_function<std::string>(
         "--weld", [&](const std::string& word) { options.weld = amount_of(word); },
         "merge vertices at the same place, or closer than TOLERANCE, in the units of IN or "
         "as a percentage of the diagonal; without this, vertices are merged only where edges "
         "of faces coincide")
      ->check(distance())
      ->type_name("[TOLERANCE]")
      ->group("Files");
  app.add_flag(
         "--orient", options.orients,
         "turn faces so that neighbours are wound alike, across all edges that two faces share")
      ->group("Files");
  app.add_flag("--manifold", options.is_manifold,
               "cut IN into manifold sheets first: at edges of more than two faces, and where "
               "sheets touch at a vertex")
      ->group("Files");
  app.add_option_function<std::string>(
         "--hidden", [&](const std::string& word) { options.hidden = parse_hidden(word).value(); },
         "faces of IN that are not seen from outside, such as inner walls: drop them first, or "
         "only "
         "report them, with cavities and their sizes; or weight, which keeps the more faces the "
         "more is seen of them. drop=0.2% also takes those that are seen from this fraction of the "
         "directions (default: 0.1%)")
      ->check(word_that([](const std::string& word) { return parse_hidden(word).has_value(); },
                        "drop, report or weight, or a fraction as in drop=0.2%"))
      ->type_name("drop|report|weight")
      ->group("Files");
  app.add_option("--into", options.folder,
                 "simplify several files: every word is an input file, whose result is written to "
                 "this folder under the same name; the folder is created if it does not exist")
      ->type_name("FOLDER")
      ->group("Files");
  app.add_flag("--external-images", options.leaves_images,
               "leave the images of glTF and OBJ in their files, and refer to them; without this "
               "they are embedded if OUT is .glb, or .gltf in another folder")
      ->group("Files");
  take_one_of(
      app.add_option("--compress", options.compression,
                     "compress OUT, a glTF file: EXT_meshopt_compression is lossless, "
                     "KHR_draco_mesh_compression rounds floats unless OUT has to keep a promise"),
      {"meshopt", "draco"})
      ->group("Files");
  app.add_flag("--force", options.is_forced, "replace OUT even if it is read-only")->group("Files");
  app.add_flag(
         "--keep-partial", options.keeps_partial,
         "after Ctrl-C, write the mesh as far as it was simplified; without this OUT stays as "
         "it was")
      ->group("Files");
}

inline void add_figures(CLI::App& app, Options& options) {
  app.add_flag("--measure", options.measures,
               "measure the distance between IN and OUT, and how far the texture has moved")
      ->group("Figures");
  app.add_flag("--verify", options.verifies,
               "check with independent code whether OUT keeps what --error, --tolerance, "
               "--no-self-intersection, --solid and --normals promise")
      ->group("Figures");
  app.add_option("--report", options.report, "write the figures of the run to this file, as JSON")
      ->type_name("FILE")
      ->group("Figures");
  app.add_flag("--quiet,-q", options.is_quiet, "print errors only")->group("Figures");
  app.add_flag("--verbose,-v", options.is_verbose, "print everything that is known about the run")
      ->group("Figures");
}

/// Records of a run, of which levels are read later. Called last: it names other options.
inline void add_records(CLI::App& app, Options& options) {
  app.add_option("--record", options.record,
                 "write all levels from IN to the target to this file (.qlv), positions only")
      ->type_name("FILE")
      ->group("Files");
  app.add_option("--from", options.from, "read the target's level from this record instead of IN")
      ->type_name("FILE")
      ->group("Files");
  app.callback([&] {
    require_compatible(app);
    if (!options.from.empty() && !options.output.empty())
      throw CLI::ValidationError("--from", "the record replaces IN: give only OUT");
    if (!options.from.empty())
      options.output = std::exchange(options.input, options.from);
    if (options.output.empty() && options.folder.empty())
      throw CLI::RequiredError("OUT");
    require_by_chunks(app, options);
  });
}

/// What does not go together, whatever the file.
inline void require_consistency(const Options& options) {
  const auto reject_if = [](bool is_wrong, const std::string& message) {
    if (is_wrong)
      throw std::runtime_error(message);
  };
  reject_if(options.cost == "length" && options.placement == "optimal",
            "--placement optimal does not go with --cost length");
  reject_if(options.drops_components && (options.topology == "free" || options.joins_pairs()),
            "--drop-parts does not go with --topology free or --pairs: it keeps the rest of the "
            "topology");
  reject_if(options.cuts_handles() && topology(options) == quadrille::Topology::free,
            "--cut-handles does not go with --topology free or --pairs: it keeps the rest of "
            "the topology");
  reject_if(options.cuts_handles() && (options.promises() || !options.record.empty()),
            "--cut-handles does not go with --error, --tolerance, --no-self-intersection, --solid, "
            "--normals or --record: nothing is promised of the faces that close a cut");
  reject_if(options.is_manifold && topology(options) == quadrille::Topology::free,
            "--manifold does not go with --topology free or --pairs: these make edges of more than "
            "two faces");
  reject_if((options.cuts_handles() || options.is_manifold) &&
                is_gltf(extension_of(options.input, options)),
            "--cut-handles and --manifold do not go with glTF: its meshes are split at seams");
  reject_if(options.hidden.drops() && (options.target.both_ways || options.keeps_solid ||
                                       !options.target.tolerance.empty()),
            "--hidden drop does not go with --both-ways, --tolerance or --solid: dropped faces are "
            "not in OUT");
  reject_if(options.crease_degrees && (options.cost == "memoryless" || options.cost == "length" ||
                                       options.cost == "thin-features"),
            "--crease goes with --cost quadric, color and texture only");
  reject_if(options.has_lines_or_noise() && !options.cost.empty() && options.cost != "quadric",
            "--lines, --normal-noise, --noise and --squared-areas go with --cost quadric only");
  reject_if(options.forbids_intersections && options.is_relaxed,
            "--no-self-intersection does not go with --order relaxed: the blocks of a pass do not "
            "see each other");
  reject_if(options.keeps_solid && options.is_relaxed,
            "--solid does not go with --order relaxed: the blocks of a pass do not see each other");
  reject_if(options.keeps_solid && topology(options) != quadrille::Topology::kept,
            "--solid keeps the topology: it does not go with --topology free, --pairs or "
            "--drop-parts");
  reject_if(options.target.is_calibrated && !options.record.empty(),
            "--calibrated does not go with --record: it needs several runs");
  reject_if(options.verifies && !options.promises(),
            "--verify needs a promise to check: --error, --tolerance, --no-self-intersection, "
            "--solid or --normals");
  reject_if(options.threads > 0 && !options.is_relaxed && options.scratch.empty(),
            "--threads needs --order relaxed or --out-of-core");
  reject_if(!options.scratch.empty() && (options.cost == "color" || options.cost == "texture"),
            "--out-of-core uses positions only: it does not go with --cost " + options.cost);
  reject_if(options.keeps_partial && (!options.levels.empty() || !options.record.empty()),
            "--keep-partial does not go with --levels or --record: they write several results");
}

inline void add_options(CLI::App& app, Options& options) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("--help,-h", "print this and exit");
  app.set_version_flag("--version,-V", QUADRILLE_PROGRAM_VERSION, "print the version and exit");
  add_target(app, options);
  add_cost(app, options);
  add_boundary(app, options);
  add_quadric(app, options);
  add_region(app, options);
  add_labels(app, options);
  add_preset(app, options);
  add_topology(app, options);
  add_promises(app, options);
  add_seams(app, options);
  add_order(app, options);
  add_files(app, options);
  add_figures(app, options);
  add_records(app, options);
  add_out_of_core(app, options);
}

} // namespace quadrille_examples

#endif
