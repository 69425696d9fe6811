#ifndef QUADRILLE_INTERNAL_CORE_STATE_CUT_REGION_H
#define QUADRILLE_INTERNAL_CORE_STATE_CUT_REGION_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/edge_cycle.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/quadric_form.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Does a cycle run round a tunnel, and not round a limb? The normals of the faces next to it
/// then lean towards its middle, on a surface that is oriented outwards.
template <std::size_t N>
bool is_round_tunnel(const Geometry<N>& geometry, const EdgeCycle& cycle, const CycleSides& sides) {
  const auto at = [&](Index v) { return space(geometry.position(v)); };
  const Vector<3> middle = 1. / 3 * (at(cycle[0]) + at(cycle[1]) + at(cycle[2]));
  double leaning = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<3> p = at(cycle[i]), inwards = middle - 0.5 * (p + at(cycle[(i + 1) % 3]));
    for (const StarFace& f : {sides.left[i].front(), sides.right[i].back()}) { // at the same edge
      const Vector<3> normal = double_area_vector(p, at(f.second), at(f.third));
      const double length = std::sqrt(squared_length(normal));
      leaning += length > 0 ? dot(normal, inwards) / length : 0;
    }
  }
  return leaning > 0;
}

/// The parts of a surface on both sides of a cycle: they are the same part, which has a handle
/// there, or two parts that hang together nowhere else.
///
/// Both sides are searched at the same time, the one of which less has been seen first, until they
/// meet or one has been seen entirely. So it takes no longer than seeing the smaller part takes, or
/// what lies around a handle.
template <std::size_t N>
class CutRegion {
public:
  CutRegion(const TriangleComplex& complex, const Geometry<N>& geometry, const EdgeCycle& cycle,
            const CycleSides& sides, VertexLabels& labels)
      : complex_(complex), geometry_(geometry), labels_(labels), origin_(at(cycle[0])) {
    labels_.clear(3);
    for (Index v : cycle)
      labels_.set(v, at_cycle);
    for (const Index side : {Index{0}, Index{1}})
      for (const auto& faces : side == 0 ? sides.left : sides.right)
        for (const StarFace& f : faces)
          see(f, side);
    while (!is_handle_ && !is_done(0) && !is_done(1))
      go_on(sides_[1].seen.size() < sides_[0].seen.size());
  }

  /// Is it one part?
  bool is_handle() const { return is_handle_; }
  /// Are both of two parts wider than that? The width of a part is four times its volume over its
  /// area, as that of a long tube.
  bool are_wider_than(double width) {
    const Index smaller = is_done(0) ? 0 : 1;
    if (this->width(smaller) <= width)
      return false;
    while (!is_done(1 - smaller))
      go_on(1 - smaller);
    return this->width(1 - smaller) > width;
  }

private:
  static constexpr Index at_cycle = 2; // labels are 0 and 1 on the sides

  struct Side {
    std::vector<Index> seen; // vertices
    std::size_t next = 0;    // of these, to look around at
  };

  Vector<3> at(Index v) const { return space(geometry_.position(v)); }
  bool is_done(Index side) const { return sides_[side].next == sides_[side].seen.size(); }

  void see(const StarFace& f, Index side) {
    for (Index v : {f.second, f.third}) {
      if (labels_.insert_as(v, side))
        sides_[side].seen.push_back(v);
      else
        is_handle_ |= labels_.has_label(v, 1 - side);
    }
  }
  void go_on(Index side) {
    const Index v = sides_[side].seen[sides_[side].next++];
    complex_.for_each_corner(
        v, [&](Index face, Index i) { see(star_face_at(complex_, face, i), side); });
  }

  // A face counts at each of its vertices that is not on the cycle. The face of the cut has no
  // volume about one of its corners.
  double width(Index side) const {
    double volume = 0, area = 0;
    for (Index v : sides_[side].seen)
      complex_.for_each_corner(v, [&](Index face, Index i) {
        const StarFace f = star_face_at(complex_, face, i);
        const double component = 1. / (1 + counts(f.second) + counts(f.third));
        const Vector<3> n = double_area_vector(at(v), at(f.second), at(f.third));
        volume += component * dot(at(v) - origin_, n) / 6;
        area += component * std::sqrt(squared_length(n)) / 2;
      });
    return area > 0 ? 4 * std::abs(volume) / area : 0;
  }
  int counts(Index v) const { return labels_.has_label(v, at_cycle) ? 0 : 1; }

  const TriangleComplex& complex_;
  const Geometry<N>& geometry_;
  VertexLabels& labels_;
  Vector<3> origin_;
  std::array<Side, 2> sides_;
  bool is_handle_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_CUT_REGION_H
