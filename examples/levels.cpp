// The cow of the 1997 paper's figures at 994, 532, 248 and 64 faces, from one run.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <iostream>
#include <quadrille/levels.h>
#include <quadrille/levels_file.h>
#include <quadrille/record.h>
#include <quadrille/simplify.h>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  using namespace quadrille;

  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  const std::string output = argc > 2 ? argv[2] : "levels_out";

  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "not a triangle mesh: " << input << '\n';
    return EXIT_FAILURE;
  }
  Levels levels;
  std::cout << simplify<Quadric, OptimalPlacement>(mesh, FaceCount{64}, record_into(levels))
            << '\n';

  for (const std::size_t faces : {994u, 532u, 248u, 64u}) {
    const Level level = levels.at(FaceCount{faces});
    std::cout << level.faces << " faces, error " << level.error << '\n';
    Mesh coarse;
    to_mesh(level, coarse);
    const std::string file = output + '-' + std::to_string(faces) + ".off";
    if (!CGAL::IO::write_polygon_mesh(file, coarse, CGAL::parameters::stream_precision(17)))
      return EXIT_FAILURE;
  }
  write_levels(output + ".qlv", levels); // LevelsFile reads each level by itself
}
