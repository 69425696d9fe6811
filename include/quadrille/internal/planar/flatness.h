#ifndef QUADRILLE_INTERNAL_PLANAR_FLATNESS_H
#define QUADRILLE_INTERNAL_PLANAR_FLATNESS_H

#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/planar/surface_sides.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace quadrille::internal {

/// The allowed deviation of a patch from a plane, in the unit of the positions.
struct FlatLimits {
  double height;       ///< the greatest distance of its vertices to its plane
  double cosine;       ///< the least cosine of the angle between the normals of a face and of the
                       ///< plane
  double attributes;   ///< the allowed deviation of a component from an affine function, as a
                       ///< fraction of its range
  double thinnest = 0; ///< the normal of a face that is no higher than this is ignored
};

/// Returns the greatest rounding error of such positions, if they are all floats, or doubles.
inline double rounding_of(std::span<const Vector<3>> positions) {
  double greatest = 0;
  bool are_floats = true;
  for (const Vector<3>& p : positions)
    for (double x : p.coordinates) {
      greatest = (std::max)(greatest, std::abs(x));
      are_floats = are_floats && static_cast<double>(to_number<float>(x)) == x;
    }
  return greatest * (are_floats ? 0x1p-24 : 0x1p-53);
}

/// A plane, with the side to which the normal of length 1 points.
struct Plane {
  Vector<3> origin, normal;
  double height(const Vector<3>& p) const { return dot(p - origin, normal); }
};

/// A surface with channels, as patches use it.
struct PatchSurface {
  std::span<const Vector<3>> positions;
  const SurfaceSides& sides;
  const std::vector<ChannelInput>& channels;

  const Vector<3>& position(Index side) const { return positions[sides.to(side)]; }
  Vector<3> area_vector(Index face) const {
    return double_area_vector(position(3 * face), position(3 * face + 1), position(3 * face + 2));
  }
  double value(const ChannelInput& channel, Index side, std::size_t component) const {
    return channel.value(channel.value_at(side / 3, side % 3, sides.to(side)), component);
  }
};

/// The plane of a patch, and all components of its channels as affine functions, determined by
/// three corners.
class AffinePatch {
public:
  /// `corners` are sides that lead to the corners.
  AffinePatch(const PatchSurface& surface, const Plane& plane, std::array<Index, 3> corners)
      : plane_(plane), origin_(surface.position(corners[0])) {
    const Vector<3> p = surface.position(corners[1]) - origin_;
    const Vector<3> q = surface.position(corners[2]) - origin_;
    const Vector<3> n = cross(p, q);
    const double scale = 1 / squared_length(n);
    for (const ChannelInput& channel : surface.channels)
      for (std::size_t c = 0; c < channel.components; ++c) {
        const double first = surface.value(channel, corners[0], c);
        const double along_p = surface.value(channel, corners[1], c) - first;
        const double along_q = surface.value(channel, corners[2], c) - first;
        functions_.push_back({first, scale * (along_p * cross(q, n) + along_q * cross(n, p))});
      }
  }

  const Plane& plane() const { return plane_; }

  /// Does function i have this value at a position, within a tolerance?
  bool has_value(std::size_t i, const Vector<3>& p, double value, double tolerance) const {
    const auto& [first, gradient] = functions_[i];
    return std::abs(first + dot(gradient, p - origin_) - value) <= tolerance;
  }

private:
  struct Affine {
    double first; // at the origin
    Vector<3> gradient;
  };

  Plane plane_;
  Vector<3> origin_;
  std::vector<Affine> functions_;
};

/// Decides which faces lie in a patch.
class Flatness {
public:
  Flatness(const PatchSurface& surface, const FlatLimits& limits)
      : surface_(surface), limits_(limits) {
    for (const ChannelInput& channel : surface.channels)
      for (std::size_t c = 0; c < channel.components; ++c) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (Index i = 0; i < channel.size(); ++i) {
          low = (std::min)(low, channel.value(i, c));
          high = (std::max)(high, channel.value(i, c));
        }
        tolerances_.push_back(limits.attributes * (high - low));
      }
  }

  bool fits(Index face, const AffinePatch& patch) const {
    for (Index s = 3 * face; s < 3 * face + 3; ++s)
      if (!(std::abs(patch.plane().height(surface_.position(s))) <= limits_.height))
        return false;
    return has_normal(face, patch.plane().normal) && has_values(face, patch);
  }

  /// Returns the patch of a single face, if it has an area.
  std::optional<AffinePatch> patch_of(Index face) const {
    const Vector<3> n = surface_.area_vector(face);
    const double length = std::sqrt(squared_length(n));
    if (!(length > 0))
      return std::nullopt;
    return AffinePatch(surface_, {surface_.position(3 * face), (1 / length) * n},
                       {3 * face, 3 * face + 1, 3 * face + 2});
  }

  /// Returns the patch of several faces: the plane through the centre of their vertices with their
  /// mean normal, and the functions determined by three corners that lie far apart.
  std::optional<AffinePatch> patch_of(std::span<const Index> faces) const {
    Vector<3> n;
    for (Index f : faces)
      n += surface_.area_vector(f);
    const double length = std::sqrt(squared_length(n));
    const auto corners = far_corners(faces);
    if (!(length > 0) || !corners)
      return std::nullopt;
    Plane plane{surface_.position(3 * faces[0]), (1 / length) * n};
    double low = 0, high = 0;
    for (Index f : faces)
      for (Index s = 3 * f; s < 3 * f + 3; ++s) {
        low = (std::min)(low, plane.height(surface_.position(s)));
        high = (std::max)(high, plane.height(surface_.position(s)));
      }
    plane.origin += 0.5 * (low + high) * plane.normal;
    return AffinePatch(surface_, plane, *corners);
  }

private:
  // Is the normal within the angle, or the face so thin that its normal is unreliable?
  bool has_normal(Index face, const Vector<3>& normal) const {
    const Vector<3> n = surface_.area_vector(face);
    const double length = std::sqrt(squared_length(n));
    double longest = 0;
    for (Index s = 3 * face; s < 3 * face + 3; ++s)
      longest = (std::max)(longest, squared_distance(surface_.position(s),
                                                     surface_.position(SurfaceSides::before(s))));
    return dot(n, normal) >= limits_.cosine * length ||
           length <= limits_.thinnest * std::sqrt(longest);
  }

  bool has_values(Index face, const AffinePatch& patch) const {
    std::size_t i = 0;
    for (const ChannelInput& channel : surface_.channels)
      for (std::size_t c = 0; c < channel.components; ++c, ++i)
        for (Index s = 3 * face; s < 3 * face + 3; ++s)
          if (!patch.has_value(i, surface_.position(s), surface_.value(channel, s, c),
                               tolerances_[i]))
            return false;
    return true;
  }

  // Returns the corners of the largest triangle with the first corner and the corner farthest from
  // it; none if that triangle has no area.
  std::optional<std::array<Index, 3>> far_corners(std::span<const Index> faces) const {
    const auto farthest = [&](auto measure) {
      Index best = none;
      double greatest = 0;
      for (Index f : faces)
        for (Index s = 3 * f; s < 3 * f + 3; ++s)
          if (const double x = measure(surface_.position(s)); x > greatest) {
            greatest = x;
            best = s;
          }
      return best;
    };
    const Index a = 3 * faces[0];
    const Vector<3> p = surface_.position(a);
    const Index b = farthest([&](const Vector<3>& x) { return squared_distance(x, p); });
    if (b == none)
      return std::nullopt;
    const Vector<3> q = surface_.position(b);
    const Index c =
        farthest([&](const Vector<3>& x) { return squared_length(double_area_vector(p, q, x)); });
    if (c == none)
      return std::nullopt;
    return std::array{a, b, c};
  }

  PatchSurface surface_;
  FlatLimits limits_;
  std::vector<double> tolerances_; // for each component of all channels
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_FLATNESS_H
