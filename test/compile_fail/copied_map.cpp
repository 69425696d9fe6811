// A map that would be written, over the vertices of a mesh that is copied.
#include "surfaces.h"

#include <boost/property_map/property_map.hpp>
#include <map>
#include <quadrille/channels.h>
#include <quadrille/simplified.h>

int main() {
  using namespace quadrille;
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
#ifdef REMEDY
  const auto heat = mesh.add_property_map<Vertex, std::array<double, 3>>("v:heat").first;
#else
  std::map<Vertex, std::array<double, 3>> values;
  const auto heat = boost::make_assoc_property_map(values);
#endif
  simplified(mesh, Attributes{heat}); // mistake
}
