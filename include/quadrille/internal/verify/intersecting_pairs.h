#ifndef QUADRILLE_INTERNAL_VERIFY_INTERSECTING_PAIRS_H
#define QUADRILLE_INTERNAL_VERIFY_INTERSECTING_PAIRS_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_surface.h>

#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Counts pairs of faces that have a point in common beside the vertices and edges that both have.
/// It shares nothing with NoSelfIntersection but CGAL's predicates, which are exact. Faces without
/// an area, and pairs on the same three vertices, do not count.
class IntersectingPairs {
public:
  explicit IntersectingPairs(const CheckedSurface& surface) : surface_(surface) {}

  struct Found {
    std::size_t count = 0;
    std::size_t first = 0; ///< the lowest number of a face that intersects, if there is any
  };

  /// By a sweep over the boxes of the faces: O(n log³ n + k) for k pairs of boxes that meet.
  Found find(CheckProgress& progress) const {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
    std::vector<Box> boxes;
    for (std::size_t face = 0; face < surface_.faces.size(); ++face)
      if (const auto triangle = surface_.triangle(face); !triangle.is_degenerate())
        boxes.emplace_back(triangle.bbox(), face);
    Found found{0, surface_.faces.size()};
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      progress.step();
      if (!intersect(a.info(), b.info()))
        return;
      ++found.count;
      found.first = (std::min)({found.first, a.info(), b.info()});
    });
    return found;
  }

private:
  using Segment = ExactKernel::Segment_3;

  bool intersect(std::size_t a, std::size_t b) const {
    const Corners& p = surface_.faces[a];
    const Corners& q = surface_.faces[b];
    const auto is_common = [](const Corners& of) {
      return [&of](std::size_t v) { return std::find(of.begin(), of.end(), v) != of.end(); };
    };
    Corners s = p, t = q; // those that both have come first
    std::stable_partition(s.begin(), s.end(), is_common(q));
    std::stable_partition(t.begin(), t.end(), is_common(p));
    const auto at = [&](std::size_t v) -> const auto& {
      return surface_.points[v];
    };
    switch (std::count_if(p.begin(), p.end(), is_common(q))) {
    case 0:
      return CGAL::do_intersect(surface_.triangle(a), surface_.triangle(b));
    case 1:
      return CGAL::do_intersect(surface_.triangle(a), Segment(at(t[1]), at(t[2]))) ||
             CGAL::do_intersect(surface_.triangle(b), Segment(at(s[1]), at(s[2])));
    case 2:
      return CGAL::coplanar(at(s[0]), at(s[1]), at(s[2]), at(t[2])) &&
             CGAL::coplanar_orientation(at(s[0]), at(s[1]), at(s[2]), at(t[2])) == CGAL::POSITIVE;
    default:
      return false;
    }
  }

  const CheckedSurface& surface_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_INTERSECTING_PAIRS_H
