#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_CONSTRAINED_TRIANGULATION_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_CONSTRAINED_TRIANGULATION_H

#include <quadrille/internal/core/base/index.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The constrained Delaunay triangulation of points in the plane, by CGAL's predicates, which are
/// exact. Points are inserted one by one, and edges flipped until all circles are empty (Lawson
/// 1977). A constraint is made an edge by flipping the edges that it crosses (Sloan 1993). Where
/// four points lie on a circle, the lifted points are moved up symbolically, the lexicographically
/// greatest one most (Devillers and Teillaud 2011). So the triangulation does not depend on the
/// order of the points.
///
/// Behind each edge of the convex hull there is an infinite triangle: a corner of it is `none`.
class ConstrainedTriangulation {
public:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;

  /// Side i is opposite to corner i. The corners run counter-clockwise.
  struct Triangle {
    std::array<Index, 3> corners;
    std::array<Index, 3> mates;                                   ///< triangles beyond the sides
    std::array<bool, 3> is_constrained = {false, false, false}; ///< sides

    bool is_infinite() const { return corner(none) < 3; }
    /// Returns which corner a point is, or 3.
    std::size_t corner(Index point) const {
      return static_cast<std::size_t>(
          std::find(corners.begin(), corners.end(), point) - corners.begin());
    }
  };

  /// Triangulates points, without constraints. Returns false if two of them coincide, or if all lie
  /// on a line. They must be finite.
  bool insert(std::span<const Point> points) {
    points_ = points;
    triangles_.clear();
    triangle_of_.assign(points.size(), none);
    if (!begin())
      return false;
    // Distant points come first, and each begins its search at one that was near in the list.
    for (std::size_t step = std::bit_ceil(points.size()) / 2; step > 0; step /= 2)
      for (std::size_t i = step; i < points.size(); i += 2 * step)
        if (triangle_of_[i] == none && !insert(static_cast<Index>(i), triangle_of_[i - step]))
          return false;
    return true;
  }

  /// Makes the line between two points an edge. Returns false, and changes nothing, if they are the
  /// same, or if the line contains another point or crosses a constraint.
  bool constrain(Index a, Index b) {
    if (a == b || !find_crossed(a, b))
      return false;
    std::vector<Ends> made;
    for (std::size_t k = 0; k < crossed_.size(); ++k) { // which grows
      const auto [t, side] = edge(crossed_[k]);
      const auto [p, x, q, y] = around(t, side);
      if (!is_left_turn(p, x, q) || !is_left_turn(p, q, y)) {
        crossed_.push_back(crossed_[k]);
        continue;
      }
      flip(t, side);
      const bool is_apart = p != a && p != b && q != a && q != b;
      if (is_apart && orientation(a, b, p) != orientation(a, b, q))
        crossed_.push_back({p, q});
      else
        made.push_back({p, q});
    }
    const auto [t, side] = edge({a, b});
    const Triangle& triangle = triangles_[t];
    const Index mate = triangle.mates[side];
    triangles_[t].is_constrained[side] = true;
    triangles_[mate].is_constrained[side_to(mate, t)] = true;
    for (const Ends& ends : made)
      waiting_.push_back(edge(ends));
    flip_waiting();
    return true;
  }

  const std::vector<Triangle>& triangles() const { return triangles_; }

private:
  using Ends = std::pair<Index, Index>; // points
  struct Side {
    Index triangle;
    std::size_t side;
  };

  static std::size_t next(std::size_t i) { return (i + 1) % 3; }
  static std::size_t previous(std::size_t i) { return (i + 2) % 3; }

  CGAL::Orientation orientation(Index a, Index b, Index c) const {
    return CGAL::orientation(points_[a], points_[b], points_[c]);
  }
  bool is_left_turn(Index a, Index b, Index c) const {
    return orientation(a, b, c) == CGAL::LEFT_TURN;
  }

  // Makes the first triangle, of three points that are not on a line, with what is around it.
  bool begin() {
    const auto count = static_cast<Index>(points_.size());
    Index b = 1, c = 2;
    while (b < count && points_[b] == points_[0])
      ++b;
    while (c < count && (c == b || CGAL::collinear(points_[0], points_[b], points_[c])))
      ++c;
    if (b >= count || c >= count)
      return false;
    Index a = 0;
    if (!is_left_turn(a, b, c))
      std::swap(b, c);
    triangles_ = {{{a, b, c}, {2, 3, 1}},
                  {{b, a, none}, {3, 2, 0}},
                  {{c, b, none}, {1, 3, 0}},
                  {{a, c, none}, {2, 1, 0}}};
    for (const Index point : {a, b, c})
      triangle_of_[point] = 0;
    return true;
  }

  // Returns false if there is a point at the same position.
  bool insert(Index p, Index near) {
    const Index t = find(p, near);
    const Triangle old = triangles_[t];
    std::size_t flat = 3; // the side on which the point lies
    if (!old.is_infinite())
      for (std::size_t i = 0; i < 3; ++i) {
        if (points_[old.corners[i]] == points_[p])
          return false;
        if (CGAL::collinear(points_[old.corners[next(i)]], points_[old.corners[previous(i)]],
                            points_[p]))
          flat = i;
      }
    const auto count = static_cast<Index>(triangles_.size());
    const auto [a, b, c] = old.corners;
    triangles_[t] = {{a, b, p}, {count, count + 1, old.mates[2]}};
    triangles_.push_back({{b, c, p}, {count + 1, t, old.mates[0]}});
    triangles_.push_back({{c, a, p}, {t, count, old.mates[1]}});
    const std::array<Index, 3> made{count, count + 1, t}; // behind side i of the old one
    for (std::size_t i = 0; i < 3; ++i) {
      set_mate(old.mates[i], t, made[i]);
      set_triangle(made[i]);
      waiting_.push_back({made[i], 2});
    }
    if (flat < 3) // first of all: a triangle without area has no circle
      waiting_.push_back({made[flat], 2});
    flip_waiting();
    return true;
  }

  // Walks to a triangle in which, or on the border of which, a point lies. It ends, for all circles
  // are empty.
  Index find(Index p, Index t) const {
    if (const std::size_t i = triangles_[t].corner(none); i < 3)
      t = triangles_[t].mates[i];
    while (!triangles_[t].is_infinite()) {
      const Triangle& triangle = triangles_[t];
      std::size_t i = 0;
      while (i < 3 && orientation(triangle.corners[next(i)], triangle.corners[previous(i)], p) !=
                          CGAL::RIGHT_TURN)
        ++i;
      if (i == 3)
        return t;
      t = triangle.mates[i];
    }
    return t;
  }

  // Flips sides that are not constrained until their circles are empty.
  void flip_waiting() {
    while (!waiting_.empty()) {
      const auto [t, side] = waiting_.back();
      waiting_.pop_back();
      const Triangle& triangle = triangles_[t];
      const Index p = triangle.corners[side], mate = triangle.mates[side];
      if (p == none || triangle.is_constrained[side] || !is_in_circle(triangles_[mate], p))
        continue;
      flip(t, side);
      for (const Side& outer : {Side{t, 0}, Side{t, 2}, Side{mate, 0}, Side{mate, 1}})
        waiting_.push_back(outer);
    }
  }

  // The circle of an infinite triangle is the half-plane beyond its finite side, with that side.
  bool is_in_circle(const Triangle& triangle, Index p) const {
    if (const std::size_t i = triangle.corner(none); i < 3) {
      const Index a = triangle.corners[next(i)], b = triangle.corners[previous(i)];
      const CGAL::Orientation turn = orientation(a, b, p);
      return turn == CGAL::LEFT_TURN ||
             (turn == CGAL::COLLINEAR && CGAL::collinear_are_strictly_ordered_along_line(
                                             points_[a], points_[p], points_[b]));
    }
    const auto& [a, b, c] = triangle.corners;
    const CGAL::Oriented_side side =
        CGAL::side_of_oriented_circle(points_[a], points_[b], points_[c], points_[p]);
    return side == CGAL::ON_ORIENTED_BOUNDARY ? is_in_circle_moved(triangle, p)
                                              : side == CGAL::ON_POSITIVE_SIDE;
  }

  // For a point on the circle: the greatest of the four decides. If it is a corner, its height moves
  // the plane through the three at p by the barycentric coordinate of p.
  bool is_in_circle_moved(const Triangle& triangle, Index p) const {
    const auto is_less = [&](Index a, Index b) { return points_[a] < points_[b]; };
    std::array<Index, 3> corners = triangle.corners;
    Index& greatest = *std::max_element(corners.begin(), corners.end(), is_less);
    if (is_less(greatest, p))
      return false;
    greatest = p;
    return is_left_turn(corners[0], corners[1], corners[2]);
  }

  // Returns the corners of the two triangles at a side, counter-clockwise: the one opposite to it in
  // the triangle, an end of it, the one beyond it, the other end.
  std::array<Index, 4> around(Index t, std::size_t side) const {
    const Triangle& triangle = triangles_[t];
    const Index mate = triangle.mates[side];
    return {triangle.corners[side], triangle.corners[next(side)],
            triangles_[mate].corners[side_to(mate, t)], triangle.corners[previous(side)]};
  }

  // Turns the edge x y of the triangles p x y and q y x into p q.
  void flip(Index t, std::size_t side) {
    const Triangle old = triangles_[t], beyond = triangles_[old.mates[side]];
    const Index mate = old.mates[side];
    const auto [p, x, q, y] = around(t, side);
    const std::size_t to_y = beyond.corner(y);
    const std::size_t to_x = beyond.corner(x);
    triangles_[t] = {{p, x, q},
                     {beyond.mates[to_y], mate, old.mates[previous(side)]},
                     {beyond.is_constrained[to_y], false, old.is_constrained[previous(side)]}};
    triangles_[mate] = {{p, q, y},
                        {beyond.mates[to_x], old.mates[next(side)], t},
                        {beyond.is_constrained[to_x], old.is_constrained[next(side)], false}};
    set_mate(beyond.mates[to_y], mate, t);
    set_mate(old.mates[next(side)], t, mate);
    set_triangle(t);
    set_triangle(mate);
  }

  std::size_t side_to(Index t, Index mate) const {
    const auto& mates = triangles_[t].mates;
    return static_cast<std::size_t>(std::find(mates.begin(), mates.end(), mate) - mates.begin());
  }
  void set_mate(Index t, Index old, Index mate) { triangles_[t].mates[side_to(t, old)] = mate; }
  void set_triangle(Index t) {
    for (const Index point : triangles_[t].corners)
      if (point != none)
        triangle_of_[point] = t;
  }

  // Finds the side from a point to another, counter-clockwise around a triangle; there is one.
  Side edge(const Ends& ends) const {
    Index t = triangle_of_[ends.first];
    while (true) {
      const std::size_t at = triangles_[t].corner(ends.first);
      if (triangles_[t].corners[next(at)] == ends.second)
        return {t, previous(at)};
      t = triangles_[t].mates[next(at)];
    }
  }

  // Lists the edges that the line from a to b crosses, from right to left: none if it is an edge.
  // Returns false if it contains another point or crosses a constraint.
  bool find_crossed(Index a, Index b) {
    crossed_.clear();
    const Index first = triangle_of_[a];
    Index t = first;
    do {
      const std::size_t at = triangles_[t].corner(a);
      const Index u = triangles_[t].corners[next(at)], v = triangles_[t].corners[previous(at)];
      if (u == b)
        return true;
      if (u != none && orientation(a, b, u) == CGAL::COLLINEAR &&
          CGAL::collinear_are_strictly_ordered_along_line(points_[a], points_[u], points_[b]))
        return false;
      if (u != none && v != none && v != b && orientation(a, b, u) == CGAL::RIGHT_TURN &&
          orientation(a, b, v) == CGAL::LEFT_TURN)
        return cross(a, b, t, at);
      t = triangles_[t].mates[next(at)];
    } while (t != first);
    return false;
  }

  // Goes on through a side that the line crosses, from triangle to triangle.
  bool cross(Index a, Index b, Index t, std::size_t side) {
    while (true) {
      const auto [from, u, w, v] = around(t, side);
      if (triangles_[t].is_constrained[side])
        return false;
      crossed_.push_back({u, v});
      if (w == b)
        return true;
      const Index mate = triangles_[t].mates[side];
      const CGAL::Orientation turn = orientation(a, b, w);
      if (turn == CGAL::COLLINEAR)
        return false;
      side = triangles_[mate].corner(turn == CGAL::LEFT_TURN ? v : u);
      t = mate;
    }
  }

  std::span<const Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<Index> triangle_of_; // one of each point; none for those not inserted yet
  std::vector<Side> waiting_;      // whose circles may not be empty
  std::vector<Ends> crossed_;      // by the line that becomes an edge
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_CONSTRAINED_TRIANGULATION_H
