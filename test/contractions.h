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
  auto candidate = surface.evaluate(a, b);
  surface.gather(surface.scratch(), a, b);
  if (surface.rejection(surface.scratch(), a, b, candidate))
    return false;
  surface.contract(surface.scratch(), a, b, candidate);
  surface.count(surface.scratch().tally);
  return true;
}

} // namespace test

#endif
