#ifndef QUADRILLE_INTERNAL_FILE_BOUNDARY_VERTICES_H
#define QUADRILLE_INTERNAL_FILE_BOUNDARY_VERTICES_H

#include <quadrille/internal/file/loaded_part.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Which vertices of a part are at an edge of one face, of the whole surface: see TrueBorders.
inline std::vector<bool> boundary_vertices(const LoadedPart& part) {
  std::vector<std::array<Index, 2>> edges; // those that no other part has
  edges.reserve(3 * part.triangles.size());
  for (const std::array<Index, 3>& t : part.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = (std::min)(t[i], t[(i + 1) % 3]), b = (std::max)(t[i], t[(i + 1) % 3]);
      if (!part.is_shared[a] || !part.is_shared[b])
        edges.push_back({a, b});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> result(part.positions.size());
  const auto mark = [&](const std::array<Index, 2>& edge) {
    result[edge[0]] = result[edge[1]] = true;
  };
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end] == edges[i];)
      ++end;
    if (end == i + 1)
      mark(edges[i]);
  }
  for (const std::array<Index, 2>& edge : part.borders)
    mark(edge);
  return result;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_BOUNDARY_VERTICES_H
