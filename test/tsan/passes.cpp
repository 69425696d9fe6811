// Runs the passes of RelaxedOrder with one thread and with four, for the thread sanitizer; fails if
// the results differ.
//   passes MODEL
// The model is subdivided once: blocks are joined where there are more than 60,000 vertices.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>
#include <quadrille/distance_limits.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <iostream>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using namespace quadrille;

template <class Cost, class... Arguments>
std::vector<Point> points_by(unsigned threads, bool refresh, Mesh mesh,
                             const Arguments&... arguments) {
  simplify<Cost, OptimalPlacement>(mesh, RelaxedOrder{.refresh = refresh, .threads = threads},
                                   arguments...);
  std::vector<Point> points;
  for (Mesh::Vertex_index v : mesh.vertices())
    points.push_back(mesh.point(v));
  return points;
}

template <class Cost, class... Arguments>
bool is_same(const Mesh& mesh, bool refresh, const Arguments&... arguments) {
  return points_by<Cost>(1, refresh, mesh, arguments...) ==
         points_by<Cost>(4, refresh, mesh, arguments...);
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: passes MODEL\n";
    return 2;
  }
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  const bool same = is_same<Quadric>(mesh, false, FaceRatio{0.1}) &&
                    is_same<Quadric>(mesh, true, FaceRatio{0.1}) &&
                    is_same<MemorylessQuadric>(mesh, false, FaceRatio{0.1}) &&
                    is_same<Quadric>(mesh, false, FaceRatio{0.2}, Topology::free) &&
                    is_same<Quadric>(mesh, false, DistanceLimit::relative(0.002));
  std::cout << (same ? "the same with four threads\n" : "the threads show in the result\n");
  return same ? 0 : 1;
}
