// A named parameter that is a channel, without the header of channels.
#include "surfaces.h"
#ifdef REMEDY
#include <quadrille/channels.h>
#endif

int main() {
  using namespace quadrille;
  const auto colors =
      mesh.add_property_map<CGAL::SM_Vertex_index, CGAL::IO::Color>("v:color").first;
  simplify(mesh, CGAL::parameters::vertex_color_map(colors)); // mistake
}
