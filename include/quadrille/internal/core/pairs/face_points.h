#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_FACE_POINTS_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_FACE_POINTS_H

#include <quadrille/internal/core/base/power_of_two.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille::internal {

/// The points of a surface that are corners of faces, in order, in a unit of their own: lengths
/// change by a power of two such that the largest coordinate is about 2^500, whatever the mesh's
/// unit. That is exact but for coordinates 2^-1574 times smaller, and squares of lengths from
/// `least` to `greatest` neither over- nor underflow.
class FacePoints {
public:
  static constexpr double least = 0x1p-500;
  static constexpr double greatest = 0x1p505; // no two points are as far apart

  explicit FacePoints(const SurfaceView& surface) {
    std::vector<bool> is_used(surface.points.size(), false);
    for (const auto& [a, b, c] : surface.triangles)
      if (a != b && b != c && c != a) // else it is no face
        is_used[a] = is_used[b] = is_used[c] = true;
    for (std::uint32_t v = 0; v < surface.points.size(); ++v)
      if (is_used[v]) {
        indices_.push_back(v);
        positions_.push_back(surface.points[v]);
      }
    scale();
  }

  std::size_t size() const { return indices_.size(); }
  std::uint32_t index(std::size_t i) const { return indices_[i]; } ///< in the surface
  std::span<const Vector<3>> positions() const { return positions_; }

  double length_of_mesh(double length) const { return std::ldexp(length, -exponent_); }
  double length_from_mesh(double length) const { return std::ldexp(length, exponent_); }

  /// Returns the diagonal of the bounding box.
  double diagonal() const { return Box<3>(positions_).diagonal(); }

private:
  void scale() {
    double largest = 0;
    for (const Vector<3>& p : positions_)
      for (double x : p.coordinates)
        largest = (std::max)(largest, std::abs(x));
    if (!(largest > 0))
      return;
    exponent_ = 500 - std::ilogb(largest);
    const PowerOfTwo scaled(exponent_);
    for (Vector<3>& p : positions_)
      for (double& x : p.coordinates)
        x = scaled(x);
  }

  std::vector<std::uint32_t> indices_;
  Array<Vector<3>> positions_;
  int exponent_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_FACE_POINTS_H
