// Soups as flat numbers, as spans, as vertices of a renderer and as matrices: the same bits as
// those of std::array, and an exception that leaves all as it was.
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;
using Catch::Matchers::Contains;

namespace {

const Soup& input() {
  static const Soup soup = with_holes(with_noise(torus(24, 12), 1, 0.02), 2, 5);
  return soup;
}

template <class T>
std::vector<std::array<T, 3>> rows(const Soup& soup) {
  std::vector<std::array<T, 3>> rows;
  for (const Position& p : soup.points)
    rows.push_back({static_cast<T>(p[0]), static_cast<T>(p[1]), static_cast<T>(p[2])});
  return rows;
}

template <class Numbers, class Rows>
Numbers flat(const Rows& rows) {
  Numbers numbers;
  for (const auto& row : rows)
    for (const auto x : row)
      numbers.push_back(static_cast<std::ranges::range_value_t<Numbers>>(x));
  return numbers;
}

// A matrix as Eigen's, by columns, with no more than is asked for.
template <class T>
class SmallMatrix {
public:
  using Scalar = T;
  SmallMatrix(int rows, int columns)
      : rows_(rows), columns_(columns), values_(static_cast<std::size_t>(rows * columns)) {}
  template <class Rows>
  explicit SmallMatrix(const Rows& rows) : SmallMatrix(static_cast<int>(rows.size()), 3) {
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < 3; ++c)
        (*this)(r, c) =
            static_cast<T>(rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]);
  }
  int rows() const { return rows_; }
  int cols() const { return columns_; }
  T& operator()(int r, int c) { return values_[static_cast<std::size_t>(c * rows_ + r)]; }
  T operator()(int r, int c) const { return values_[static_cast<std::size_t>(c * rows_ + r)]; }
  void swap(SmallMatrix& other) {
    std::swap(rows_, other.rows_);
    std::swap(columns_, other.columns_);
    values_.swap(other.values_);
  }
  friend bool operator==(const SmallMatrix& a, const SmallMatrix& b) {
    return a.rows_ == b.rows_ && a.columns_ == b.columns_ && a.values_ == b.values_;
  }

private:
  int rows_, columns_;
  std::vector<T> values_;
};

template <class T>
struct Expected {
  std::vector<std::array<T, 3>> points = rows<T>(input());
  std::vector<Triangle> triangles = input().triangles;
  Report report;
  template <class... Arguments>
  explicit Expected(const Arguments&... arguments)
      : report(simplify(points, triangles, arguments...)) {}
};

struct Vertex {
  std::array<float, 2> uv;
  float position[3];
  std::uint32_t number; // of the input: nothing that simplify knows of
  std::array<std::uint8_t, 4> color;
};

std::vector<Vertex> vertices_of(const Soup& soup) {
  std::vector<Vertex> vertices;
  for (const auto& [x, y, z] : rows<float>(soup)) {
    const auto i = static_cast<std::uint32_t>(vertices.size());
    const auto tint = static_cast<std::uint8_t>(i % 251);
    vertices.push_back({{x, 0.5F * y}, {x, y, z}, i, {tint, 7, 9, 255}});
  }
  return vertices;
}

} // namespace

TEMPLATE_TEST_CASE("Flat numbers give the bits of arrays", "", float, double) {
  const Expected<TestType> expected(FaceRatio{0.3});
  const auto check = [&](auto points, auto indices) {
    const Report report = simplify(points, indices, FaceRatio{0.3});
    CHECK((points == flat<decltype(points)>(expected.points)));
    CHECK((indices == flat<decltype(indices)>(expected.triangles)));
    CHECK(report.faces_after == expected.triangles.size());
    CHECK(report.rejections == expected.report.rejections);
  };
  const auto points = flat<std::vector<TestType>>(rows<TestType>(input()));
  check(points, flat<std::vector<std::uint32_t>>(input().triangles));
  check(points, flat<std::vector<int>>(input().triangles));
  check(std::deque<TestType>(points.begin(), points.end()),
        flat<std::deque<std::uint16_t>>(input().triangles));
}

TEST_CASE("Only one of both need be flat, and policies may be template arguments") {
  const Expected<float> expected(FaceRatio{0.3});
  auto points = rows<float>(input());
  auto indices = flat<std::vector<std::uint32_t>>(input().triangles);
  simplify<Quadric, OptimalPlacement>(points, indices, FaceRatio{0.3});
  CHECK(points == expected.points);
  CHECK(indices == flat<std::vector<std::uint32_t>>(expected.triangles));

  auto numbers = flat<std::vector<float>>(rows<float>(input()));
  auto triangles = input().triangles;
  simplify(numbers, triangles, FaceRatio{0.3});
  CHECK(numbers == flat<std::vector<float>>(expected.points));
  CHECK(triangles == expected.triangles);
}

TEST_CASE("Of spans the report tells how much is left, at their beginning") {
  const Expected<float> expected(FaceRatio{0.3});
  auto numbers = flat<std::vector<float>>(rows<float>(input()));
  auto indices = flat<std::vector<std::uint32_t>>(input().triangles);
  const std::size_t size = numbers.size();
  const Report report = simplify(std::span(numbers), std::span(indices), FaceRatio{0.3});
  CHECK(numbers.size() == size);
  numbers.resize(3 * report.vertices_after);
  indices.resize(3 * report.faces_after);
  CHECK(numbers == flat<std::vector<float>>(expected.points));
  CHECK(indices == flat<std::vector<std::uint32_t>>(expected.triangles));

  const std::span constant_numbers(numbers);
  const std::span constant_indices(indices);
  CHECK(simplify(constant_numbers, constant_indices, FaceCount{60}).faces_after <= 60);
}

TEST_CASE("What refers to memory may be constant itself") {
  const Expected<float> expected(FaceRatio{0.3});
  auto numbers = flat<std::vector<float>>(rows<float>(input()));
  auto indices = flat<std::vector<std::uint32_t>>(input().triangles);
  const VertexAttribute<float, 3> position(numbers.data(), numbers.size() / 3);
  const std::span constant_indices(indices);
  const Report report = simplify(position, constant_indices, FaceRatio{0.3});
  numbers.resize(3 * report.vertices_after);
  indices.resize(3 * report.faces_after);
  CHECK(numbers == flat<std::vector<float>>(expected.points));
  CHECK(indices == flat<std::vector<std::uint32_t>>(expected.triangles));
}

TEST_CASE("Matrices give the bits of arrays") {
  const Expected<double> expected(FaceRatio{0.3});
  SmallMatrix<double> v(rows<double>(input()));
  SmallMatrix<int> f(input().triangles);
  simplify(v, f, FaceRatio{0.3});
  CHECK((v == SmallMatrix<double>(expected.points)));
  CHECK((f == SmallMatrix<int>(expected.triangles)));
}

TEST_CASE("The rows of a matrix are a channel") {
  auto points = rows<double>(input());
  auto triangles = input().triangles;
  auto colors = rows<double>(input());
  SmallMatrix<double> v(points), c(colors);
  SmallMatrix<int> f(triangles);
  simplify(points, triangles, FaceRatio{0.3}, Colors{CGAL::make_property_map(colors)});
  simplify(v, f, FaceRatio{0.3}, Colors{matrix_rows<3>(c)});
  CHECK((v == SmallMatrix<double>(points)));
  CHECK((c == SmallMatrix<double>(colors)));
  CHECK_THROWS_WITH(matrix_rows<4>(c), "quadrille::matrix_rows: 3 columns are less than 4");
  CHECK_THROWS_WITH(get(matrix_rows<2>(c), input().points.size()), Contains("matrix_rows: row"));
}

TEST_CASE("Vertices of a renderer move as a whole, with their channels") {
  std::vector<std::array<float, 3>> points = rows<float>(input());
  std::vector<Triangle> triangles = input().triangles;
  const std::vector<Vertex> all = vertices_of(input());
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::array<std::uint8_t, 4>> colors;
  std::vector<std::uint32_t> numbers;
  for (const Vertex& vertex : all) {
    uvs.push_back(vertex.uv);
    colors.push_back(vertex.color);
    numbers.push_back(vertex.number);
  }
  std::vector<std::size_t> images(all.size());
  simplify(points, triangles, FaceRatio{0.3}, Texture{CGAL::make_property_map(uvs)},
           Colors{CGAL::make_property_map(colors)},
           quadrille::parameters::vertex_to_vertex_map(CGAL::make_property_map(images)));

  std::vector<Vertex> vertices = all;
  auto indices = flat<std::vector<std::uint32_t>>(input().triangles);
  const Report report = simplify(VertexAttribute(vertices, &Vertex::position), indices,
                                 FaceRatio{0.3}, Texture{VertexAttribute(vertices, &Vertex::uv)},
                                 Colors{VertexAttribute(vertices, &Vertex::color)});
  REQUIRE(report.vertices_after == points.size());
  CHECK(indices == flat<std::vector<std::uint32_t>>(triangles));
  std::size_t changed_colors = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(std::equal(points[i].begin(), points[i].end(), vertices[i].position));
    CHECK(vertices[i].uv == uvs[i]);
    CHECK(vertices[i].color == colors[i]);
    CHECK(images[vertices[i].number] == i); // the rest of the vertex came with it
    changed_colors += vertices[i].color != all[vertices[i].number].color;
  }
  CHECK(changed_colors > points.size() / 4);
}

TEST_CASE("Split vertices of a renderer are one at a place") {
  // Each triangle has three vertices of its own, all of one colour.
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  const std::vector<Vertex> all = vertices_of(input());
  for (const Triangle& t : input().triangles)
    for (const std::uint32_t i : t) {
      indices.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back(all[i]);
      vertices.back().color = {9, 9, 9, 255};
    }
  const Report report =
      simplify(VertexAttribute(vertices, &Vertex::position), std::span(indices), SplitVertices{},
               FaceRatio{0.3}, Colors{VertexAttribute(vertices, &Vertex::color)});
  vertices.resize(report.vertices_after);
  indices.resize(3 * report.faces_after);
  CHECK(report.faces_after < input().triangles.size() / 3);
  CHECK(report.vertices_after < report.faces_after);
  for (const Vertex& vertex : vertices)
    CHECK(vertex.color == std::array<std::uint8_t, 4>{9, 9, 9, 255});
  CHECK(*std::max_element(indices.begin(), indices.end()) + 1 == vertices.size());
}

TEST_CASE("An attribute lies at an offset, in memory that need not be aligned") {
  constexpr std::size_t stride = 15;
  std::vector<std::byte> bytes(stride * 4);
  const VertexAttribute<float, 3> position(bytes.data(), 4, stride, 1);
  put(position, 2, {1, 2, 3});
  CHECK((get(position, 2) == std::array<float, 3>{1, 2, 3}));
  float y = 0;
  std::memcpy(&y, bytes.data() + 2 * stride + 1 + sizeof y, sizeof y);
  CHECK(y == 2);
  CHECK_THROWS_WITH(get(position, 4), "quadrille::VertexAttribute: vertex 4 of 4");
  using Attribute = VertexAttribute<float, 3>;
  CHECK_THROWS_WITH(Attribute(bytes.data(), 4, 12, 1),
                    "quadrille::VertexAttribute: 12 bytes at 1 do not lie in a stride of 12");
  CHECK_THROWS_WITH(Attribute(bytes.data(), 4, 12, 13), Contains("do not lie in a stride of 12"));
  CHECK_THROWS_WITH(Attribute(nullptr, 4), "quadrille::VertexAttribute: no buffer of 4 vertices");
  CHECK_NOTHROW(Attribute(nullptr, 0));
}

TEST_CASE("What is no soup is refused with what and where, and stays as it was") {
  const auto check = [](auto points, auto triangles, const std::string& message) {
    const auto old_points = points;
    const auto old_triangles = triangles;
    CHECK_THROWS_WITH(simplify(points, triangles), message);
    CHECK_THROWS_AS(simplify(points, triangles), std::invalid_argument);
    CHECK((points == old_points));
    CHECK((triangles == old_triangles));
  };
  const std::vector<float> three{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<int> one{0, 1, 2};
  check(std::vector<float>{0, 0, 0, 1}, one,
        "quadrille::simplify: 4 numbers are not three for each point");
  check(three, std::vector<int>{0, 1, 2, 0, 1},
        "quadrille::simplify: 5 numbers are not three for each triangle");
  check(three, std::vector<int>{0, 1, 2, 0, -1, 2},
        "quadrille::simplify: face 1 names point -1 of 3");
  check(three, std::vector<std::uint32_t>{0, 1, 3},
        "quadrille::simplify: face 0 names point 3 of 3");
  check(SmallMatrix<double>(2, 4), SmallMatrix<int>(1, 3),
        "quadrille::simplify: a matrix of points has 2 rows and 4 columns, not a row of three "
        "columns for each point, nor a column of three rows");
  check(SmallMatrix<double>(3, 3), SmallMatrix<int>(2, 1),
        "quadrille::simplify: a matrix of triangles has 2 rows and 1 columns, not a row of three "
        "columns for each triangle, nor a column of three rows");
  SmallMatrix<int> negative(1, 3);
  negative(0, 1) = -7;
  check(SmallMatrix<double>(3, 3), negative, "quadrille::simplify: face 0 names point -7 of 3");
}

TEST_CASE("Nothing, and no triangles, are soups as well") {
  std::vector<float> points;
  std::vector<std::uint32_t> indices;
  CHECK(simplify(points, indices).faces_after == 0);
  points = {1, 2, 3};
  CHECK(simplify(points, indices).vertices_after == 0);
  CHECK(points.empty());
  std::vector<Vertex> none;
  CHECK(simplify(VertexAttribute(none, &Vertex::position), indices).vertices_after == 0);
}

namespace {

// A channel that can be written so often.
struct Failing {
  using key_type = std::size_t;
  using value_type = std::array<double, 3>;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  std::vector<value_type>* values;
  int* left;
  friend value_type get(const Failing& map, std::size_t i) { return (*map.values)[i]; }
  friend void put(const Failing& map, std::size_t i, const value_type& value) {
    if (--*map.left == 0)
      throw std::runtime_error("full");
    (*map.values)[i] = value;
  }
};

} // namespace

TEST_CASE("If a map throws, vertices and indices are as they were") {
  const std::vector<Vertex> all = vertices_of(input());
  const auto all_indices = flat<std::vector<std::uint32_t>>(input().triangles);
  std::vector<std::array<double, 3>> heat(all.size());
  for (std::size_t i = 0; i < heat.size(); ++i)
    heat[i] = {all[i].uv[0], 0, all[i].uv[1]};
  const auto all_heat = heat;
  for (const int writes : {1, 2, 40}) {
    CAPTURE(writes);
    std::vector<Vertex> vertices = all;
    std::vector<std::uint32_t> indices = all_indices;
    int left = writes;
    CHECK_THROWS_WITH(simplify(VertexAttribute(vertices, &Vertex::position), std::span(indices),
                               Colors{VertexAttribute(vertices, &Vertex::color)},
                               Attributes{Failing{&heat, &left}}),
                      "full");
    CHECK(std::memcmp(vertices.data(), all.data(), all.size() * sizeof(Vertex)) == 0);
    CHECK(indices == all_indices);
    CHECK(heat == all_heat);
  }
}
