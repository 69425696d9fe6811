// Colours of faces as a channel.
#include "surfaces.h"

#include <quadrille/channels.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const auto colors =
      mesh.add_property_map<CGAL::SM_Halfedge_index, std::array<float, 3>>("h:color").first;
#else
  const auto colors =
      mesh.add_property_map<CGAL::SM_Face_index, std::array<float, 3>>("f:color").first;
#endif
  simplify(mesh, Colors{colors}); // mistake
}
