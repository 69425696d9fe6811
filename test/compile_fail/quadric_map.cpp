// The quadrics of vertices, of a cost that remembers none.
#include "surfaces.h"

#include <quadrille/memoryless_quadric.h>

int main() {
  using namespace quadrille;
  const auto quadrics = mesh.add_property_map<CGAL::SM_Vertex_index, QuadricForm<3>>("q").first;
#ifdef REMEDY
  simplify<Quadric>(mesh, parameters::vertex_quadric_map(quadrics));
#else
  simplify<MemorylessQuadric>(mesh, parameters::vertex_quadric_map(quadrics)); // mistake
#endif
}
