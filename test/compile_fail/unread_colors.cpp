// Texture coordinates that no policy reads.
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>

int main() {
  using namespace quadrille;
  const auto colors =
      mesh.add_property_map<CGAL::SM_Vertex_index, CGAL::IO::Color>("v:color").first;
#ifdef REMEDY
  const auto named = CGAL::parameters::vertex_color_map(colors);
#else
  const auto named = CGAL::parameters::vertex_color_map(colors).vertex_texture_map(colors);
#endif
  simplify<ColorQuadric>(mesh, named); // mistake
}
