#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_LINK_CONDITION_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_LINK_CONDITION_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
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

/// Decides whether a contraction keeps the topology of the surface.
///
/// The contraction of an edge ab does, if Lk(a) ∩ Lk(b) = Lk(ab), where the links of boundary edges
/// are joined to a point at infinity. A line along which three surfaces or more meet, as the pages
/// of a book do at its spine, is contracted along itself; other vertices that are neither inside
/// the surface nor on its boundary (where such lines meet, or two surfaces in a point) are called
/// singular; for them the test here is stricter than it need be: two of them are never contracted.
/// Source: Dey, Edelsbrunner, Guha and Nekhayev, Topology preserving edge contraction, 1999.
class LinkCondition {
public:
  LinkCondition() = default;

  /// Classifies every vertex, in linear time. labels_of(worker) are labels for each thread.
  template <class LabelsOf>
  LinkCondition(TriangleComplex& complex, LabelsOf labels_of, Threads threads = Threads())
      : kind_(complex.vertex_capacity(), complex.arena()) {
    for_each_range(threads, kind_.size(), [&](const auto& range, std::size_t worker) {
      VertexClassifier classify;
      for (Index v = range.begin; v < range.end; ++v)
        kind_[v] = classify(complex, v, labels_of(worker));
    });
    is_closed_ =
        std::all_of(kind_.begin(), kind_.end(), [](Kind kind) { return kind <= Kind::unoriented; });
  }

  bool holds(const PairStar& star, Index a, Index b, VertexLabels& labels) const {
    if (star.shared.empty() || star.may_meet_high_valence)
      return false; // not an edge, or one that would join two high-valence vertices if they are not
                    // joined yet
    constexpr Index in_first = 0, in_both = 1;
    labels.clear(2);
    for (const StarFace& f : star.shared)
      labels.set(f.other_than(b), in_first);
    for_each_neighbour(star.first, a, [&](Index v) { labels.set(v, in_first); });
    std::size_t common = 0;
    const auto count_common = [&](Index v) {
      if (labels.has_label(v, in_first)) {
        labels.set(v, in_both);
        ++common;
      }
    };
    for_each_neighbour(star.second, b, count_common);
    for (const StarFace& f : star.shared)
      count_common(f.other_than(b));
    if (common != star.shared.size())
      return false; // a common neighbour that is not opposite to the edge, or a duplicate face
    for (const StarFace& f : star.first)
      if (labels.has_label(f.second, in_both) && labels.has_label(f.third, in_both) &&
          has_link_edge(star.second, f.second, f.third))
        return false; // a common edge: the two would become a duplicate face
    return (std::min)(kind_[a], kind_[b]) <= Kind::unoriented || is_along_boundary(star, a, b) ||
           is_along_spine(star, a, b, labels);
  }

  /// Does it know of each vertex how its faces lie? Not where topology is free.
  bool knows_kinds() const { return !kind_.empty(); }
  /// Is every vertex known to be inside the surface?
  bool is_closed() const { return is_closed_; }

  /// And are their faces oriented alike?
  bool is_oriented() const {
    return is_closed_ && std::all_of(kind_.begin(), kind_.end(),
                                     [](Kind kind) { return kind == Kind::interior; });
  }

  /// Is the vertex known to be inside the surface? A condition without a surface knows of none.
  bool is_interior(Index v) const { return !kind_.empty() && kind_[v] <= Kind::unoriented; }
  /// And is each neighbour the second vertex of just one of its faces?
  bool is_oriented(Index v) const { return !kind_.empty() && kind_[v] == Kind::interior; }

  /// Is it known that more than one surface may meet at the vertex?
  bool may_be_junction(Index v) const { return !kind_.empty() && kind_[v] > Kind::boundary; }

  static auto vertex_arrays(auto& self) { return std::tie(self.kind_); }
  QUADRILLE_ALWAYS_INLINE void prefetch(Index v) const {
    if (!kind_.empty())
      internal::prefetch(&kind_[v]);
  }

  /// A vertex of two kinds is of the one that allows less.
  void merge(Index kept, Index gone) {
    if (!kind_.empty())
      kind_[kept] = (std::max)(kind_[kept], kind_[gone]);
  }

private:
  using Kind = VertexKind;

  // The second vertices of the faces at an oriented vertex are all its neighbours but those of its
  // shared faces.
  template <class Visit>
  void for_each_neighbour(const AppendBuffer<StarFace>& faces, Index v, Visit visit) const {
    if (kind_[v] == Kind::interior) {
      for (const StarFace& f : faces)
        visit(f.second);
      return;
    }
    for (const StarFace& f : faces) {
      visit(f.second);
      visit(f.third);
    }
  }

  static bool has_link_edge(const AppendBuffer<StarFace>& star, Index p, Index q) {
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
    const Index opposite = f.other_than(b);
    return has_vertex(star.first, opposite) || has_vertex(star.second, opposite);
  }

  // Both ends lie on one spine: then the edge must as well, and nothing may join the ends
  // elsewhere. It is enough to look from one of two ends on the spine: from the end with more
  // faces, so that numbers do not matter, or from either where both have as many.
  bool is_along_spine(const PairStar& star, Index a, Index b, VertexLabels& labels) const {
    if (star.shared.size() < 3 || (kind_[a] != Kind::spine && kind_[b] != Kind::spine))
      return false;
    const bool are_both = kind_[a] == kind_[b];
    const auto is_seen_from = [&](Index end, Index other, const auto& faces, const auto& others) {
      const bool is_the_one =
          star.high_valence == none ? faces.size() >= others.size() : star.high_valence == other;
      return kind_[end] == Kind::spine && (!are_both || is_the_one) &&
             goes_on_after(faces, star.shared, labels);
    };
    return is_seen_from(a, b, star.first, star.second) ||
           is_seen_from(b, a, star.second, star.first);
  }

  // Does the spine continue beyond one end of an edge, without returning to it? The next vertex on
  // it belongs to as many faces as the edge has, all of which are among these unless it is opposite
  // to it.
  static bool goes_on_after(const AppendBuffer<StarFace>& faces,
                            const AppendBuffer<StarFace>& shared, VertexLabels& labels) {
    const Index pages = static_cast<Index>(shared.size());
    labels.clear(pages + 1);
    for (const StarFace& f : faces)
      for (Index v : {f.second, f.third}) {
        labels.set(v, labels.is_labelled(v) ? labels[v] + 1 : 1);
        if (labels[v] == pages)
          return true;
      }
    return false;
  }

  static bool has_vertex(const AppendBuffer<StarFace>& star, Index v) {
    return std::any_of(star.begin(), star.end(), [&](const StarFace& f) { return f.has(v); });
  }

  Array<Kind> kind_;
  bool is_closed_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_LINK_CONDITION_H
