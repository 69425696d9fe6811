// Two costs.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, Quadric{});
#else
  simplify(points, triangles, Quadric{}, MemorylessQuadric{}); // mistake
#endif
}
