// A placement that gives a number where a position is wanted.
#include "surfaces.h"

struct First {
  auto operator()(const auto&, const auto& pair) const {
#ifdef REMEDY
    return pair.first;
#else
    return pair.first[0];
#endif
  }
};

int main() {
  using namespace quadrille;
  simplify<Quadric, First>(mesh);                      // mistake
  simplify<Quadric, First>(points, triangles);         // mistake
  simplify(mesh, FaceCount{10}, First());              // mistake
  simplify(points, triangles, First(), FaceCount{10}); // mistake
}
