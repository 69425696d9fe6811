#ifndef QUADRILLE_EXAMPLES_PROGRAM_OUT_OF_CORE_OPTIONS_H
#define QUADRILLE_EXAMPLES_PROGRAM_OUT_OF_CORE_OPTIONS_H

#include "checked_words.h"
#include "exclusions.h"
#include "options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace quadrille_examples {

/// Options that do not go with parts, and why.
struct NotByChunks {
  const char* option;
  const char* reason;
};
inline constexpr NotByChunks not_by_chunks[] = {
    {"--calibrated",
     "each of its runs measures the whole surface, which is not in memory; --both-ways "
     "alone also keeps the limit"},
    {"--orient", "a chunk does not know the orientation of the others"},
    {"--pairs", "pairs that are not edges may lie in different chunks"},
    {"--join-gaps",
     "a gap may lie between several chunks; simplify out of core to what fits into memory first, "
     "and then OUT with --join-gaps"},
    {"--cut-handles",
     "a handle may lie in several chunks; simplify out of core to what fits into memory first, and "
     "then OUT with --cut-handles"},
    {"--preset",
     "a chunk does not see the surface of the others; simplify out of core to what fits into "
     "memory first, and then OUT with --preset"},
    {"--manifold",
     "a chunk does not see the faces of the others; simplify out of core to what fits into memory "
     "first, and then OUT with --manifold"},
    {"--hidden", "a chunk does not see the faces of the others"},
    {"--no-self-intersection", "a chunk does not see the faces of the others"},
    {"--solid", "a chunk does not see the faces of the others"},
    {"--normals", "the deviation of normals is not passed on from phase to phase"},
    {"--levels", "levels need a single run in memory"},
    {"--record", "a record needs a single run in memory"},
    {"--from", "a record needs a single run in memory"},
    {"--vertices", "the number of vertices is only known at the end; use --faces or --keep"},
    {"--order",
     "each chunk is simplified in greedy order; --threads sets the number of chunks at a "
     "time"},
    {"--region", "names of faces are not passed on from phase to phase"},
    {"--labels", "it is for glTF"},
    {"--seams", "seams of a file that is read in chunks become boundaries"},
    {"--importance", "scalars of vertices are kept, but they do not affect the cost"},
    {"--keep-partial", "finished work stays in the folder, and --restart resumes it"}};

/// The options of the table that go with chunks.
inline constexpr std::string_view options_of_chunks[] = {
    "faces", "ratio",     "error",   "both_ways",       "tolerance",
    "cost",  "placement", "threads", "boundary_weight", "topology"};

/// Throws for options that do not go with parts, with the reason.
inline void require_by_chunks(const CLI::App& app, const Options& options) {
  if (options.scratch.empty())
    return;
  for (const NotByChunks& refused : not_by_chunks)
    reject_with(app, {refused.option, "--out-of-core", refused.reason});
  for_others(options_of_chunks, [&](const std::string& option) {
    reject_with(app,
                {option.c_str(), "--out-of-core", "only the plain costs are compiled for chunks"});
  });
  if (options.weld && options.weld->value > 0)
    reject_with(
        app, {"--weld", "--out-of-core",
              "the vertices that a distance merges depend on the order of points in the file, in "
              "chains that may continue in other chunks; without a distance, --weld merges the "
              "vertices at exactly the same place"});
}

/// Bytes: 4G, 500M, 1.5G, 4GB, 4g; 4GiB is a little more.
inline std::optional<std::uint64_t> parse_bytes(std::string word) {
  double unit = 1, thousand = 1000;
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  const auto ends_with = [&](const std::string& end) {
    const bool does = word.ends_with(end);
    word.resize(word.size() - (does ? end.size() : 0));
    return does;
  };
  if (ends_with("ib"))
    thousand = 1024;
  else
    ends_with("b");
  const std::string units = "kmgt";
  if (const std::size_t at = word.empty() ? std::string::npos : units.find(word.back());
      at != std::string::npos) {
    unit = std::pow(thousand, static_cast<double>(at + 1));
    word.pop_back();
  } else if (thousand == 1024) {
    return std::nullopt;
  }
  const std::optional<Amount> value = parse_amount(word);
  if (!value || value->is_percentage || !(value->value * unit < 1e18))
    return std::nullopt;
  return static_cast<std::uint64_t>(value->value * unit);
}

/// Files that do not fit into memory. Called after all options that do not go with it.
inline void add_out_of_core(CLI::App& app, Options& options) {
  const char* const group =
      "Files that do not fit into memory: from PLY or binary STL, to PLY; IN may be a "
      "pattern such as 'tiles/*.ply', for tiles with coincident boundaries, and OUT a "
      "folder for the simplified tiles";
  CLI::Option* const parts = app.add_option(
      "--out-of-core", options.scratch,
      "simplify IN in chunks, and keep them in this folder meanwhile: about 60 bytes per "
      "face, 70 bytes if half of the faces stay, 90 bytes while STL is welded; at the end the "
      "folder is as it was");
  parts->type_name("FOLDER")->group(group);
  const auto in_group = [&](CLI::Option* option) { return option->group(group)->needs(parts); };
  in_group(app.add_option_function<std::string>(
               "--memory",
               [&](const std::string& word) { options.memory = parse_bytes(word).value(); },
               "use at most this much memory; the result depends on it (default: 4G)"))
      ->check(word_that([](const std::string& word) { return parse_bytes(word).has_value(); },
                        "a number of bytes, such as 4G or 500M"))
      ->type_name("BYTES");
  in_group(app.add_flag("--restart", options.restarts, "resume the interrupted job in the folder"));
  in_group(app.add_option(
               "--progress", options.progress,
               "write the progress to this file, one line of JSON for each stage and each second; "
               "the first line estimates time, memory and disk space"))
      ->type_name("FILE.json");
  in_group(app.add_flag(
      "--positions-only", options.positions_only,
      "keep only positions, faces, labels and tolerances; without this, colours and other "
      "scalars of vertices are kept too, and attributes that cannot be kept are an error"));
  const auto is_step = [](const std::string& word) {
    const std::optional<std::int64_t> part = parse_integer(word);
    return word == "cut" || word == "close" || (part && *part >= 0);
  };
  in_group(app.add_option(
               "--step", options.step,
               "do a single step: cut IN, simplify chunk N, or close the phase; prints the number "
               "of chunks of the phase, or 0 once OUT is written"))
      ->check(word_that(is_step, "cut, close or the number of a chunk"))
      ->type_name("cut|N|close");
}

} // namespace quadrille_examples

#endif
