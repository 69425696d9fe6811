#ifndef QUADRILLE_TRIANGLE_SOUP_H
#define QUADRILLE_TRIANGLE_SOUP_H

#include <quadrille/quadric_form.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

/// \file
/// Points, and triangles between them: the representation of a surface outside of the engine.

namespace quadrille {

/// A read-only view of a surface that it does not own.
struct SurfaceView {
  std::span<const Vector<3>> points;                       ///< the positions
  std::span<const std::array<std::uint32_t, 3>> triangles; ///< indices of points
  std::span<const std::uint32_t> constrained = {}; ///< the points that must not move, ascending
};

/// A surface that owns its data. Points may be of another type: of a kernel, or in a plane.
template <class Point = Vector<3>>
struct TriangleSoup {
  std::vector<Point> points;                           ///< the positions
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points

  /// Returns a view, which is valid until elements are added.
  operator SurfaceView() const requires std::same_as<Point, Vector<3>> {
    return {points, triangles};
  }
};

} // namespace quadrille

#endif // QUADRILLE_TRIANGLE_SOUP_H
