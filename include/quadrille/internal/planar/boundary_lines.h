#ifndef QUADRILLE_INTERNAL_PLANAR_BOUNDARY_LINES_H
#define QUADRILLE_INTERNAL_PLANAR_BOUNDARY_LINES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Returns the edges that only one face has, each in both directions, in order.
inline std::vector<std::array<Index, 2>> boundary_edges_of(const SurfaceView& surface) {
  std::vector<std::array<Index, 2>> sides; // the sides of faces, the lower end first
  for (const auto& [a, b, c] : surface.triangles)
    if (a != b && b != c && c != a)
      for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        sides.push_back({(std::min)(v, w), (std::max)(v, w)});
  std::sort(sides.begin(), sides.end());
  std::vector<std::array<Index, 2>> edges;
  for (auto side = sides.begin(); side != sides.end();) {
    const auto next = std::upper_bound(side, sides.end(), *side);
    if (next - side == 1) {
      edges.push_back(*side);
      edges.push_back({(*side)[1], (*side)[0]});
    }
    side = next;
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The boundaries of a surface, cut into lines. A line runs from a vertex that stays, or that does
/// not have exactly two boundary edges, to the next such vertex; a loop without such a vertex runs
/// from its least point to that point again. A line does not depend on the surface around it or on
/// the numbers of its vertices: of its two directions it has the one in which its points come first
/// in order.
class BoundaryLines {
public:
  explicit BoundaryLines(const SurfaceView& surface)
      : points_(surface.points), edges_(boundary_edges_of(surface)), is_end_(points_.size()),
        is_done_(points_.size()) {
    for (const Index v : surface.constrained)
      is_end_[v] = true;
    for (const auto& [v, w] : edges_)
      is_end_[v] = is_end_[v] || neighbours(v).size() != 2;
    for (const auto& [v, w] : edges_)
      if (is_end_[v] && !(is_end_[w] && w < v) && !is_done_[w])
        add_from(v, w);
    for (const auto& [v, w] : edges_)
      if (!is_end_[v] && !is_done_[v])
        add_loop(v);
  }

  /// Each line includes both of its ends.
  const std::vector<std::vector<Index>>& lines() const { return lines_; }
  /// The vertices with which a vertex has a boundary edge.
  std::span<const std::array<Index, 2>> neighbours(Index v) const {
    const auto [begin, end] = std::equal_range(
        edges_.begin(), edges_.end(), std::array<Index, 2>{v, 0},
        [](const std::array<Index, 2>& a, const std::array<Index, 2>& b) { return a[0] < b[0]; });
    return {begin, end};
  }

private:
  bool is_before(Index v, Index w) const { return points_[v].coordinates < points_[w].coordinates; }

  // Follows the boundary from v over w to the next end, or back to v.
  std::vector<Index> follow(Index v, Index w) {
    std::vector<Index> line{v, w};
    while (!is_end_[w] && w != line.front()) {
      is_done_[w] = true;
      const auto around = neighbours(w);
      const Index next = around[0][1] == v ? around[1][1] : around[0][1];
      v = std::exchange(w, next);
      line.push_back(w);
    }
    return line;
  }

  void add(std::vector<Index> line) {
    const auto is_less = [this](Index v, Index w) { return is_before(v, w); };
    if (std::lexicographical_compare(line.rbegin(), line.rend(), line.begin(), line.end(), is_less))
      std::reverse(line.begin(), line.end());
    lines_.push_back(std::move(line));
  }
  void add_from(Index v, Index w) { add(follow(v, w)); }
  void add_loop(Index v) {
    std::vector<Index> loop = follow(v, neighbours(v)[0][1]);
    is_done_[v] = true;
    loop.pop_back();
    const auto least = std::min_element(loop.begin(), loop.end(),
                                        [this](Index a, Index b) { return is_before(a, b); });
    std::rotate(loop.begin(), least, loop.end());
    loop.push_back(loop.front());
    add(std::move(loop));
  }

  std::span<const Vector<3>> points_;
  std::vector<std::array<Index, 2>> edges_;
  std::vector<bool> is_end_, is_done_;
  std::vector<std::vector<Index>> lines_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_BOUNDARY_LINES_H
