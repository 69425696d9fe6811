// Attributes of two components for a cost that reads three.
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  std::vector<std::array<double, 3>> values;
#else
  std::vector<std::array<double, 2>> values;
#endif
  const auto map = CGAL::make_property_map(values);
  simplify<ColorQuadric>(points, triangles, CGAL::parameters::vertex_color_map(map)); // mistake
}
