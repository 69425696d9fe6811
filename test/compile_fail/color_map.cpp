// A ColorQuadric without colours.
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const auto colors =
      mesh.add_property_map<CGAL::SM_Vertex_index, CGAL::IO::Color>("v:color").first;
  simplify<ColorQuadric>(mesh, CGAL::parameters::vertex_color_map(colors));
#else
  simplify<ColorQuadric>(mesh); // mistake
#endif
}
