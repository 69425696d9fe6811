#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_EDGE_ORDER_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_EDGE_ORDER_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/quadric_form.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// The faces around an edge. If solids touch along it there are four or more, and the space between
/// two of them is inside a solid and outside, alternately: so they run up the edge and down it
/// alternately. Faces that change places there meet nowhere else, and turn a solid inside out. This
/// is decided exactly.
class EdgeOrder {
public:
  EdgeOrder(const Vector<3>& from, const Vector<3>& to) : from_(point(from)), to_(point(to)) {}

  /// A face at the edge; false if it is none, or has no area.
  bool add(const FaceCorners& face, Index from, Index to) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = face.vertices[i], w = face.vertices[(i + 1) % 3];
      if (!(v == from && w == to) && !(v == to && w == from))
        continue;
      const Side side{point(face.points[(i + 2) % 3]), v == from};
      if (CGAL::collinear(from_, to_, side.apex))
        return false;
      sides_.push_back(side);
      return true;
    }
    return false;
  }

  /// Do they run up and down in turn, or not as many up as down?
  bool alternates() {
    const auto ups =
        std::count_if(sides_.begin(), sides_.end(), [](const Side& side) { return side.is_up; });
    if (sides_.size() <= 2 || 2 * static_cast<std::size_t>(ups) != sides_.size())
      return true;
    const Point first = sides_.front().apex;
    std::sort(sides_.begin(), sides_.end(), [&](const Side& a, const Side& b) {
      const int s = quarter(first, a.apex), t = quarter(first, b.apex);
      return s != t ? s < t
                    : s % 2 == 1 && CGAL::orientation(from_, to_, a.apex, b.apex) == CGAL::POSITIVE;
    });
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (sides_[i].is_up == sides_[(i + 1) % sides_.size()].is_up)
        return false;
    return true;
  }

private:
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  struct Side {
    Point apex;
    bool is_up;
  };

  static Point point(const Vector<3>& p) { return {p[0], p[1], p[2]}; }

  // Around the edge: 0 on the side of the first one, 1 less than half a turn, 2 half a turn, 3
  // more.
  int quarter(const Point& first, const Point& apex) const {
    switch (CGAL::orientation(from_, to_, first, apex)) {
    case CGAL::POSITIVE:
      return 1;
    case CGAL::NEGATIVE:
      return 3;
    default:
      return CGAL::coplanar_orientation(from_, to_, first, apex) == CGAL::POSITIVE ? 0 : 2;
    }
  }

  Point from_, to_;
  std::vector<Side> sides_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_EDGE_ORDER_H
