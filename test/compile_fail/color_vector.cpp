// Colours of a soup in a vector that is no property map.
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>

int main() {
  using namespace quadrille;
  std::vector<CGAL::IO::Color> colors;
#ifdef REMEDY
  const auto map = CGAL::make_property_map(colors);
#else
  const auto& map = colors;
#endif
  simplify<ColorQuadric>(points, triangles, CGAL::parameters::vertex_color_map(map)); // mistake
}
