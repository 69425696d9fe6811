#ifndef QUADRILLE_COMPILED_VOXEL_LATTICE_H
#define QUADRILLE_COMPILED_VOXEL_LATTICE_H

#include <quadrille/compiled.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The numbers begin, begin + step, begin + 2 step, … on which all coordinates along an axis lie.
struct CoordinateLattice {
  double begin = 0, step = 0;

  std::int64_t index(double coordinate) const { return std::llround((coordinate - begin) / step); }
};

/// Finds the coarsest lattice on which coordinates lie, but for a thousandth of its step and the
/// rounding of floats. Its step is their least difference, or a half, a third or a quarter of that.
/// None if there is no such lattice, only one coordinate, or one that is not finite. O(n log n).
inline std::optional<CoordinateLattice> lattice_of(std::vector<double> coordinates) {
  if (coordinates.empty() || !std::all_of(coordinates.begin(), coordinates.end(),
                                          [](double x) { return std::isfinite(x); }))
    return std::nullopt;
  std::sort(coordinates.begin(), coordinates.end());
  const double begin = coordinates.front(), length = coordinates.back() - begin;
  const double rounding = 0x1p-22 * (std::max)(std::abs(begin), std::abs(coordinates.back()));
  double least = length;
  for (std::size_t i = 1; i < coordinates.size(); ++i)
    if (const double step = coordinates[i] - coordinates[i - 1]; step > 64 * rounding)
      least = (std::min)(least, step);
  if (!(least > 64 * rounding))
    return std::nullopt;
  for (int divisor = 1; divisor <= 4; ++divisor) {
    const CoordinateLattice lattice{begin, length / std::round(divisor * length / least)};
    const double tolerance = 8 * rounding + 1e-3 * lattice.step;
    if (std::all_of(coordinates.begin(), coordinates.end(), [&](double x) {
          return std::abs(x - begin - static_cast<double>(lattice.index(x)) * lattice.step) <=
                 tolerance;
        }))
      return lattice;
  }
  return std::nullopt;
}

/// The places of the points of a soup on a lattice along each axis.
class PointLattice {
public:
  PointLattice(const SoupView& soup, const std::array<CoordinateLattice, 3>& axes)
      : soup_(soup), axes_(axes) {}

  /// Is each triangle perpendicular to an axis?
  bool are_all_on_axes() const {
    return std::all_of(soup_.triangles.begin(), soup_.triangles.end(), [this](const auto& t) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (index(t[0], axis) == index(t[1], axis) && index(t[0], axis) == index(t[2], axis))
          return true;
      return false;
    });
  }

  /// Is each point of a triangle halfway along one axis between places that have the same parities
  /// as all others? Then the parities of two points differ along two axes, or along none.
  bool are_all_halfway() const {
    unsigned found = 0; // bit p is set if there is a point with the parities p
    for (const auto& t : soup_.triangles)
      for (const std::uint32_t v : t) {
        unsigned parities = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
          parities |= static_cast<unsigned>(index(v, axis) & 1) << axis;
        found |= 1u << parities;
      }
    constexpr unsigned even = 0b01101001, odd = 0b10010110; // sums of parities
    return std::popcount(found) == 3 && ((found & even) == 0 || (found & odd) == 0);
  }

private:
  std::int64_t index(std::uint32_t v, std::size_t axis) const {
    return axes_[axis].index(soup_.points[v][axis]);
  }

  const SoupView& soup_;
  std::array<CoordinateLattice, 3> axes_;
};

/// Finds the size of the voxels of which a surface was made: the least of its sides, if these are
/// not the same along all axes. There is one if each triangle is perpendicular to an axis, and all
/// points lie on a lattice, as the corners of blocks do; or if each point lies halfway between
/// neighbours on a lattice along one axis, as those of marching cubes of a binary image do. Flat
/// parts may have been merged before. O(n log n), about 16 bytes per point.
inline std::optional<double> lattice_voxel_size(const SoupView& soup) {
  std::vector<bool> is_used(soup.points.size(), false);
  for (const auto& t : soup.triangles)
    for (const std::uint32_t v : t) {
      if (v >= soup.points.size())
        return std::nullopt;
      is_used[v] = true;
    }
  std::array<CoordinateLattice, 3> axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> coordinates;
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      if (is_used[v])
        coordinates.push_back(soup.points[v][axis]);
    const std::optional<CoordinateLattice> lattice = lattice_of(std::move(coordinates));
    if (!lattice)
      return std::nullopt;
    axes[axis] = *lattice;
  }
  const double size = (std::min)({axes[0].step, axes[1].step, axes[2].step});
  const PointLattice points(soup, axes);
  if (points.are_all_on_axes())
    return size;
  return points.are_all_halfway() ? std::optional(2 * size) : std::nullopt;
}

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_VOXEL_LATTICE_H
