// A map over faces where one over vertices is read.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const auto fixed = mesh.add_property_map<CGAL::SM_Vertex_index, bool>("v:fixed", false).first;
#else
  const auto fixed = mesh.add_property_map<CGAL::SM_Face_index, bool>("f:fixed", false).first;
#endif
  simplify(mesh, CGAL::parameters::vertex_is_constrained_map(fixed)); // mistake
}
