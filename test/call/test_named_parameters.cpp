// What a call tells by named parameters, and the attribute maps that it refuses.
#include "meshes.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

// --- The topology of a soup ----------------------------------------------------------------------

TEST_CASE("A closed manifold soup comes out as one by default") {
  const Soup cow = to_soup(read_model("cow"));
  const SoupTopology before = topology_of(cow);
  const auto check = [&](const auto&... order) {
    for (std::size_t faces : {2000u, 580u, 60u}) {
      PointSoup soup(cow);
      const Report report = simplify(soup.points, soup.triangles, FaceCount{faces}, order...);
      CHECK(report.non_manifold_edges == 0);
      CHECK(report.non_manifold_vertices == 0);
      Soup after{{}, soup.triangles};
      for (const Point& p : soup.points)
        after.points.push_back(to_position(p));
      CHECK(is_same_topology(topology_of(after), before));
    }
  };
  check();
  check(RelaxedOrder{});
  PointSoup soup(cow);
  CHECK(simplify(soup.points, soup.triangles, FaceCount{580}, Topology::free).non_manifold_edges >
        0);
}

TEST_CASE("Pairs that are not edges still join the parts of a soup by default") {
  const Soup two = joined(sphere(2), sphere(2), {{2.1, 0, 0}});
  PointSoup soup(two);
  const Report report = simplify(soup.points, soup.triangles, FaceCount{100}, ThresholdPairs{0.5});
  CHECK(report.components_before == 2);
  CHECK(report.components_after == 1);
}

// --- What became of each vertex ------------------------------------------------------------------

namespace {

// Has every vertex of the input an image, has each of the result itself or a part, and do faces of
// the input go to faces, edges and vertices of the result?
void check_map(const Soup& before, const std::vector<std::size_t>& images, const Soup& after) {
  REQUIRE(images.size() == before.points.size());
  std::set<std::size_t> reached;
  for (std::size_t v = 0; v < images.size(); ++v) {
    REQUIRE((images[v] < after.points.size() || images[v] == parameters::vanished));
    reached.insert(images[v]);
  }
  reached.erase(parameters::vanished);
  CHECK(reached.size() == after.points.size());
  std::set<Triangle> faces;
  const auto canonical_of = [](std::size_t a, std::size_t b, std::size_t c) {
    return canonical({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                      static_cast<std::uint32_t>(c)});
  };
  for (const auto& [a, b, c] : before.triangles)
    faces.insert(canonical_of(images[a], images[b], images[c]));
  for (const auto& [a, b, c] : after.triangles)
    CHECK(faces.count(canonical_of(a, b, c)) == 1);
}

template <class... Arguments>
void check_map_of_soup(const Soup& input, const Arguments&... arguments) {
  PointSoup soup(input);
  std::vector<std::size_t> images(input.points.size(), 12345);
  simplify(soup.points, soup.triangles, arguments...,
           parameters::vertex_to_vertex_map(CGAL::make_property_map(images)));
  Soup after{{}, soup.triangles};
  for (const Point& p : soup.points)
    after.points.push_back(to_position(p));
  check_map(input, images, after);
}

template <class... Arguments>
void check_map_of_mesh(const Soup& input, const Arguments&... arguments) {
  using Vertex = Mesh::Vertex_index;
  Mesh mesh = make_mesh(input);
  std::map<Vertex, Vertex> images;
  simplify(mesh, arguments...,
           parameters::vertex_to_vertex_map(boost::make_assoc_property_map(images)));
  std::map<Vertex, std::size_t> number{{Mesh::null_vertex(), parameters::vanished}};
  for (Vertex v : vertices(mesh)) {
    CHECK(images.at(v) == v);
    number.emplace(v, number.size() - 1);
  }
  std::vector<std::size_t> by_number;
  for (const auto& [v, image] : images)
    by_number.push_back(number.at(image));
  check_map(input, by_number, to_soup(mesh));
}

} // namespace

TEST_CASE("vertex_to_vertex_map tells what became of each vertex") {
  for (const Soup& soup : {sphere(2), with_noise(torus(160, 80), 1, 0.01),
                           with_holes(with_noise(torus(60, 40), 1, 0.01), 1, 20)}) {
    for (const double ratio : {1.0, 0.5, 0.1}) { // the larger ones are renumbered, and packed
      check_map_of_soup(soup, FaceRatio{ratio});
      check_map_of_soup(soup, FaceRatio{ratio}, RelaxedOrder{});
      check_map_of_soup(soup, FaceRatio{ratio}, Topology::free);
      check_map_of_mesh(soup, FaceRatio{ratio});
      check_map_of_mesh(soup, FaceRatio{ratio}, RelaxedOrder{});
    }
  }
}

TEST_CASE("vertex_to_vertex_map tells of a surface in no order") {
  Soup soup = with_noise(torus(160, 80), 1, 0.01); // the engine renumbers it
  std::vector<std::uint32_t> place(soup.points.size());
  for (std::uint32_t v = 0; v < place.size(); ++v)
    place[v] = static_cast<std::uint32_t>(v * std::uint64_t{7919} % place.size());
  Soup mixed{std::vector<Position>(place.size()), soup.triangles};
  for (std::size_t v = 0; v < place.size(); ++v)
    mixed.points[place[v]] = soup.points[v];
  for (auto& triangle : mixed.triangles)
    for (auto& v : triangle)
      v = place[v];
  check_map_of_soup(mixed, FaceRatio{0.1});
  check_map_of_soup(mixed, FaceRatio{0.1}, RelaxedOrder{});
  check_map_of_mesh(mixed, FaceRatio{0.1});
}

TEST_CASE("A vertex without a face has vanished") {
  Soup soup = sphere(2);
  soup.points.insert(soup.points.begin(), Position{{9, 9, 9}});
  for (auto& triangle : soup.triangles)
    for (auto& v : triangle)
      ++v;
  PointSoup points(soup);
  std::vector<std::size_t> images(soup.points.size(), 12345);
  simplify(points.points, points.triangles, FaceRatio{1},
           parameters::vertex_to_vertex_map(CGAL::make_property_map(images)));
  CHECK(images[0] == parameters::vanished);
  for (std::size_t v = 1; v < images.size(); ++v)
    CHECK(images[v] == v - 1);

  Mesh mesh = make_mesh(soup);
  const auto of_mesh = mesh.add_property_map<Mesh::Vertex_index, Mesh::Vertex_index>("image").first;
  simplify(mesh, FaceRatio{1}, parameters::vertex_to_vertex_map(of_mesh));
  CHECK(of_mesh[Mesh::Vertex_index(0)] == Mesh::null_vertex());
  CHECK(of_mesh[Mesh::Vertex_index(5)] == Mesh::Vertex_index(5));
}

// --- What became of each face --------------------------------------------------------------------

namespace {

// Is each triangle of the result the one of the input that the map names, by what its vertices have
// become?
template <class... Arguments>
void check_faces_of_soup(const Soup& input, const Arguments&... arguments) {
  PointSoup soup(input);
  std::vector<std::size_t> vertex(input.points.size()), face(input.triangles.size(), 12345);
  simplify(soup.points, soup.triangles, arguments...,
           parameters::face_to_face_map(
               CGAL::make_property_map(face),
               parameters::vertex_to_vertex_map(CGAL::make_property_map(vertex))));
  std::size_t left = 0;
  for (std::size_t f = 0; f < face.size(); ++f) {
    if (face[f] == parameters::vanished)
      continue;
    ++left;
    REQUIRE(face[f] < soup.triangles.size());
    for (std::size_t i = 0; i < 3; ++i)
      REQUIRE(soup.triangles[face[f]][i] == vertex[input.triangles[f][i]]);
  }
  CHECK(left == soup.triangles.size());
  CHECK(std::set<std::size_t>(face.begin(), face.end()).size() == left + (left < face.size()));
}

} // namespace

TEST_CASE("face_to_face_map tells which triangle of a soup each triangle has become") {
  const Soup soup = with_holes(with_noise(torus(60, 40), 1, 0.01), 1, 20);
  check_faces_of_soup(soup, FaceRatio{1});
  check_faces_of_soup(soup, FaceRatio{0.1});
  check_faces_of_soup(soup, FaceRatio{0.1}, RelaxedOrder{});
  check_faces_of_soup(soup, FaceRatio{0.1}, Topology::free);
}

TEST_CASE("face_to_face_map maps faces of a mesh that are left to themselves, others to none") {
  using Face = Mesh::Face_index;
  Mesh mesh = make_mesh(with_noise(torus(60, 40), 1, 0.01));
  const std::size_t before = mesh.number_of_faces();
  std::map<Face, Face> becomes;
  simplify(mesh, FaceRatio{0.1},
           parameters::face_to_face_map(boost::make_assoc_property_map(becomes)));
  CHECK(becomes.size() == before);
  std::size_t left = 0;
  for (const auto& [face, now] : becomes) {
    CHECK((now == face || now == Mesh::null_face()));
    CHECK((now == face) == !mesh.is_removed(face));
    left += now == face;
  }
  CHECK(left == mesh.number_of_faces());

  Mesh other = make_mesh(with_noise(torus(60, 40), 1, 0.01)); // CGAL has this name as well
  std::map<Face, Face> by_cgals_name;
  simplify(other, FaceRatio{0.1},
           CGAL::parameters::face_to_face_map(boost::make_assoc_property_map(by_cgals_name)));
  CHECK(by_cgals_name == becomes);
}

// --- Attribute maps ------------------------------------------------------------------------------

TEST_CASE("Attributes with too few components are refused before anything is changed") {
  PointSoup soup(sphere(2));
  const PointSoup before = soup;
  std::vector<std::vector<double>> values(soup.points.size(), std::vector<double>(3));
  values[7].pop_back();
  const auto map = parameters::vertex_attribute_map(CGAL::make_property_map(values));
  CHECK_THROWS_WITH(simplify(soup.points, soup.triangles, AttributeQuadric<3>{}, map),
                    Catch::Contains("2 components of 3"));
  CHECK(soup.points == before.points);
  CHECK(soup.triangles == before.triangles);
  CHECK(simplify(soup.points, soup.triangles, AttributeQuadric<2>{}, map).contractions > 0);
}

TEST_CASE("Attributes may have more components than the cost reads") {
  PointSoup soup(sphere(2));
  std::vector<std::array<float, 4>> values(soup.points.size(), {1, 2, 3, 4});
  simplify(soup.points, soup.triangles, AttributeQuadric<3>{},
           parameters::vertex_attribute_map(CGAL::make_property_map(values)));
  CHECK(values.front()[3] == 4);
}

TEST_CASE("CGAL's names of the graph are allowed where nothing reads them") {
  Mesh mesh = make_mesh(sphere(2));
  const auto indices = get(boost::vertex_index, mesh);
  simplify(mesh, CGAL::parameters::geom_traits(Kernel())
                     .vertex_index_map(indices)
                     .face_index_map(get(boost::face_index, mesh))
                     .vertex_point_map(get(CGAL::vertex_point, mesh)));
  simplify(mesh, CGAL::parameters::default_values());
  CHECK(mesh.number_of_faces() < 128);
}

// --- Chains --------------------------------------------------------------------------------------

TEST_CASE(
    "Each of our names can follow each other one, and CGAL's stand anywhere after the first") {
  namespace np = CGAL::internal_np;
  using CGAL::parameters::get_parameter;
  const auto check = [](const auto& named) {
    CHECK(get_parameter(named, parameters::edge_is_crease) == 1);
    CHECK(get_parameter(named, parameters::face_is_selected) == 2);
    CHECK(get_parameter(named, parameters::vertex_tolerance) == 3);
    CHECK(get_parameter(named, parameters::vertex_is_shared) == 4);
    CHECK(get_parameter(named, parameters::edge_is_boundary) == 5);
    CHECK(get_parameter(named, parameters::boundary_edges_tag) == 6);
    CHECK(get_parameter(named, parameters::bounding_box_tag).xmax() == 7);
    CHECK(get_parameter(named, parameters::vertex_attribute) == 8);
    CHECK(get_parameter(named, parameters::vertex_quadric) == 9);
    CHECK(get_parameter(named, parameters::vertex_importance) == 10);
    CHECK(get_parameter(named, parameters::vertex_to_vertex) == 11);
    CHECK(get_parameter(named, parameters::duplicate_output) == 12);
    CHECK(get_parameter(named, parameters::face_to_face) == 14);
    CHECK(get_parameter(named, np::vertex_point) == 13);
  };
  using namespace parameters;
  check(edge_is_crease_map(1)
            .face_is_selected_map(2)
            .vertex_tolerance_map(3)
            .vertex_is_shared_map(4)
            .edge_is_boundary_map(5)
            .boundary_edges(6)
            .bounding_box({0, 0, 0, 7, 7, 7})
            .vertex_attribute_map(8)
            .vertex_quadric_map(9)
            .vertex_importance_map(10)
            .vertex_to_vertex_map(11)
            .duplicate_output_iterator(12)
            .face_to_face_map(14)
            .vertex_point_map(13));
  check(edge_is_crease_map(1)
            .vertex_point_map(13)
            .face_is_selected_map(2)
            .face_to_face_map(14)
            .vertex_tolerance_map(3)
            .vertex_is_shared_map(4)
            .edge_is_boundary_map(5)
            .vertex_to_vertex_map(11)
            .boundary_edges(6)
            .bounding_box({0, 0, 0, 7, 7, 7})
            .vertex_attribute_map(8)
            .vertex_quadric_map(9)
            .vertex_importance_map(10)
            .duplicate_output_iterator(12));
  check(duplicate_output_iterator(12, vertex_to_vertex_map(11)
                                          .face_to_face_map(14)
                                          .vertex_importance_map(10)
                                          .vertex_quadric_map(9)
                                          .vertex_attribute_map(8)
                                          .bounding_box({0, 0, 0, 7, 7, 7})
                                          .boundary_edges(6)
                                          .edge_is_boundary_map(5)
                                          .vertex_is_shared_map(4)
                                          .vertex_tolerance_map(3)
                                          .face_is_selected_map(2)
                                          .edge_is_crease_map(1)
                                          .vertex_point_map(13)));
}

TEST_CASE("A call reads all of a chain, whether it ends with our names or with CGAL's") {
  const Soup input = sphere(3);
  const std::vector<double> importance = [&] {
    std::vector<double> values;
    for (const Position& p : input.points)
      values.push_back(p[2] > 0 ? 8 : 1);
    return values;
  }();
  std::vector<bool> fixed(input.points.size());
  std::fill(fixed.begin(), fixed.begin() + 40, true);
  const auto by_index = [](const auto& values) {
    return boost::make_function_property_map<std::size_t>(
        [&values](std::size_t v) { return values[v]; });
  };
  const auto run = [&](const auto& named_of) {
    PointSoup soup(input);
    std::vector<std::size_t> image(input.points.size());
    simplify(soup.points, soup.triangles, FaceCount{200}, named_of(CGAL::make_property_map(image)));
    return std::pair(soup.points, image);
  };
  using CGAL::parameters::vertex_is_constrained_map;
  const auto by_arguments = run([&](const auto& image) {
    return parameters::vertex_to_vertex_map(
        image, parameters::vertex_importance_map(by_index(importance),
                                                 vertex_is_constrained_map(by_index(fixed))));
  });
  const auto ends_with_cgals = run([&](const auto& image) {
    return parameters::vertex_to_vertex_map(image)
        .vertex_importance_map(by_index(importance))
        .vertex_is_constrained_map(by_index(fixed));
  });
  CHECK(ends_with_cgals == by_arguments);
  CHECK(run([&](const auto& image) { return parameters::vertex_to_vertex_map(image); }) !=
        by_arguments);
}
