// More faces where a surface is curved, where it is seen, and where somebody has painted: a bunny
// of 1,500 faces, four times.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <quadrille/importance.h>
#include <quadrille/simplify.h>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

bool write(Mesh mesh, const std::string& file) {
  using namespace quadrille;
  const auto map = mesh.property_map<Mesh::Vertex_index, double>("v:importance").first;
  std::cout << file << ": "
            << simplify(mesh, FaceCount{1500}, parameters::vertex_importance_map(map)) << '\n';
  return CGAL::IO::write_polygon_mesh(file, mesh, CGAL::parameters::stream_precision(17));
}

int main(int argc, char* argv[]) {
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  const std::string output = argc > 2 ? argv[2] : "importance_out";

  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "not a triangle mesh: " << input << '\n';
    return EXIT_FAILURE;
  }
  auto importance = mesh.add_property_map<Mesh::Vertex_index, double>("v:importance", 1).first;
  bool is_written = write(mesh, output + "-alike.off");

  quadrille::curvature_importance(mesh, importance, {.strength = 6});
  is_written &= write(mesh, output + "-curvature.off");

  quadrille::view_importance(mesh, importance, {.eye = {{-1.2, 0.2, 0.4}}});
  is_written &= write(mesh, output + "-view.off");

  for (const auto v : mesh.vertices()) // the head
    importance[v] = mesh.point(v).y() > 0.1 && mesh.point(v).x() < 0 ? 1000 : 1;
  is_written &= write(mesh, output + "-painted.off");
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
