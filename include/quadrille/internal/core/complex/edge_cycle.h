#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_CYCLE_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_CYCLE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Three vertices, each joined to the next by an edge.
using EdgeCycle = std::array<Index, 3>;

/// Is there an edge between two vertices?
inline bool has_edge(const TriangleComplex& complex, Index a, Index b) {
  return complex.any_corner(
      a, [&](Index face, Index i) { return star_face_at(complex, face, i).has(b); });
}
/// Is there a face of three vertices, either way round?
inline bool has_face(const TriangleComplex& complex, const EdgeCycle& v) {
  return complex.any_corner(v[0], [&](Index face, Index i) {
    const StarFace f = star_face_at(complex, face, i);
    return f.has(v[1]) && f.has(v[2]);
  });
}
/// Are these joined by edges, and is there no face between them?
inline bool is_open_cycle(const TriangleComplex& complex, const EdgeCycle& v) {
  return has_edge(complex, v[0], v[1]) && has_edge(complex, v[1], v[2]) &&
         has_edge(complex, v[2], v[0]) && !has_face(complex, v);
}

/// The faces at a vertex inside the surface from the edge to one neighbour to that to another one,
/// turning as the faces run.
inline std::vector<StarFace> faces_between(const TriangleComplex& complex, Index vertex, Index from,
                                           Index to) {
  std::vector<StarFace> star, between;
  complex.for_each_corner(
      vertex, [&](Index face, Index i) { star.push_back(star_face_at(complex, face, i)); });
  for (Index at = from; at != to && between.size() < star.size(); at = between.back().third)
    between.push_back(*std::find_if(star.begin(), star.end(),
                                    [at](const StarFace& f) { return f.second == at; }));
  return between;
}

/// The faces next to a cycle inside the surface, at each of its vertices: on its left side, whose
/// faces run along its edges as it does, and on its right.
struct CycleSides {
  std::array<std::vector<StarFace>, 3> left, right;

  CycleSides(const TriangleComplex& complex, const EdgeCycle& v) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index next = v[(i + 1) % 3], previous = v[(i + 2) % 3];
      left[i] = faces_between(complex, v[i], next, previous);
      right[i] = faces_between(complex, v[i], previous, next);
    }
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_CYCLE_H
