// Closed and manifold stays so, with its genus, its parts and its borders, and no face turns over.

#include "meshes.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Position;
using test::SoupTopology;

struct Model {
  std::string name;
  Mesh mesh;
};

std::vector<Model> read_models(const std::vector<std::string>& names) {
  std::vector<Model> models;
  for (const std::string& name : names)
    models.push_back({name, test::read_model(name)});
  return models;
}

std::vector<Model> closed_models() {
  std::vector<Model> models =
      read_models({"cow", "bones", "bunny00", "fandisk", "elephant", "eight", "elk", "pinion"});
  models.push_back({"sphere", test::make_mesh(test::sphere(5))});
  models.push_back({"sphere with poles", test::make_mesh(test::uv_sphere(60, 40))});
  models.push_back({"cube", test::make_mesh(test::cube(12))});
  models.push_back({"torus", test::make_mesh(test::torus(80, 40))});
  models.push_back({"plate with 2 holes", test::make_mesh(test::plate_with_holes(2, 8))});
  models.push_back({"plate with 9 holes", test::make_mesh(test::plate_with_holes(9, 4))});
  return models;
}

std::vector<Model> open_models() {
  return read_models({"mesh_with_border", "blobby_3cc", "three_peaks", "mech-holes-shark", "head",
                      "lion-head", "nefertiti", "elephant-with-holes"});
}

bool turns_over(const Position& before, const Position& after) {
  return squared_length(before) > 0 && dot(before, after) <= 0;
}

// Behind the filters of the engine: sees the contractions that they let through.
struct TurnedFaces {
  std::size_t* count;

  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces())
      *count += turns_over(double_area_vector(face.before, face.second, face.third),
                           double_area_vector(face.after, face.second, face.third));
    return true;
  }
};

SoupTopology topology_of(const Mesh& mesh) {
  return test::topology_of(test::to_soup(mesh));
}

template <class Cost, class... Arguments>
void require_kept(const Model& model, const SoupTopology& before, std::size_t target,
                  const Arguments&... arguments) {
  Mesh mesh = model.mesh;
  const Report report = simplify<Cost, OptimalPlacement>(mesh, FaceCount{target}, arguments...);
  INFO(model.name << ": " << report);
  REQUIRE(test::is_valid_triangle_mesh(mesh));
  const SoupTopology after = topology_of(mesh);
  INFO(after);
  REQUIRE(after.is_manifold);
  REQUIRE(after.is_oriented);
  REQUIRE_FALSE(after.has_duplicate_faces);
  REQUIRE(is_same_topology(before, after));
  REQUIRE(report.faces_after == mesh.number_of_faces());
  const std::size_t faces = mesh.number_of_faces();
  if (report.stop == StopReason::target_met)
    REQUIRE(faces == target);
  else if (report.stop == StopReason::target_passed)
    REQUIRE(faces + 1 == target);
  else
    REQUIRE(faces > target);
}

// To a half, a tenth, a fiftieth and as far as it goes.
template <class Cost>
void require_kept_at_every_ratio(const Model& model) {
  const SoupTopology before = topology_of(model.mesh);
  REQUIRE(before.is_manifold);
  for (double ratio : {0.5, 0.1, 0.02, 0.0}) {
    const auto target =
        static_cast<std::size_t>(ratio * static_cast<double>(model.mesh.number_of_faces()));
    std::size_t turned_faces = 0;
    require_kept<Cost>(model, before, target, TurnedFaces{&turned_faces});
    REQUIRE(turned_faces == 0);
  }
}

// Irreducible triangulations are small: of the sphere only the tetrahedron, of other surfaces those
// of at most 26 · genus − 4 vertices (Joret and Wood 2010).
std::size_t most_vertices_of_irreducible(const SoupTopology& topology) {
  return topology.genus() == 0 ? 4 * topology.components
                               : static_cast<std::size_t>(26 * topology.genus() - 4);
}

} // namespace

TEMPLATE_TEST_CASE("Closed models keep their topology, and no face turns over", "", Quadric,
                   MemorylessQuadric) {
  for (const Model& model : closed_models()) {
    REQUIRE(CGAL::is_closed(model.mesh));
    require_kept_at_every_ratio<TestType>(model);
  }
}

TEMPLATE_TEST_CASE("Open models keep their borders, and no face turns over", "", Quadric,
                   MemorylessQuadric) {
  for (const Model& model : open_models()) {
    REQUIRE_FALSE(CGAL::is_closed(model.mesh));
    require_kept_at_every_ratio<TestType>(model);
  }
}

TEMPLATE_TEST_CASE("Only its topology keeps a closed model from an irreducible triangulation", "",
                   Quadric, MemorylessQuadric) {
  for (const Model& model : closed_models()) {
    CAPTURE(model.name);
    const SoupTopology before = topology_of(model.mesh);
    Mesh mesh = model.mesh;
    // As far as it goes: for a count it would not lose its shape.
    const auto never = [](const Status& status) {
      return status.next_error > std::numeric_limits<double>::max();
    };
    const Report report = simplify<TestType, OptimalPlacement>(mesh, never, NormalFlip{180});
    INFO(report);
    const SoupTopology after = topology_of(mesh);
    CHECK(is_same_topology(before, after));
    if (report.components_before > 1) {
      CHECK(after.vertices <= 2 * most_vertices_of_irreducible(before));
    } else {
      CHECK(report.stop == StopReason::all_pairs_rejected);
      CHECK(after.vertices <= most_vertices_of_irreducible(before));
    }
  }
}

// The meshes after each number of contractions, side by side: nothing of what the engine tells.
TEMPLATE_TEST_CASE("From one contraction to the next no face turns over", "", Quadric,
                   MemorylessQuadric) {
  std::vector<Model> models = read_models({"eight", "nefertiti"});
  models.push_back({"flat faces", test::make_mesh(test::plate_with_holes(1, 3))});
  models.push_back({"noise", test::make_mesh(test::random_closed(2))});
  models.push_back({"holes", test::make_mesh(test::random_with_boundaries(3))});
  for (const Model& model : models) {
    CAPTURE(model.name);
    Mesh before = model.mesh;
    std::size_t contractions = 0;
    while (true) {
      ++contractions;
      CAPTURE(contractions);
      Mesh after = model.mesh;
      const Report report = simplify<TestType, OptimalPlacement>(
          after, [&](const Status& status) { return status.contractions == contractions; });
      if (report.stop != StopReason::target_met)
        break;
      const auto doubled_area = [](const Mesh& mesh, Mesh::Face_index f) {
        const auto h = mesh.halfedge(f);
        return double_area_vector(test::to_position(mesh.point(mesh.source(h))),
                                  test::to_position(mesh.point(mesh.target(h))),
                                  test::to_position(mesh.point(mesh.target(mesh.next(h)))));
      };
      for (const auto f : after.faces())
        REQUIRE_FALSE(turns_over(doubled_area(before, f), doubled_area(after, f)));
      before = after;
    }
    REQUIRE(contractions > model.mesh.number_of_faces() / 3);
  }
}
