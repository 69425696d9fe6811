// What is left of a mesh keeps its descriptors, its maps and its validity; odd meshes are fine.

#include "meshes.h"
#include "reference.h"

#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <boost/property_map/property_map.hpp>
#include <boost/property_map/vector_property_map.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Point;
using test::Position;
using test::Soup;
using test::Triangle;

// Stops after so many contractions.
auto after(std::size_t contractions) {
  return [contractions](const Status& status) { return status.contractions == contractions; };
}

void require_consistent(const Mesh& mesh, const Report& report) {
  INFO(report);
  REQUIRE(test::is_valid_triangle_mesh(mesh));
  REQUIRE(report.faces_after == mesh.number_of_faces());
  REQUIRE(report.vertices_after == mesh.number_of_vertices());
  REQUIRE(test::is_finite(test::to_soup(mesh)));
  const test::SoupTopology topology = test::topology_of(test::to_soup(mesh));
  REQUIRE_FALSE(topology.has_duplicate_faces);
  REQUIRE_FALSE(topology.has_collapsed_faces);
}

// A mesh of which each element has a map that tells what it was in the beginning.
struct LabelledMesh {
  using Vertex = std::uint32_t;

  explicit LabelledMesh(const Soup& soup)
      : mesh(test::make_mesh(soup)),
        vertex(mesh.add_property_map<Mesh::Vertex_index, Vertex>("v").first),
        ends(mesh.add_property_map<Mesh::Halfedge_index, std::array<Vertex, 2>>("h").first),
        edge(mesh.add_property_map<Mesh::Edge_index, std::set<Vertex>>("e").first),
        face(mesh.add_property_map<Mesh::Face_index, Triangle>("f").first) {
    for (const auto v : mesh.vertices())
      vertex[v] = v;
    for (const auto h : mesh.halfedges())
      ends[h] = {mesh.source(h), mesh.target(h)};
    for (const auto e : mesh.edges())
      edge[e] = {mesh.vertex(e, 0), mesh.vertex(e, 1)};
    for (const auto f : mesh.faces())
      face[f] = corners(f);
  }

  Triangle corners(Mesh::Face_index f) const {
    Triangle t{};
    std::size_t i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      t.at(i++) = vertex[v];
    return t;
  }

  // Every label, taken along by the contractions, is what it labels.
  void require_labels_right(const test::Reference& reference) const {
    const auto merged_vertex = [&](Vertex v) { return reference.image(v); };
    for (const auto v : mesh.vertices())
      REQUIRE(merged_vertex(vertex[v]) == vertex[v]);
    for (const auto h : mesh.halfedges()) {
      REQUIRE(merged_vertex(ends[h][0]) == vertex[mesh.source(h)]);
      REQUIRE(merged_vertex(ends[h][1]) == vertex[mesh.target(h)]);
    }
    for (const auto e : mesh.edges()) {
      std::set<Vertex> images;
      for (const Vertex v : edge[e])
        images.insert(merged_vertex(v));
      REQUIRE(images == std::set{vertex[mesh.vertex(e, 0)], vertex[mesh.vertex(e, 1)]});
    }
    for (const auto f : mesh.faces()) {
      const auto& [a, b, c] = face[f];
      REQUIRE(test::canonical({merged_vertex(a), merged_vertex(b), merged_vertex(c)}) ==
              test::canonical(corners(f)));
    }
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Vertex> vertex;
  Mesh::Property_map<Mesh::Halfedge_index, std::array<Vertex, 2>> ends;
  Mesh::Property_map<Mesh::Edge_index, std::set<Vertex>> edge;
  Mesh::Property_map<Mesh::Face_index, Triangle> face;
};

} // namespace

// --- Descriptors and property maps ---------------------------------------------------------------

TEST_CASE("Property maps on vertices, halfedges, edges and faces stay right") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 8));
  const bool has_boundaries = GENERATE(true, false);
  CAPTURE(seed, has_boundaries);
  const Soup soup = has_boundaries ? test::random_with_boundaries(seed) : test::random_closed(seed);
  test::Reference reference(soup);
  std::size_t done = 0;
  for (const auto contractions : std::array<std::size_t, 6>{0, 1, 2, 10, 30, 50}) {
    CAPTURE(contractions);
    for (; done < contractions && reference.contract_next(); ++done) {
    }
    LabelledMesh labelled(soup);
    const Report report = simplify(labelled.mesh, after(contractions));
    require_consistent(labelled.mesh, report);
    labelled.require_labels_right(reference);
    for (const auto v : labelled.mesh.vertices())
      REQUIRE(labelled.vertex[v] == std::uint32_t{v}); // the descriptor itself

    labelled.mesh.collect_garbage();
    require_consistent(labelled.mesh, report);
    labelled.require_labels_right(reference);
  }
}

TEST_CASE("A border stays a border, with edges that were on it") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 8));
  Mesh mesh = test::make_mesh(test::random_with_boundaries(seed));
  std::set<Mesh::Halfedge_index> was_boundary;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      was_boundary.insert(h);
  simplify(mesh, FaceRatio{0.4});
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      CHECK(was_boundary.contains(h));
}

TEST_CASE("A constrained edge keeps its descriptor, its ends and its values") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 8));
  CAPTURE(seed);
  LabelledMesh labelled(test::random_with_boundaries(seed));
  Mesh& mesh = labelled.mesh;
  const Mesh input = mesh;
  const auto constrained = mesh.add_property_map<Mesh::Edge_index, bool>("c", false).first;
  test::Random random(seed);
  std::set<Mesh::Edge_index> chosen;
  while (chosen.size() < 12)
    chosen.insert(Mesh::Edge_index(random.below(mesh.number_of_edges())));
  for (const auto e : chosen)
    constrained[e] = true;

  simplify(mesh, FaceCount{0}, CGAL::parameters::edge_is_constrained_map(constrained),
           NormalFlip(90, FoldOvers::allowed));
  REQUIRE(4 * mesh.number_of_faces() < 3 * input.number_of_faces());
  REQUIRE(test::is_valid_triangle_mesh(mesh));
  std::set<Mesh::Edge_index> left;
  for (const auto e : mesh.edges())
    if (constrained[e])
      left.insert(e);
  REQUIRE(left == chosen);
  for (const auto e : chosen) {
    const std::set<std::uint32_t> ends{mesh.vertex(e, 0), mesh.vertex(e, 1)};
    CHECK(ends == labelled.edge[e]);
    for (const unsigned i : {0u, 1u})
      CHECK(mesh.point(mesh.vertex(e, i)) == input.point(mesh.vertex(e, i)));
  }
}

TEST_CASE("Of a large mesh out of order, which the engine renumbers, all descriptors stay right") {
  const bool in_passes = GENERATE(false, true);
  LabelledMesh labelled(test::shuffled(test::with_noise(test::grid(90, 90), 1, 1e-3), 1));
  Mesh& mesh = labelled.mesh;
  const Mesh input = mesh;
  const auto constrained = mesh.add_property_map<Mesh::Edge_index, bool>("c", false).first;
  test::Random random(1);
  std::set<Mesh::Edge_index> chosen;
  while (chosen.size() < 100)
    chosen.insert(Mesh::Edge_index(random.below(mesh.number_of_edges())));
  for (const auto e : chosen)
    constrained[e] = true;

  const auto constraints = CGAL::parameters::edge_is_constrained_map(constrained);
  if (in_passes)
    simplify(mesh, FaceRatio{0.2}, EndpointPlacement{}, RelaxedOrder{}, constraints);
  else
    simplify(mesh, FaceRatio{0.2}, EndpointPlacement{}, constraints);
  REQUIRE(mesh.number_of_faces() < input.number_of_faces() / 4);
  REQUIRE(test::is_valid_triangle_mesh(mesh));
  for (const auto e : chosen) {
    REQUIRE_FALSE(mesh.is_removed(e));
    CHECK(std::set<std::uint32_t>{mesh.vertex(e, 0), mesh.vertex(e, 1)} == labelled.edge[e]);
  }
  std::map<std::uint32_t, std::uint32_t> merged_vertex; // what vertices have become part of
  for (const auto v : mesh.vertices()) {
    merged_vertex[v] = v;
    REQUIRE(mesh.point(v) == input.point(v));
  }
  const auto require_image = [&](std::uint32_t v, std::uint32_t now) {
    REQUIRE(merged_vertex.emplace(v, now).first->second == now);
  };
  for (const auto h : mesh.halfedges()) {
    require_image(labelled.ends[h][0], mesh.source(h));
    require_image(labelled.ends[h][1], mesh.target(h));
    if (mesh.is_border(h))
      REQUIRE(input.is_border(h));
  }
  for (const auto f : mesh.faces()) // from the same corner on
    for (std::size_t k = 0; k < 3; ++k)
      require_image(labelled.face[f].at(k), labelled.corners(f).at(k));
}

TEST_CASE("Of a large soup out of order, points and triangles keep theirs") {
  const bool in_passes = GENERATE(false, true);
  const test::PointSoup input(test::shuffled(test::with_noise(test::grid(90, 90), 1, 1e-3), 1));
  test::PointSoup soup = input;
  if (in_passes)
    simplify(soup.points, soup.triangles, FaceRatio{0.6}, EndpointPlacement{}, RelaxedOrder{});
  else
    simplify(soup.points, soup.triangles, FaceRatio{0.6}, EndpointPlacement{});
  REQUIRE(100 * soup.triangles.size() < 61 * input.triangles.size());
  std::vector<std::uint32_t> number; // in the input, of each point
  for (const Point& p : soup.points) {
    const auto first = input.points.begin() + (number.empty() ? 0 : number.back() + 1);
    const auto place = std::find(first, input.points.end(), p);
    REQUIRE(place != input.points.end());
    number.push_back(static_cast<std::uint32_t>(place - input.points.begin()));
  }
  auto triangle = input.triangles.begin(); // of which no corner has changed
  std::size_t unchanged = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    const Triangle before{number[a], number[b], number[c]};
    if (std::find(input.triangles.begin(), input.triangles.end(), before) == input.triangles.end())
      continue;
    triangle = std::find(triangle, input.triangles.end(), before);
    REQUIRE(triangle != input.triangles.end());
    ++unchanged;
  }
  CHECK(unchanged > 1000);
}

TEST_CASE("Where vertices go to an end of their pair, those that are left lie where they were") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 6));
  const auto topology = GENERATE(Topology::kept, Topology::free);
  CAPTURE(seed);
  const Soup soup = test::random_with_boundaries(seed);
  LabelledMesh labelled(soup);
  const Mesh& mesh = labelled.mesh;
  const Report report = simplify(labelled.mesh, EndpointPlacement{}, FaceRatio{0.3}, topology);
  REQUIRE(report.contractions > 10);
  for (const auto v : mesh.vertices()) {
    const bool is_added = v.idx() >= soup.points.size();
    if (!is_added)
      CHECK(labelled.vertex[v] == v.idx());
    CHECK(std::count(soup.points.begin(), soup.points.end(), test::to_position(mesh.point(v))) > 0);
    CHECK((is_added || test::to_position(mesh.point(v)) == soup.points.at(v.idx())));
  }
}

TEST_CASE("Nothing to do changes nothing") {
  const Soup soup = test::random_with_boundaries(3);
  Mesh mesh = test::make_mesh(soup);
  const Report report = simplify(mesh, FaceCount{soup.triangles.size()});
  CHECK(report.contractions == 0);
  CHECK(report.stop == StopReason::target_met);
  CHECK(report.error == 0);
  CHECK_FALSE(mesh.has_garbage());
  CHECK(test::to_soup(mesh).points == soup.points);
  CHECK(test::is_same_surface(test::to_soup(mesh), soup, 0));
}

// --- Odd meshes ----------------------------------------------------------------------------------

TEST_CASE("An empty mesh stays empty") {
  Mesh mesh;
  const Report report = simplify(mesh);
  require_consistent(mesh, report);
  CHECK(report.stop == StopReason::target_met);
  CHECK(report.faces_after == 0);
}

TEST_CASE("One triangle cannot be simplified") {
  Mesh mesh = test::make_mesh(test::triangle());
  const Report report = simplify(mesh, FaceCount{0});
  require_consistent(mesh, report);
  CHECK(report.stop == StopReason::all_pairs_rejected);
  CHECK(mesh.number_of_faces() == 1);
}

TEST_CASE("Two triangles become one") {
  Mesh mesh = test::make_mesh(test::two_triangles());
  const Report report = simplify(mesh, FaceCount{0});
  require_consistent(mesh, report);
  CHECK(mesh.number_of_faces() == 1);
  CHECK(mesh.number_of_edges() == 3);
}

TEST_CASE("A tetrahedron stays, and closed surfaces end as one") {
  Mesh mesh = test::make_mesh(test::tetrahedron());
  Report report = simplify(mesh, FaceCount{0});
  require_consistent(mesh, report);
  CHECK(mesh.number_of_faces() == 4);
  CHECK(report.stop == StopReason::all_pairs_rejected);

  mesh = test::make_mesh(test::sphere(3));
  report = simplify(mesh, FaceCount{0});
  require_consistent(mesh, report);
  CHECK(mesh.number_of_faces() == 4);
}

TEST_CASE("Isolated vertices go") {
  Soup soup = test::sphere(2);
  const std::size_t vertices = soup.points.size();
  for (int i = 0; i < 5; ++i)
    soup.points.push_back({{double(i), 5, 5}});
  Mesh mesh = test::make_mesh(soup);
  Report report = simplify(mesh, FaceRatio{1});
  require_consistent(mesh, report);
  CHECK(mesh.number_of_vertices() == vertices);
  CHECK(report.vertices_before == vertices + 5);

  Mesh points;
  points.add_vertex(Point(1, 2, 3));
  report = simplify(points);
  require_consistent(points, report);
  CHECK(points.number_of_vertices() == 0);
}

// Of points on a line, in the order of their first coordinates.
std::pair<Position, Position> ends_of(const std::vector<Position>& points) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const Position& p, const Position& q) { return p[0] < q[0]; });
  return {*low, *high};
}

TEST_CASE("Faces without area are simplified as any others") {
  const auto flatten = GENERATE(0, 1, 2);
  CAPTURE(flatten);
  const auto f = [&](const Position& p) {
    return flatten == 0   ? Position{{1, 2, 3}}               // all in one point
           : flatten == 1 ? Position{{p[0], 2 * p[0], 0}}     // all in one line
                          : Position{{p[0], p[0], p[0] / 3}}; // with rounding
  };
  for (const Soup& soup : {test::sphere(2), test::grid(6, 6), test::torus(8, 8)}) {
    const Soup flat = test::mapped(soup, f);
    Mesh mesh = test::make_mesh(flat);
    const Report report = simplify(mesh, FaceRatio{0.25});
    require_consistent(mesh, report);
    CHECK(report.stop == StopReason::target_met);
    // No plane is left; but the ends of a line recede, and the error tells how far at least.
    const Soup result = test::to_soup(mesh);
    const auto [low, high] = ends_of(flat.points);
    const auto [first, last] = ends_of(result.points);
    const double receded =
        std::sqrt(std::max(squared_distance(low, first), squared_distance(high, last)));
    CHECK(report.error > 0.999 * receded - 1e-12);
    CHECK(report.error <= std::sqrt(squared_distance(low, high)) + 1e-12);
    CHECK(is_same_topology(test::topology_of(flat), test::topology_of(result)));
  }
}

TEST_CASE("Some points in one place are no obstacle") {
  Soup soup = test::random_closed(1);
  for (std::size_t i = 0; i < soup.points.size(); i += 3)
    soup.points[i] = soup.points[i / 2];
  Mesh mesh = test::make_mesh(soup);
  const Report report = simplify(mesh, FaceRatio{0.5});
  require_consistent(mesh, report);
}

TEST_CASE("A vertex between two sheets stays one vertex") {
  // Two grids that only meet in the corner 0 of both.
  Soup second = test::with_noise(test::grid(5, 5), 1, 0.02);
  for (Position& p : second.points)
    p *= -1;
  const Soup first = test::with_noise(test::grid(5, 5), 2, 0.02);
  Soup soup = test::joined(first, second);
  const auto corner = static_cast<std::uint32_t>(first.points.size());
  for (Triangle& t : soup.triangles)
    for (std::uint32_t& v : t)
      v = v == corner ? 0 : v > corner ? v - 1 : v;
  soup.points.erase(soup.points.begin() + corner);

  const Mesh input = test::make_mesh(soup);
  REQUIRE(CGAL::is_valid_polygon_mesh(input));
  for (double ratio : {0.9, 0.5, 0.2, 0.0}) {
    Mesh mesh = input;
    const Report report = simplify(mesh, FaceRatio{ratio});
    require_consistent(mesh, report);
    CHECK(report.components_after == 1);
    CHECK(report.non_manifold_vertices == 1);
    CHECK(report.duplicated_vertices == 0);
    const test::SoupTopology topology = test::topology_of(test::to_soup(mesh));
    CHECK(topology.components == 1);
    CHECK_FALSE(topology.is_manifold);
    CHECK(topology.euler() == 1);
  }
}

TEST_CASE("Garbage from before the call does no harm") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 6));
  const Soup soup = test::random_closed(seed);
  Mesh with_garbage = test::make_mesh(soup);
  test::Random random(seed);
  for (int i = 0; i < 15; ++i) {
    const Mesh::Face_index f(random.below(soup.triangles.size()));
    if (!with_garbage.is_removed(f))
      CGAL::Euler::remove_face(with_garbage.halfedge(f), with_garbage);
  }
  REQUIRE(with_garbage.has_garbage());
  REQUIRE(CGAL::is_valid_polygon_mesh(with_garbage));
  Mesh without = with_garbage;
  without.collect_garbage();

  const Report report = simplify(with_garbage, FaceCount{40});
  simplify(without, FaceCount{40});
  require_consistent(with_garbage, report);
  CHECK(test::is_same_surface(test::to_soup(with_garbage), test::to_soup(without), 1e-12));
  with_garbage.collect_garbage();
  require_consistent(with_garbage, report);
}

TEST_CASE("Where holes close, no edge is left to two") {
  for (const char* name : {"elephant-with-holes", "mech-holes-shark", "nefertiti"}) {
    const Mesh input = test::read_model(name);
    for (double ratio : {0.5, 0.2, 0.1, 0.05}) {
      CAPTURE(name, ratio);
      Mesh mesh = input;
      const Report report = simplify(mesh, FaceRatio{ratio}, Topology::free);
      require_consistent(mesh, report);
    }
  }
}

TEST_CASE("Where topology is free, constrained edges are left, and to one face a side each") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 20));
  CAPTURE(seed);
  Mesh mesh = test::make_mesh(test::random_with_boundaries(seed));
  test::Random random(seed);
  const auto is_constrained =
      mesh.add_property_map<Mesh::Edge_index, bool>("e:constrained", false).first;
  std::vector<std::pair<Mesh::Edge_index, std::set<Point>>> constrained;
  for (const auto e : mesh.edges())
    if (random.below(12) == 0) {
      is_constrained[e] = true;
      constrained.push_back({e, {mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))}});
    }
  const Report report = simplify(mesh, FaceCount{4}, Topology::free,
                                 CGAL::parameters::edge_is_constrained_map(is_constrained));
  require_consistent(mesh, report);
  for (const auto& [e, ends] : constrained) {
    REQUIRE_FALSE(mesh.is_removed(e));
    REQUIRE(ends == std::set<Point>{mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))});
  }
}

TEST_CASE("A mesh can be simplified again and again, and refined in between") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 6));
  CAPTURE(seed);
  Mesh mesh = test::make_mesh(test::random_with_boundaries(seed));
  while (true) {
    const std::size_t target = mesh.number_of_faces() - 7;
    const Report report = simplify(mesh, FaceCount{target});
    require_consistent(mesh, report);
    if (!is_target_reached(report.stop))
      break;
    REQUIRE(mesh.number_of_faces() <= target);
    REQUIRE(mesh.number_of_faces() + 1 >= target); // an edge inside may be all that is left to take
    // A face is split, on top of the garbage that is there.
    const auto h = halfedge(*mesh.faces().begin(), mesh);
    const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)),
                r = mesh.point(mesh.target(mesh.next(h)));
    const auto center = CGAL::Euler::add_center_vertex(h, mesh);
    mesh.point(mesh.target(center)) = CGAL::centroid(p, q, r);
    REQUIRE(test::is_valid_triangle_mesh(mesh));
  }
  CHECK(3 * mesh.number_of_faces() <= 2 * test::random_with_boundaries(seed).triangles.size());
}

// --- The user's own maps -------------------------------------------------------------------------

TEST_CASE("Positions of the user's own are read and written, and the mesh's are left alone") {
  const Soup soup = test::random_with_boundaries(4);
  Mesh expected = test::make_mesh(soup);
  simplify(expected, FaceCount{40});

  Mesh mesh = test::make_mesh(soup);
  const Point nowhere(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  std::map<Mesh::Vertex_index, Point> positions;
  for (const auto v : mesh.vertices()) {
    positions[v] = mesh.point(v);
    mesh.point(v) = nowhere;
  }
  simplify(mesh, FaceCount{40},
           CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(positions)));
  for (const auto v : mesh.vertices()) {
    CHECK(mesh.point(v).x() != mesh.point(v).x());
    mesh.point(v) = positions.at(v);
  }
  CHECK(test::is_same_surface(test::to_soup(mesh), test::to_soup(expected), 0));
  for (const auto v : expected.vertices())
    CHECK(positions.at(v) == expected.point(v));
}

TEST_CASE("Points of a constant mesh far from the origin, tiny or huge, are no special case") {
  const Soup soup = test::random_closed(0);
  Mesh expected = test::make_mesh(soup);
  simplify(expected, FaceCount{40});
  for (double unit : {0x1p-1000, 0x1p-300, 0x1p-20, 0x1p40, 0x1p900}) {
    CAPTURE(unit);
    Mesh mesh = test::make_mesh(test::mapped(soup, [&](const Position& p) { return unit * p; }));
    const Report report = simplify(mesh, FaceCount{40});
    require_consistent(mesh, report);
    for (const auto v : expected.vertices()) { // exactly: a unit that is a power of two
      REQUIRE_FALSE(mesh.is_removed(v));
      CHECK(test::to_position(mesh.point(v)) == unit * test::to_position(expected.point(v)));
    }
  }
}
