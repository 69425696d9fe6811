// Eigen's matrices as soups, as libigl has them: the same bits as those of std::array.
#include "soups.h"

#include <Eigen/Core>
#include <quadrille/channels.h>
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

template <class Matrix, class Rows>
Matrix vertex_arrays_of(const Rows& rows) {
  return matrix_of<Eigen::Matrix<typename Matrix::Scalar, Eigen::Dynamic, 3>>(rows).transpose();
}

struct Arrays {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
Arrays arrays_of(const Soup& soup) {
  Arrays arrays;
  for (const Position& p : soup.points)
    arrays.points.push_back({p[0], p[1], p[2]});
  for (const Triangle& t : soup.triangles)
    arrays.triangles.push_back({t[0], t[1], t[2]});
  return arrays;
}
// What simplify leaves of arrays.
const Arrays& expected() {
  static const Arrays result = [] {
    Arrays arrays = arrays_of(input());
    simplify(arrays.points, arrays.triangles, FaceRatio{0.3});
    return arrays;
  }();
  return result;
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

TEST_CASE("Matrices of three rows have a column for each") {
  const auto check_columns = [](auto v, auto f, const Arrays& before, const Arrays& after) {
    using V = decltype(v);
    using F = decltype(f);
    v = vertex_arrays_of<V>(before.points);
    f = vertex_arrays_of<F>(before.triangles);
    simplify(v, f, FaceRatio{0.3});
    CHECK(v == vertex_arrays_of<V>(after.points));
    CHECK(f == vertex_arrays_of<F>(after.triangles));
  };
  const Arrays before = arrays_of(input());
  check_columns(Eigen::MatrixXd(), Eigen::MatrixXi(), before, expected());
  check_columns(Eigen::Matrix3Xd(), Eigen::Matrix3Xi(), before, expected());

  // 3 x 3: three triangles in columns are told by their points; by themselves they lie in rows
  const Arrays fan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
  Arrays left = fan;
  simplify(left.points, left.triangles, FaceRatio{0.3});
  check_columns(Eigen::MatrixXd(), Eigen::MatrixXi(), fan, left);
  auto v = matrix_of<Eigen::MatrixXd>(fan.points);
  auto f = matrix_of<Eigen::MatrixXi>(fan.triangles);
  simplify(v, f, FaceRatio{0.3});
  CHECK(f == matrix_of<Eigen::MatrixXi>(left.triangles));
}

TEST_CASE("Of views of matrices, what is left is at the beginning") {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  const Arrays before = arrays_of(input());
  const auto v_left = matrix_of<Eigen::MatrixXd>(expected().points);
  const auto f_left = matrix_of<Eigen::MatrixXi>(expected().triangles);
  const auto check_views = [&](auto v, auto f, const auto& v_all, const auto& f_all) {
    const Report report = simplify(v, f, FaceRatio{0.3});
    REQUIRE(report.vertices_after == expected().points.size());
    REQUIRE(report.faces_after == expected().triangles.size());
    CHECK(v_all.topRows(v_left.rows()) == v_left);
    CHECK(f_all.topRows(f_left.rows()) == f_left);
  };
  SECTION("maps, by rows and by columns") {
    auto v = matrix_of<Rows>(before.points);
    auto f = matrix_of<Eigen::MatrixXi>(before.triangles);
    check_views(Eigen::Map<Rows>(v.data(), v.rows(), 3),
                Eigen::Map<Eigen::MatrixXi>(f.data(), f.rows(), 3), v, f);
  }
  SECTION("maps of three rows, as temporaries") {
    auto v = vertex_arrays_of<Eigen::Matrix3Xd>(before.points);
    auto f = vertex_arrays_of<Eigen::Matrix3Xi>(before.triangles);
    simplify(Eigen::Map<Eigen::Matrix3Xd>(v.data(), 3, v.cols()),
             Eigen::Map<Eigen::Matrix3Xi>(f.data(), 3, f.cols()), FaceRatio{0.3});
    CHECK(v.leftCols(v_left.rows()) == v_left.transpose());
    CHECK(f.leftCols(f_left.rows()) == f_left.transpose());
  }
  SECTION("transposes and blocks") {
    auto v = vertex_arrays_of<Eigen::MatrixXd>(before.points);
    Eigen::MatrixXi f(before.triangles.size(), 5);
    f.leftCols(3) = matrix_of<Eigen::MatrixXi>(before.triangles);
    f.rightCols(2).setConstant(7);
    check_views(v.transpose(), f.leftCols(3), v.transpose(), f.leftCols(3));
    CHECK((f.rightCols(2).array() == 7).all());
  }
}

TEST_CASE("A simplified copy of a view is a matrix") {
  const Arrays before = arrays_of(input());
  const auto v = vertex_arrays_of<Eigen::Matrix3Xd>(before.points);
  const auto f = matrix_of<Eigen::MatrixXi>(before.triangles);
  const auto [v_left, f_left, report] =
      simplified(Eigen::Map<const Eigen::Matrix3Xd>(v.data(), 3, v.cols()),
                 Eigen::Map<const Eigen::MatrixXi>(f.data(), f.rows(), 3), FaceRatio{0.3});
  CHECK(v_left == vertex_arrays_of<Eigen::Matrix3Xd>(expected().points));
  CHECK(f_left == matrix_of<Eigen::MatrixXi>(expected().triangles));
  CHECK(v == vertex_arrays_of<Eigen::Matrix3Xd>(before.points));
}

TEST_CASE("Views of the wrong size are refused before anything is changed") {
  auto v = matrix_of<Eigen::MatrixXd>(arrays_of(input()).points);
  auto f = matrix_of<Eigen::MatrixXi>(arrays_of(input()).triangles);
  const Eigen::MatrixXd before = v;
  CHECK_THROWS_WITH(simplify(v.leftCols(2), f.leftCols(3)),
                    Catch::Contains("rows and 2 columns, not a row of three columns for each "
                                    "point, nor a column of three rows"));
  CHECK(v == before);
}

TEST_CASE("Attributes in columns are the rows of a transpose") {
  auto v = vertex_arrays_of<Eigen::MatrixXd>(arrays_of(input()).points);
  auto f = vertex_arrays_of<Eigen::MatrixXi>(arrays_of(input()).triangles);
  Eigen::MatrixXd colors = v.array().abs() / 4;
  auto by_rows = colors.transpose();
  simplify(v, f, FaceRatio{0.3}, Colors{matrix_rows<3>(by_rows)});
  colors.conservativeResize(3, v.cols());
  CHECK((colors - Eigen::MatrixXd(v.array().abs() / 4)).norm() < 0.05 * colors.norm());
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
