#ifndef QUADRILLE_PLACEMENT_H
#define QUADRILLE_PLACEMENT_H

#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/policy/tie_break.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace quadrille {

/// The position halfway between the two ends of a pair.
struct MidpointPlacement {
  using ScaleFree = MidpointPlacement; ///< scale-invariant

  /// Returns (first + second) / 2, attributes included.
  auto operator()(const auto& /*cost*/, const auto& pair) const {
    return 0.5 * (pair.first + pair.second);
  }
};

/// The cheaper end of a pair, or the first if both cost the same. The output's vertices are then a
/// subset of the input's, with exact positions and exact attributes.
struct EndpointPlacement {
  using ScaleFree = EndpointPlacement; ///< scale-invariant

  /// Returns one of the ends, unchanged.
  auto operator()(const auto& cost, const auto& pair) const {
    return cost(pair, pair.second) < cost(pair, pair.first) ? pair.second : pair.first;
  }
};

/// A cost with `cost.minimizer(pair)`, an optional position.
template <class Cost, class Pair>
concept HasMinimizer = requires(const Cost cost, const Pair pair) {
  *cost.minimizer(pair);
};

/// The position of least cost; if it differs from an end by rounding only, this end itself, bit for
/// bit. If the cost has no minimizer, or it lies further from both ends than the farthest neighbour
/// (whose squared distance is `pair.squared_ring_radius`), it is the cheapest of the two ends and
/// the midpoint.
///
/// Source: Garland and Heckbert 1997, section 4 (without the intermediate search along the segment:
/// where planes leave directions free, this library's costs choose a position in them, see
/// Quadric).
struct OptimalPlacement {
  using ScaleFree = OptimalPlacement; ///< scale-invariant

  /// Returns the position of least cost within the one-ring radius.
  template <class Cost, class Pair>
  requires HasMinimizer<Cost, Pair>
  auto operator()(const Cost& cost, const Pair& pair) const {
    if (const auto x = cost.minimizer(pair); x && is_within_ring(pair, *x))
      return is_rounded(pair, pair.first, *x)    ? pair.first
             : is_rounded(pair, pair.second, *x) ? pair.second
                                                 : *x;
    const auto end = EndpointPlacement{}(cost, pair);
    const auto midpoint = MidpointPlacement{}(cost, pair);
    return cost(pair, midpoint) < cost(pair, end) ? midpoint : end;
  }

  /// Returns whether the predicate holds for another position that costs as much as x, up to
  /// rounding: an end or the midpoint. In flat and straight regions filters may accept one of these
  /// where they reject x.
  template <class Cost, class Pair, class Predicate>
  requires HasMinimizer<Cost, Pair>
  static bool any_equal(const Cost& cost, const Pair& pair, const auto& x, Predicate predicate) {
    if constexpr (internal::BreaksTies<Cost, Pair, std::decay_t<decltype(x)>>) {
      const double most = cost(pair, x) + rounding * cost.tie_break(pair, x);
      for (const auto& y : {pair.first, pair.second, MidpointPlacement{}(cost, pair)})
        if (cost(pair, y) <= most && predicate(y))
          return true;
    }
    return false;
  }

private:
  // The threshold of rounding in the tie break: a distance of about a millionth of the pair's
  // length.
  static constexpr double rounding = 1e-3;

  // Returns whether x is that end, up to rounding.
  static bool is_rounded(const auto& pair, const auto& end, const auto& x) {
    return squared_distance(end, x) <= 0x1p-60 * pair.squared_ring_radius;
  }

  // Returns false for a position that is not finite.
  static bool is_within_ring(const auto& pair, const auto& x) {
    return (std::min)(squared_distance(space(x), space(pair.first)),
                      squared_distance(space(x), space(pair.second))) <= pair.squared_ring_radius;
  }
};

/// Any placement, moved to a position that keeps the enclosed volume: along the mean normal of the
/// faces around the pair, to the plane Σ n · x = Σ n · p of their doubled area vectors n and points
/// p. A pair is rejected (Rejection::volume) if this position is further from both ends than the
/// farthest neighbour, or if the mean normal is zero.
///
/// On a closed surface the volume only changes by the rounding of coordinates: by less than 10⁻¹²
/// of it with doubles. A fixed vertex does not move, so its pairs are contracted only if the volume
/// stays the same. On a surface with boundary, the volume between the old and the new faces is 0.
///
/// With a scale-free placement only: `VolumeKeeping<OptimalPlacement>`, for instance.
///
/// Source: Lindstrom and Turk, Fast and Memory Efficient Polygonal Simplification, 1998, section 4.
template <class Placement>
struct VolumeKeeping {
  using ScaleFree = VolumeKeeping; ///< scale-invariant
  using Estimate = Placement;      ///< orders pairs until they are contracted
  static_assert(internal::is_scale_free<Placement>,
                "VolumeKeeping needs a placement that is scale-free: see <quadrille/concepts.h>.");
  static constexpr bool looks_at_star = true;   ///< the faces around the pair decide the position
  static constexpr bool asks_for_volume = true; ///< Report contains the volume
  static constexpr Rejection cause = Rejection::volume; ///< counts its rejections

  Placement placement = {}; ///< the placement whose position is moved

  /// Returns the estimate by which pairs are ordered: the position of the wrapped placement.
  auto operator()(const auto& cost, const auto& pair) const { return placement(cost, pair); }

  /// Returns the position of the wrapped placement, moved to the plane.
  template <class Cost, class Pair, class Star>
  auto resolve(const Cost& cost, const Pair& pair, const Star& star) const {
    auto x = placement(cost, pair);
    std::optional<decltype(x)> result;
    const Plane plane(star, space(pair.first));
    const double squared = squared_length(plane.normal);
    const double change = plane.change(space(x) - space(pair.first));
    if (std::abs(change) > plane.rounding()) {
      if (!(squared > least_mean * plane.area * plane.area))
        return result;
      const Vector<3> displacement = -change / squared * plane.normal;
      for (std::size_t i = 0; i < 3; ++i)
        x[i] += displacement[i];
      if (!is_within_ring(pair, x))
        return result;
    }
    result = x;
    return result;
  }

  /// Returns whether the volume stays the same if the pair moves to x.
  template <class Pair, class Star>
  bool admits(const Pair& pair, const Star& star, const auto& x) const {
    const Plane plane(star, space(pair.first));
    return std::abs(plane.change(space(x) - space(pair.first))) <= plane.rounding();
  }

  /// Does the same as in the wrapped placement.
  template <class Cost, class Pair, class Predicate>
  requires requires(const Placement& p, const Cost& cost, const Pair& pair, Predicate predicate) {
    p.any_equal(cost, pair, pair.first, predicate);
  }
  bool any_equal(const Cost& cost, const Pair& pair, const auto& x, Predicate predicate) const {
    return placement.any_equal(cost, pair, x, predicate);
  }

private:
  static constexpr double least_mean = 1e-12; // fraction of the squared mean normal

  // The plane on which the volume stays the same, relative to an end of the pair.
  struct Plane {
    Vector<3> normal{};
    double offset = 0;
    double area = 0, extent = 0; // the sum of all areas, doubled; the farthest corner, squared
    double size = 0;             // of coordinates; then by how much these are rounded

    Plane(const auto& star, const Vector<3>& origin) {
      star.for_each_face([&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
        const Vector<3> n = double_area_vector(p, q, r);
        normal += n;
        offset += dot(n, p - origin);
        area += std::sqrt(squared_length(n));
        for (const Vector<3>& corner : {p, q, r})
          extent = (std::max)(extent, squared_distance(corner, origin));
        size = (std::max)(size, std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]));
      });
      size = star.rounding(size);
    }
    double change(const Vector<3>& x) const { return dot(normal, x) - offset; }
    // Returns the amount below which a volume may be mere rounding.
    double rounding() const { return area * (0x1p-46 * std::sqrt(extent) + 4 * size); }
  };

  static bool is_within_ring(const auto& pair, const auto& x) {
    return (std::min)(squared_distance(space(x), space(pair.first)),
                      squared_distance(space(x), space(pair.second))) <= pair.squared_ring_radius;
  }
};

} // namespace quadrille

#endif // QUADRILLE_PLACEMENT_H
