#ifndef QUADRILLE_TRIANGLE_SOUP_H
#define QUADRILLE_TRIANGLE_SOUP_H

#include <quadrille/quadric_form.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

/// \file
/// Points, and triangles between them: how all of the library that is not the engine sees a
/// surface.

namespace quadrille {

/// A surface that belongs to somebody else and is only read.
struct SurfaceView {
  std::span<const Vector<3>> points;                       ///< where they are
  std::span<const std::array<std::uint32_t, 3>> triangles; ///< indices of points
  std::span<const std::uint32_t> constrained = {}; ///< points that stay where they are, ascending
};

/// A surface of its own. Points may be of another type: of a kernel, or in a plane.
template <class Point = Vector<3>>
struct TriangleSoup {
  std::vector<Point> points;                           ///< where they are
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of points

  /// The view of it, which is good as long as nothing is added.
  operator SurfaceView() const requires std::same_as<Point, Vector<3>> {
    return {points, triangles};
  }
};

} // namespace quadrille

#endif // QUADRILLE_TRIANGLE_SOUP_H
