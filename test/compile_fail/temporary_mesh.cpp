// A mesh that is gone before anybody can look at it.
#include "surfaces.h"

#include <utility>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(mesh, FaceCount{10});
#else
  simplify(std::move(mesh));                                        // mistake
  simplify(std::move(mesh), VertexCount{10});                       // mistake
  simplify<Quadric, EndpointPlacement>(std::move(mesh));            // mistake
  simplify(std::move(points), std::move(triangles), FaceCount{10}); // mistake
#endif
}
