#ifndef TEST_COMPILE_FAIL_MATRICES_H
#define TEST_COMPILE_FAIL_MATRICES_H

// What looks like matrices of Eigen: of a size that is fixed or not, and views of one.
#include "surfaces.h"

template <class T, int rows_ = -1>
struct MatrixOfEigen {
  using Scalar = T;
  static constexpr int RowsAtCompileTime = rows_, ColsAtCompileTime = 3;
  MatrixOfEigen() = default;
  MatrixOfEigen(int, int) {}
  int rows() const { return 0; }
  int cols() const { return 3; }
  T& operator()(int, int) { return number; }
  const T& operator()(int, int) const { return number; }
  void swap(MatrixOfEigen&) {}
  T number{};
};

template <class T, class Reference>
struct MapOfEigen {
  using Scalar = T;
  int rows() const { return 0; }
  int cols() const { return 3; }
  Reference operator()(int, int) const { return *number; }
  T* number = nullptr;
};

#endif // TEST_COMPILE_FAIL_MATRICES_H
