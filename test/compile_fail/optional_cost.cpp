// A cost that is given or not at run time.
#include "surfaces.h"

#include <optional>
#include <quadrille/memoryless_quadric.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const MemorylessQuadric cost{};
#else
  const std::optional<MemorylessQuadric> cost;
#endif
  simplify(mesh, FaceCount{10}, cost); // mistake
  simplify(points, triangles, cost);   // mistake
}
