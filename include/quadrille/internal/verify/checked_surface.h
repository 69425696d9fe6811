#ifndef QUADRILLE_INTERNAL_VERIFY_CHECKED_SURFACE_H
#define QUADRILLE_INTERNAL_VERIFY_CHECKED_SURFACE_H

#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <CGAL/Bbox_3.h>

#include <array>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

using Corners = std::array<std::uint32_t, 3>;

/// Returns a surface as verify() sees it, from a mesh or from points and triangles: without the
/// faces whose corners are not three different points. If several faces have the same three
/// vertices, as the two sides of a double-sided face do, all of them count. Throws as
/// read_surface() does.
template <class... Surface>
TriangleSoup<> checked_surface(const char* caller, const Surface&... surface) {
  TriangleSoup<> checked = read_surface(caller, surface...);
  std::erase_if(checked.triangles, [](const Corners& corners) {
    const auto& [a, b, c] = corners;
    return a == b || b == c || c == a;
  });
  return checked;
}

/// Returns the box around the vertices of the faces.
inline CGAL::Bbox_3 box_of(const SurfaceView& surface) {
  CGAL::Bbox_3 box;
  for (const Corners& corners : surface.triangles)
    for (const std::uint32_t v : corners) {
      const Vector<3>& p = surface.points[v];
      box += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
    }
  return box;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_CHECKED_SURFACE_H
