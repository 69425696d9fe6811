// The distance between two surfaces, which surface_distance() measures by samples and which knows
// nothing of how they were made:
//   distance INPUT RESULT...
// prints for each result the root mean square and the greatest distance, both ways, in 1e-4 of the
// diagonal of the input's bounding box.

#include "../../examples/products/mesh_io/mesh_io.h"

#include <quadrille/distance.h>

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  using namespace quadrille_examples;
  try {
    const IndexedMesh input = read_mesh(argv[1]);
    CGAL::Bbox_3 box;
    for (const Point& p : input.points)
      box += p.bbox();
    const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    for (int i = 2; i < argc; ++i) {
      const IndexedMesh result = read_mesh(argv[i]);
      const auto distance = quadrille::surface_distance(result.points, result.triangles,
                                                        input.points, input.triangles);
      std::printf("%.3g %.3g\n", 1e4 * distance.rms / diagonal,
                  1e4 * distance.hausdorff / diagonal);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
