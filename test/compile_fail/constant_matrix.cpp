// A map of Eigen of constant numbers.
#include "matrices.h"

int main() {
  using namespace quadrille;
  MatrixOfEigen<int> faces;
#ifdef REMEDY
  MapOfEigen<double, double&> map;
#else
  MapOfEigen<double, const double&> map;
#endif
  simplify(map, faces, FaceCount{10}); // mistake
}
