// A pair policy that gives pairs back instead of emitting them.
#include "surfaces.h"

struct Neighbours {
#ifdef REMEDY
  void operator()(const quadrille::SurfaceView& surface, const quadrille::EmitPair& emit) const {
    for (std::size_t i = 1; i < surface.points.size(); ++i)
      emit(i - 1, i);
  }
#else
  std::vector<std::array<std::size_t, 2>> operator()(const quadrille::SurfaceView& surface) const {
    return {{0, surface.points.size() - 1}};
  }
#endif
};

int main() {
  using namespace quadrille;
  simplify(mesh, Neighbours());              // mistake
  simplify(points, triangles, Neighbours()); // mistake
}
