// SPDX-License-Identifier: MIT
//
// Makes a large model of a small one: Loop subdivision, then noise, without which a subdivided
// surface would be far smoother than any scan.

#include "contender.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: refine IN OUT LEVELS, each of which makes four faces of one\n";
    return EXIT_FAILURE;
  }
  bench::Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << " cannot be read\n";
    return EXIT_FAILURE;
  }
  const auto levels = static_cast<unsigned int>(std::stoul(argv[3]));
  CGAL::Subdivision_method_3::Loop_subdivision(mesh,
                                               CGAL::parameters::number_of_iterations(levels));
  bench::add_noise(mesh, 0.05, 1997);
  std::cout << argv[2] << ": " << mesh.number_of_faces() << " faces\n";
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
