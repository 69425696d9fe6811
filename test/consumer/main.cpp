#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <iostream>
#include <quadrille/simplify.h>

int main() {
  using namespace quadrille;
  using Point = CGAL::Simple_cartesian<double>::Point_3;

  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.0);
  std::cout << simplify<Quadric, OptimalPlacement>(mesh, FaceCount{8}) << '\n';
  return mesh.number_of_faces() <= 8 ? 0 : 1;
}
