// The vertices that a mesh gets so that it can hold a non-manifold result.
#include "mesh_types.h"
#include "snapshot.h"
#include "soups.h"

#include <quadrille/edge_length.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

constexpr std::size_t parts = 5;

// Tetrahedra, whose first vertices are made one, or two.
Soup tetrahedra() {
  Soup soup;
  for (std::size_t i = 0; i < parts; ++i)
    soup = joined(soup, tetrahedron(), {{4.0 * static_cast<double>(i), 0, 0}});
  return soup;
}

struct FirstVertices {
  void operator()(const SurfaceView&, const EmitPair& emit) const {
    for (std::size_t i = 1; i < parts; ++i)
      emit(0, 4 * i);
    emit(1, 5);
  }
};

constexpr auto all_of_them = [](const Status& status) { return status.contractions == parts; };

template <class M, class Duplicates>
Report join_parts(M& mesh, Duplicates& duplicates) {
  return simplify(mesh, EdgeLength{}, MidpointPlacement{}, FirstVertices{}, all_of_them,
                  NormalFlip{180},
                  parameters::duplicate_output_iterator(std::back_inserter(duplicates)));
}

struct Throwing {
  Throwing& operator*() { return *this; }
  Throwing& operator++() { return *this; }
  Throwing& operator++(int) { return *this; }
  template <class T>
  void operator=(const T&) {
    throw std::runtime_error("no");
  }
};

} // namespace

TEMPLATE_TEST_CASE("The duplicates of vertices are told", "", Mesh, Polyhedron, TriMesh) {
  auto mesh = convert<TestType>(tetrahedra());
  using Vertex = typename boost::graph_traits<TestType>::vertex_descriptor;
  std::vector<std::pair<Vertex, Vertex>> duplicates;
  const Report report = join_parts(mesh, duplicates);
  CHECK(report.duplicated_vertices == parts);
  REQUIRE(duplicates.size() == parts);
  const auto points = get(CGAL::vertex_point, mesh);
  for (const auto& [added, original] : duplicates) {
    CHECK(added != original);
    CHECK(get(points, added) == get(points, original));
    CHECK(degree(added, mesh) == 3);
  }
  CHECK(is_valid_triangle_mesh(mesh));
}

TEST_CASE("The duplicates of a Surface_mesh have all properties of their originals") {
  Mesh mesh = make_mesh(tetrahedra());
  using Vertex = Mesh::Vertex_index;
  mesh.remove_vertex(mesh.add_vertex(Point(9, 9, 9))); // there is garbage
  const auto names = mesh.add_property_map<Vertex, std::string>("name").first;
  const auto flags = mesh.add_property_map<Vertex, bool>("flag").first;
  const auto weights = mesh.add_property_map<Mesh::Edge_index, double>("weight", 1).first;
  for (Vertex v : vertices(mesh)) {
    names[v] = "vertex number " + std::to_string(v.idx());
    flags[v] = v.idx() % 2 == 0;
  }
  std::vector<std::pair<Vertex, Vertex>> duplicates;
  join_parts(mesh, duplicates);
  REQUIRE(duplicates.size() == parts);
  std::map<Vertex, std::size_t> originals;
  for (const auto& [added, original] : duplicates) {
    CHECK(names[added] == names[original]);
    CHECK(names[added] == "vertex number " + std::to_string(original.idx()));
    CHECK(flags[added] == flags[original]);
    ++originals[original];
  }
  CHECK(originals.size() == 2);
  for (const auto e : edges(mesh))
    CHECK(weights[e] == 1);
  CHECK(is_valid_triangle_mesh(mesh));
  mesh.collect_garbage();
  CHECK(is_valid_triangle_mesh(mesh));
  CHECK(mesh.number_of_vertices() == 4 * parts);
}

TEST_CASE("The duplicates of a mesh of OpenMesh have all properties of their originals") {
  auto mesh = convert<TriMesh>(tetrahedra());
  OpenMesh::VPropHandleT<int> numbers;
  mesh.add_property(numbers, "number");
  for (const auto v : mesh.vertices())
    mesh.property(numbers, v) = v.idx() + 100;
  using Vertex = boost::graph_traits<TriMesh>::vertex_descriptor;
  std::vector<std::pair<Vertex, Vertex>> duplicates;
  join_parts(mesh, duplicates);
  REQUIRE(duplicates.size() == parts);
  for (const auto& [added, original] : duplicates)
    CHECK(mesh.property(numbers, added) == original.idx() + 100);
}

TEST_CASE("Where telling duplicates fails, the mesh is as it was") {
  Mesh mesh = make_mesh(tetrahedra());
  mesh.add_property_map<Mesh::Vertex_index, std::string>("name", "?");
  const Snapshot before = snapshot(mesh);
  CHECK_THROWS_WITH(simplify(mesh, EdgeLength{}, MidpointPlacement{}, FirstVertices{}, all_of_them,
                             NormalFlip{180}, parameters::duplicate_output_iterator(Throwing())),
                    "no");
  CHECK((snapshot(mesh) == before));
  CHECK(mesh.number_of_vertices() == 4 * parts);
  CHECK(is_valid_triangle_mesh(mesh));
}
