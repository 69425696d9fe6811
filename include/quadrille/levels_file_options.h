#ifndef QUADRILLE_LEVELS_FILE_OPTIONS_H
#define QUADRILLE_LEVELS_FILE_OPTIONS_H

#include <quadrille/internal/levels/bytes.h>

#include <string>

namespace quadrille {

/// How write_levels() writes levels: see <quadrille/levels_file.h>.
struct LevelsFileOptions {
  /// About half as many bytes. True where zstd is there; without it std::runtime_error.
  bool is_compressed = internal::has_zstd;
  /// Rounds coordinates and attributes to floats, as for a mesh of floats they are anyway.
  bool rounds_to_floats = false;
  std::string comment = {}; ///< anything: how the levels were made
};

} // namespace quadrille

#endif // QUADRILLE_LEVELS_FILE_OPTIONS_H
