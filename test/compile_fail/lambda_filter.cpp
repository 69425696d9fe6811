// A lambda as a filter, beside a stop policy.
#include "surfaces.h"

struct Low {
  bool allows(const auto& contraction) const { return contraction.target()[2] < 1; }
};

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, FaceCount{10}, Low());
#else
  const auto low = [](const auto&) { return true; };
  simplify(points, triangles, FaceCount{10}, low); // mistake
#endif
}
