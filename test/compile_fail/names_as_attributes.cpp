// Attributes that are strings.
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  std::vector<double> values;
#else
  std::vector<std::string> values;
#endif
  const auto map = quadrille::parameters::vertex_attribute_map(CGAL::make_property_map(values));
  simplify<AttributeQuadric<1>>(points, triangles, map); // mistake
}
