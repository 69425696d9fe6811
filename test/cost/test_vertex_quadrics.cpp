// The named parameter vertex_quadric_map: what the vertices that are left remember.
#include "meshes.h"
#include "soups.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Soup;
using Form = QuadricForm<3>;
using QuadricMap = Mesh::Property_map<Mesh::Vertex_index, Form>;

QuadricMap quadrics(Mesh& mesh) {
  return mesh.add_property_map<Mesh::Vertex_index, Form>("v:quadric").first;
}

// The plane quadrics of the faces at a vertex, about it, and the sum of the areas.
struct Expected {
  Form sum;
  double weight = 0;

  Expected(const Soup& soup, std::uint32_t v) {
    for (const auto& t : soup.triangles)
      if (std::find(t.begin(), t.end(), v) != t.end()) {
        const auto& p = soup.points;
        Form plane = Quadric{}.face(p[t[0]], p[t[1]], p[t[2]]);
        plane.move_origin(p[v] - p[t[0]]);
        sum += plane;
        weight += std::sqrt(squared_length(double_area_vector(p[t[0]], p[t[1]], p[t[2]]))) / 2;
      }
  }
};

const std::array<test::Position, 4> displacements = {
    {{{0, 0, 0}}, {{0.1, 0.02, -0.3}}, {{-0.2, 0.4, 0.05}}, {{0.01, -0.3, 0.2}}}};

const auto nothing = [](const Status&) { return true; };

} // namespace

TEST_CASE("A vertex that was not contracted remembers its own faces, in the mesh's unit") {
  const double unit = GENERATE(1.0, 1e-3, 12345.0);
  const Soup soup = test::mapped(test::random_closed(2), [=](const auto& p) { return unit * p; });
  Mesh mesh = test::make_mesh(soup);
  const QuadricMap map = quadrics(mesh);
  simplify(mesh, nothing, parameters::vertex_quadric_map(map));
  for (const auto v : mesh.vertices()) {
    const Expected expected(soup, v);
    for (const test::Position& x : displacements)
      REQUIRE(map[v](unit * x) ==
              Approx(expected.sum(unit * x) / expected.weight).margin(1e-8 * unit * unit));
  }
}

TEST_CASE("After a contraction a vertex remembers what both of its ends did") {
  const Soup soup = test::random_closed(3);
  Mesh mesh = test::make_mesh(soup);
  const QuadricMap map = quadrics(mesh);
  const auto one = [](const Status& status) { return status.contractions == 1; };
  const Report report = simplify(mesh, one, parameters::vertex_quadric_map(map));
  REQUIRE(report.contractions == 1);
  std::uint32_t gone = 0, kept = 0;
  for (std::uint32_t v = 0; v < soup.points.size(); ++v)
    if (mesh.is_removed(Mesh::Vertex_index(v)))
      gone = v;
    else if (test::to_position(mesh.point(Mesh::Vertex_index(v))) != soup.points[v])
      kept = v;
  const Expected first(soup, kept), second(soup, gone);
  const test::Position place = test::to_position(mesh.point(Mesh::Vertex_index(kept)));
  const Form& form = map[Mesh::Vertex_index(kept)];
  for (const test::Position& x : displacements)
    REQUIRE(form(x) == Approx((first.sum(place + x - soup.points[kept]) +
                               second.sum(place + x - soup.points[gone])) /
                              (first.weight + second.weight))
                           .margin(1e-8));
  CHECK(std::sqrt(form({})) == Approx(report.error).epsilon(1e-5));
}

TEST_CASE("No vertex has an error above that of the report") {
  Mesh mesh = test::make_mesh(test::random_with_boundaries(4));
  const QuadricMap map = quadrics(mesh);
  const Report report = simplify(mesh, FaceRatio{0.3}, parameters::vertex_quadric_map(map));
  double largest = 0;
  for (const auto v : mesh.vertices())
    largest = std::max(largest, map[v]({}));
  CHECK(largest > 0);
  CHECK(std::sqrt(largest) <= report.error * (1 + 1e-6));
}

TEST_CASE("The points of a soup have their quadrics at their new indices") {
  const Soup soup = test::random_closed(5);
  Mesh mesh = test::make_mesh(soup);
  const QuadricMap map = quadrics(mesh);
  simplify(mesh, Topology::kept, parameters::vertex_quadric_map(map));
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  for (const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  auto triangles = soup.triangles;
  std::vector<Form> forms(points.size());
  simplify(points, triangles, Topology::kept,
           parameters::vertex_quadric_map(boost::make_iterator_property_map(
               forms.begin(), boost::typed_identity_property_map<std::size_t>())));
  REQUIRE(points.size() == mesh.number_of_vertices());
  std::size_t i = 0;
  for (const auto v : mesh.vertices()) {
    REQUIRE(points[i] == mesh.point(v));
    for (const test::Position& x : displacements)
      REQUIRE(forms[i](x) == map[v](x));
    ++i;
  }
}

TEST_CASE("A vertex that is duplicated has the quadric of its original") {
  Mesh mesh = test::make_mesh(test::random_closed(5));
  const QuadricMap map = quadrics(mesh);
  const Report report = simplify(mesh, Topology::free, parameters::vertex_quadric_map(map));
  REQUIRE(report.duplicated_vertices > 0);
  for (const auto v : mesh.vertices())
    CHECK(map[v].trace() == Approx(1).margin(1e-8));
}

TEST_CASE("The quadric of an attribute is in the attribute's unit") {
  // One attribute, 1000 · x: on the plane z = 0 a displacement along x with 1000 of the attribute
  // stays on the planes, another one does not.
  const Soup soup = test::grid(4, 4);
  Mesh mesh = test::make_mesh(soup);
  const auto heat = mesh.add_property_map<Mesh::Vertex_index, double>("v:heat").first;
  for (const auto v : mesh.vertices())
    heat[v] = 1000 * mesh.point(v).x();
  const auto map = mesh.add_property_map<Mesh::Vertex_index, QuadricForm<4>>("v:quadric4").first;
  simplify(mesh, AttributeQuadric<1>{.boundary_weight = 0}, nothing,
           parameters::vertex_quadric_map(map, parameters::vertex_attribute_map(heat)));
  const double weight = 0.02 * std::sqrt(2.0) / 1000;
  for (const auto v : mesh.vertices()) {
    CHECK(map[v]({{0.25, 0.5, 0, 250}}) == Approx(0).margin(1e-8));
    CHECK(map[v]({{0, 0, 0.5, 0}}) == Approx(0.25));
    // A difference of 250, as far from the slanted plane as its slope lets it be.
    const double slope = 1000 * weight, height = 250 * weight;
    CHECK(map[v]({{0, 0, 0, 250}}) == Approx(height * height / (1 + slope * slope)));
  }
}
