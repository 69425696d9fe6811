#ifndef QUADRILLE_TEST_CONTRACTIONS_H
#define QUADRILLE_TEST_CONTRACTIONS_H

#include "arrays.h"
#include "soups.h"

#include <quadrille/simplify.h>

/// \file
/// The engine, one contraction at a time.

namespace test {

/// The surface so large that the engine's unit is its own: half of its extent is 2^20 and more.
inline Soup large(const Soup& soup) {
  const double unit = 0x1p22 / diagonal(soup);
  return mapped(soup, [unit](const Position& p) { return unit * p; });
}

inline quadrille::internal::SurfaceInput<3> input_of(const Soup& soup) {
  quadrille::internal::SurfaceInput<3> input;
  input.positions = array_of(soup.points);
  input.triangles = array_of(soup.triangles);
  return input;
}

/// Contracts the pair a < b. False if it is refused.
template <class Surface>
bool contract(Surface& surface, quadrille::internal::Index a, quadrille::internal::Index b) {
  auto candidate = surface.evaluator().evaluate(a, b);
  const quadrille::internal::GatheredStar star(surface.complex(), a, b, surface.scratch());
  typename Surface::Contraction contraction(candidate, star);
  if (surface.checks().rejection(contraction))
    return false;
  surface.apply(contraction, quadrille::internal::AtOnce{});
  surface.progress().count(surface.scratch().counters);
  return true;
}

/// In the engine's units, which are those of a large surface.
template <class Surface>
const Position& position(const Surface& surface, quadrille::internal::Index v) {
  return surface.evaluator().state().geometry.position(v);
}

} // namespace test

#endif
