#ifndef QUADRILLE_EXAMPLES_PROGRAM_OPTIONS_H
#define QUADRILLE_EXAMPLES_PROGRAM_OPTIONS_H

/// \file
/// What the program is asked for.

#include "../mesh_io/format.h"
#include "../mesh_io/text.h"
#include "asked_levels.h"
#include "hidden.h"
#include "target.h"

#include <quadrille/channel_options.h>
#include <quadrille/compiled/soup_job.h>
#include <quadrille/quadric.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille_examples {

struct Options {
  std::string input, output;
  Target target;
  AskedLevels levels;                // empty: one result, by the target
  std::string record;                // the file of levels to write; empty: none
  std::string from;                  // the one to read instead of IN; empty: none
  std::string report;                // the file of figures to write; empty: none
  std::string format, output_format; // empty: as their names say
  /// The options of the table (options.def), but for those of the target and what depends on IN.
  quadrille::internal::SoupJob soup;
  quadrille::ChannelOptions textures;
  std::map<std::string, Amount> lengths;      ///< options of the table that are lengths
  std::map<std::string, std::string> scalars; ///< options of the table that IN's vertices have
  std::string cost;                           // empty: quadric with attributes
  bool locks_boundaries = false;
  std::string region;           // names of IN's faces; empty: all of it
  std::set<std::string> labels; // attributes of glTF of which regions stay
  HiddenChoice hidden;          // what is done with faces that nobody sees
  bool drops_components = false;
  bool keeps_components = false; // neither: see topology()
  unsigned threads = 0;          // 0: as many as the machine has, where the order is relaxed
  std::optional<Amount> weld;
  bool orients = false;                 // are faces wound alike first?
  std::string scratch;                  // a folder for parts of what does not fit; empty: in memory
  std::uint64_t memory = 4'000'000'000; // in bytes, for parts
  std::string step;                     // of a run in parts, if it is not all of it
  bool restarts = false;                // a run in parts
  std::string progress;                 // the file that tells how far that is; empty: none
  bool positions_only = false;          // in parts, leaving out what else there is
  bool measures = false, verifies = false;
  bool keeps_partial = false;
  bool is_forced = false;
  bool is_quiet = false, is_verbose = false;
  bool leaves_images = false; // of glTF and OBJ, as files that OUT names
  std::string compression;    // of glTF that is written; empty: none
  std::string folder;         // for the results of several files; empty: there is one

  bool has_length(const std::string& option) const {
    const auto found = lengths.find(option);
    return found != lengths.end() && found->second.value > 0;
  }
  bool has_lines_or_noise() const {
    return soup.line_weight > 0 || soup.normal_noise > 0 || has_length("position_noise") ||
           soup.weighting != quadrille::Weighting::by_area;
  }
  bool joins_pairs() const { return has_length("pairs_closer_than"); }
  bool joins_gaps() const { return has_length("join_gaps"); }
  bool cuts_handles() const { return has_length("simplified_topology"); }
  bool is_relaxed() const { return soup.order == quadrille::SoupOptions::Order::relaxed; }
  /// Is anything asked for that OUT is to keep?
  bool promises() const {
    const bool is_limited =
        target.is_limited() || std::any_of(levels.begin(), levels.end(), [](const auto& level) {
          return level.target.is_limited();
        });
    return is_limited || soup.no_self_intersection || soup.keep_solid || soup.normal_deviation;
  }
};

/// Where remarks go: standard output may be the mesh.
inline std::ostream& output_of_figures(const Options& options) {
  return is_standard_output(options.output) ? std::cerr : std::cout;
}

// --- Formats -------------------------------------------------------------------------------------

inline bool is_page(const std::string& extension) {
  return equal_ignoring_case(extension, ".html");
}

/// The extension that tells the format of a file: that of its name, else that of --format.
inline std::string extension_of(const std::string& file, const Options& options) {
  const std::string extension = std::filesystem::path(file).extension().string();
  const bool tells = options.format.empty() || find_format(extension) || is_gltf(extension);
  return tells ? extension : "." + options.format;
}
inline std::string output_extension(const Options& options) {
  return options.output_format.empty() ? extension_of(options.output, options)
                                       : "." + options.output_format;
}
/// Are coordinates of OUT floats, whatever IN has? So they are in STL.
inline bool writes_floats(const Options& options) {
  return equal_ignoring_case(output_extension(options), ".stl");
}

/// The format that the name of a file ends in, else that of --format.
inline const MeshFormat& format_of(const std::string& file, const Options& options) {
  if (const MeshFormat* named = find_format(std::filesystem::path(file).extension().string()))
    return *named;
  if (options.format.empty() && (is_standard_input(file) || is_standard_output(file)))
    throw std::runtime_error(file + ": its name does not show its format: pass --format");
  return options.format.empty() ? mesh_format(file, " .gltf .glb, nor .html for OUT")
                                : *find_format("." + options.format);
}

inline const MeshFormat& output_format(const Options& options) {
  return options.output_format.empty() ? format_of(options.output, options)
                                       : *find_format("." + options.output_format);
}

/// Is a file in a format in which assets come, of many parts of which small ones may go?
inline bool is_of_assets(const Options& options) {
  const std::string extension = extension_of(options.input, options);
  return is_gltf(extension) || equal_ignoring_case(extension, ".obj") ||
         equal_ignoring_case(extension, ".ply");
}

/// As it is asked for; else free if there are pairs that are no edges, and of assets kept but for
/// small parts, unless regions are labels or they are simplified by parts of files.
inline quadrille::Topology topology(const Options& options) {
  using quadrille::Topology;
  const Topology asked =
      options.soup.topology.value_or(options.joins_pairs() ? Topology::free : Topology::kept);
  if (asked != Topology::kept)
    return asked;
  const bool is_by_default = !options.soup.topology && !options.keeps_components &&
                             !options.soup.keep_solid && options.scratch.empty() &&
                             options.labels.empty() && is_of_assets(options);
  return options.drops_components || is_by_default ? Topology::components_may_vanish
                                                   : Topology::kept;
}

// --- What concerns several options, or options and what the file has
// ------------------------------

inline void require_fit(const Options& options, bool has_colors, bool has_textures) {
  if (options.cost == "color" && !has_colors)
    throw std::runtime_error(options.input + ": it has no colours for --cost color");
  if (options.cost == "texture" && !has_textures)
    throw std::runtime_error(options.input + ": it has no texture coordinates for --cost texture");
}

/// `others` is what else the file has.
[[noreturn]] inline void reject_without_faces(const Options& options, std::size_t vertices,
                                              const std::string& others = "") {
  throw std::runtime_error(
      options.input + ": nothing to simplify: it has " + std::to_string(vertices) + " vertices" +
      (others.empty() ? "" : ", " + others) + " and no face with three different vertices");
}

} // namespace quadrille_examples

#endif
