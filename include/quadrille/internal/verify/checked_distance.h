#ifndef QUADRILLE_INTERNAL_VERIFY_CHECKED_DISTANCE_H
#define QUADRILLE_INTERNAL_VERIFY_CHECKED_DISTANCE_H

#include <quadrille/internal/distance/distance_surface.h>
#include <quadrille/internal/verify/checked_surface.h>

#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace quadrille::internal {

/// The distances between two surfaces, one way and the other, as CGAL bounds them.
class CheckedDistance {
public:
  /// Throws std::invalid_argument where one has no face.
  CheckedDistance(const CheckedSurface& a, const CheckedSurface& b)
      : frame_(box_of(a, b)), a_(faces_of(a)), b_(faces_of(b)), farthest_(diagonal(box_of(a, b))) {}

  double diagonal_of_both() const { return farthest_; }
  /// How far the points of `a` are from `b`, wrong by at most `error`.
  double from_a(double error) const { return one_way(a_, b_, error); }
  double from_b(double error) const { return one_way(b_, a_, error); }

private:
  using Mesh = CGAL::Surface_mesh<DistancePoint>;

  static CGAL::Bbox_3 box_of(const CheckedSurface& a, const CheckedSurface& b) {
    if (a.faces.empty() || b.faces.empty())
      throw std::invalid_argument("quadrille::verify: a surface without faces is at no distance");
    return a.box() + b.box();
  }

  // As faces that have no vertex in common: a surface may be non-manifold.
  Mesh faces_of(const CheckedSurface& surface) const {
    Mesh mesh;
    const auto vertex = [&](std::size_t v) {
      const auto& p = surface.points[v];
      return mesh.add_vertex(frame_.to(DistancePoint(p.x(), p.y(), p.z())));
    };
    for (const auto& [a, b, c] : surface.faces) {
      const auto first = vertex(a), second = vertex(b), third = vertex(c);
      mesh.add_face(first, second, third);
    }
    return mesh;
  }

  double one_way(const Mesh& from, const Mesh& to, double error) const {
    if (farthest_ == 0)
      return 0; // all is one point, which CGAL does not measure
    const double distance =
        CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(
            from, to, (std::max)(frame_.to(error), 0x1p-40));
    return (std::min)(frame_.from(distance), farthest_);
  }

  DistanceFrame frame_;
  Mesh a_, b_;
  double farthest_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_CHECKED_DISTANCE_H
