#ifndef QUADRILLE_EXAMPLES_MESH_IO_SHEET_SIDES_H
#define QUADRILLE_EXAMPLES_MESH_IO_SHEET_SIDES_H

#include "indexed_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Vertices of which some are one.
class JoinedVertices {
public:
  explicit JoinedVertices(std::size_t count) : firsts_(count) {
    std::iota(firsts_.begin(), firsts_.end(), std::uint32_t{0});
  }

  void join(std::uint32_t v, std::uint32_t w) {
    v = first(v);
    w = first(w);
    firsts_[std::max(v, w)] = std::min(v, w);
  }

  /// The first of those that are one with it.
  std::uint32_t first(std::uint32_t v) {
    while (firsts_[v] != v)
      v = firsts_[v] = firsts_[firsts_[v]];
    return v;
  }

  std::vector<std::uint32_t> firsts() {
    for (std::uint32_t v = 0; v < firsts_.size(); ++v)
      firsts_[v] = firsts_[firsts_[v]]; // which are below it, and done
    return std::move(firsts_);
  }

private:
  std::vector<std::uint32_t> firsts_;
};

/// An edge of a face, and the corner where it begins.
struct FaceEdge {
  std::uint32_t face, corner;

  friend auto operator<=>(const FaceEdge&, const FaceEdge&) = default;
};

/// Edges of two faces that have become one.
using FaceMates = std::array<FaceEdge, 2>;

/// Finds sheets of two sides. Where an edge of one face has become one with that of the face behind
/// it, which runs against it at the same three places, so have their other corners, and so on from
/// face to face, as far as both sides agree.
class SheetSides {
public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  SheetSides(const std::vector<Point>& points, const Triangles& triangles,
             const std::vector<FaceMates>& mates, JoinedVertices& vertices)
      : points_(points), triangles_(triangles), mates_(mates), vertices_(vertices) {}

  void join() {
    for (const FaceMates& mates : mates_)
      if (are_sides(mates))
        waiting_.push_back(mates);
    if (waiting_.empty())
      return;
    find_neighbors();
    is_done_.resize(triangles_.size());
    while (!waiting_.empty()) {
      const FaceMates mates = waiting_.back();
      waiting_.pop_back();
      if (is_done_[mates[0].face])
        continue;
      is_done_[mates[0].face] = true;
      go_on(mates);
    }
  }

private:
  std::uint32_t vertex(const FaceEdge& edge, std::uint32_t further) const {
    return triangles_[edge.face][(edge.corner + further) % 3];
  }

  /// Do the faces at two edges run against each other at the same places?
  bool are_sides(const FaceMates& mates) const {
    const auto at = [&](std::size_t i, std::uint32_t further) {
      return points_[vertex(mates[i], further)];
    };
    return at(0, 0) == at(1, 1) && at(0, 1) == at(1, 0) && at(0, 2) == at(1, 2);
  }

  /// To the faces beside two sides of a sheet.
  void go_on(const FaceMates& mates) {
    vertices_.join(vertex(mates[0], 2), vertex(mates[1], 2));
    for (const std::uint32_t further : {1U, 2U}) { // the other side runs the other way
      const auto next = neighbor({mates[0].face, (mates[0].corner + further) % 3});
      const auto behind = neighbor({mates[1].face, (mates[1].corner + 3 - further) % 3});
      if (next && behind && next->face != mates[1].face && are_sides({*next, *behind})) {
        waiting_.push_back({*next, *behind});
      }
    }
  }

  /// At edges of two faces, and where edges have become one.
  void find_neighbors() {
    using Edge = std::pair<std::array<std::uint32_t, 2>, FaceEdge>; // with its vertices
    std::vector<Edge> edges;
    for (std::uint32_t face = 0; face < triangles_.size(); ++face)
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t v = triangles_[face][i], w = triangles_[face][(i + 1) % 3];
        edges.push_back({{std::min(v, w), std::max(v, w)}, {face, i}});
      }
    std::sort(edges.begin(), edges.end());
    for (auto begin = edges.begin(); begin != edges.end();) {
      const auto end = std::find_if(begin, edges.end(),
                                    [&](const Edge& edge) { return edge.first != begin->first; });
      if (end - begin == 2)
        add_neighbors({begin[0].second, begin[1].second});
      begin = end;
    }
    for (const FaceMates& mates : mates_)
      add_neighbors(mates);
    std::sort(neighbors_.begin(), neighbors_.end());
  }

  void add_neighbors(const FaceMates& mates) {
    neighbors_.push_back(mates);
    neighbors_.push_back({mates[1], mates[0]});
  }

  std::optional<FaceEdge> neighbor(const FaceEdge& edge) const {
    const auto found =
        std::lower_bound(neighbors_.begin(), neighbors_.end(), edge,
                         [](const FaceMates& a, const FaceEdge& b) { return a[0] < b; });
    if (found == neighbors_.end() || (*found)[0] != edge)
      return std::nullopt;
    return (*found)[1];
  }

  const std::vector<Point>& points_;
  const Triangles& triangles_;
  const std::vector<FaceMates>& mates_;
  JoinedVertices& vertices_;
  std::vector<FaceMates> neighbors_; // both ways, in order
  std::vector<FaceMates> waiting_;
  std::vector<bool> is_done_; // of the first face of a pair
};

} // namespace quadrille_examples

#endif
