// Points that are none for CGAL, nor three numbers by index.
#include "surfaces.h"

struct Vertex {
  double x, y, z;
};

int main() {
  using namespace quadrille;
#ifdef REMEDY
  std::vector<std::array<double, 3>> vertices;
#else
  std::vector<Vertex> vertices;
#endif
  simplify(vertices, triangles, FaceCount{10}); // mistake
}
