#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_COUNT_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_COUNT_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille::internal {

/// How many edges the faces have for which counts(face) holds, each edge once however many faces it
/// has. In linear time.
template <class Counts>
std::size_t count_edges(const TriangleComplex& complex, VertexLabels& labels, Counts counts) {
  std::size_t edges = 0;
  for (Index v = 0; v < complex.vertex_capacity(); ++v) {
    labels.clear();
    complex.for_each_corner(v, [&](Index face, Index i) {
      if (!counts(face))
        return;
      const StarFace f = star_face_at(complex, face, i);
      for (const Index other : {f.second, f.third})
        edges += v < other && labels.insert(other);
    });
  }
  return edges;
}

/// How many edges these faces have.
inline std::size_t count_edges(const TriangleComplex& complex, std::span<const Index> faces) {
  std::vector<std::array<Index, 2>> edges;
  for (const Index face : faces) {
    const auto [a, b, c] = complex.vertices(face);
    for (const std::array<Index, 2>& edge : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
      edges.push_back({(std::min)(edge[0], edge[1]), (std::max)(edge[0], edge[1])});
  }
  std::sort(edges.begin(), edges.end());
  return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

/// How many edges the contraction of a pair takes, of which `b` is the second end: its own; one for
/// each vertex that has an edge to both ends; and both of these where all faces of the vertex at
/// the pair are removed. Does not depend on what else is removed, since of faces that come to lie
/// on each other one is left.
inline std::size_t count_edges_taken(const PairStar& star, Index b, VertexLabels& labels) {
  enum : Index { at_first, at_second, is_counted, kinds };
  labels.clear(kinds);
  for (const StarFace& f : star.first)
    for (const Index v : {f.second, f.third})
      labels.set(v, at_first);
  std::size_t edges = !star.shared.empty();
  for (const StarFace& f : star.second)
    for (const Index v : {f.second, f.third}) {
      if (!labels.is_labelled(v)) {
        labels.set(v, at_second);
      } else if (labels.has_label(v, at_first)) {
        ++edges;
        labels.set(v, is_counted);
      }
    }
  for (const StarFace& f : star.shared) {
    const Index v = f.other_than(b);
    edges += !labels.is_labelled(v) ? 2 : !labels.has_label(v, is_counted);
    labels.set(v, is_counted);
  }
  return edges;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_COUNT_H
