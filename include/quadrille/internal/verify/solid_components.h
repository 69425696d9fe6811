#ifndef QUADRILLE_INTERNAL_VERIFY_SOLID_COMPONENTS_H
#define QUADRILLE_INTERNAL_VERIFY_SOLID_COMPONENTS_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/umbrellas_of_solid.h>
#include <quadrille/quadric_form.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace quadrille::internal {

inline double length(const Vector<3>& v) {
  return std::sqrt(squared_length(v));
}

/// Returns the corners of a face of a surface, minus a point.
inline std::array<Vector<3>, 3> corners_seen_from(const SurfaceView& surface, std::size_t face,
                                                  const Vector<3>& p) {
  std::array<Vector<3>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = surface.points[surface.triangles[face][i]] - p;
  return corners;
}

/// The place of a component of a surface, its extent, and the side of it on which its inside lies.
class ComponentShape {
public:
  ComponentShape() = default;
  ComponentShape(const SurfaceView& surface, const std::vector<std::size_t>& faces) {
    for (const std::size_t face : faces)
      for (const Vector<3>& p : corners_seen_from(surface, face, {}))
        for (std::size_t i = 0; i < 3; ++i) {
          low_[i] = (std::min)(low_[i], p[i]);
          high_[i] = (std::max)(high_[i], p[i]);
        }
    place_ = corners_seen_from(surface, faces.front(), {})[0];
    measure(surface, faces);
  }

  /// 1 if the component is oriented outward, -1 if it is inside out, 0 if its volume does not
  /// exceed rounding errors.
  int orientation() const { return orientation_; }
  /// A point of the component.
  const Vector<3>& place() const { return place_; }

  bool box_contains(const ComponentShape& other) const {
    return low_[0] <= other.low_[0] && low_[1] <= other.low_[1] && low_[2] <= other.low_[2] &&
           high_[0] >= other.high_[0] && high_[1] >= other.high_[1] && high_[2] >= other.high_[2];
  }

  /// A measure of distance with one certain property: it is small for a component that has hardly
  /// changed. It compares the boxes, the centres, and the spread around the centres.
  double apart(const ComponentShape& other) const {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
      most =
          (std::max)({most, std::abs(low_[i] - other.low_[i]), std::abs(high_[i] - other.high_[i]),
                      std::abs(centre_[i] - other.centre_[i])});
    const double size = std::sqrt(trace()) + std::sqrt(other.trace());
    for (std::size_t i = 0; i < 6 && size > 0; ++i)
      most = (std::max)(most, std::abs(spread_[i] - other.spread_[i]) / size);
    return most;
  }

private:
  double trace() const { return spread_[0] + spread_[1] + spread_[2]; }

  /// Computes integrals over the faces. A volume counts if it is greater than the rounding errors
  /// of the coordinates and of the sum.
  void measure(const SurfaceView& surface, const std::vector<std::size_t>& faces) {
    double area = 0, volume = 0, terms = 0;
    Vector<3> first{};
    std::array<double, 6> second{};
    for (const std::size_t face : faces) {
      const auto [a, b, c] = corners_seen_from(surface, face, place_);
      const double double_area = length(cross(b - a, c - a)), term = dot(a, cross(b, c));
      const Vector<3> middle = 1.0 / 3 * (a + b + c);
      area += double_area;
      volume += term;
      terms += std::abs(term);
      first += double_area * middle;
      for (std::size_t i = 0; i < 6; ++i)
        second[i] += double_area * middle[rows[i]] * middle[columns[i]];
    }
    for (std::size_t i = 0; i < 3; ++i)
      centre_[i] = area > 0 ? first[i] / area : 0;
    for (std::size_t i = 0; i < 6 && area > 0; ++i)
      spread_[i] = second[i] / area - centre_[rows[i]] * centre_[columns[i]];
    centre_ += place_;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double rounding = 8 * epsilon * (greatest_coordinate() * area + terms);
    orientation_ = std::abs(volume) <= rounding ? 0 : volume > 0 ? 1 : -1;
  }

  double greatest_coordinate() const {
    double greatest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      greatest = (std::max)({greatest, std::abs(low_[i]), std::abs(high_[i])});
    return greatest;
  }

  static constexpr std::array<std::size_t, 6> rows{0, 1, 2, 0, 1, 2}, columns{0, 1, 2, 1, 2, 0};
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Vector<3> low_{{infinity, infinity, infinity}}, high_{{-infinity, -infinity, -infinity}};
  Vector<3> place_{}, centre_{};
  std::array<double, 6> spread_{};
  int orientation_ = 0;
};

/// A component of a closed surface that has been cut where it only touches itself.
struct SolidComponent {
  std::vector<std::size_t> faces;
  std::ptrdiff_t euler_number = 0; ///< two minus twice its genus
  ComponentShape shape;
  std::vector<std::size_t> around; ///< the numbers of the other components that it lies in
};

/// Returns the components of a closed surface, numbered by their first faces: the orientation of
/// each, its number of handles, and the components in which it lies, which follow from how often
/// these wind around a point of it. No component makes this fail, even if it is flat, a line or a
/// point.
inline std::vector<SolidComponent>
solid_components(const SurfaceView& surface, UmbrellasOfSolid& umbrellas, CheckProgress& progress);

/// Counts pairs of faces on the same three vertices; each face is in one pair at most. Such a pair
/// is a double-sided face or a closed surface of two faces, which encloses nothing. `first` becomes
/// the lowest number of such a face.
inline std::size_t count_doubled_faces(const SurfaceView& surface, std::size_t& first) {
  std::set<Corners> single;
  std::size_t count = 0;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
    Corners key = surface.triangles[face];
    std::sort(key.begin(), key.end());
    if (single.insert(key).second)
      continue;
    single.erase(key);
    if (count++ == 0)
      first = face;
  }
  return count;
}

/// Returns how often a component winds around a point.
inline double winding_number(const SurfaceView& surface, const SolidComponent& component,
                             const Vector<3>& p) {
  double sum = 0;
  for (const std::size_t face : component.faces) {
    const auto [a, b, c] = corners_seen_from(surface, face, p);
    const double k = length(a), l = length(b), m = length(c);
    sum +=
        std::atan2(dot(a, cross(b, c)), k * l * m + dot(a, b) * m + dot(b, c) * k + dot(c, a) * l);
  }
  return sum / (2 * std::numbers::pi);
}

/// Does one component lie in another one? Where they touch, a point may lie on both, and its
/// winding number is then undefined: so the point with the clearest winding number decides.
inline bool lies_in(const SurfaceView& surface, const SolidComponent& inner,
                    const SolidComponent& outer) {
  constexpr std::size_t most_points = 16;
  constexpr double enough = 1e-6;
  const std::size_t step = (std::max)(std::size_t{1}, inner.faces.size() / most_points);
  double best = 0, error = 1;
  for (std::size_t i = 0; i < inner.faces.size() && error > enough; i += step) {
    const auto [a, b, c] = corners_seen_from(surface, inner.faces[i], {});
    const double winding = winding_number(surface, outer, 1.0 / 3 * (a + b + c));
    if (const double e = std::abs(winding - std::round(winding)); e < error) {
      best = std::round(winding);
      error = e;
    }
  }
  return best != 0;
}

inline std::vector<SolidComponent>
solid_components(const SurfaceView& surface, UmbrellasOfSolid& umbrellas, CheckProgress& progress) {
  std::vector<SolidComponent> components;
  std::map<std::size_t, std::size_t> numbers;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
    const auto [at, is_new] = numbers.try_emplace(umbrellas.component_of(face), components.size());
    if (is_new)
      components.emplace_back();
    components[at->second].faces.push_back(face);
  }
  for (SolidComponent& component : components) {
    // Each face has three half-edges, and two of these are an edge: F - E = -F/2.
    component.euler_number = static_cast<std::ptrdiff_t>(umbrellas.count(component.faces)) -
                             static_cast<std::ptrdiff_t>(component.faces.size() / 2);
    component.shape = ComponentShape(surface, component.faces);
  }
  for (std::size_t i = 0; i < components.size(); ++i)
    for (std::size_t j = 0; j < components.size(); ++j) {
      progress.step();
      if (i != j && components[j].shape.box_contains(components[i].shape) &&
          lies_in(surface, components[i], components[j]))
        components[i].around.push_back(j);
    }
  return components;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_SOLID_COMPONENTS_H
