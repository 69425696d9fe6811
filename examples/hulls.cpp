// The inner and the outer hull of a cow, of 400 faces each: the cow encloses the one and is
// enclosed by the other.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <quadrille/guards.h>
#include <quadrille/hull.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <class Hull>
bool write_hull(Mesh mesh, const std::string& file) {
  using namespace quadrille;
  const Report report =
      simplify<MemorylessQuadric, Hull>(mesh, FaceCount{400}, NoSelfIntersection{});
  std::cout << file << ": " << report << '\n';
  return CGAL::IO::write_polygon_mesh(file, mesh, CGAL::parameters::stream_precision(17));
}

int main(int argc, char* argv[]) {
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  const std::string output = argc > 2 ? argv[2] : "hulls_out";

  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "not a triangle mesh: " << input << '\n';
    return EXIT_FAILURE;
  }
  const bool written = write_hull<quadrille::InnerHull>(mesh, output + "-inner.off") &&
                       write_hull<quadrille::OuterHull>(mesh, output + "-outer.off");
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
