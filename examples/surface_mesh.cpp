// Simplifies a Surface_mesh to 1,000 faces.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <quadrille/simplify.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  using namespace quadrille;

  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  const std::string output = argc > 2 ? argv[2] : "surface_mesh_out.off";

  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "not a triangle mesh: " << input << '\n';
    return EXIT_FAILURE;
  }
  std::cout << simplify<Quadric, OptimalPlacement>(mesh, FaceCount{1000}) << '\n';
  const bool written =
      CGAL::IO::write_polygon_mesh(output, mesh, CGAL::parameters::stream_precision(17));
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
