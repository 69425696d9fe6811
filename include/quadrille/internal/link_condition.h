#ifndef QUADRILLE_INTERNAL_LINK_CONDITION_H
#define QUADRILLE_INTERNAL_LINK_CONDITION_H

#include <quadrille/internal/marks.h>
#include <quadrille/internal/star.h>
#include <quadrille/internal/triangle_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// Tells whether a contraction keeps the topology of the surface.
///
/// The contraction of an edge ab does, if Lk(a) ∩ Lk(b) = Lk(ab), where the links of boundary edges
/// are joined to a point at infinity. Vertices that are neither inside the surface nor on its
/// boundary (on an edge of three faces, or where two sheets meet in a point) are called singular;
/// for them the test here is stricter than it need be: two of them are never contracted. Source:
/// Dey, Edelsbrunner, Guha and Nekhayev, Topology preserving edge contraction, 1999.
class LinkCondition {
public:
  /// Classifies every vertex, in linear time.
  LinkCondition(TriangleComplex& complex, Marks& marks)
      : kind_(complex.vertex_capacity(), Kind::interior) {
    std::vector<StarFace> star;
    std::vector<LinkVertex> link;
    for (Index v = 0; v < complex.vertex_capacity(); ++v) {
      star.clear();
      complex.for_each_corner(
          v, [&](Index face, Index i) { star.push_back(PairStar::star_face(complex, face, i)); });
      kind_[v] = classify(star, marks, link);
    }
  }

  bool holds(const PairStar& star, Index a, Index b, Marks& marks) const {
    if (star.shared.empty())
      return false; // not an edge
    marks.clear(2);
    constexpr Index in_first = 0, in_both = 1;
    for (const StarFace& f : star.first)
      mark_unless(f, a, b, in_first, marks);
    for (const StarFace& f : star.shared)
      mark_unless(f, a, b, in_first, marks);
    std::size_t common = 0;
    const auto count_common = [&](Index v) {
      if (marks.is_marked_with(v, in_first)) {
        marks.set(v, in_both);
        ++common;
      }
    };
    for (const StarFace& f : star.second) {
      count_common(f.second);
      count_common(f.third);
    }
    for (const StarFace& f : star.shared) {
      count_common(f.second);
      count_common(f.third);
    }
    if (common != star.shared.size())
      return false; // a common neighbour that is not opposite to the edge, or a doubled face
    for (const StarFace& f : star.first)
      if (marks.is_marked_with(f.second, in_both) && marks.is_marked_with(f.third, in_both) &&
          has_link_edge(star.second, f.second, f.third))
        return false; // a common edge: the two would become a doubled face
    return kind_[a] == Kind::interior || kind_[b] == Kind::interior ||
           is_along_boundary(star, a, b);
  }

  void merge(Index kept, Index gone) { kind_[kept] = std::max(kind_[kept], kind_[gone]); }

private:
  enum class Kind : std::uint8_t { interior, boundary, singular };

  static void mark_unless(const StarFace& f, Index a, Index b, Index number, Marks& marks) {
    for (Index v : {f.second, f.third})
      if (v != a && v != b)
        marks.set(v, number);
  }

  static bool has_link_edge(const std::vector<StarFace>& star, Index p, Index q) {
    return std::any_of(star.begin(), star.end(), [&](const StarFace& f) {
      return (f.second == p && f.third == q) || (f.second == q && f.third == p);
    });
  }

  // Both ends lie on the boundary (or are singular): so must the edge, and no triangle of boundary
  // edges may vanish with it.
  bool is_along_boundary(const PairStar& star, Index a, Index b) const {
    if (star.shared.size() != 1 || (kind_[a] == Kind::singular && kind_[b] == Kind::singular))
      return false;
    const StarFace& f = star.shared.front();
    const Index opposite = f.second == b ? f.third : f.second;
    return has_vertex(star.first, opposite) || has_vertex(star.second, opposite);
  }

  static bool has_vertex(const std::vector<StarFace>& star, Index v) {
    return std::any_of(star.begin(), star.end(),
                       [&](const StarFace& f) { return f.second == v || f.third == v; });
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

  // The link of an interior vertex is one cycle, that of a boundary vertex one path.
  static Kind classify(const std::vector<StarFace>& star, Marks& marks,
                       std::vector<LinkVertex>& link) {
    number_link(star, marks, link);
    std::size_t ends = 0;
    Index start = 0;
    for (Index i = 0; i < link.size(); ++i) {
      if (link[i].degree > 2)
        return Kind::singular;
      if (link[i].degree == 1) {
        ++ends;
        start = i;
      }
    }
    if (star.empty() || ends > 2 || walk(link, start) != star.size())
      return Kind::singular;
    return ends == 0 ? Kind::interior : Kind::boundary;
  }

  static void number_link(const std::vector<StarFace>& star, Marks& marks,
                          std::vector<LinkVertex>& link) {
    link.clear();
    marks.clear(static_cast<Index>(2 * star.size()));
    const auto number_of = [&](Index v) {
      if (!marks.is_marked(v)) {
        marks.set(v, static_cast<Index>(link.size()));
        link.emplace_back();
      }
      return marks[v];
    };
    for (const StarFace& f : star) {
      const Index p = number_of(f.second), q = number_of(f.third);
      link[p].add(q);
      link[q].add(p);
    }
  }

  // The number of edges on the way from `start` to the other end of its path, or round its cycle.
  static std::size_t walk(const std::vector<LinkVertex>& link, Index start) {
    if (link.empty())
      return 0;
    Index previous = start;
    Index current = link[start].neighbours[0];
    std::size_t edges = 1;
    while (current != start && link[current].degree == 2) {
      const auto& n = link[current].neighbours;
      const Index next = n[0] == previous ? n[1] : n[0];
      previous = current;
      current = next;
      ++edges;
    }
    return edges;
  }

  std::vector<Kind> kind_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LINK_CONDITION_H
