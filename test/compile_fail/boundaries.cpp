// A number where the limit of a distance is meant.
#include "surfaces.h"
#include <quadrille/boundaries.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const DistanceLimit limit{0.1};
#else
  const double limit = 0.1;
#endif
  simplify_boundaries(mesh, limit);              // mistake
  simplify_boundaries(points, triangles, limit); // mistake
}
