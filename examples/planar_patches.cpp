// The planar patches of a mesh, triangulated anew: what is flat gets the fewest faces at once.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <quadrille/planar_patches.h>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const std::string output = argc > 2 ? argv[2] : "planar_patches_out.off";
  const double part = argc > 3 ? std::stod(argv[3]) : 0.001; // of the diagonal

  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "not a triangle mesh: " << input << '\n';
    return EXIT_FAILURE;
  }
  auto tolerance = quadrille::PlanarTolerance::relative(part);
  tolerance.degrees = 15;
  std::cout << quadrille::remesh_planar_patches(mesh, tolerance) << '\n';
  return CGAL::IO::write_polygon_mesh(output, mesh, CGAL::parameters::stream_precision(17))
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
