// A channel of a soup over a mesh's vertices.
#include "surfaces.h"

#include <quadrille/channels.h>

int main() {
  using namespace quadrille;
  std::vector<std::array<float, 3>> values;
#ifdef REMEDY
  const auto colors = CGAL::make_property_map(values);
#else
  const auto colors =
      mesh.add_property_map<CGAL::SM_Vertex_index, std::array<float, 3>>("v:soup_color").first;
#endif
  simplify(points, triangles, Colors{colors}); // mistake
}
