#ifndef QUADRILLE_INTERNAL_CORE_APPEARANCE_SEAM_GRAPH_H
#define QUADRILLE_INTERNAL_CORE_APPEARANCE_SEAM_GRAPH_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/edge_sides.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The position of a vertex in the seam graph: on no seam, on a line, or at a point where other
/// than two seam edges meet.
enum class SeamKind : std::uint8_t { free, line, corner };

/// The graph of seams in a surface: edges between two labels, edges at which a channel is
/// discontinuous whose seams are kept, edges at which a texture is mirrored, and edges of other
/// than two faces.
///
/// A contraction keeps the graph, in addition to the topology of the surface, if an edge between
/// two of its vertices is one of its own, no two corners become one, and no third vertex is joined
/// to both ends by seams. Source: Vivodtzev, Bonneau and Le Texier, Topology preserving
/// simplification of 2D non-manifold meshes with embedded structures, 2005.
///
/// `ChannelSeams` answers its questions about channels, or `NoChannelSeams` for a surface without
/// channels.
template <class OfChannels>
class SeamGraph {
public:
  SeamGraph() = default;
  /// `labels`: of each face, or empty. `of_channels`: the seams of channels, which stay where they
  /// are.
  SeamGraph(const TriangleComplex& complex, Array<Index> labels, OfChannels of_channels)
      : complex_(&complex), of_channels_(of_channels), label_(std::move(labels)),
        kind_(complex.arena()) {
    if (label_.empty() && !keeps_channels())
      return;
    kind_.resize(complex.vertex_capacity(), SeamKind::free);
    bool is_any_inside = false;
    EdgeSides edges;
    for (Index v = 0; v < kind_.size(); ++v) {
      edges.gather(complex, v);
      std::size_t seams = 0;
      for_each_edge(edges, v, [&](Index, bool is_seam, const auto& sides) {
        seams += is_seam;
        is_any_inside = is_any_inside || (is_seam && sides.size() > 1);
      });
      kind_[v] = seams == 0 ? SeamKind::free : seams == 2 ? SeamKind::line : SeamKind::corner;
    }
    if (!is_any_inside)
      kind_.clear();
  }

  /// Has the surface any seam but those of edges of other than two faces?
  bool is_empty() const { return kind_.empty(); }
  /// Are the seams of any channel kept?
  bool keeps_channels() const { return of_channels_.are_any_kept(); }
  /// The label of each face; may be empty.
  const Array<Index>& labels() const { return label_; }
  bool is_corner(Index v) const { return kind_[v] == SeamKind::corner; }

  /// Would the contraction of the pair ab change the graph?
  bool is_changed_by(const PairStar& star, Index a, Index b) const {
    if (is_empty())
      return false;
    if (kind_[a] != SeamKind::free && kind_[b] != SeamKind::free &&
        (!is_seam_edge(star.shared, a, b) || joins_seams(star, a, b)))
      return true;
    return of_channels_.are_changed_by(star, a, b);
  }

  /// Calls visit(v, w, sides) for each seam, once; the second of each side is a face.
  template <class Visit>
  void for_each_seam(Visit visit) const {
    EdgeSides edges;
    for (Index v = 0; v < kind_.size(); ++v) {
      if (kind_[v] == SeamKind::free)
        continue;
      edges.gather(*complex_, v);
      for_each_edge(edges, v, [&](Index w, bool is_seam, const auto& sides) {
        if (is_seam && v < w)
          visit(v, w, sides);
      });
    }
  }

  static constexpr bool is_seldom_there = true;
  static auto vertex_arrays(auto& self) { return std::tie(self.kind_); }
  /// Leaves out those of faces for which is_left(face) is false.
  template <class IsLeft>
  void pack_if(IsLeft is_left) {
    internal::pack_if(label_, is_left);
  }

  void merge(Index kept, Index gone) {
    if (!is_empty())
      kind_[kept] = (std::max)(kind_[kept], kind_[gone]);
  }

private:
  // Calls visit(other, is_seam, sides) for each edge at a vertex, in the order of the other ends.
  template <class Visit>
  void for_each_edge(EdgeSides& edges, Index v, Visit visit) const {
    edges.for_each([&](Index w, std::span<const EdgeSides::Side> sides) {
      visit(w, sides.size() != 2 || is_seam(sides[0].second, sides[1].second, v, w), sides);
    });
  }

  // Is the edge vw of two faces a seam?
  bool is_seam(Index face, Index other, Index v, Index w) const {
    return (!label_.empty() && label_[face] != label_[other]) ||
           of_channels_.are_at(face, other, v, w);
  }

  // Is the edge ab, with these faces, a seam? A pair without a face is no edge.
  bool is_seam_edge(const AppendBuffer<StarFace>& faces, Index a, Index b) const {
    return faces.size() == 1 || faces.size() > 2 ||
           (faces.size() == 2 && is_seam(faces[0].face, faces[1].face, a, b));
  }

  // The vertices that seams join to an end v of the pair, in order, but the other end. The faces
  // at that end alone are given.
  std::vector<Index> seam_neighbours(Index v, const AppendBuffer<StarFace>& faces,
                                     const PairStar& star, Index b) const {
    EdgeSides edges;
    for (const StarFace& f : faces)
      edges.add(f);
    for (const StarFace& f : star.shared)
      edges.add(f.other_than(b), f.face);
    std::vector<Index> neighbours;
    for_each_edge(edges, v, [&](Index other, bool is_seam, const auto&) {
      if (is_seam)
        neighbours.push_back(other);
    });
    return neighbours;
  }

  // Would two corners become one, or is there a vertex that seams join to both ends? A vertex may
  // have got further seams since the beginning: half ones that met, and folds of faces that had no
  // area in the texture.
  bool joins_seams(const PairStar& star, Index a, Index b) const {
    const std::vector<Index> at_first = seam_neighbours(a, star.first, star, b);
    const std::vector<Index> at_second = seam_neighbours(b, star.second, star, b);
    if ((is_corner(a) || at_first.size() != 1) && (is_corner(b) || at_second.size() != 1))
      return true;
    std::vector<Index> common;
    std::set_intersection(at_first.begin(), at_first.end(), at_second.begin(), at_second.end(),
                          std::back_inserter(common));
    return !common.empty();
  }

  const TriangleComplex* complex_ = nullptr;
  QUADRILLE_NO_UNIQUE_ADDRESS OfChannels of_channels_;
  Array<Index> label_;   // of each face; empty if there are none
  Array<SeamKind> kind_; // of each vertex; empty if there are no seams
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_APPEARANCE_SEAM_GRAPH_H
