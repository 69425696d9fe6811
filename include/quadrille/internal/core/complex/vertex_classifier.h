#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_VERTEX_CLASSIFIER_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_VERTEX_CLASSIFIER_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// How the faces lie around a vertex: all round and each in the same sense, all round in senses
/// that differ, along a path, as three pages or more of a book on whose spine the vertex is, or
/// otherwise.
enum class VertexKind : std::uint8_t { interior, unoriented, boundary, spine, singular };

/// Classifies vertices by their links: that of an interior vertex is one cycle, that of a boundary
/// vertex one path, that of a vertex on a spine three paths or more between the same two ends.
class VertexClassifier {
public:
  VertexKind operator()(TriangleComplex& complex, Index v, VertexLabels& labels) {
    star_.resize(complex.degree_bound(v));
    Index faces = 0;
    labels.clear(star_.size());
    complex.prune_corners(v, [&](Index face, Index i) {
      const StarFace f = star_[faces] = star_face_at(complex, face, i);
      labels.set(f.second, faces++);
    });
    star_.resize(faces);
    return is_oriented_cycle(labels) ? VertexKind::interior : classify(labels);
  }

private:
  // The usual case: each face of the star follows just one other, all round. A vertex of the link
  // is labelled with the face that begins at it.
  bool is_oriented_cycle(const VertexLabels& labels) const {
    const Index faces = static_cast<Index>(star_.size());
    Index face = 0;
    for (Index step = 0; step < faces; ++step) {
      const Index end = star_[face].third;
      if (!labels.is_labelled(end) || labels[end] == 0)
        return step + 1 == faces && labels.is_labelled(end); // round; too early if faces are left
      face = labels[end];
    }
    return false;
  }

  struct LinkVertex {
    Index degree = 0;
    std::array<Index, 2> neighbours{}; // the first two

    void add(Index neighbour) {
      if (degree < 2)
        neighbours[degree] = neighbour;
      ++degree;
    }
  };

  VertexKind classify(VertexLabels& labels) {
    number_link(labels);
    std::size_t ends = 0;
    Index start = 0;
    for (Index i = 0; i < link_.size(); ++i) {
      if (link_[i].degree > 2)
        return is_spine(i, labels) ? VertexKind::spine : VertexKind::singular;
      if (link_[i].degree == 1) {
        ++ends;
        start = i;
      }
    }
    if (star_.empty())
      return VertexKind::interior; // it takes part in nothing
    if (ends > 2 || walk(start) != star_.size())
      return VertexKind::singular;
    return ends == 0 ? VertexKind::unoriented : VertexKind::boundary;
  }

  void number_link(VertexLabels& labels) {
    link_.clear();
    labels.clear(2 * star_.size());
    const auto number_of = [&](Index v) {
      if (!labels.is_labelled(v)) {
        labels.set(v, static_cast<Index>(link_.size()));
        link_.emplace_back();
      }
      return labels[v];
    };
    for (const StarFace& f : star_) {
      const Index p = number_of(f.second), q = number_of(f.third);
      link_[p].add(q);
      link_[q].add(p);
    }
  }

  struct Path {
    std::size_t edges;
    Index end;
  };

  // From `start` over `current` to the other end of that path, or round its cycle.
  Path follow(Index start, Index current) const {
    Index previous = start;
    std::size_t edges = 1;
    while (current != start && link_[current].degree == 2) {
      const auto& n = link_[current].neighbours;
      const Index next = n[0] == previous ? n[1] : n[0];
      previous = current;
      current = next;
      ++edges;
    }
    return {edges, current};
  }
  std::size_t walk(Index start) const {
    return link_.empty() ? 0 : follow(start, link_[start].neighbours[0]).edges;
  }

  // Does every path from an end of pages lead to the same other end, and are there no other edges?
  bool is_spine(Index first, const VertexLabels& labels) const {
    Index second = none;
    std::size_t edges = 0;
    const auto leads_to_second = [&](Index next) {
      const Path path = follow(first, next);
      edges += path.edges;
      second = second == none ? path.end : second;
      return path.end == second && path.end != first;
    };
    for (const StarFace& f : star_) {
      const Index p = labels[f.second], q = labels[f.third];
      if ((p == first && !leads_to_second(q)) || (q == first && !leads_to_second(p)))
        return false;
    }
    return edges == star_.size() && link_[second].degree == link_[first].degree;
  }

  std::vector<StarFace> star_;
  std::vector<LinkVertex> link_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_VERTEX_CLASSIFIER_H
