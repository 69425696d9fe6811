#ifndef QUADRILLE_INTERNAL_VERIFY_INTERSECTING_PAIRS_H
#define QUADRILLE_INTERNAL_VERIFY_INTERSECTING_PAIRS_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/face_tree.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Counts the pairs of faces that have a point in common other than their shared vertices and
/// edges, and those among them that pass through each other, so that they do not only touch or
/// overlap in a plane. It shares nothing with NoSelfIntersection but CGAL's predicates, which are
/// exact. Faces without an area, and pairs on the same three vertices, do not count.
class IntersectingPairs {
public:
  explicit IntersectingPairs(const SurfaceView& surface) : surface_(surface) {}

  struct Kind {
    std::size_t count = 0;
    std::size_t first = none; ///< the lowest number of such a face, if there is one

    void add(std::size_t a, std::size_t b) {
      ++count;
      first = (std::min)({first, a, b});
    }
  };
  struct Found {
    Kind meet;         ///< in any way
    Kind pass_through; ///< each other
  };

  /// Finds the pairs by a tree of boxes: about O(n log n + k) for k pairs of boxes that meet.
  Found find(CheckProgress& progress) const {
    std::vector<std::size_t> faces; // with an area
    for (std::size_t face = 0; face < surface_.triangles.size(); ++face)
      if (!exact_triangle(face).is_degenerate())
        faces.push_back(face);
    Found found;
    if (faces.empty())
      return found;
    std::vector<DistanceTriangle> triangles;
    for (const std::size_t face : faces)
      triangles.push_back(triangle(face));
    const FaceTree tree(
        faces.size(),
        [&](std::size_t i) -> const DistanceTriangle& { return triangles[i]; }, [] {});
    tree.for_each_near_pair([&](std::size_t i, std::size_t j) {
      if (!CGAL::do_overlap(triangles[i].bbox(), triangles[j].bbox()))
        return;
      progress.step();
      add(faces[i], faces[j], found);
    });
    return found;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Segment = Kernel::Segment_3;
  using Rational = CGAL::Exact_rational;
  using RationalKernel = CGAL::Simple_cartesian<Rational>;
  using RationalTriangle = std::array<RationalKernel::Point_3, 3>;

  Kernel::Point_3 exact_point(std::size_t v) const {
    const Vector<3>& p = surface_.points[v];
    return {p[0], p[1], p[2]};
  }
  Kernel::Triangle_3 exact_triangle(std::size_t face) const {
    const auto& [a, b, c] = surface_.triangles[face];
    return {exact_point(a), exact_point(b), exact_point(c)};
  }

  DistanceTriangle triangle(std::size_t face) const {
    const auto& [a, b, c] = surface_.triangles[face];
    return {distance_point(surface_.points[a]), distance_point(surface_.points[b]),
            distance_point(surface_.points[c])};
  }

  void add(std::size_t a, std::size_t b, Found& found) const {
    if (!intersect(a, b))
      return;
    found.meet.add(a, b);
    if (pass_through(a, b))
      found.pass_through.add(a, b);
  }

  bool intersect(std::size_t a, std::size_t b) const {
    const Corners& p = surface_.triangles[a];
    const Corners& q = surface_.triangles[b];
    const auto is_common = [](const Corners& of) {
      return [&of](std::size_t v) { return std::find(of.begin(), of.end(), v) != of.end(); };
    };
    Corners s = p, t = q; // the shared corners come first
    std::stable_partition(s.begin(), s.end(), is_common(q));
    std::stable_partition(t.begin(), t.end(), is_common(p));
    const auto at = [&](std::size_t v) { return exact_point(v); };
    switch (std::count_if(p.begin(), p.end(), is_common(q))) {
    case 0:
      return CGAL::do_intersect(exact_triangle(a), exact_triangle(b));
    case 1:
      return CGAL::do_intersect(exact_triangle(a), Segment(at(t[1]), at(t[2]))) ||
             CGAL::do_intersect(exact_triangle(b), Segment(at(s[1]), at(s[2])));
    case 2:
      return CGAL::coplanar(at(s[0]), at(s[1]), at(s[2]), at(t[2])) &&
             CGAL::coplanar_orientation(at(s[0]), at(s[1]), at(s[2]), at(t[2])) == CGAL::POSITIVE;
    default:
      return false;
    }
  }

  // Each face covers an interval of the line in which both planes intersect. The intervals are
  // computed as rational numbers.
  bool pass_through(std::size_t a, std::size_t b) const {
    if (!crosses_plane(a, b) || !crosses_plane(b, a))
      return false;
    const RationalTriangle s = rational(a), t = rational(b);
    const auto normal = [](const RationalTriangle& face) {
      return CGAL::cross_product(face[1] - face[0], face[2] - face[0]);
    };
    const auto along = CGAL::cross_product(normal(s), normal(t));
    const auto of_s = section_of(s, t[0], normal(t), along),
               of_t = section_of(t, s[0], normal(s), along);
    return of_s && of_t &&
           (std::max)(of_s->first, of_t->first) < (std::min)(of_s->second, of_t->second);
  }

  // Does a face have corners on both sides of the plane of another one?
  bool crosses_plane(std::size_t face, std::size_t other) const {
    const Corners& corners = surface_.triangles[face];
    const auto t = exact_triangle(other);
    const auto has = [&](CGAL::Orientation side) {
      return std::any_of(corners.begin(), corners.end(), [&](std::size_t v) {
        return CGAL::orientation(t[0], t[1], t[2], exact_point(v)) == side;
      });
    };
    return has(CGAL::POSITIVE) && has(CGAL::NEGATIVE);
  }

  // Returns the interval, along a vector, in which a plane cuts a face with corners on both sides
  // of it.
  template <class Vector>
  static std::optional<std::pair<Rational, Rational>>
  section_of(const RationalTriangle& face, const RationalKernel::Point_3& in_plane,
             const Vector& normal, const Vector& along) {
    std::array<Rational, 3> height, place;
    for (std::size_t i = 0; i < 3; ++i) {
      height[i] = (face[i] - in_plane) * normal;
      place[i] = (face[i] - CGAL::ORIGIN) * along;
    }
    const auto [low, high] = std::minmax_element(height.begin(), height.end());
    if (!(*low < 0 && *high > 0))
      return std::nullopt;
    std::vector<Rational> cuts;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((height[i] < 0) != (height[j] < 0))
        cuts.push_back((place[i] * height[j] - place[j] * height[i]) / (height[j] - height[i]));
    }
    const auto [from, to] = std::minmax(cuts[0], cuts[1]);
    return std::pair(from, to);
  }

  RationalTriangle rational(std::size_t face) const {
    const auto point = [&](std::size_t corner) {
      const Vector<3>& p = surface_.points[surface_.triangles[face][corner]];
      return RationalKernel::Point_3(p[0], p[1], p[2]);
    };
    return {point(0), point(1), point(2)};
  }

  SurfaceView surface_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_INTERSECTING_PAIRS_H
