// Input that makes no sense is refused with a message that says where, and if anything throws, the
// surface is as it was.

#include "meshes.h"
#include "snapshot.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Polyhedron_3.h>
#include <boost/property_map/property_map.hpp>
#include <quadrille/attribute_quadric.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/filters.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using Catch::Contains;
using test::Mesh;
using test::Point;
using test::Position;
using test::snapshot;
using test::Snapshot;
using test::Soup;
using Polyhedron = CGAL::Polyhedron_3<test::Kernel>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Triangles>
struct PointSoup {
  std::vector<Point> points;
  Triangles triangles;
};

using Triangles = std::vector<std::array<std::size_t, 3>>;

PointSoup<Triangles> point_soup(const Soup& soup) {
  PointSoup<Triangles> result;
  result.points = test::points_of(soup);
  for (const auto& [a, b, c] : soup.triangles)
    result.triangles.push_back({a, b, c});
  return result;
}

template <class Surface>
Surface make(const Soup& soup) {
  return test::make_mesh<Surface>(soup);
}
template <>
PointSoup<Triangles> make(const Soup& soup) {
  return point_soup(soup);
}

// One name for meshes and soups.
template <class Cost = internal::NotGiven, class M, class... Arguments>
Report run(M& mesh, const Arguments&... arguments) {
  return simplify<Cost>(mesh, arguments...);
}
template <class Cost = internal::NotGiven, class T, class... Arguments>
Report run(PointSoup<T>& soup, const Arguments&... arguments) {
  return simplify<Cost>(soup.points, soup.triangles, arguments...);
}

template <class Surface, class... Arguments>
void require_rejected(const Surface& input, const std::string& message,
                      const Arguments&... arguments) {
  Surface surface = input;
  CHECK_THROWS_AS(run(surface, arguments...), std::invalid_argument);
  CHECK_THROWS_WITH(run(surface, arguments...), Contains(message));
  CHECK((snapshot(surface) == snapshot(input)));
}

template <class M>
M cube_with_square() { // of which face 7 is a square
  M mesh = test::make_mesh<M>(test::cube());
  auto f = faces(mesh).begin();
  std::advance(f, 7);
  auto h = halfedge(*f, mesh);
  while (squared_distance(get(get(CGAL::vertex_point, mesh), source(h, mesh)),
                          get(get(CGAL::vertex_point, mesh), target(h, mesh))) < 1.5)
    h = next(h, mesh);
  CGAL::Euler::join_face(h, mesh);
  return mesh;
}

} // namespace

// --- Surfaces that make no sense -----------------------------------------------------------------

TEMPLATE_TEST_CASE("A face that is not a triangle is named, with the remedy", "", Mesh,
                   Polyhedron) {
  const auto mesh = cube_with_square<TestType>();
  REQUIRE_FALSE(CGAL::is_triangle_mesh(mesh));
  std::size_t number = 0;
  for (const auto f : faces(mesh)) {
    if (!CGAL::is_triangle(halfedge(f, mesh), mesh))
      break;
    ++number;
  }
  require_rejected(mesh, "face " + std::to_string(number) + " is not a triangle");
  require_rejected(mesh, "CGAL::Polygon_mesh_processing::triangulate_faces");
}

TEMPLATE_TEST_CASE("A vertex that is not finite is named", "", Mesh, Polyhedron) {
  const auto input = test::make_mesh<TestType>(test::sphere(1));
  for (double value : {not_a_number, infinity, -infinity})
    for (const auto at : std::array<std::size_t, 3>{0, 7, 17})
      for (std::size_t axis = 0; axis < 3; ++axis) {
        TestType mesh = input;
        auto v = vertices(mesh).begin();
        std::advance(v, at);
        Position p = test::to_position(get(get(CGAL::vertex_point, mesh), *v));
        p[axis] = value;
        put(get(CGAL::vertex_point, mesh), *v, test::to_point<Point>(p));
        require_rejected(mesh, "vertex " + std::to_string(at) + " is not finite");
      }
}

TEST_CASE("Soups are refused likewise") {
  const auto good = point_soup(test::sphere(1));
  auto soup = good;
  soup.points[11] = Point(0, not_a_number, 0);
  require_rejected(soup, "vertex 11 is not finite");
  soup = good;
  soup.triangles[5][2] = 18;
  require_rejected(soup, "face 5 names point 18 of 18");
  soup.triangles[5][2] = std::numeric_limits<std::size_t>::max();
  require_rejected(soup, "face 5 names point 18446744073709551615 of 18");
  soup.triangles[5][2] = std::size_t{1} << 32;
  require_rejected(soup, "face 5 names point 4294967296 of 18");

  PointSoup<std::vector<std::array<int, 3>>> with_signs{good.points, {{0, 1, 2}, {0, -1, 2}}};
  require_rejected(with_signs, "face 1 names point -1 of 18");

  PointSoup<std::vector<std::vector<int>>> polygons{good.points, {{0, 1, 2}, {0, 1, 2, 3}}};
  require_rejected(polygons, "face 1 is not a triangle");
  require_rejected(polygons, "CGAL::Polygon_mesh_processing::triangulate_polygons");
  polygons.triangles[1] = {0, 1};
  require_rejected(polygons, "face 1 is not a triangle");
  polygons.triangles[1] = {};
  require_rejected(polygons, "face 1 is not a triangle");
}

TEST_CASE("An attribute that is not finite is named") {
  Mesh mesh = test::make_mesh(test::sphere(1));
  const auto numbers = mesh.add_property_map<Mesh::Vertex_index, std::array<double, 2>>("n").first;
  numbers[Mesh::Vertex_index(3)] = {0, not_a_number};
  CHECK_THROWS_WITH(run<AttributeQuadric<2>>(mesh, parameters::vertex_attribute_map(numbers)),
                    Contains("vertex 3 has an attribute that is not finite"));
}

// --- Policies that make no sense -----------------------------------------------------------------

TEST_CASE("Policies that make no sense are refused") {
  const Mesh mesh = test::make_mesh(test::sphere(1));
  for (double ratio : {-0.1, 1.1, not_a_number, infinity}) {
    require_rejected(mesh, "quadrille::FaceRatio: the ratio", FaceRatio{ratio});
    require_rejected(mesh, "quadrille::FaceRatio", AnyOf{FaceCount{3}, AllOf{FaceRatio{ratio}}});
  }
  for (double distance : {-1.0, -infinity, not_a_number}) {
    require_rejected(mesh, "quadrille::DistanceLimit", DistanceLimit(distance));
    require_rejected(mesh, "quadrille::DistanceLimit", DistanceLimit::relative(distance));
    require_rejected(mesh, "quadrille::ThresholdPairs", ThresholdPairs(distance));
    require_rejected(mesh, "quadrille::ThresholdPairs", ThresholdPairs::relative(distance));
  }
  require_rejected(mesh, "quadrille::ThresholdPairs", ThresholdPairs(infinity));
  for (double weight : {-1.0, not_a_number, infinity}) {
    require_rejected(mesh, "boundary_weight", Quadric{.boundary_weight = weight});
    require_rejected(mesh, "crease_weight", Quadric{.crease_weight = weight});
    require_rejected(mesh, "boundary_weight", MemorylessQuadric{.boundary_weight = weight});
    const auto thin_features = [&](double ThinFeatureQuadric::*member) {
      ThinFeatureQuadric cost;
      cost.*member = weight;
      return cost;
    };
    require_rejected(mesh, "boundary_weight", thin_features(&ThinFeatureQuadric::boundary_weight));
    require_rejected(mesh, "quadrille::ThinFeatureQuadric: loss_weight",
                     thin_features(&ThinFeatureQuadric::loss_weight));
    require_rejected(mesh, "quadrille::ThinFeatureQuadric: loss_tolerance",
                     thin_features(&ThinFeatureQuadric::loss_tolerance));
  }
  for (double degrees : {-1.0, 181.0, not_a_number})
    require_rejected(mesh, "crease_degrees", Quadric{.crease_degrees = degrees});
}

TEST_CASE("Weights of attributes that make no sense are refused") {
  using Cost = AttributeQuadric<1>;
  Mesh mesh = test::make_mesh(test::sphere(1));
  const auto numbers = mesh.add_property_map<Mesh::Vertex_index, double>("n").first;
  const auto require_rejected_cost = [&](const Cost& cost, const std::string& message) {
    CHECK_THROWS_AS(simplify(mesh, cost, parameters::vertex_attribute_map(numbers)),
                    std::invalid_argument);
    CHECK_THROWS_WITH(simplify(mesh, cost, parameters::vertex_attribute_map(numbers)),
                      Contains(message));
  };
  for (double value : {-1.0, 0.0, not_a_number, infinity}) {
    require_rejected_cost(Cost{.importance = value}, "importance");
    require_rejected_cost(Cost{.weights = Vector<1>{{value}}}, "weight");
  }
  for (double value : {-1.0, not_a_number, infinity})
    require_rejected_cost(Cost{.boundary_weight = value}, "boundary_weight");
}

TEST_CASE("Filters that make no sense are refused") {
  for (double degrees : {-90.0, 0.0, 180.1, not_a_number, infinity})
    CHECK_THROWS_AS(NormalFlip(degrees), std::invalid_argument);
  CHECK_THROWS_AS(HighestDegree(2), std::invalid_argument);
  for (double degrees : {-1.0, 61.0, not_a_number})
    CHECK_THROWS_AS(SmallestAngle(degrees), std::invalid_argument);
  for (double length : {0.0, -1.0, not_a_number}) {
    CHECK_THROWS_AS(LongestEdge(length), std::invalid_argument);
    if (length != 0)
      CHECK_THROWS_AS(ShortestEdge{length}.validate(), std::invalid_argument);
  }
  for (double seconds : {-1.0, not_a_number})
    CHECK_THROWS_AS(TimeBudget(seconds), std::invalid_argument);
  for (double z : {0.0, infinity, not_a_number})
    CHECK_THROWS_WITH(HeightField({{0, 0, z}}), Catch::Contains("HeightField: the direction"));
}

// --- What throws in between ----------------------------------------------------------------------

namespace {

struct Accident {};

// Counts down to an accident, once.
class Fuse {
public:
  explicit Fuse(std::size_t length) : left_(length) {}
  void burn() {
    if (left_ > 0 && --left_ == 0)
      throw Accident();
  }

private:
  std::size_t left_;
};

// A property map of which each access burns the fuse.
template <class Map>
struct Fused {
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  Map map;
  Fuse* fuse;

  friend value_type get(const Fused& fused, const key_type& key) {
    fused.fuse->burn();
    return get(fused.map, key);
  }
  template <class Key> // constant or not, as the map wants it
  friend void put(const Fused& fused, Key& key, const value_type& value) {
    fused.fuse->burn();
    put(fused.map, key, value);
  }
};
template <class Map>
Fused(Map, Fuse*) -> Fused<Map>;

// Calls simplify(fuse) with longer and longer fuses, beyond `each` in larger steps, until one does
// not burn down. Returns the length of the longest that did.
template <class Simplify, class Check>
std::size_t survive_accidents(Simplify simplify, Check check,
                              std::size_t each = std::numeric_limits<std::size_t>::max()) {
  std::size_t longest = 0;
  for (std::size_t length = 1;; length += 1 + (length < each ? 0 : length / 16)) {
    Fuse fuse(length);
    try {
      simplify(&fuse);
      return longest;
    } catch (const Accident&) {
      CAPTURE(length);
      check();
      longest = length;
    }
  }
}

// The same with a surface that must be as it was after each accident: calls simplify(surface,
// fuse).
template <class Surface, class Simplify>
std::size_t survive_accidents_of(const Surface& input, Simplify simplify, std::size_t each = 400) {
  Surface surface = input;
  const Snapshot before = snapshot(surface);
  return survive_accidents([&](Fuse* fuse) { simplify(surface, fuse); },
                           [&] {
                             REQUIRE((snapshot(surface) == before));
                             REQUIRE(test::is_sound(surface));
                           },
                           each);
}

Soup plate() {
  return test::with_noise(test::plate_with_holes(3, 2), 1, 0.02);
}

// Contracted with each other, these two need a vertex twice.
Soup neighbours() {
  return test::joined(test::sphere(2), test::sphere(2), {{2.02, 0, 0}});
}

} // namespace

TEMPLATE_TEST_CASE("A point map that throws leaves the mesh as it was", "", Mesh, Polyhedron) {
  const bool joins = GENERATE(false, true);
  TestType mesh = test::make_mesh<TestType>(joins ? neighbours() : plate());
  const Snapshot before = snapshot(mesh);
  Report report;
  const std::size_t accidents = survive_accidents(
      [&](Fuse* fuse) {
        const Fused points{get(CGAL::vertex_point, mesh), fuse};
        report = run(mesh, FaceCount{60}, ThresholdPairs(joins ? 0.1 : 0),
                     CGAL::parameters::vertex_point_map(points));
      },
      [&] {
        REQUIRE((snapshot(mesh) == before));
        REQUIRE(CGAL::is_valid_polygon_mesh(mesh));
      });
  CHECK(accidents > before.points.size());
  CHECK(report.faces_after == snapshot(mesh).faces.size());
  CHECK((report.duplicated_vertices > 0) == joins);
}

TEMPLATE_TEST_CASE(
    "Maps of indices, constraints, creases and quadrics that throw leave the mesh as it was", "",
    Mesh, Polyhedron) {
  using Traits = boost::graph_traits<TestType>;
  using Vertex = typename Traits::vertex_descriptor;
  using Edge = typename Traits::edge_descriptor;
  const bool joins = GENERATE(false, true);
  TestType mesh = make<TestType>(joins ? neighbours() : test::with_holes(plate(), 1, 20));
  const Snapshot before = snapshot(mesh);
  std::map<Vertex, std::size_t> numbers;
  for (const auto v : vertices(mesh))
    numbers[v] = numbers.size();
  std::map<Vertex, bool> fixed_vertices;
  for (const auto& [v, number] : numbers)
    fixed_vertices[v] = number == 7;
  std::map<Edge, bool> fixed_edges, creases;
  for (const auto e : edges(mesh)) {
    fixed_edges[e] = numbers[source(e, mesh)] == 11;
    creases[e] = numbers[source(e, mesh)] % 5 == 0;
  }
  std::map<Vertex, QuadricForm<3>> quadrics;
  const auto fused = [](auto& values, Fuse* fuse) {
    return Fused{boost::make_assoc_property_map(values), fuse};
  };
  Report report;
  const std::size_t accidents = survive_accidents(
      [&](Fuse* fuse) {
        report =
            run(mesh, FaceCount{60}, ThresholdPairs(joins ? 0.1 : 0),
                parameters::edge_is_crease_map(
                    fused(creases, fuse), parameters::vertex_quadric_map(fused(quadrics, fuse)))
                    .vertex_index_map(fused(numbers, fuse))
                    .vertex_is_constrained_map(fused(fixed_vertices, fuse))
                    .edge_is_constrained_map(fused(fixed_edges, fuse)));
      },
      [&] {
        REQUIRE((snapshot(mesh) == before));
        REQUIRE(test::is_sound(mesh));
      },
      400);
  CHECK(accidents > 10 * before.points.size());
  CHECK((report.duplicated_vertices > 0) == joins);
}

TEMPLATE_TEST_CASE("A colour map that throws leaves mesh and colours as they were", "", Mesh,
                   Polyhedron) {
  TestType mesh = test::make_mesh<TestType>(plate());
  using Vertex = typename boost::graph_traits<TestType>::vertex_descriptor;
  std::map<Vertex, CGAL::IO::Color> colors;
  unsigned char shade = 0;
  for (const auto v : vertices(mesh))
    colors[v] = CGAL::IO::Color(shade += 7, 99, 7);
  const Snapshot before = snapshot(mesh);
  const auto colors_before = colors;
  const std::size_t accidents = survive_accidents(
      [&](Fuse* fuse) {
        const Fused map{boost::make_assoc_property_map(colors), fuse};
        run<ColorQuadric>(mesh, FaceCount{60}, CGAL::parameters::vertex_color_map(map));
      },
      [&] {
        REQUIRE((snapshot(mesh) == before));
        REQUIRE((colors == colors_before));
      });
  CHECK(accidents > before.points.size());
}

TEST_CASE("Maps that throw leave a soup as it was") {
  auto soup = point_soup(plate());
  std::vector<CGAL::IO::Color> colors;
  unsigned char shade = 0;
  for ([[maybe_unused]] const Point& p : soup.points)
    colors.emplace_back(shade += 7, 99, 7);
  std::vector<char> is_fixed(soup.points.size(), 0);
  is_fixed[7] = 1;
  std::vector<ColorQuadric::State> quadrics(soup.points.size());
  const Snapshot before = snapshot(soup);
  const auto colors_before = colors;
  const std::size_t accidents = survive_accidents(
      [&](Fuse* fuse) {
        const auto fused = [fuse](auto& values) {
          return Fused{boost::make_iterator_property_map(
                           values.begin(), boost::typed_identity_property_map<std::size_t>()),
                       fuse};
        };
        const Fused points{CGAL::Identity_property_map<Point>(), fuse};
        run<ColorQuadric>(soup, FaceCount{60},
                          parameters::vertex_quadric_map(fused(quadrics))
                              .vertex_color_map(fused(colors))
                              .vertex_is_constrained_map(fused(is_fixed))
                              .point_map(points));
      },
      [&] {
        REQUIRE((snapshot(soup) == before));
        REQUIRE((colors == colors_before));
      });
  CHECK(accidents > 2 * before.points.size());
}

TEST_CASE("A map that throws leaves points as they were that it keeps elsewhere") {
  const auto soup = point_soup(plate());
  std::vector<Point> places = soup.points;
  std::vector<std::size_t> points(places.size());
  std::iota(points.begin(), points.end(), 0);
  auto triangles = soup.triangles;
  const std::size_t accidents = survive_accidents(
      [&](Fuse* fuse) {
        const Fused map{boost::make_iterator_property_map(
                            places.begin(), boost::typed_identity_property_map<std::size_t>()),
                        fuse};
        simplify<Quadric, OptimalPlacement>(points, triangles, FaceCount{60},
                                            CGAL::parameters::point_map(map));
      },
      [&] {
        REQUIRE((places == soup.points));
        REQUIRE(points.size() == places.size());
        REQUIRE((triangles == soup.triangles));
      });
  CHECK(accidents > places.size());
}

namespace {

struct FusedStop {
  Fuse* fuse;
  bool operator()(const Status& status) const {
    fuse->burn();
    return status.faces <= 60;
  }
};
struct FusedFilter {
  Fuse* fuse;
  bool allows(const auto&) const {
    fuse->burn();
    return true;
  }
};
struct FusedPlacement {
  Fuse* fuse;
  auto operator()(const auto& cost, const auto& pair) const {
    fuse->burn();
    return OptimalPlacement{}(cost, pair);
  }
};
struct FusedPairs {
  static constexpr bool includes_edges = true;
  Fuse* fuse;
  void operator()(const SurfaceView& surface, auto&& emit) const {
    for (std::size_t v = 1; v < surface.points.size(); v += 10) {
      fuse->burn();
      emit(v - 1, v);
    }
  }
};
// Each of its functions burns the fuse.
struct FusedCost : Quadric {
  Fuse* fuse;
  explicit FusedCost(Fuse* f) : Quadric{.crease_degrees = 60}, fuse(f) {}

  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    fuse->burn();
    return Quadric::face(p, q, r);
  }
  State boundary(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    fuse->burn();
    return Quadric::boundary(p, q, r);
  }
  State crease(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    fuse->burn();
    return Quadric::crease(p, q, r);
  }
  double operator()(const auto& pair, const Vector<3>& x) const {
    fuse->burn();
    return Quadric::operator()(pair, x);
  }
  auto minimizer(const auto& pair) const {
    fuse->burn();
    return Quadric::minimizer(pair);
  }
  double squared_error(const auto& pair, double value) const {
    fuse->burn();
    return Quadric::squared_error(pair, value);
  }
};
struct FusedVisitor : Visitor {
  Fuse* fuse;
  explicit FusedVisitor(Fuse* f) : fuse(f) {}
  bool proceed(const Status&) const {
    fuse->burn();
    return true;
  }
};

} // namespace

TEST_CASE("Policies that throw leave the mesh as it was, at each of their calls") {
  Mesh mesh = test::make_mesh(plate());
  const Snapshot before = snapshot(mesh);
  const auto check = [&] { REQUIRE((snapshot(mesh) == before)); };
  CHECK(survive_accidents([&](Fuse* fuse) { run(mesh, FusedStop{fuse}); }, check) > 100);
  mesh = test::make_mesh(plate());
  CHECK(survive_accidents([&](Fuse* fuse) { run(mesh, FaceCount{60}, FusedFilter{fuse}); }, check) >
        100);
}

TEMPLATE_TEST_CASE("Policies that throw leave the surface as it was", "", Mesh, Polyhedron,
                   PointSoup<Triangles>) {
  const auto input = make<TestType>(test::with_holes(plate(), 1, 20));
  const auto survive = [&](const auto& order) {
    const auto accidents = [&](const auto& policy) {
      return survive_accidents_of(input, [&](auto& surface, Fuse* fuse) {
        run(surface, FaceCount{60}, order, policy(fuse));
      });
    };
    CHECK(accidents([](Fuse* fuse) { return FusedFilter{fuse}; }) > 100);
    CHECK(accidents([](Fuse* fuse) { return FusedPlacement{fuse}; }) > 100);
    CHECK(accidents([](Fuse* fuse) { return FusedPairs{fuse}; }) > 10);
    CHECK(accidents([](Fuse* fuse) { return FusedCost(fuse); }) > 1000);
    CHECK(survive_accidents_of(input, [&](auto& surface, Fuse* fuse) {
            run(surface, order, FusedStop{fuse});
          }) > 10);
  };
  survive(GreedyOrder{});
  survive(RelaxedOrder{});
  survive(RelaxedOrder{.refresh = true});
}

TEMPLATE_TEST_CASE("A visitor that throws leaves the surface as it was", "", Mesh, Polyhedron,
                   PointSoup<Triangles>) {
  const auto input = make<TestType>(test::with_noise(test::torus(60, 40), 1, 0.01));
  const auto accidents = [&](const auto& order) {
    return survive_accidents_of(input, [&](auto& surface, Fuse* fuse) {
      run(surface, FaceCount{4}, order, CGAL::parameters::visitor(FusedVisitor(fuse)));
    });
  };
  CHECK(accidents(GreedyOrder{}) > 5);
  CHECK(accidents(RelaxedOrder{}) > 5);
}

// --- Cancelling ----------------------------------------------------------------------------------

namespace {

struct CancelAt : Visitor {
  std::size_t contractions;
  explicit CancelAt(std::size_t n) : contractions(n) {}
  bool proceed(const Status& status) const { return status.contractions < contractions; }
};

template <class Surface>
void require_cancellable(const Surface& input) {
  for (std::size_t at = 1; at < 1500; at += 97) {
    CAPTURE(at);
    Surface surface = input;
    const CancelAt visitor(at);
    const Report report = run(surface, FaceCount{4}, CGAL::parameters::visitor(visitor));
    REQUIRE(report.stop == StopReason::cancelled);
    REQUIRE(report.contractions >= at);
    REQUIRE(report.contractions < at + 500);

    Surface stopped = input; // it is where a stop at that moment would have ended
    const Report other = run(
        stopped, [&](const Status& status) { return status.contractions == report.contractions; });
    REQUIRE((snapshot(surface) == snapshot(stopped)));
    REQUIRE(report.faces_after == other.faces_after);
  }
}

} // namespace

TEST_CASE("A visitor cancels, and what is left is valid") {
  const Soup torus = test::with_noise(test::torus(80, 40), 1, 0.01);
  require_cancellable(test::make_mesh(torus));
  require_cancellable(test::make_mesh<Polyhedron>(torus));
  require_cancellable(point_soup(torus));

  Mesh mesh = test::make_mesh(torus);
  const CancelAt visitor(1000);
  CHECK(run(mesh, FaceCount{4}, CGAL::parameters::visitor(visitor)).stop == StopReason::cancelled);
  CHECK(test::is_valid_triangle_mesh(mesh));
  CHECK(test::topology_of(test::to_soup(mesh)).genus() == 1);
}

// --- The report, and the same again --------------------------------------------------------------

TEST_CASE("A report prints itself in one line") {
  Mesh mesh = test::make_mesh(test::with_noise(test::torus(9, 7), 1, 0.05));
  Report report = simplify(mesh, FaceCount{0});
  std::ostringstream out;
  out << report;
  CHECK(out.str().find('\n') == std::string::npos);
  CHECK_THAT(out.str(), Contains("126 -> " + std::to_string(mesh.number_of_faces()) + " faces"));
  CHECK_THAT(out.str(),
             Contains("63 -> " + std::to_string(mesh.number_of_vertices()) + " vertices"));
  CHECK_THAT(out.str(), Contains(std::to_string(report.contractions) + " contractions"));
  CHECK_THAT(out.str(), Contains("stopped: target unreachable"));
  CHECK_THAT(out.str(), Contains("rejected: ") && Contains(" topology"));
}

TEST_CASE("The same input gives the same output, bit for bit") {
  const auto require_same = [](const auto& input, const auto&... arguments) {
    auto first = input;
    const Report expected = run(first, arguments...);
    REQUIRE(expected.contractions > 0);
    std::vector<std::vector<char>> rubbish; // so that memory is neither where it was nor zero
    for (std::size_t i = 1; i < 20; ++i) {
      rubbish.emplace_back(i * 10007, static_cast<char>(i));
      auto again = input;
      const Report report = run(again, arguments...);
      REQUIRE((snapshot(again) == snapshot(first)));
      REQUIRE(report.rejections == expected.rejections);
      REQUIRE(std::bit_cast<std::uint64_t>(report.error) ==
              std::bit_cast<std::uint64_t>(expected.error));
    }
  };
  const Soup flat = test::cube(16), noisy = test::with_noise(test::torus(90, 40), 1, 0.01);
  for (const Soup& soup : {flat, noisy}) {
    require_same(test::make_mesh(soup), FaceRatio{0.1});
    require_same(test::make_mesh(soup), MemorylessQuadric{}, FaceRatio{0.1});
    require_same(test::make_mesh<Polyhedron>(soup), FaceRatio{0.1});
    require_same(point_soup(soup), FaceRatio{0.1}, ThresholdPairs::relative(0.02));
  }
}

namespace {

struct RejectAll {
  bool allows(const auto&) const { return false; }
};

struct CountCalls : Visitor {
  std::size_t* calls;
  std::size_t most;
  CountCalls(std::size_t* c, std::size_t m) : calls(c), most(m) {}
  bool proceed(const Status&) const { return ++*calls < most; }
};

} // namespace

TEST_CASE("Visitors are asked every few hundred pairs, and cancel where all of them are refused") {
  Mesh mesh = test::make_mesh(test::torus(80, 40));
  std::size_t calls = 0;
  Report report = run(mesh, RejectAll{}, CGAL::parameters::visitor(CountCalls(&calls, 1000)));
  CHECK(report.stop == StopReason::all_pairs_rejected);
  CHECK(calls >= 5); // of 9,600 pairs
  CHECK(calls <= 100);
  calls = 0;
  report = run(mesh, RejectAll{}, CGAL::parameters::visitor(CountCalls(&calls, 2)));
  CHECK(report.stop == StopReason::cancelled);
  CHECK(calls == 2);
}
