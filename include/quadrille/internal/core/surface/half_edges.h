#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_HALF_EDGES_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_HALF_EDGES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A surface of which the faces at each edge and around each vertex are known, and which can be cut
/// along loops. Side i of a face f, from its corner i to the next one, is the half-edge 3 f + i. It
/// has a twin where exactly one other face has the edge, and runs along it the other way.
class HalfEdges {
public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// `is_kept`: empty, or of each vertex whether it counts as one at the boundary.
  explicit HalfEdges(const SurfaceView& surface, const std::vector<bool>& is_kept = {})
      : points_(surface.points.begin(), surface.points.end()),
        triangles_(surface.triangles.begin(), surface.triangles.end()),
        twin_(3 * triangles_.size(), none), out_(points_.size(), none),
        is_inside_(points_.size(), false) {
    find_twins();
    find_inside(is_kept);
    measure_sides();
  }

  std::size_t vertices() const { return points_.size(); }
  std::size_t faces() const { return triangles_.size(); }
  const Vector<3>& point(Index v) const { return points_[v]; }
  const Triangle& triangle(Index face) const { return triangles_[face]; }

  static Index face(Index h) { return h / 3; }
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index twin(Index h) const { return twin_[h]; }
  Index origin(Index h) const { return triangles_[h / 3][h % 3]; }
  Index target(Index h) const { return origin(next(h)); }
  double length(Index h) const { return static_cast<double>(length_[h]); }

  /// Do the faces of a vertex form one disc around it, wound alike, and may it be cut?
  bool is_inside(Index v) const { return is_inside_[v]; }
  /// Visits the half-edges that leave a vertex inside the surface.
  template <class Visit>
  void for_each_out(Index v, Visit visit) const {
    Index h = out_[v];
    do {
      visit(h);
      h = twin_[previous(h)];
    } while (h != out_[v]);
  }

  /// Cuts along a loop of half-edges through vertices inside the surface, each beginning where the
  /// one before it ends, and closes both sides: by a face if the loop has three edges, else by a
  /// face from each edge to a new vertex in the middle between two of the loop. The faces on the
  /// left keep the vertices. Calls add_vertex(a, b) for each vertex that is added in the middle
  /// between two earlier ones, which are one for a copy, and add_face(like) for each face, with the
  /// one next to it. Copies lie a little to the right of the loop.
  template <class AddVertex, class AddFace>
  void cut(const std::vector<Index>& loop, AddVertex add_vertex, AddFace add_face) {
    std::vector<Index> left, right, right_sides; // vertices, and twins of the loop
    std::vector<std::vector<Index>> corners;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      left.push_back(origin(loop[i]));
      right_sides.push_back(twin_[loop[i]]);
      const Index before = twin_[loop[(i + loop.size() - 1) % loop.size()]];
      corners.push_back(corners_between(before, twin_[loop[i]]));
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      right.push_back(add(left[i], left[i], add_vertex));
      for (const Index corner : corners[i])
        triangles_[corner / 3][corner % 3] = right[i];
      out_[left[i]] = loop[i];
      out_[right[i]] = corners[i].front();
    }
    move_aside(right, corners);
    std::reverse(left.begin(), left.end()); // as the new faces run
    std::vector<Index> left_sides(loop.rbegin(), loop.rend());
    std::rotate(left_sides.begin(), left_sides.begin() + 1, left_sides.end());
    const std::size_t last = loop.size() - 1, half = loop.size() / 2;
    close(left, left_sides, {left[last], left[last - half]}, add_vertex, add_face);
    close(right, right_sides, {right[0], right[half]}, add_vertex, add_face);
    measure_sides();
  }

  /// Splits a half-edge that has a twin at a new vertex in its middle, and each of the faces there
  /// in two. The pieces at the origins of the half-edge and of its twin keep the numbers of the
  /// faces. Calls add_vertex(a, b) and add_face(like), as cut() does.
  template <class AddVertex, class AddFace>
  void split(Index h, AddVertex add_vertex, AddFace add_face) {
    const Index twin = twin_[h];
    const Index middle = add(origin(h), origin(twin), add_vertex);
    const Index beyond = split_face(h, middle, add_face),
                before = split_face(twin, middle, add_face);
    join(h, before);
    join(twin, beyond);
    out_[middle] = beyond;
    for (const Index side : {h, next(h), twin, next(twin)})
      length_[side] = measured(side);
    measure_sides();
  }

private:
  struct Side {
    Index other, half_edge; // by the lower vertex of an edge, its higher one
    auto operator<=>(const Side&) const = default;
  };

  void find_twins() {
    std::vector<std::size_t> end(points_.size() + 1, 0);
    for_each_side([&](Index low, const Side&) { ++end[low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Side> sides(end.back());
    for_each_side([&](Index low, const Side& side) { sides[end[low]++] = side; });
    for (std::size_t low = 0, begin = 0; low < points_.size(); begin = end[low++]) {
      const auto first = sides.begin() + static_cast<std::ptrdiff_t>(begin),
                 last = sides.begin() + static_cast<std::ptrdiff_t>(end[low]);
      std::sort(first, last);
      for (auto at = first, beyond = first; at != last; at = beyond) {
        while (beyond != last && beyond->other == at->other)
          ++beyond;
        join(at, beyond);
      }
    }
  }
  template <class Visit>
  void for_each_side(Visit visit) const {
    for (Index h = 0; h < 3 * triangles_.size(); ++h)
      if (const Index v = origin(h), w = target(h); v != w)
        visit((std::min)(v, w), Side{(std::max)(v, w), h});
  }
  template <class Iterator>
  void join(Iterator begin, Iterator end) {
    if (end - begin != 2)
      return;
    const Index a = begin->half_edge, b = (begin + 1)->half_edge;
    if (origin(a) != target(b))
      return; // wound against each other
    twin_[a] = b;
    twin_[b] = a;
  }

  void find_inside(const std::vector<bool>& is_kept) {
    std::vector<Index> corners(points_.size(), 0);
    for (Index h = 0; h < 3 * triangles_.size(); ++h) {
      ++corners[origin(h)];
      out_[origin(h)] = h;
    }
    for (Index v = 0; v < points_.size(); ++v)
      is_inside_[v] =
          out_[v] != none && (is_kept.empty() || !is_kept[v]) && is_closed_around(v, corners[v]);
  }
  bool is_closed_around(Index v, Index corners) const {
    Index h = out_[v];
    for (Index i = 0; i < corners; ++i) {
      h = twin_[previous(h)];
      if (h == none)
        return false;
      if (h == out_[v])
        return i + 1 == corners;
    }
    return false;
  }

  // Computes the lengths of sides that are not yet known.
  void measure_sides() {
    auto h = static_cast<Index>(length_.size());
    length_.resize(3 * triangles_.size());
    for (; h < length_.size(); ++h)
      length_[h] = measured(h);
  }
  float measured(Index h) const {
    return static_cast<float>(std::sqrt(squared_length(points_[target(h)] - points_[origin(h)])));
  }

  // Moves the vertices of a loop a sixteenth of the way to the middle of their neighbours that are
  // not in it, so that what closes the other side lies apart; one without such, as those before and
  // after it. `corners`: those of each vertex.
  void move_aside(const std::vector<Index>& loop, const std::vector<std::vector<Index>>& corners) {
    const std::size_t n = loop.size();
    std::vector<Vector<3>> moves(n);
    std::vector<bool> has_neighbor(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      double count = 0;
      for (const Index h : corners[i])
        for (const Index v : {target(h), origin(previous(h))})
          if (std::find(loop.begin(), loop.end(), v) == loop.end()) {
            moves[i] += points_[v] - points_[loop[i]];
            ++count;
          }
      has_neighbor[i] = count > 0;
      if (count > 0)
        moves[i] = 1 / (16 * count) * moves[i];
    }
    for (std::size_t i = 0; i < n; ++i)
      points_[loop[i]] +=
          has_neighbor[i] ? moves[i] : 0.5 * (moves[(i + n - 1) % n] + moves[(i + 1) % n]);
    for (const std::vector<Index>& of_vertex : corners)
      for (const Index corner : of_vertex)
        for (Index h = 3 * face(corner); h < 3 * face(corner) + 3; ++h)
          length_[h] = measured(h);
  }

  // The corners at a vertex from the face of a half-edge that leaves it to that of one that comes.
  std::vector<Index> corners_between(Index leaving, Index coming) const {
    std::vector<Index> corners{leaving};
    while (previous(corners.back()) != coming)
      corners.push_back(twin_[previous(corners.back())]);
    return corners;
  }

  template <class AddVertex>
  Index add(Index a, Index b, AddVertex& add_vertex) {
    points_.push_back(a == b ? Vector<3>(points_[a]) : 0.5 * points_[a] + 0.5 * points_[b]);
    out_.push_back(none);
    is_inside_.push_back(true);
    add_vertex(a, b);
    return static_cast<Index>(points_.size() - 1);
  }

  // The face of a half-edge ends at the new vertex on it. Returns the first half-edge of the new
  // face, which has the rest.
  template <class AddFace>
  Index split_face(Index h, Index middle, AddFace& add_face) {
    const Index second = next(h), end = origin(second), first = static_cast<Index>(3 * faces());
    triangles_.push_back({middle, end, origin(previous(h))});
    add_face(face(h));
    triangles_[second / 3][second % 3] = middle;
    twin_.resize(3 * triangles_.size(), none);
    if (twin_[second] != none)
      join(first + 1, twin_[second]);
    join(second, first + 2);
    if (out_[end] == second)
      out_[end] = first + 1;
    return first;
  }

  // Closes a hole with these vertices in the order in which the new faces run; from the i-th one to
  // the next, the i-th half-edge has no twin. `ends`: between which a new vertex lies.
  template <class AddVertex, class AddFace>
  void close(const std::vector<Index>& hole, const std::vector<Index>& sides,
             const std::array<Index, 2>& ends, AddVertex& add_vertex, AddFace& add_face) {
    const std::size_t n = hole.size();
    auto f = static_cast<Index>(triangles_.size());
    if (n == 3) {
      triangles_.push_back({hole[0], hole[1], hole[2]});
      add_face(face(sides[0]));
      for (std::size_t i = 0; i < n; ++i)
        join(3 * f + static_cast<Index>(i), sides[i]);
      return;
    }
    const Index middle = add(ends[0], ends[1], add_vertex);
    const Index first = f;
    for (std::size_t i = 0; i < n; ++i, ++f) {
      triangles_.push_back({hole[i], hole[(i + 1) % n], middle});
      add_face(face(sides[i]));
      join(3 * f, sides[i]);
    }
    for (Index i = 0; i < n; ++i)
      join(3 * (first + i) + 1, 3 * (first + (i + 1) % static_cast<Index>(n)) + 2);
    out_[middle] = 3 * first + 2;
  }
  void join(Index a, Index b) {
    twin_.resize(3 * triangles_.size(), none);
    twin_[a] = b;
    twin_[b] = a;
  }

  std::vector<Vector<3>> points_;
  std::vector<Triangle> triangles_;
  std::vector<Index> twin_;
  std::vector<float> length_; // of each half-edge
  std::vector<Index> out_;    // of each vertex a half-edge that leaves it
  std::vector<bool> is_inside_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_HALF_EDGES_H
