// Faces kept apart, in passes.
#include "surfaces.h"

#include <quadrille/relaxed_order.h>
#include <quadrille/self_intersection.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, NoSelfIntersection{});
#else
  simplify(points, triangles, NoSelfIntersection{}, RelaxedOrder{}); // mistake
#endif
}
