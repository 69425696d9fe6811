#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FLAT_FAN_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FLAT_FAN_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Do faces around a vertex go once around it, seen from somewhere? Then no two of them intersect,
/// and it need not be asked of each pair. Most stars are like that.
class FlatFan {
public:
  /// The vertex is the first of each face.
  template <class Faces>
  bool is(const Faces& faces) {
    if (!closes(faces))
      return false;
    Vector<3> normal{};
    for (const auto& face : faces) {
      const auto& [x, p, q] = face.corners.points;
      normal += cross(difference(p, x), difference(q, x));
    }
    const Axes axes = axes_across(normal);
    std::size_t turns = 0;
    for (const auto& face : faces) {
      const auto& [x, p, q] = face.corners.points;
      const Vector<3> to_p = difference(p, x), to_q = difference(q, x);
      const RoundedSum pu = rounded_dot(axes[0], to_p), pv = rounded_dot(axes[1], to_p),
                       qu = rounded_dot(axes[0], to_q), qv = rounded_dot(axes[1], to_q);
      if (!is_product_greater(pu, qv, pv, qu) || !has_sign(pv) || !has_sign(qv))
        return false;
      turns +=
          pv.value < 0 && qv.value > 0; // past the first axis, since it turns by less than half
    }
    return turns == 1;
  }

private:
  using Axes = std::array<Vector<3>, 2>;

  // Does each edge at the vertex have as many faces on one side as on the other?
  template <class Faces>
  bool closes(const Faces& faces) {
    ends_[0].clear(), ends_[1].clear();
    for (const auto& face : faces)
      for (std::size_t i = 0; i < 2; ++i)
        ends_[i].push_back(face.corners.vertices[i + 1]);
    for (auto& ends : ends_)
      std::sort(ends.begin(), ends.end());
    return ends_[0] == ends_[1];
  }

  static Axes axes_across(const Vector<3>& normal) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(normal[i]) < std::abs(normal[least]))
        least = i;
    Vector<3> unit{};
    unit[least] = 1;
    const Vector<3> first = cross(unit, normal);
    return {first, cross(normal, first)};
  }

  static bool has_sign(const RoundedSum& sum) { return sum.is_positive() || sum.is_negative(); }

  // Is ab > cd?
  static bool is_product_greater(const RoundedSum& a, const RoundedSum& b, const RoundedSum& c,
                                 const RoundedSum& d) {
    const double size = a.size * b.size + c.size * d.size;
    return a.value * b.value - c.value * d.value - 4 * RoundedSum::tolerance * size >
           RoundedSum::least;
  }

  std::array<std::vector<Index>, 2> ends_; // of the edges around
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FLAT_FAN_H
