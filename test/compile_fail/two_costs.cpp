// A cost as a template argument and as a value.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(mesh, MemorylessQuadric{});
#else
  simplify<Quadric>(mesh, MemorylessQuadric{}); // mistake
#endif
}
