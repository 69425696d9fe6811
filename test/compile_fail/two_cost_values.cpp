// Two costs.
#include "surfaces.h"

#include <quadrille/memoryless_quadric.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, Quadric{});
#else
  simplify(points, triangles, Quadric{}, MemorylessQuadric{}); // mistake
#endif
}
