// first INPUT OUTPUT: simplifies a triangle mesh to 1,000 faces.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <quadrille/simplify.h>

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "no mesh to read\n";
    return EXIT_FAILURE;
  }
  std::cout << quadrille::simplify(mesh, quadrille::FaceCount{1000}) << '\n';
  const auto exact = CGAL::parameters::stream_precision(17); // coordinates keep all of their digits
  return CGAL::IO::write_polygon_mesh(argv[2], mesh, exact) ? EXIT_SUCCESS : EXIT_FAILURE;
}
