// Texture coordinates that no policy reads.
#include "surfaces.h"

int main() {
  using namespace quadrille;
  const auto colors =
      mesh.add_property_map<CGAL::SM_Vertex_index, CGAL::IO::Color>("v:color").first;
#ifdef REMEDY
  simplify<ColorQuadric>(mesh, CGAL::parameters::vertex_color_map(colors));
#else
  simplify<ColorQuadric>(mesh, CGAL::parameters::vertex_color_map(colors).vertex_texture_map(
                                   colors)); // mistake
#endif
}
