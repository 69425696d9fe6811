#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_SOLID_GUARD_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_SOLID_GUARD_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/complex/edge_balance.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/guards/intersection/face_intersections.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace quadrille::internal {

/// Keeps the faces of a solid apart. At the beginning it throws std::invalid_argument for a surface
/// that is not closed or intersects itself.
template <std::size_t N>
class SolidGuard final : public FaceIntersections<N> {
public:
  explicit SolidGuard(const GuardRoom<N>& room)
      : FaceIntersections<N>(room.complex, room.geometry), room_(room) {}

  void begin(Report& report) override {
    FaceIntersections<N>::begin(report);
    require_closed();
    if (const std::size_t pairs = report.self_intersections->before; pairs > 0) {
      const auto [a, b] = this->first_pair();
      throw std::invalid_argument(
          "quadrille::KeepSolid: the surface intersects itself: " + std::to_string(pairs) +
          " pairs of faces do, the first one near " + place(room_.complex.vertices(a)[0]) +
          " and " + place(room_.complex.vertices(b)[0]));
    }
  }

private:
  void require_closed() const {
    std::array<Index, 2> first{none, none};
    const std::size_t open = for_each_unbalanced_edge(room_.complex, [&](Index v, Index w) {
      if (first[0] == none)
        first = {v, w};
    });
    if (open > 0)
      throw std::invalid_argument(
          "quadrille::KeepSolid: the surface is not closed: " + std::to_string(open) +
          " edges have different numbers of faces on both sides, the first from " +
          place(first[0]) + " to " + place(first[1]));
  }

  // In the units of the mesh, in words.
  std::string place(Index v) const {
    const auto p = room_.scale.position_of_mesh(room_.geometry.position(v));
    return "(" + text_of(p[0]) + ", " + text_of(p[1]) + ", " + text_of(p[2]) + ")";
  }

  GuardRoom<N> room_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_SOLID_GUARD_H
