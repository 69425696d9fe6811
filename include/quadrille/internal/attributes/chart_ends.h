#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHART_ENDS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHART_ENDS_H

#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/edge_sides.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace quadrille::internal {

/// An edge vw of a face at which its chart ends.
struct ChartEnd {
  Index v, w, face;
};

/// Finds the edges at which the charts of a texture end: at boundaries of the surface, at seams and
/// at folds.
///
/// No edge of a vertex that is inside a chart can be one of these, and such are most: an edge is
/// looked at only if neither end is.
class ChartEnds {
public:
  /// A walk around a vertex is spared where the link condition knows its kind.
  ChartEnds(const TriangleComplex& complex, const LinkCondition& link_condition,
            const Channel& channel)
      : complex_(complex), link_condition_(link_condition), channel_(channel),
        signs_(complex.face_capacity(), 0, complex.arena()),
        is_inside_(complex.vertex_capacity(), 0, complex.arena()) {
    for_each_face(complex_, [&](Index face) {
      const double area = channel_.texture_area(complex_, face);
      signs_[face] = static_cast<signed char>((area > 0) - (area < 0));
    });
    find_inner_vertices();
    EdgeSides edges;
    for (Index v = 0; v < is_inside_.size(); ++v)
      if (!is_inside_[v]) {
        edges.gather(complex_, v);
        edges.for_each([&](Index w, const auto& sides) { add(v, w, sides); });
      }
  }

  const std::vector<ChartEnd>& ends() const { return ends_; }
  bool has_seams() const { return seams_ > 0; }
  /// The fraction of edges that are seams or folds.
  double fraction_of_seams() const {
    return static_cast<double>(seams_) / (static_cast<double>(edge_ends_) / 2);
  }

private:
  // A vertex is inside if it has one wedge, its faces lie on one side in the texture, and each of
  // its neighbours follows once and is followed once, around it.
  void find_inner_vertices() {
    const bool are_kinds_known = link_condition_.knows_kinds();
    Cycles cycles(complex_, are_kinds_known ? 0 : is_inside_.size());
    for (Index v = 0; v < is_inside_.size(); ++v) {
      if (!channel_.has_one_wedge(v) ||
          !(are_kinds_known ? link_condition_.is_oriented(v) : cycles.are_around(v)))
        continue;
      std::size_t faces = 0;
      int signs = 0;
      complex_.for_each_corner(v, [&](Index face, Index) {
        signs += signs_[face];
        ++faces;
      });
      is_inside_[v] = static_cast<std::size_t>(std::abs(signs)) == faces;
      edge_ends_ += is_inside_[v] ? faces : 0;
    }
  }

  // Answers whether the faces at a vertex are cycles, oriented alike, if nothing else knows.
  class Cycles {
  public:
    Cycles(const TriangleComplex& complex, std::size_t vertices)
        : complex_(complex), follows_(vertices, none, complex.arena()),
          is_followed_(vertices, none, complex.arena()) {}

    bool are_around(Index v) {
      bool are_simple = true;
      complex_.for_each_corner(v, [&](Index face, Index i) {
        const StarFace f = star_face_at(complex_, face, i);
        are_simple = are_simple && follows_[f.second] != v && is_followed_[f.third] != v;
        follows_[f.second] = is_followed_[f.third] = v;
      });
      complex_.for_each_corner(v, [&](Index face, Index i) {
        are_simple = are_simple && is_followed_[star_face_at(complex_, face, i).second] == v;
      });
      return are_simple;
    }

  private:
    const TriangleComplex& complex_;
    Array<Index> follows_, is_followed_; // of each vertex, around which one last
  };

  template <class Sides>
  void add(Index v, Index w, const Sides& sides) {
    ++edge_ends_;
    if (w < v || is_inside_[w] || (sides.size() == 2 && is_in_chart(v, w, sides)))
      return;
    seams_ += sides.size() > 1;
    for (const auto& side : sides)
      ends_.push_back({v, w, side.second});
  }
  template <class Sides>
  bool is_in_chart(Index v, Index w, const Sides& sides) const {
    const Index face = sides[0].second, other = sides[1].second;
    return !channel_.has_seam(complex_, face, other, v, w) &&
           !Channel::are_folded(complex_, face, signs_[face], other, signs_[other], v, w);
  }

  const TriangleComplex& complex_;
  const LinkCondition& link_condition_;
  const Channel& channel_;
  Array<signed char> signs_; // of the area of each face in the texture
  Array<unsigned char> is_inside_;
  std::vector<ChartEnd> ends_;
  std::size_t seams_ = 0, edge_ends_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHART_ENDS_H
