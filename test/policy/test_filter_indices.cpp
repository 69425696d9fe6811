// The indices by which a filter is told what a contraction is about: those of the input.
#include "meshes.h"

#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

using Indices = std::set<std::size_t>;

// What a filter was told the last time, and a recorder that is told the same contraction of it.
struct Told {
  Indices ends, changed, removed;
  std::size_t contractions = 0;

  void begin(const RecordedSurface& surface) { triangles = surface.triangles; }
  void record(const RecordedContraction& contraction) {
    ++contractions;
    REQUIRE(ends == Indices{contraction.kept, contraction.gone});
    REQUIRE(removed == Indices(contraction.removed_faces.begin(), contraction.removed_faces.end()));
    Indices expected; // by the recorder's triangles
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const Indices corners(triangles[f].begin(), triangles[f].end());
      if (std::ranges::any_of(ends, [&](std::size_t v) { return corners.contains(v); }) &&
          !removed.contains(f))
        expected.insert(f);
    }
    REQUIRE(changed == expected);
    for (std::size_t f : removed)
      triangles[f].fill(not_recorded);
    for (auto& corners : triangles)
      std::ranges::replace(corners, contraction.gone, contraction.kept);
  }
  void end() {}

  std::vector<std::array<RecordedIndex, 3>> triangles;
};

template <bool is_scale_free>
struct Reporter {
  using ScaleFree = std::conditional_t<is_scale_free, Reporter, void>;
  Told* told;

  bool allows(const auto& contraction) const {
    told->ends = {contraction.first(), contraction.second()};
    told->changed.clear();
    for (const auto& face : contraction.faces())
      told->changed.insert(face.index);
    const auto removed = contraction.removed_faces();
    told->removed = Indices();
    for (std::size_t f : removed)
      told->removed.insert(f);
    REQUIRE(removed.size() == told->removed.size());
    return true;
  }
};

// Keeps selected vertices, or faces, as they are.
struct KeepVertices {
  const std::vector<bool>* is_selected;
  bool allows(const auto& contraction) const {
    return !(*is_selected)[contraction.first()] && !(*is_selected)[contraction.second()];
  }
};
struct KeepFaces {
  const std::vector<bool>* is_selected;
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces())
      if ((*is_selected)[face.index])
        return false;
    for (const std::size_t f : contraction.removed_faces())
      if ((*is_selected)[f])
        return false;
    return true;
  }
};

Soup input() {
  return shuffled(with_noise(torus(120, 60), 1, 0.005), 1);
}

bool is_in_part(const Position& p) {
  return p[0] > 0.3 && p[1] > -0.2;
}

bool is_face_in_part(const Soup& soup, const Triangle& t) {
  return std::ranges::all_of(t, [&](auto v) { return is_in_part(soup.points[v]); });
}

// The faces of the part, from their lowest corner on.
std::set<std::array<std::array<double, 3>, 3>> part_of(const Soup& soup) {
  std::set<std::array<std::array<double, 3>, 3>> faces;
  for (const Triangle& t : soup.triangles)
    if (is_face_in_part(soup, t)) {
      std::array corners{soup.points[t[0]].coordinates, soup.points[t[1]].coordinates,
                         soup.points[t[2]].coordinates};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      faces.insert(corners);
    }
  return faces;
}

void check_part(const Soup& before, const Soup& after) {
  CHECK(after.triangles.size() < before.triangles.size() / 2);
  const auto expected = part_of(before), left = part_of(after);
  REQUIRE(expected.size() > 500);
  CHECK(std::ranges::includes(left, expected));
}

template <class... Policies>
void check_soup(const Policies&... policies) {
  const Soup soup = input();
  std::vector<bool> vertices, faces;
  for (const Position& p : soup.points)
    vertices.push_back(is_in_part(p));
  for (const Triangle& t : soup.triangles)
    faces.push_back(is_face_in_part(soup, t));
  const auto check = [&](const auto& filter) {
    Soup after = soup;
    const Report report =
        simplify(after.points, after.triangles, FaceRatio{0.3}, filter, NormalFlip{}, policies...);
    CHECK(report.rejected(Rejection::filter) > 0);
    check_part(soup, after);
  };
  check(KeepVertices{&vertices});
  check(KeepFaces{&faces});
}

} // namespace

TEST_CASE("A filter is told the indices that a recorder is told") {
  Soup soup = shuffled(with_noise(torus(24, 12), 1, 0.01), 1);
  soup.points.insert(soup.points.begin(), 3, Position{}); // of no face
  for (Triangle& t : soup.triangles)
    for (auto& v : t)
      v += 3;
  Told told;
  const auto check = [&](const auto& filter) {
    Soup copy = soup;
    told = {};
    const Report report = simplify(copy.points, copy.triangles, FaceCount{60}, record_into(told),
                                   NormalFlip{}, filter);
    CHECK(told.contractions == report.contractions);
    CHECK(told.contractions > 200);
  };
  check(Reporter<false>{&told});
  check(Reporter<true>{&told});
}

TEST_CASE("A filter keeps the selected part of a soup, by vertices or by faces") {
  check_soup();
  check_soup(RelaxedOrder{});
}

TEST_CASE("A filter keeps the selected part of a mesh, which has gaps, in its order") {
  Mesh mesh = make_mesh<Mesh>(input());
  for (const Mesh::size_type v : {0u, 5u, 77u}) { // with the faces around it
    const auto around = mesh.halfedge(Mesh::Vertex_index(v));
    CGAL::Euler::remove_face(CGAL::Euler::remove_center_vertex(around, mesh), mesh);
  }
  REQUIRE(mesh.has_garbage());
  std::vector<bool> is_selected;
  for (const Mesh::Vertex_index v : mesh.vertices())
    is_selected.push_back(is_in_part(to_position(mesh.point(v))));
  const Soup before = to_soup(mesh);
  simplify(mesh, FaceRatio{0.3}, NormalFlip{}, KeepVertices{&is_selected});
  check_part(before, to_soup(mesh));
}
