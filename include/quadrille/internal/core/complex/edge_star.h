#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_STAR_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_STAR_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>

#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// An edge as its one end sees it.
struct EdgeAt {
  Index other;                     // the other end
  std::size_t faces = 0;           // how many faces it has
  std::array<Index, 2> opposite{}; // the third vertices of the first two
};

/// The edges at a vertex, each once, in the order in which they are met.
class EdgeStar {
public:
  const std::vector<EdgeAt>& gather(TriangleComplex& complex, Index v, VertexLabels& labels) {
    edges_.clear();
    labels.clear(2 * complex.degree_bound(v));
    complex.prune_corners(v, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex, face, i);
      add(f.second, f.third, labels);
      add(f.third, f.second, labels);
    });
    return edges_;
  }

private:
  void add(Index w, Index opposite, VertexLabels& labels) {
    if (!labels.is_labelled(w)) {
      labels.set(w, static_cast<Index>(edges_.size()));
      edges_.push_back({w});
    }
    EdgeAt& edge = edges_[labels[w]];
    if (edge.faces < 2)
      edge.opposite[edge.faces] = opposite;
    ++edge.faces;
  }

  std::vector<EdgeAt> edges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_STAR_H
