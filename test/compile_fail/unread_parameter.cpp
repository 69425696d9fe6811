// A named parameter that nothing reads: the one for points of a mesh, of a soup.
#include "surfaces.h"

int main() {
  using namespace quadrille;
  const CGAL::Identity_property_map<Point> map;
#ifdef REMEDY
  simplify(points, triangles, CGAL::parameters::point_map(map));
#else
  simplify(points, triangles, CGAL::parameters::vertex_point_map(map)); // mistake
#endif
}
