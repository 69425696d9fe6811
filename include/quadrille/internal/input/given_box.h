#ifndef QUADRILLE_INTERNAL_INPUT_GIVEN_BOX_H
#define QUADRILLE_INTERNAL_INPUT_GIVEN_BOX_H

#include <quadrille/internal/base/text.h>
#include <quadrille/internal/input/surface_input.h>
#include <quadrille/internal/surface/box.h>
#include <quadrille/vector.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace quadrille::internal {

/// The corners of a box, in words.
template <std::size_t N>
std::string text_of_box(const Box<N>& box) {
  const auto corner = [](const Vector<N>& p) {
    return "(" + text_of(p[0]) + ", " + text_of(p[1]) + ", " + text_of(p[2]) + ")";
  };
  return corner(box.low) + " to " + corner(box.high);
}

/// Throws std::invalid_argument for a box of which a side is negative or not finite.
template <std::size_t N>
void require_box(const Box<N>& box) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(box.low[i] <= box.high[i]) || !std::isfinite(box.low[i]) || !std::isfinite(box.high[i]))
      throw std::invalid_argument("quadrille::simplify: bounding_box, from " + text_of_box(box) +
                                  ", is not a box");
}

/// The box that decides about the units in which a surface is simplified: its own, or the one that
/// is given instead. Throws std::invalid_argument if it reaches out of that by more than half of
/// the diagonal: a little may come of an earlier simplification, which moves vertices.
template <std::size_t N>
Box<N> box_of_units(const SurfaceInput<N>& input, const Box<N>& own) {
  if (!input.given_box)
    return own;
  const Box<N>& given = *input.given_box;
  require_box(given);
  const double margin = given.diagonal() / 2;
  for (std::size_t i = 0; i < 3 && !input.triangles.empty(); ++i)
    if (own.low[i] < given.low[i] - margin || own.high[i] > given.high[i] + margin)
      throw std::invalid_argument("quadrille::simplify: the surface, from " + text_of_box(own) +
                                  ", is not inside of bounding_box, from " + text_of_box(given));
  return given;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_INPUT_GIVEN_BOX_H
