#ifndef QUADRILLE_INTERNAL_INTERSECTION_SOLID_REQUIREMENT_H
#define QUADRILLE_INTERNAL_INTERSECTION_SOLID_REQUIREMENT_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/base/text.h>
#include <quadrille/internal/complex/edge_balance.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace quadrille::internal {

/// A place in the units of the mesh, in words.
inline std::string text_of_place(const Vector<3>& p) {
  return "(" + text_of(p[0]) + ", " + text_of(p[1]) + ", " + text_of(p[2]) + ")";
}

/// Throws std::invalid_argument if a surface, of which intersecting pairs of faces have been
/// counted, is not closed or intersects itself.
template <class Surface>
void require_solid(Surface& surface, const Report& report) {
  const auto place = [&](Index v) {
    const auto& evaluator = surface.evaluator();
    return text_of_place(
        space(evaluator.scale().position_of_mesh(evaluator.geometry().position(v))));
  };
  std::array<Index, 2> first{none, none};
  const std::size_t open = for_each_unbalanced_edge(surface.complex(), [&](Index v, Index w) {
    if (first[0] == none)
      first = {v, w};
  });
  if (open > 0)
    throw std::invalid_argument(
        "quadrille::keep_solid: the surface is not closed: " + std::to_string(open) +
        " edges have not as many faces on one side as on the other, the "
        "first from " +
        place(first[0]) + " to " + place(first[1]));
  if (const std::size_t pairs = report.self_intersections->before; pairs > 0) {
    const auto [a, b] = surface.checks().optional().intersections()->first_pair();
    throw std::invalid_argument(
        "quadrille::keep_solid: the surface intersects itself: " + std::to_string(pairs) +
        " pairs of faces do, the first one near " + place(surface.complex().vertices(a)[0]) +
        " and " + place(surface.complex().vertices(b)[0]));
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_INTERSECTION_SOLID_REQUIREMENT_H
