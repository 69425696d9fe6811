#ifndef QUADRILLE_COMPILED_SOUP_RUN_H
#define QUADRILLE_COMPILED_SOUP_RUN_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/soup_arrays.h>

#include <cstddef>
#include <functional>
#include <vector>

/// \file
/// A call on its way to the source file that is compiled for its cost.

namespace quadrille::internal {

struct SoupRun {
  const SoupView& soup;
  const SoupOptions& options;
  SoupPointArray points;
  SoupTriangleArray triangles;
  std::vector<SoupChannel> channels; ///< empty until they are rewritten
  std::vector<std::size_t> vertex_map;

  /// Returns whether the soup has anything in addition to points and triangles.
  bool is_carrying() const {
    return !soup.labels.empty() || !soup.channels.empty() || options.split_vertices;
  }
};

/// Checks a call, calls `simplify`, and collects the result.
SoupResult run_soup(const SoupView& soup, const SoupOptions& options,
                    const std::function<Report(SoupRun&)>& simplify);

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_RUN_H
