#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_9_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_9_H

#include "pictures.h"
#include "surfaces.h"

#include <quadrille/threshold_pairs.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace figures {

/// The pairs of vertices of a foot that are selected at the beginning: its edges, and what is
/// closer than the paper's threshold.
struct Figure9 {
  static constexpr double threshold = 0.318;

  std::vector<PairSegment<Point>> segments;

  explicit Figure9(const fs::path& models)
      : segments(pair_segments(read_model(models, "bones"), quadrille::ThresholdPairs{threshold})) {
  }

  std::size_t count(bool are_edges) const {
    return static_cast<std::size_t>(
        std::ranges::count(segments, are_edges, &PairSegment<Point>::is_edge));
  }

  void print() const {
    std::printf("edges   other pairs closer than %.3f\n%5zu %27zu\n", threshold, count(true),
                count(false));
  }

  void write(const fs::path& folder) const {
    write_segments(true, folder, "9_bones_edges");
    write_segments(false, folder, "9_bones_pairs");
  }

private:
  // As lines of an OBJ file.
  void write_segments(bool are_edges, const fs::path& folder, const std::string& name) const {
    const fs::path path = folder / (name + ".obj");
    std::ofstream file(path);
    std::size_t vertices = 0;
    for (const auto& segment : segments) {
      if (segment.is_edge != are_edges)
        continue;
      for (const Point& p : segment.ends)
        file << "v " << p << '\n';
      file << "l " << vertices + 1 << ' ' << vertices + 2 << '\n';
      vertices += 2;
    }
    require_written(static_cast<bool>(file.flush()), path);
  }
};

} // namespace figures

#endif
