// The planar patches of a mesh, triangulated anew: what is flat gets the fewest faces at once.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <quadrille/planar_patches.h>

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const double part = argc > 3 ? std::stod(argv[3]) : 0.001; // of the diagonal
  if (!CGAL::IO::read_polygon_mesh(input, mesh))
    return EXIT_FAILURE;
  std::cout << remesh_planar_patches(mesh, quadrille::PlanarTolerance::relative(part)) << '\n';
  const auto exact = CGAL::parameters::stream_precision(17);
  return !CGAL::IO::write_polygon_mesh(argc > 2 ? argv[2] : "planar_patches_out.off", mesh, exact);
}
