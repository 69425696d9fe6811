// Labels of vertices.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const auto labels = mesh.add_property_map<CGAL::SM_Face_index, int>("f:label", 0).first;
#else
  const auto labels = mesh.add_property_map<CGAL::SM_Vertex_index, int>("v:label", 0).first;
#endif
  simplify(mesh, Labels{labels}); // mistake
}
