// Eigen's matrices as soups, as libigl has them: the same bits as those of std::array.
#include "soups.h"

#include <Eigen/Core>
#include <quadrille/simplified.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

const Soup& input() {
  static const Soup soup = with_holes(with_noise(torus(24, 12), 1, 0.02), 2, 5);
  return soup;
}

template <class Matrix, class Rows>
Matrix matrix_of(const Rows& rows) {
  Matrix matrix(static_cast<Eigen::Index>(rows.size()), 3);
  for (Eigen::Index r = 0; r < matrix.rows(); ++r)
    for (std::size_t c = 0; c < 3; ++c)
      matrix(r, static_cast<Eigen::Index>(c)) =
          static_cast<typename Matrix::Scalar>(rows[static_cast<std::size_t>(r)][c]);
  return matrix;
}

// Simplifies matrices, and arrays of the same numbers.
template <class V, class F, class... Arguments>
void check(const Arguments&... arguments) {
  using T = typename V::Scalar;
  std::vector<std::array<T, 3>> points;
  for (const Position& p : input().points)
    points.push_back({static_cast<T>(p[0]), static_cast<T>(p[1]), static_cast<T>(p[2])});
  auto triangles = input().triangles;
  V v = matrix_of<V>(points);
  F f = matrix_of<F>(triangles);
  const V all = v;
  const auto [coarse, coarse_faces, copy_report] = simplified(v, f, arguments...);
  CHECK(v == all);
  const Report report = simplify(v, f, arguments...);
  simplify(points, triangles, arguments...);
  CHECK(static_cast<std::size_t>(v.rows()) == report.vertices_after);
  CHECK(v == matrix_of<V>(points));
  CHECK(f == matrix_of<F>(triangles));
  CHECK(coarse == v);
  CHECK(coarse_faces == f);
  CHECK(copy_report.faces_after == report.faces_after);
}

} // namespace

TEST_CASE("Matrices of all kinds of numbers and layouts are soups") {
  using Eigen::Dynamic;
  check<Eigen::MatrixXd, Eigen::MatrixXi>(FaceRatio{0.3});
  check<Eigen::MatrixXf, Eigen::Matrix<unsigned, Dynamic, Dynamic>>(FaceRatio{0.3});
  check<Eigen::Matrix<double, Dynamic, 3, Eigen::RowMajor>,
        Eigen::Matrix<int, Dynamic, 3, Eigen::RowMajor>>(FaceRatio{0.3});
  check<Eigen::MatrixX3f, Eigen::Matrix<std::int64_t, Dynamic, 3>>(FaceRatio{0.3});
}

TEST_CASE("A vector of Eigen's points is a soup, with indices one after the other") {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<double, 3>> arrays;
  std::vector<std::uint32_t> indices;
  for (const Position& p : input().points) {
    points.emplace_back(p[0], p[1], p[2]);
    arrays.push_back({p[0], p[1], p[2]});
  }
  auto triangles = input().triangles;
  for (const Triangle& t : triangles)
    indices.insert(indices.end(), t.begin(), t.end());
  simplify(points, indices, FaceRatio{0.3});
  simplify(arrays, triangles, FaceRatio{0.3});
  REQUIRE(points.size() == arrays.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK(points[i] == Eigen::Vector3d(arrays[i][0], arrays[i][1], arrays[i][2]));
  CHECK(indices.size() == 3 * triangles.size());
}
