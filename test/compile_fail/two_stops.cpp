// Two stop policies.
#include "surfaces.h"

#include <quadrille/distance_limits.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, AnyOf{FaceCount{10}, DistanceLimit{0.1}});
#else
  simplify(points, triangles, FaceCount{10}, DistanceLimit{0.1}); // mistake
#endif
}
