#ifndef QUADRILLE_INTERNAL_ORDER_LOOK_AHEAD_H
#define QUADRILLE_INTERNAL_ORDER_LOOK_AHEAD_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/index.h>

namespace quadrille::internal {

/// Asks for what contracting the pairs that come next will read, one thing after the other: what
/// the parts of the surface hold of their ends, the corners of these, the faces, what is held of
/// their neighbours. Pairs lie anywhere, so most of the time would go into waiting for memory.
/// peek(n) points to the pair that comes n pairs later, or nowhere; also(w) asks for what the
/// caller will read of a neighbour.
template <class Surface, class Peek, class Also>
QUADRILLE_ALWAYS_INLINE inline void look_ahead(const Surface& surface, Peek peek, Also also) {
  const auto& complex = surface.complex();
  if (const auto* last = peek(12))
    for (Index v : {last->first, last->second})
      surface.prefetch_end(v);
  if (const auto* later = peek(8))
    for (Index v : {later->first, later->second})
      complex.prefetch_corners(v);
  if (const auto* soon = peek(4))
    for (Index v : {soon->first, soon->second})
      complex.prefetch_faces(v);
  if (const auto* next = peek(2))
    for (Index v : {next->first, next->second})
      complex.for_each_next(v, [&](Index w) QUADRILLE_ALWAYS_INLINE_LAMBDA {
        surface.prefetch_neighbour(w);
        also(w);
      });
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_LOOK_AHEAD_H
