// Faces kept apart, in passes.
#include "surfaces.h"

#include <quadrille/guards.h>
#include <quadrille/relaxed_order.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, NoSelfIntersection{});
#else
  simplify(points, triangles, NoSelfIntersection{}, RelaxedOrder{}); // mistake
#endif
}
