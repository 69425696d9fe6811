#ifndef QUADRILLE_EXAMPLES_PROGRAM_COMMAND_LINE_H
#define QUADRILLE_EXAMPLES_PROGRAM_COMMAND_LINE_H

/// \file
/// From the words of the command line to options.

#include "checked_words.h"
#include "exclusions.h"
#include "help_formatter.h"
#include "options.h"
#include "out_of_core_options.h"
#include "table_options.h"

#include <quadrille/version.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

/// Returns the group of an option of the table.
inline std::string group_of(const CLI::App& app, const std::string& option) {
  return app.get_option(option)->get_group();
}

/// The options of the target that are not in the table.
inline void add_target(CLI::App& app, Options& options) {
  app.get_option("--both-ways")->needs("--error");
  app.get_option("--calibrated")->needs("--both-ways");
  app.add_option_function<std::string>(
         "--levels", [&](const std::string& list) { options.levels = asked_levels(list); },
         "several results, each coarser than the one before: fractions or counts of the faces "
         "(50%,25%,1000) or distances (error=0.1%,error=0.5%); they are written to OUT-1, "
         "OUT-2, ... with the extension of OUT, or for glTF into the one file OUT, as MSFT_lod")
      ->check({complaint_of_levels, ""})
      ->type_name("LIST")
      ->group(group_of(app, "--error"));
}

/// The options for parts of the surface that are not in the table.
inline void add_parts(CLI::App& app, Options& options) {
  const std::string group = group_of(app, "--topology");
  app.add_flag("--drop-parts", options.drops_components,
               "small components may be removed where that is the cheapest step; the rest of the "
               "topology is kept. This is the default for glTF, OBJ and PLY")
      ->group(group);
  app.add_flag("--keep-parts", options.keeps_components,
               "no component vanishes. This is the default for other formats")
      ->group(group);
  app.add_option(
         "--region", options.region,
         "simplify only these faces, leave all others as they are, and count only these for "
         "the target: names of objects, groups or materials (head,arm), or scalars of faces "
         "with a value or not 0 (label=3,label=7)")
      ->check(word_that([](const std::string& list) { return !list.empty(); }, "a list of names"))
      ->type_name("LIST")
      ->group(group);
  app.add_option("--labels", options.labels,
                 "keep the regions of these integer attributes of a glTF file, as those of its "
                 "materials: names such as _PART,_LAYER; other integer attributes have no effect")
      ->delimiter(',')
      ->type_name("LIST")
      ->group(group);
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
      ->type_name("FILE.json")
      ->group("Figures");
  app.add_flag("--quiet,-q", options.is_quiet, "print errors only")->group("Figures");
  app.add_flag("--verbose,-v", options.is_verbose, "print everything that is known about the run")
      ->group("Figures");
}

/// Records of a run, of which levels are read later. Called last: it names other options.
inline void add_records(CLI::App& app, Options& options) {
  app.add_option("--record", options.record,
                 "write all levels from IN to the target to this file (.qlv), positions only")
      ->type_name("FILE.qlv")
      ->group("Files");
  app.add_option("--from", options.from, "read the target's level from this record instead of IN")
      ->type_name("FILE.qlv")
      ->group("Files");
  app.callback([&] {
    require_compatible(app);
    options.target.take(options.soup);
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
  using Cost = quadrille::SoupOptions::Cost;
  using Placement = quadrille::SoupOptions::Placement;
  const quadrille::SoupOptions& soup = options.soup;
  reject_if(soup.cost == Cost::edge_length && soup.placement == Placement::optimal,
            "--placement optimal does not go with --cost length");
  reject_if(options.drops_components &&
                (soup.topology == quadrille::Topology::free || options.joins_pairs()),
            "--drop-parts does not go with --topology free or --pairs: it keeps the rest of the "
            "topology");
  reject_if(options.joins_gaps() && topology(options) == quadrille::Topology::free,
            "--join-gaps does not go with --topology free or --pairs: it keeps the rest of the "
            "topology");
  reject_if(options.joins_gaps() && (options.promises() || !options.record.empty()),
            "--join-gaps does not go with --error, --tolerance, --no-self-intersection, --solid, "
            "--normals or --record: faces at a gap that is filled are not in OUT");
  reject_if(options.cuts_handles() && topology(options) == quadrille::Topology::free,
            "--cut-handles does not go with --topology free or --pairs: it keeps the rest of "
            "the topology");
  reject_if(options.cuts_handles() && soup.keep_solid,
            "--cut-handles does not go with --solid: both sides of a cut may touch, which a solid does "
            "not");
  reject_if(options.soup.manifold && topology(options) == quadrille::Topology::free,
            "--manifold does not go with --topology free or --pairs: these make edges of more than "
            "two faces");
  reject_if(options.hidden.drops() &&
                (options.target.both_ways || soup.keep_solid || !options.target.tolerance.empty()),
            "--hidden drop does not go with --both-ways, --tolerance or --solid: dropped faces are "
            "not in OUT");
  reject_if(soup.crease_degrees != 180 && soup.cost != Cost::quadric,
            "--crease goes with --cost quadric, color and texture only");
  reject_if(options.has_lines_or_noise() && !options.cost.empty() && options.cost != "quadric",
            "--lines, --normal-noise, --noise and --weighting go with --cost quadric only");
  reject_if(soup.no_self_intersection && options.is_relaxed(),
            "--no-self-intersection does not go with --order relaxed: the blocks of a pass do not "
            "see each other");
  reject_if(soup.keep_solid && options.is_relaxed(),
            "--solid does not go with --order relaxed: the blocks of a pass do not see each other");
  reject_if(soup.keep_solid && topology(options) != quadrille::Topology::kept,
            "--solid keeps the topology: it does not go with --topology free, --pairs or "
            "--drop-parts");
  reject_if(options.target.is_calibrated && !options.record.empty(),
            "--calibrated does not go with --record: it needs several runs");
  reject_if(options.verifies && !options.promises(),
            "--verify needs a promise to check: --error, --tolerance, --no-self-intersection, "
            "--solid or --normals");
  reject_if(options.threads > 0 && !options.is_relaxed() && !options.cuts_handles() &&
                !soup.preset && options.scratch.empty(),
            "--threads needs --order relaxed, --cut-handles, --preset or --out-of-core");
  reject_if(!options.scratch.empty() && (options.cost == "color" || options.cost == "texture"),
            "--out-of-core uses positions only: it does not go with --cost " + options.cost);
  reject_if(options.keeps_partial && (!options.levels.empty() || !options.record.empty()),
            "--keep-partial does not go with --levels or --record: they write several results");
}

inline void add_options(CLI::App& app, Options& options) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("--help,-h", "print this and exit");
  app.set_version_flag("--version,-V", QUADRILLE_PROGRAM_VERSION, "print the version and exit");
  TableOptions::add(app, options);
  add_target(app, options);
  add_parts(app, options);
  add_files(app, options);
  add_figures(app, options);
  add_records(app, options);
  add_out_of_core(app, options);
}

} // namespace quadrille_examples

#endif
