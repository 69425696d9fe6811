#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_TOPOLOGY_COUNT_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_TOPOLOGY_COUNT_H

#include <quadrille/internal/core/complex/edge_star.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Returns for each vertex the one that represents its connected component.
inline Array<Index> component_roots(const TriangleComplex& complex) {
  Array<Index> parent(complex.vertex_capacity(), complex.arena());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    const auto [a, b, c] = complex.vertices(face);
    parent[root(b)] = root(a);
    parent[root(c)] = root(a);
  }
  for (Index v = 0; v < parent.size(); ++v)
    parent[v] = root(v);
  return parent;
}

/// Counts the connected components.
inline std::size_t count_components(const TriangleComplex& complex) {
  const Array<Index> root = component_roots(complex);
  std::size_t components = 0;
  for (Index v = 0; v < root.size(); ++v)
    components += root[v] == v && complex.has_faces(v);
  return components;
}

struct TopologyCount {
  std::size_t components = 0, non_manifold_edges = 0, non_manifold_vertices = 0;

  void write_to(Report& report) const {
    report.components_after = components;
    report.non_manifold_edges = non_manifold_edges;
    report.non_manifold_vertices = non_manifold_vertices;
  }
};

/// Is a vertex that has faces with reverse faces neither a disc nor half a disc around? It is a
/// disc where a face is alone with its reverse. Edges of more than two faces, reverse faces being
/// such, are counted.
inline bool is_non_manifold_with_reverse_faces(const TriangleComplex& complex, Index v,
                                               TopologyCount& count) {
  std::vector<std::pair<Index, std::size_t>> edges; // the other end, how many faces
  std::size_t faces = 0;
  complex.for_each_corner(v, [&](Index face, Index i) {
    const StarFace f = star_face_at(complex, face, i);
    for (Index other : {f.second, f.third})
      edges.emplace_back(other, complex.reverse_faces().count(face));
    ++faces;
  });
  std::sort(edges.begin(), edges.end());
  for (auto begin = edges.begin(); begin != edges.end();) {
    std::size_t at_edge = 0;
    const Index other = begin->first;
    for (; begin != edges.end() && begin->first == other; ++begin)
      at_edge += begin->second;
    count.non_manifold_edges += at_edge > 2 && v < other;
  }
  return faces > 1;
}

inline TopologyCount count_topology(TriangleComplex& complex, VertexLabels& labels) {
  TopologyCount count{count_components(complex)};
  VertexClassifier classify;
  EdgeStar star;
  for (Index v = 0; v < complex.vertex_capacity(); ++v) {
    if (!complex.has_faces(v))
      continue;
    if (complex.any_corner(v,
                           [&](Index face, Index) { return complex.reverse_faces().has(face); })) {
      count.non_manifold_vertices += is_non_manifold_with_reverse_faces(complex, v, count);
      continue;
    }
    if (classify(complex, v, labels) < VertexKind::spine)
      continue;
    ++count.non_manifold_vertices;
    for (const EdgeAt& edge : star.gather(complex, v, labels))
      count.non_manifold_edges += edge.faces > 2 && v < edge.other;
  }
  return count;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_TOPOLOGY_COUNT_H
