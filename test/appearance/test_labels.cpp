// Labels of faces: each face keeps its own, and regions of equal labels keep their topology.
#include "mesh_types.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

struct Labelled {
  Soup soup;
  std::vector<int> labels; // of each triangle
};

Position centre(const Soup& soup, const Triangle& t) {
  return (1. / 3) * (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]);
}

template <class LabelAt>
Labelled labelled(const Soup& soup, LabelAt label_at) {
  Labelled result{soup, {}};
  for (const Triangle& t : soup.triangles)
    result.labels.push_back(label_at(centre(soup, t)));
  return result;
}

// What must not change, by plain maps: for each label how many parts its faces have, by edges, and
// their Euler characteristic; which labels have an edge in common; at how many vertices other
// than two seams meet.
struct Pattern {
  std::map<int, std::size_t> parts;
  std::map<int, std::ptrdiff_t> euler; // V − E + F of its faces
  std::set<std::pair<int, int>> neighbours;
  std::size_t corners = 0;
  friend bool operator==(const Pattern&, const Pattern&) = default;
};

std::ostream& operator<<(std::ostream& out, const Pattern& p) {
  for (const auto& [label, parts] : p.parts)
    out << label << ": " << parts << " parts, " << p.euler.at(label) << " Euler; ";
  return out << p.neighbours.size() << " neighbours, " << p.corners << " corners";
}

Pattern pattern_of(const Labelled& surface) {
  const auto& [soup, labels] = surface;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> faces_of;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      faces_of[std::minmax({soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]})].push_back(f);
  std::vector<std::size_t> part(soup.triangles.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  const auto root = [&](std::size_t f) {
    while (part[f] != f)
      f = part[f];
    return f;
  };
  Pattern pattern;
  std::map<std::uint32_t, std::size_t> seams;
  for (const auto& [edge, faces] : faces_of) {
    const bool is_inside = faces.size() == 2 && labels[faces[0]] == labels[faces[1]];
    if (is_inside)
      part[root(faces[0])] = root(faces[1]);
    else
      ++seams[edge.first], ++seams[edge.second];
    for (std::size_t f : faces)
      for (std::size_t g : faces)
        if (labels[f] < labels[g])
          pattern.neighbours.insert({labels[f], labels[g]});
  }
  for (std::size_t f = 0; f < part.size(); ++f)
    pattern.parts[labels[f]] += part[f] == f;
  for (const auto& [v, count] : seams)
    pattern.corners += count != 2;
  for (const auto& [label, parts] : pattern.parts) {
    std::set<std::uint32_t> vertices;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::size_t faces = 0;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (labels[f] == label) {
        ++faces;
        for (std::size_t i = 0; i < 3; ++i) {
          vertices.insert(soup.triangles[f][i]);
          edges.insert(std::minmax({soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]}));
        }
      }
    pattern.euler[label] =
        std::ptrdiff_t(vertices.size()) - std::ptrdiff_t(edges.size()) + std::ptrdiff_t(faces);
  }
  return pattern;
}

double area_of(const Labelled& surface, int label) {
  double area = 0;
  for (std::size_t f = 0; f < surface.labels.size(); ++f)
    if (surface.labels[f] == label)
      area += std::sqrt(squared_length(area_vector(surface.soup, surface.soup.triangles[f])));
  return area;
}

template <class... Policies>
std::pair<Labelled, Report> simplified(Labelled surface, const Policies&... policies) {
  std::vector<Point> points = points_of(surface.soup);
  const Report report = simplify(points, surface.soup.triangles, policies...,
                                 Labels{CGAL::make_property_map(surface.labels)});
  surface.soup.points.clear();
  for (const Point& p : points)
    surface.soup.points.push_back(to_position(p));
  surface.labels.resize(surface.soup.triangles.size());
  return {surface, report};
}

int octant(const Position& p) {
  return (p[0] > 0.1) + 2 * (p[1] > -0.05) + 4 * (p[2] > 0.2);
}

std::vector<Labelled> surfaces() {
  const auto wave = [](const Position& p) { return p[2] > 0.15 * std::sin(5 * p[0]) ? 7 : 2; };
  const auto islands = [](const Position& p) {
    return std::fmod(p[0], 0.4) < 0.15 && std::fmod(p[1], 0.4) < 0.15 ? 1 : 0;
  };
  return {labelled(with_noise(sphere(4), 1, 0.005), wave),
          labelled(with_noise(sphere(4), 2, 0.005), octant),
          labelled(with_noise(grid(30, 21), 3, 0.01), islands),
          labelled(with_noise(torus(48, 24), 4, 0.01), octant)};
}

} // namespace

TEMPLATE_TEST_CASE("Regions of labels keep their topology, and their neighbours", "",
                   (std::tuple<Quadric, GreedyOrder>), (std::tuple<Quadric, RelaxedOrder>),
                   (std::tuple<MemorylessQuadric, GreedyOrder>)) {
  const auto& [cost, order] = TestType();
  for (const Labelled& surface : surfaces())
    for (const double ratio : {0.3, 0.05, 0.001}) {
      const auto [result, report] = simplified(surface, cost, order, FaceRatio{ratio});
      CAPTURE(ratio, report);
      const bool is_same = pattern_of(result) == pattern_of(surface);
      INFO(pattern_of(surface) << "\n  " << pattern_of(result));
      CHECK(is_same);
      CHECK(topology_of(result.soup).is_manifold);
      if (ratio > 0.1)
        CHECK(report.stop == StopReason::target_met);
      if (ratio < 0.01)
        CHECK(report.rejected(Rejection::seam) > 0);
    }
}

TEST_CASE("Without labels as an argument, regions are torn") {
  std::size_t torn = 0;
  for (const Labelled& surface : surfaces()) {
    Labelled result = surface;
    Mesh mesh = make_mesh(surface.soup);
    const auto label = mesh.add_property_map<Mesh::Face_index, int>("label", -1).first;
    for (const auto f : faces(mesh))
      label[f] = surface.labels[f];
    simplify(mesh, FaceRatio{0.05});
    mesh.collect_garbage();
    result.soup = to_soup(mesh);
    result.labels.clear();
    for (const auto f : faces(mesh))
      result.labels.push_back(label[f]);
    torn += !(pattern_of(result) == pattern_of(surface));
  }
  CHECK(torn > 0); // else the patterns say nothing
}

TEST_CASE("The areas of regions stay") {
  for (const Labelled& surface : surfaces()) {
    const auto result = simplified(surface, Quadric{}, FaceRatio{0.1}).first;
    for (int label = 0; label < 8; ++label) {
      CAPTURE(label);
      CHECK(area_of(result, label) == Approx(area_of(surface, label)).epsilon(0.2).margin(0.02));
    }
  }
}

TEST_CASE("Labels of a mesh are a map over its faces, or CGAL's face_patch_map") {
  const Labelled surface = surfaces()[1];
  const auto expected = pattern_of(surface);
  for (const bool is_named : {false, true}) {
    Mesh mesh = make_mesh(surface.soup);
    const auto label = mesh.add_property_map<Mesh::Face_index, int>("label", -1).first;
    for (const auto f : faces(mesh))
      label[f] = surface.labels[f];
    if (is_named)
      simplify(mesh, FaceRatio{0.05}, CGAL::parameters::face_patch_map(label));
    else
      simplify(mesh, FaceRatio{0.05}, Labels{label});
    mesh.collect_garbage();
    Labelled result{to_soup(mesh), {}};
    for (const auto f : faces(mesh))
      result.labels.push_back(label[f]);
    CHECK(result.labels.size() < 300);
    const bool is_same = pattern_of(result) == expected;
    CHECK(is_same);
  }
}

TEST_CASE("A cube of six labels comes to twelve faces and eight corners") {
  const Soup soup = cube(8);
  double size = 0;
  for (const Position& p : soup.points)
    size = std::max(size, p[0]);
  const Labelled cube_of_labels = labelled(soup, [size](const Position& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] < 1e-9 * size)
        return static_cast<int>(2 * i);
      if (p[i] > (1 - 1e-9) * size)
        return static_cast<int>(2 * i + 1);
    }
    return 6;
  });
  REQUIRE(*std::max_element(cube_of_labels.labels.begin(), cube_of_labels.labels.end()) == 5);
  const auto [result, report] = simplified(cube_of_labels, Quadric{}, FaceCount{12});
  CHECK(result.labels.size() == 12);
  for (int label = 0; label < 6; ++label)
    CHECK(area_of(result, label) == Approx(area_of(cube_of_labels, label)));
}

TEST_CASE("Duplicate faces of a soup are no seams") {
  const Labelled surface = surfaces()[1];
  Labelled doubled = surface;
  for (std::size_t f = 0; f < surface.labels.size(); f += 3) {
    doubled.soup.triangles.push_back(surface.soup.triangles[f]);
    doubled.labels.push_back(surface.labels[f]);
  }
  const FaceCount stop{200};
  const Labelled expected = simplified(surface, Quadric{}, stop).first;
  const Labelled result = simplified(doubled, Quadric{}, stop).first;
  CHECK(result.labels == expected.labels);
  CHECK(is_identical(result.soup, expected.soup));
}

TEST_CASE("Of doubled faces with different labels one is left, and the others are counted") {
  Labelled doubled = surfaces()[1];
  const std::size_t faces = doubled.labels.size();
  for (std::size_t f = 0; f < faces; f += 3)
    for (const int other : {100, 100, doubled.labels[f]}) {
      doubled.soup.triangles.push_back(doubled.soup.triangles[f]);
      doubled.labels.push_back(other);
    }
  const auto [result, report] = simplified(doubled, Quadric{}, FaceCount{faces});
  CHECK(result.labels.size() == faces);
  const std::size_t left =
      static_cast<std::size_t>(std::count(result.labels.begin(), result.labels.end(), 100));
  // Of four with two labels each, two have another label than the one that is left.
  CHECK(report.doubled_labels == 2 * ((faces + 2) / 3));
  CHECK(left <= (faces + 2) / 3);
}

TEST_CASE("Where sheets of different labels become one, the faces that go are counted") {
  const Soup sheet = with_noise(grid(4, 4), 1, 0.05);
  Labelled sheets{joined(sheet, sheet, {0, 0, 1e-3}), {}};
  for (std::size_t f = 0; f < sheets.soup.triangles.size(); ++f)
    sheets.labels.push_back(f < sheet.triangles.size());
  const auto [result, report] =
      simplified(sheets, Quadric{}, FaceCount{sheet.triangles.size()}, ThresholdPairs{2e-3});
  CAPTURE(report);
  CHECK(topology_of(result.soup).components == 1);
  CHECK(report.doubled_labels > sheet.triangles.size() / 2);
}

TEST_CASE("Where labels are all the same, nothing changes but borders") {
  const Soup soup = with_noise(sphere(3), 1, 0.01);
  const auto result =
      simplified(labelled(soup, [](const Position&) { return 3; }), FaceRatio{0.1}).first;
  std::vector<Point> points = points_of(soup);
  std::vector<Triangle> triangles = soup.triangles;
  simplify(points, triangles, FaceRatio{0.1});
  const bool is_same = triangles == result.soup.triangles;
  CHECK(is_same);
}

TEST_CASE("A border weight that makes no sense is refused") {
  Labelled surface = surfaces()[0];
  std::vector<Point> points = points_of(surface.soup);
  CHECK_THROWS_AS(simplify(points, surface.soup.triangles,
                           Labels{CGAL::make_property_map(surface.labels), -1.0}),
                  std::invalid_argument);
}
