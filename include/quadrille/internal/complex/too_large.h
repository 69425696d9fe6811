#ifndef QUADRILLE_INTERNAL_COMPLEX_TOO_LARGE_H
#define QUADRILLE_INTERNAL_COMPLEX_TOO_LARGE_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace quadrille::internal {

/// Refuses a surface that has more vertices or faces than there may be.
[[noreturn]] inline void throw_too_large(std::size_t vertices, std::size_t faces,
                                         std::size_t most_vertices, std::size_t most_faces) {
  throw std::length_error(
      "quadrille::simplify: " + std::to_string(vertices) + " vertices and " +
      std::to_string(faces) + " faces do not fit into 32-bit indices (at most " +
      std::to_string(most_vertices) + " and " + std::to_string(most_faces) + ")");
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COMPLEX_TOO_LARGE_H
