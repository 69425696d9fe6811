// SPDX-License-Identifier: MIT
//
// Makes a large model of a small one: Loop subdivision, then noise, without which a subdivided
// surface would be far smoother than any scan.

#include "contender.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace {

using namespace bench;

double mean_edge_length(const Mesh& mesh) {
  double sum = 0;
  for (const auto e : mesh.edges())
    sum += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

/// Moves every coordinate by at most `amplitude`, the same on every platform.
void add_noise(Mesh& mesh, double amplitude) {
  std::mt19937_64 generator(1997);
  const auto offset = [&] {
    return amplitude * (static_cast<double>(generator() >> 11) * 0x1.0p-52 - 1);
  };
  for (const auto v : mesh.vertices()) {
    const double x = offset(), y = offset();
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(x, y, offset());
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: refine IN OUT LEVELS, each of which makes four faces of one\n";
    return EXIT_FAILURE;
  }
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << " cannot be read\n";
    return EXIT_FAILURE;
  }
  const auto levels = static_cast<unsigned int>(std::stoul(argv[3]));
  CGAL::Subdivision_method_3::Loop_subdivision(mesh,
                                               CGAL::parameters::number_of_iterations(levels));
  add_noise(mesh, 0.05 * mean_edge_length(mesh));
  std::cout << argv[2] << ": " << mesh.number_of_faces() << " faces\n";
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
