// A matrix of eight rows, which cannot get fewer.
#include "matrices.h"

int main() {
  using namespace quadrille;
  MatrixOfEigen<int> faces;
#ifdef REMEDY
  MatrixOfEigen<double> points_of_cube;
#else
  MatrixOfEigen<double, 8> points_of_cube;
#endif
  simplify(points_of_cube, faces, FaceCount{10}); // mistake
}
