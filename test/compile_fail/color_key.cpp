// Colours of corners for a cost that reads those of vertices.
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const auto colors =
      mesh.add_property_map<CGAL::SM_Vertex_index, std::array<float, 3>>("v:color").first;
#else
  const auto colors =
      mesh.add_property_map<CGAL::SM_Halfedge_index, std::array<float, 3>>("h:color").first;
#endif
  simplify<ColorQuadric>(mesh, CGAL::parameters::vertex_color_map(colors)); // mistake
}
