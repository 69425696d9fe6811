// A cost as a template argument and as a value.
#include "surfaces.h"

#include <quadrille/memoryless_quadric.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(mesh, MemorylessQuadric{});
#else
  simplify<Quadric>(mesh, MemorylessQuadric{}); // mistake
#endif
}
