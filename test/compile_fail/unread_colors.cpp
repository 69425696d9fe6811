// Colours that no policy reads.
#include "surfaces.h"

int main() {
  using namespace quadrille;
  const auto colors =
      mesh.add_property_map<CGAL::SM_Vertex_index, CGAL::IO::Color>("v:color").first;
  const auto named = CGAL::parameters::vertex_color_map(colors);
#ifdef REMEDY
  simplify<ColorQuadric>(mesh, named);
#else
  simplify<Quadric>(mesh, named); // mistake
#endif
}
