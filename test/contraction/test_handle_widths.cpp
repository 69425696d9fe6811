// cut_handles on shapes of which the genus is known: each is made of formulas, with all of its
// tunnels and handles, and once more without those that are narrower than the size.

#include "soups.h"

#include <quadrille/cut_handles.h>
#include <quadrille/manifold.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace {

using test::Position;
using test::Soup;

// --- Shapes by formulas --------------------------------------------------------------------------

/// Negative inside; near the surface about the distance from it.
using Field = std::function<double(const Position&)>;

double length(const Position& p) {
  return std::sqrt(squared_length(p));
}
Field box(const Position& low, const Position& high) {
  return [=](const Position& p) {
    double value = -std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis)
      value = std::max({value, low[axis] - p[axis], p[axis] - high[axis]});
    return value;
  };
}
Field ball(const Position& center, double radius) {
  return [=](const Position& p) { return length(p - center) - radius; };
}
Field ring(const Position& center, std::size_t axis, double radius, double thickness) {
  return [=](const Position& p) {
    Position from_center = p - center;
    const double along = std::exchange(from_center[axis], 0);
    return std::hypot(length(from_center) - radius, along) - thickness / 2;
  };
}
/// A tube round a path.
Field tube(const std::vector<Position>& path, double diameter) {
  return [=](const Position& p) {
    double value = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Position along = path[i] - path[i - 1], to = p - path[i - 1];
      const double t = std::clamp(dot(to, along) / squared_length(along), 0., 1.);
      value = (std::min)(value, length(to - t * along));
    }
    return value - diameter / 2;
  };
}
Field joined(std::vector<Field> fields) {
  return [fields = std::move(fields)](const Position& p) {
    double value = std::numeric_limits<double>::infinity();
    for (const Field& field : fields)
      value = (std::min)(value, field(p));
    return value;
  };
}
Field without(const Field& field, const Field& other) {
  return [=](const Position& p) { return (std::max)(field(p), -other(p)); };
}

struct Part {
  double width;
  Field field;
};
enum class Mesh { cubes, tetrahedra };
struct Shape {
  const char* name;
  Mesh mesh;
  double step; // of its grid
  Position low, high;
  Field body;
  std::vector<Part> tunnels, handles; // handles may lie in tunnels

  double operator()(const Position& p, double size) const {
    double value = body(p);
    for (const Part& tunnel : tunnels)
      if (tunnel.width >= size)
        value = (std::max)(value, -tunnel.field(p));
    for (const Part& handle : handles)
      if (handle.width >= size)
        value = (std::min)(value, handle.field(p));
    return value;
  }
};

Soup of_cubes(const Shape& shape, double size) {
  const Position extent = 1 / shape.step * (shape.high - shape.low);
  const auto cells = [&](std::size_t axis) { return static_cast<int>(std::lround(extent[axis])); };
  const Soup soup = test::surface_of_cubes(cells(0), cells(1), cells(2), [&](int x, int y, int z) {
    return shape(shape.low + shape.step * Position{{x + 0.5, y + 0.5, z + 0.5}}, size) < 0;
  });
  return test::mapped(soup, [&](const Position& p) { return shape.low + shape.step * p; });
}

/// Marching tetrahedra: each cube of a grid is cut into six, and the surface runs through them.
class OfTetrahedra {
public:
  Soup soup;

  OfTetrahedra(const Shape& shape, double size) {
    const Position extent = 1 / shape.step * (shape.high - shape.low);
    for (std::size_t axis = 0; axis < 3; ++axis)
      count_[axis] = std::lround(extent[axis]) + 2;
    const auto corner = [&](long x, long y, long z) {
      return static_cast<std::size_t>((x * count_[1] + y) * count_[2] + z);
    };
    for (long x = 0; x < count_[0]; ++x)
      for (long y = 0; y < count_[1]; ++y)
        for (long z = 0; z < count_[2]; ++z) { // at no place where a coordinate is round
          place_.push_back(shape.low + shape.step * Position{{double(x) - 0.137, double(y) - 0.211,
                                                              double(z) - 0.171}});
          value_.push_back(shape(place_.back(), size));
        }
    for (long x = 0; x + 1 < count_[0]; ++x)
      for (long y = 0; y + 1 < count_[1]; ++y)
        for (long z = 0; z + 1 < count_[2]; ++z) {
          std::array<std::size_t, 3> axes{0, 1, 2};
          do {
            std::array<long, 3> at{x, y, z};
            std::array<std::size_t, 4> corners{corner(x, y, z)};
            for (std::size_t i = 0; i < 3; ++i) {
              ++at[axes[i]];
              corners[i + 1] = corner(at[0], at[1], at[2]);
            }
            cut(corners);
          } while (std::next_permutation(axes.begin(), axes.end()));
        }
  }

private:
  void cut(std::array<std::size_t, 4> corners) {
    const auto first_outside = std::partition(corners.begin(), corners.end(),
                                              [&](std::size_t c) { return value_[c] < 0; });
    const auto inside = first_outside - corners.begin();
    if (inside == 0 || inside == 4)
      return;
    const Position outwards =
        middle({first_outside, corners.end()}) - middle({corners.begin(), first_outside});
    const auto& [a, b, c, d] = corners;
    if (inside == 1)
      add({at(a, b), at(a, c), at(a, d)}, outwards);
    else if (inside == 3)
      add({at(d, a), at(d, b), at(d, c)}, outwards);
    else {
      add({at(a, c), at(a, d), at(b, d)}, outwards);
      add({at(a, c), at(b, d), at(b, c)}, outwards);
    }
  }
  Position middle(const std::vector<std::size_t>& corners) const {
    Position sum;
    for (const std::size_t c : corners)
      sum += place_[c];
    return 1. / static_cast<double>(corners.size()) * sum;
  }
  void add(test::Triangle triangle, const Position& outwards) {
    if (dot(test::area_vector(soup, triangle), outwards) < 0)
      std::swap(triangle[0], triangle[1]);
    soup.triangles.push_back(triangle);
  }
  std::uint32_t at(std::size_t a, std::size_t b) {
    const auto [found, is_new] = number_.try_emplace(
        {(std::min)(a, b), (std::max)(a, b)}, static_cast<std::uint32_t>(soup.points.size()));
    if (is_new) {
      const double t = std::clamp(value_[a] / (value_[a] - value_[b]), 0.05, 0.95);
      soup.points.push_back(place_[a] + t * (place_[b] - place_[a]));
    }
    return found->second;
  }

  std::array<long, 3> count_{};
  std::vector<Position> place_;
  std::vector<double> value_;
  std::map<std::array<std::size_t, 2>, std::uint32_t> number_;
};

Soup surface_of(const Shape& shape, double size) {
  Soup soup = shape.mesh == Mesh::cubes ? of_cubes(shape, size) : OfTetrahedra(shape, size).soup;
  quadrille::make_manifold(soup.points, soup.triangles);
  return soup;
}

/// A square tunnel along an axis.
Part square(std::size_t axis, double u, double v, double width) {
  Position low{{-99, -99, -99}}, high{{99, 99, 99}};
  low[(axis + 1) % 3] = u;
  low[(axis + 2) % 3] = v;
  high[(axis + 1) % 3] = u + width;
  high[(axis + 2) % 3] = v + width;
  return {width, box(low, high)};
}
Part round(const std::vector<Position>& path, double diameter) {
  return {diameter, tube(path, diameter)};
}

std::vector<Shape> shapes() {
  const Field block = box({{0, 0, 0}}, {{18, 12, 6}});
  const Field hollow = without(box({{0, 0, 0}}, {{16, 12, 8}}), box({{2, 2, 2}}, {{14, 10, 6}}));
  const Position low{{-1, -1, -1}};
  std::vector<Shape> all;
  all.push_back({"a block with square tunnels",
                 Mesh::cubes,
                 1,
                 low,
                 {{19, 13, 7}},
                 block,
                 {square(2, 2, 2, 1), square(2, 2, 8, 1), square(2, 5, 3, 3), square(2, 10, 4, 6)},
                 {}});
  all.push_back({"tunnels of two voxels",
                 Mesh::cubes,
                 0.5,
                 low,
                 {{8, 8, 4}},
                 box({{0, 0, 0}}, {{7, 7, 3}}),
                 {square(2, 1, 1, 1), square(2, 3, 3, 3)},
                 {}});
  all.push_back(
      {"a plate with round holes",
       Mesh::tetrahedra,
       0.8,
       low,
       {{21, 17, 3}},
       box({{0, 0, 0}}, {{20, 16, 2}}),
       {round({{{4, 4, -9}}, {{4, 4, 9}}}, 2), round({{{12.5, 8, -9}}, {{12.5, 8, 9}}}, 5)},
       {}});
  all.push_back({"a hollow box with holes between its walls",
                 Mesh::cubes,
                 1,
                 low,
                 {{17, 13, 9}},
                 hollow,
                 {square(2, 4, 4, 1), square(0, 4, 4, 1), square(1, 3, 9, 1)},
                 {}});
  all.push_back({"a hollow ball with round holes between its walls",
                 Mesh::tetrahedra,
                 0.7,
                 {{-6, -6, -6}},
                 {{6, 6, 6}},
                 without(ball({}, 5.4), ball({}, 4)),
                 {round({{{-9, 0, 0}}, {{0, 0, 0}}}, 2), round({{{0, 0, 0}}, {{9, 0, 0}}}, 2),
                  round({{{0, 0, -9}}, {{0, 0, 9}}}, 4.5)},
                 {}});
  all.push_back({"a block with handles",
                 Mesh::cubes,
                 1,
                 low,
                 {{21, 9, 15}},
                 box({{0, 0, 0}}, {{20, 8, 6}}),
                 {},
                 {{1, without(box({{1, 2, 5}}, {{10, 3, 9}}), box({{2, 2, 5}}, {{9, 3, 8}}))},
                  {3, without(box({{2, 4, 5}}, {{19, 7, 14}}), box({{5, 4, 5}}, {{16, 7, 11}}))}}});
  all.push_back(
      {"a chain of rings",
       Mesh::tetrahedra,
       0.8,
       {{-6, -8, -2}},
       {{16, 6, 2}},
       joined({ring({}, 2, 3.6, 3), ring({{10, 0, 0}}, 2, 3.6, 3),
               tube({{{4, 0, 0}}, {{6, 0, 0}}}, 2)}),
       {},
       {{1.8, tube({{{0, -4, 0}}, {{0, -6.5, 0}}, {{10, -6.5, 0}}, {{10, -4, 0}}}, 1.8)}}});
  all.push_back({"tunnels that cross",
                 Mesh::cubes,
                 1,
                 low,
                 {{17, 13, 9}},
                 box({{0, 0, 0}}, {{16, 12, 8}}),
                 {square(0, 3, 3, 1), square(1, 3, 3, 1), square(2, 10, 6, 3), square(0, 7, 4, 1)},
                 {}});
  all.push_back({"tunnels that meet in a ball",
                 Mesh::tetrahedra,
                 0.6,
                 {{-5, -5, -5}},
                 {{5, 5, 5}},
                 ball({}, 4.4),
                 {round({{{-9, 0, 0}}, {{9, 0, 0}}}, 2), round({{{0, -9, 0}}, {{0, 9, 0}}}, 2),
                  round({{{0, 0, 0}}, {{6, 6, 6}}}, 2)},
                 {}});
  all.push_back({"wide holes with bars in them, and narrow ones side by side",
                 Mesh::cubes,
                 1,
                 low,
                 {{31, 19, 3}},
                 box({{0, 0, 0}}, {{30, 18, 2}}),
                 {{6, box({{4, 5, -9}}, {{13, 11, 9}})},
                  {6, box({{17, 4, -9}}, {{25, 14, 9}})},
                  square(2, 3, 15, 1),
                  square(2, 5, 15, 1),
                  square(2, 7, 15, 1)},
                 {{1, box({{8, 5, 0}}, {{9, 11, 1}})},
                  {1, box({{17, 6, 1}}, {{25, 7, 2}})},
                  {2, box({{17, 10, 0}}, {{25, 12, 2}})}}});
  all.push_back({"tunnels that bend",
                 Mesh::tetrahedra,
                 0.7,
                 low,
                 {{13, 10, 6}},
                 box({{0, 0, 0}}, {{12, 9, 5.5}}),
                 {round({{{3, 3, 9}}, {{3, 3, 3}}, {{9, 3, 3}}, {{9, 6, 3}}, {{9, 6, 9}}}, 2)},
                 {}});
  all.push_back({"two rooms",
                 Mesh::cubes,
                 1,
                 low,
                 {{25, 11, 11}},
                 without(box({{0, 0, 0}}, {{24, 10, 10}}),
                         joined({box({{2, 2, 2}}, {{10, 8, 8}}), box({{13, 2, 2}}, {{22, 8, 8}})})),
                 {{1, box({{9, 3, 3}}, {{14, 4, 4}})},
                  {1, box({{9, 6, 6}}, {{14, 7, 7}})},
                  {1, box({{4, 4, 7}}, {{5, 5, 99}})},
                  {3, box({{15, 4, 7}}, {{18, 7, 99}})}},
                 {}});
  all.push_back(
      {"dents, limbs and a waist",
       Mesh::cubes,
       1,
       {{-1, -1, -1}},
       {{31, 11, 14}},
       without(joined({box({{0, 0, 0}}, {{10, 10, 8}}), box({{18, 0, 0}}, {{26, 8, 8}}),
                       box({{10, 4, 4}}, {{18, 5, 5}}), box({{3, 3, 8}}, {{4, 4, 13}}),
                       box({{26, 2, 2}}, {{30, 4, 4}})}),
               joined({box({{6, 6, 2}}, {{7, 7, 9}}), box({{2, 5, 1}}, {{3, 6, 4}}),
                       box({{20, 2, -1}}, {{22, 4, 6}}), box({{6, 2, -1}}, {{7, 3, 4}})})),
       {},
       {}});
  return all;
}

/// Sizes that are clear of all widths of a shape: a square one is known well, and a round one only
/// to some part of the step.
std::vector<double> sizes_for(const Shape& shape) {
  const double factor = shape.mesh == Mesh::cubes ? 1.15 : 1.4;
  std::vector<double> widths;
  for (const auto* parts : {&shape.tunnels, &shape.handles})
    for (const Part& part : *parts)
      widths.push_back(part.width);
  if (widths.empty())
    return {1.15, 3};
  std::vector<double> sizes{*std::min_element(widths.begin(), widths.end()) / factor};
  for (const double width : widths)
    if (width < 4) // a search for wider ones takes long
      sizes.push_back(factor * width);
  std::erase_if(sizes, [&](double size) {
    return std::any_of(widths.begin(), widths.end(), [&](double width) {
      return size > 1.01 * width / factor && size < 0.99 * factor * width;
    });
  });
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

// --- What must hold ------------------------------------------------------------------------------

/// The genus of each component, the highest first: by counting vertices, edges and faces.
std::vector<long> genera(const Soup& soup) {
  test::detail::Partition parts(soup.points.size());
  for (const auto& [a, b, c] : soup.triangles) {
    parts.merge(a, b);
    parts.merge(b, c);
  }
  std::map<std::uint32_t, long> vertices, faces;
  std::vector<bool> is_seen(soup.points.size(), false);
  for (const test::Triangle& t : soup.triangles) {
    ++faces[parts.root(t[0])];
    for (const std::uint32_t v : t) {
      vertices[parts.root(v)] += is_seen[v] ? 0 : 1;
      is_seen[v] = true;
    }
  }
  std::vector<long> result;
  for (const auto& [root, count] : faces) // with 3/2 edges a face
    result.push_back(1 - (vertices[root] - count / 2) / 2);
  std::sort(result.rbegin(), result.rend());
  return result;
}

void require_closed_manifold(const Soup& soup) {
  const auto topology = test::topology_of(soup);
  CAPTURE(topology);
  CHECK(topology.is_closed());
  CHECK(topology.is_manifold);
  CHECK(topology.is_oriented);
  CHECK(!topology.has_duplicate_faces);
  CHECK(!topology.has_collapsed_faces);
}

double distance(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Cuts a surface, of which no point may move, and no corner of a triangle further than to a copy.
Soup cut(const Soup& input, double size) {
  Soup soup = input;
  quadrille::cut_handles(soup.points, soup.triangles, size);
  require_closed_manifold(soup);
  REQUIRE(soup.triangles.size() >= input.triangles.size());
  CHECK(std::equal(input.points.begin(), input.points.end(), soup.points.begin()));
  double longest_edge = 0, farthest = 0;
  for (std::size_t face = 0; face < input.triangles.size(); ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      const Position& corner = input.points[input.triangles[face][i]];
      longest_edge = (std::max)(
          longest_edge, distance(corner, input.points[input.triangles[face][(i + 1) % 3]]));
      farthest = (std::max)(farthest, distance(corner, soup.points[soup.triangles[face][i]]));
    }
  CHECK(farthest <= longest_edge / 8); // one may be cut twice
  return soup;
}

/// The distance of the farthest added point from all that is narrower than the size.
double farthest_change(const Shape& shape, double size, const Soup& input, const Soup& result) {
  double farthest = 0;
  for (std::size_t face = input.triangles.size(); face < result.triangles.size(); ++face)
    for (const std::uint32_t v : result.triangles[face]) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto* parts : {&shape.tunnels, &shape.handles})
        for (const Part& part : *parts)
          if (part.width < size)
            nearest = (std::min)(nearest, part.field(result.points[v]));
      farthest = (std::max)(farthest, nearest);
    }
  return farthest;
}

/// A surface turned, moved far away, with noise and other numbers.
Soup elsewhere(const Shape& shape, const Soup& soup) {
  return test::shuffled(test::mapped(test::tilted(test::with_noise(soup, 5, 0.08 * shape.step)),
                                     [](const Position& p) {
                                       return p + Position{{-3e5, 1e6, 2e5}};
                                     }),
                        7);
}

} // namespace

TEST_CASE("The genus is that of the shape with all filled that is narrower than the size") {
  for (const Shape& shape : shapes()) {
    const Soup input = surface_of(shape, 0);
    require_closed_manifold(input);
    for (const double size : sizes_for(shape)) {
      INFO(shape.name << ", size " << size);
      const std::vector<long> filled = genera(surface_of(shape, size));
      const Soup result = cut(input, size);
      CHECK(genera(result) == filled);
      CHECK(farthest_change(shape, size, input, result) <= size);
      if (shape.mesh == Mesh::cubes)
        CHECK(genera(cut(elsewhere(shape, input), size)) == filled);
    }
  }
}
