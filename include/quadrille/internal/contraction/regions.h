#ifndef QUADRILLE_INTERNAL_CONTRACTION_REGIONS_H
#define QUADRILLE_INTERNAL_CONTRACTION_REGIONS_H

#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Where a vertex is on the seams of a surface: on none, on a line, or where other than two of
/// their edges meet.
enum class SeamKind : std::uint8_t { free, line, corner };

/// The regions of equal labels, and the graph of seams between them: edges of two labels, and edges
/// of other than two faces.
///
/// A contraction keeps the graph, beside the topology of the surface, if an edge between two of its
/// vertices is one of its own, no two corners become one, and no third vertex is joined to both
/// ends by seams. Source: Vivodtzev, Bonneau and Le Texier, Topology preserving simplification of
/// 2D non-manifold meshes with embedded structures, 2005.
class Regions {
public:
  Regions() = default;
  /// `labels`: of each face.
  Regions(const TriangleComplex& complex, Array<Index> labels)
      : label_(std::move(labels)),
        kind_(complex.vertex_capacity(), SeamKind::free, complex.workspace()) {
    Edges edges;
    for (Index v = 0; v < kind_.size(); ++v) {
      gather(edges, complex, v);
      std::size_t seams = 0;
      edges.for_each([&](Index, bool is_seam, bool) { seams += is_seam; });
      kind_[v] = seams == 0 ? SeamKind::free : seams == 2 ? SeamKind::line : SeamKind::corner;
    }
  }

  bool is_corner(Index v) const { return kind_[v] == SeamKind::corner; }

  /// Would the contraction of the pair ab change the graph?
  bool are_changed_by(const PairStar& star, Index a, Index b) const {
    if (kind_[a] == SeamKind::free || kind_[b] == SeamKind::free)
      return false;
    return !is_seam_edge(star.shared) || (is_corner(a) && is_corner(b)) || has_common_seam(star, b);
  }

  /// Edges of two faces between different labels, each once.
  std::vector<std::array<Index, 2>> borders(const TriangleComplex& complex) const {
    std::vector<std::array<Index, 2>> borders;
    Edges edges;
    for (Index v = 0; v < kind_.size(); ++v) {
      if (kind_[v] == SeamKind::free)
        continue;
      gather(edges, complex, v);
      edges.for_each([&](Index other, bool, bool is_border) {
        if (is_border && v < other)
          borders.push_back({v, other});
      });
    }
    return borders;
  }

  static auto vertex_columns(auto& self) { return std::tie(self.kind_); }
  /// Leaves out those of faces for which is_left(face) is false.
  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    internal::pack_if(label_, is_left);
  }

  template <class Event>
  void after(const Event& event) {
    kind_[event.kept] = (std::max)(kind_[event.kept], kind_[event.gone]);
  }

private:
  // The edges at a vertex, by the labels of their faces.
  class Edges {
  public:
    void clear() { sides_.clear(); }
    void add(Index other, Index label) { sides_.push_back({other, label}); }
    // The two edges of a face at the vertex.
    void add(const StarFace& f, Index label) {
      add(f.second, label);
      add(f.third, label);
    }

    // Calls visit(other, is_seam, is_border) for each edge, in the order of the other ends: a
    // border is a seam of two faces.
    template <class Visit>
    void for_each(Visit visit) {
      std::sort(sides_.begin(), sides_.end());
      for (auto side = sides_.begin(); side != sides_.end();) {
        const auto [other, label] = *side;
        const auto end = std::find_if(
            side, sides_.end(), [other = other](const auto& next) { return next.first != other; });
        const bool is_border = end - side == 2 && side[1].second != label;
        visit(other, is_border || end - side != 2, is_border);
        side = end;
      }
    }

  private:
    std::vector<std::pair<Index, Index>> sides_; // other end, label of the face
  };

  void gather(Edges& edges, const TriangleComplex& complex, Index v) const {
    edges.clear();
    complex.for_each_corner(
        v, [&](Index face, Index i) { edges.add(star_face_at(complex, face, i), label_[face]); });
  }

  // Of the edge that has these faces; a pair without a face is no edge.
  bool is_seam_edge(const AppendBuffer<StarFace>& faces) const {
    return faces.size() == 1 || faces.size() > 2 ||
           (faces.size() == 2 && label_[faces[0].face] != label_[faces[1].face]);
  }

  // The vertices that seams join to an end of the pair, in order, but the other end. The faces at
  // that end alone are given.
  std::vector<Index> seam_neighbours(const AppendBuffer<StarFace>& faces, const PairStar& star,
                                     Index b) const {
    Edges edges;
    for (const StarFace& f : faces)
      edges.add(f, label_[f.face]);
    for (const StarFace& f : star.shared)
      edges.add(f.other_than(b), label_[f.face]);
    std::vector<Index> neighbours;
    edges.for_each([&](Index other, bool is_seam, bool) {
      if (is_seam)
        neighbours.push_back(other);
    });
    return neighbours;
  }

  // Is there a vertex that seams join to both ends?
  bool has_common_seam(const PairStar& star, Index b) const {
    const std::vector<Index> at_first = seam_neighbours(star.first, star, b);
    const std::vector<Index> at_second = seam_neighbours(star.second, star, b);
    std::vector<Index> common;
    std::set_intersection(at_first.begin(), at_first.end(), at_second.begin(), at_second.end(),
                          std::back_inserter(common));
    return !common.empty();
  }

  Array<Index> label_;   // of each face
  Array<SeamKind> kind_; // of each vertex
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_REGIONS_H
