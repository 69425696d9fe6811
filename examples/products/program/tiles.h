#ifndef QUADRILLE_EXAMPLES_PROGRAM_TILES_H
#define QUADRILLE_EXAMPLES_PROGRAM_TILES_H

#include "options.h"

#include <quadrille/file_report.h>

#include <glob.h>

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille_examples {

/// Is IN no file but a pattern of names, as a shell has them?
inline bool is_pattern(const Options& options) {
  return options.input.find_first_of("*?[") != std::string::npos &&
         !std::filesystem::exists(options.input);
}

/// IN, or the files that it names as a pattern of the shell, in the order of their names: tiles of
/// one surface.
inline quadrille::SurfaceFiles surface_files(const Options& options) {
  if (!is_pattern(options))
    return options.input;
  ::glob_t found = {};
  const bool is_any = ::glob(options.input.c_str(), GLOB_ERR, nullptr, &found) == 0;
  std::vector<std::filesystem::path> tiles;
  for (std::size_t i = 0; is_any && i < found.gl_pathc; ++i)
    tiles.emplace_back(found.gl_pathv[i]);
  ::globfree(&found);
  if (tiles.empty())
    throw std::runtime_error(options.input + ": no file matches this pattern");
  return tiles;
}

/// Is OUT a folder, in which each tile becomes a file again?
inline bool keeps_tiles(const Options& options) {
  return options.output.ends_with('/') ||
         (is_pattern(options) && std::filesystem::is_directory(options.output));
}

/// OUT, or the tiles in it.
inline quadrille::SurfaceFiles result_files(const Options& options) {
  if (!keeps_tiles(options))
    return options.output;
  std::vector<std::filesystem::path> tiles;
  for (const std::filesystem::path& tile : surface_files(options).paths)
    tiles.push_back(options.output / tile.filename().replace_extension(".ply"));
  return tiles;
}

} // namespace quadrille_examples

#endif
