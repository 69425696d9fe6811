#ifndef QUADRILLE_INTERNAL_CORE_STATE_DISTANCE_TO_REST_H
#define QUADRILLE_INTERNAL_CORE_STATE_DISTANCE_TO_REST_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/box_tree.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

inline std::array<float, 3> as_floats(const Vector<3>& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}
inline FloatBox cube_around(const Vector<3>& place, double radius) {
  const Vector<3> half{{radius, radius, radius}};
  return {as_floats(place - half), as_floats(place + half)};
}

/// How far a place is from the faces that are left. In O(n log n) time to begin with, and in about
/// O(log n) for a place near them.
template <std::size_t N>
class DistanceToRest {
public:
  DistanceToRest(const TriangleComplex& complex, const Geometry<N>& geometry)
      : complex_(complex), geometry_(geometry) {
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_removed(face))
        faces_.push_back(face);
    sort_for_box_tree(faces_.data(), faces_.data() + faces_.size(), [&](Index face) {
      const FloatBox box = box_of(face);
      return std::array{box.low[0] + box.high[0], box.low[1] + box.high[1],
                        box.low[2] + box.high[2]};
    });
    tree_ = BoxTree(faces_.size());
    for (std::size_t slot = 0; slot < faces_.size(); ++slot) {
      tree_.put(slot, box_of(faces_[slot]));
      whole_.add(box_of(faces_[slot]));
    }
    tree_.fit();
  }

  /// Returns the distance of a place, where `estimate` approximates it: larger than 0, in the
  /// engine's unit.
  double operator()(const Vector<3>& place, double estimate) const {
    if (faces_.empty())
      return 0;
    double radius = estimate;
    for (;;) {
      const double nearest = nearest_within(place, radius);
      if (nearest <= radius || has_all(place, radius))
        return nearest;
      radius = std::isfinite(nearest) ? nearest * (1 + 0x1p-20) : 2 * radius;
    }
  }

private:
  Vector<3> at(Index v) const { return space(geometry_.position(v)); }

  FloatBox box_of(Index face) const {
    FloatBox box = FloatBox::empty();
    for (Index v : complex_.vertices(face))
      box.add(as_floats(at(v)));
    return box;
  }

  bool has_all(const Vector<3>& place, double radius) const {
    FloatBox box = cube_around(place, radius);
    box.add(whole_);
    return box == cube_around(place, radius);
  }

  // Returns the distance to the faces whose boxes meet a cube around the place: at most that of any
  // face nearer than the radius. It is infinite if there are none.
  double nearest_within(const Vector<3>& place, double radius) const {
    double squared = std::numeric_limits<double>::infinity();
    tree_.for_each_meeting(cube_around(place, radius), [&](std::size_t slot, const FloatBox&) {
      const auto [a, b, c] = complex_.vertices(faces_[slot]);
      squared = (std::min)(squared, squared_distance_to_triangle(place, at(a), at(b), at(c)));
    });
    return std::sqrt(squared);
  }

  const TriangleComplex& complex_;
  const Geometry<N>& geometry_;
  std::vector<Index> faces_;
  BoxTree tree_;
  FloatBox whole_ = FloatBox::empty();
};

/// The place of a component that has vanished, in the engine's unit.
struct Trace {
  Vector<3> centre;
  double radius;
};

/// Returns about the greatest distance of the points of vanished components from the remaining
/// surface: the distance of a centre and the radius, at right angles to each other.
template <std::size_t N>
double distance_of(const std::vector<Trace>& gone, const TriangleComplex& complex,
                   const Geometry<N>& geometry) {
  if (gone.empty())
    return 0;
  const DistanceToRest<N> to_rest(complex, geometry);
  double greatest = 0;
  for (const Trace& component : gone)
    if (component.radius > 0)
      greatest = (std::max)(
          greatest, std::hypot(to_rest(component.centre, component.radius), component.radius));
  return greatest;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_DISTANCE_TO_REST_H
