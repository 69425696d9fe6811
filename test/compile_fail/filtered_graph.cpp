// A view of some faces of a mesh.
#include "surfaces.h"

#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <boost/property_map/vector_property_map.hpp>

int main() {
  using namespace quadrille;
  const boost::vector_property_map<int> patches;
#ifdef REMEDY
  const boost::vector_property_map<bool> is_selected;
  simplify(mesh, FaceCount{100}, parameters::face_is_selected_map(is_selected));
#else
  CGAL::Face_filtered_graph<CGAL::Surface_mesh<Point>> part(mesh, 1, patches);
  simplify(part, FaceCount{100}); // mistake
#endif
}
