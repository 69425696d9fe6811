// Points and triangles in the wrong order.
#include "matrices.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  MatrixOfEigen<double> first;
  MatrixOfEigen<int> second;
#else
  MatrixOfEigen<int> first;
  MatrixOfEigen<double> second;
#endif
  simplify(first, second, FaceCount{10}); // mistake
}
