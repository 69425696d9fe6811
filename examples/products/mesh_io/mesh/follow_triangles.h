#ifndef QUADRILLE_EXAMPLES_MESH_IO_FOLLOW_TRIANGLES_H
#define QUADRILLE_EXAMPLES_MESH_IO_FOLLOW_TRIANGLES_H

#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// One value for each triangle, as that of which it is a part has it.
template <class Value>
void follow_triangles(std::vector<Value>& values, const std::vector<std::size_t>& triangles) {
  if (values.empty())
    return;
  std::vector<Value> result;
  for (const std::size_t triangle : triangles)
    result.push_back(values[triangle]);
  values = std::move(result);
}

/// The numbers of those that are not dropped.
inline std::vector<std::size_t> kept_triangles(const std::vector<bool>& is_dropped) {
  std::vector<std::size_t> kept;
  for (std::size_t triangle = 0; triangle < is_dropped.size(); ++triangle)
    if (!is_dropped[triangle])
      kept.push_back(triangle);
  return kept;
}

} // namespace quadrille_examples

#endif
