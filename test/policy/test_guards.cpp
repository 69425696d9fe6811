// Guards of the user's: what they see, what they refuse, and where they may be used.
#include "archetypes.h"
#include "mesh_types.h"
#include "meshes.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/channels.h>
#include <quadrille/guard.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace quadrille;
using test::Soup;

namespace {

static_assert(GuardPolicy<test::GuardArchetype>);

// No vertex leaves its cell of a grid.
template <bool in_passes>
struct SameCell {
  static constexpr bool works_in_passes = in_passes;
  static constexpr Rejection cause = Rejection::shape;
  double size;

  static std::array<double, 3> cell(const auto& p, double size) {
    return {std::floor(p[0] / size), std::floor(p[1] / size), std::floor(p[2] / size)};
  }
  struct State {
    double size;
    std::vector<std::array<double, 3>> cells;
    bool allows(const auto& contraction) const {
      const auto& first = cells[contraction.first()];
      return first == cells[contraction.second()] && first == cell(contraction.target(), size);
    }
    void follow(const auto&) {}
  };
  State begin(const GuardedSurface& surface) const {
    State state{size, std::vector<std::array<double, 3>>(surface.vertex_count)};
    for (const auto& [index, point] : surface.vertices)
      state.cells[index] = cell(point, size);
    return state;
  }
};

constexpr double size_of_cell = 0.3;

// How many vertices of the input have become part of one in another cell?
std::size_t cells_left(const Soup& input, const Soup& result,
                       const std::vector<std::size_t>& image) {
  std::size_t outside = 0;
  for (std::size_t v = 0; v < image.size(); ++v)
    if (image[v] != parameters::vanished)
      outside += SameCell<false>::cell(input.points[v], size_of_cell) !=
                 SameCell<false>::cell(result.points[image[v]], size_of_cell);
  return outside;
}

template <bool in_passes, class... Policies>
Report check_cells(const Soup& input, const Policies&... policies) {
  Soup soup = input;
  std::vector<std::size_t> image(input.points.size());
  const Report report =
      simplify(soup.points, soup.triangles, SameCell<in_passes>{size_of_cell}, FaceCount{0},
               policies..., parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  CHECK(cells_left(input, soup, image) == 0);
  return report;
}

// What a guard has been told, for a recorder that is told the same contractions.
struct Told {
  std::map<std::size_t, Vector<3>> places; // of the vertices that are left
  std::set<std::set<std::size_t>> faces;   // at the beginning
  std::size_t vertex_count = 0, face_count = 0;
  std::vector<std::pair<std::size_t, std::size_t>> kept_and_gone;
  std::size_t vanished_faces = 0;
  int ends = 0;
};

struct Follower {
  Told* told;

  struct State {
    Told* told;
    bool allows(const auto& contraction) const {
      return told->places.contains(contraction.first()) &&
             told->places.contains(contraction.second());
    }
    void follow(const auto& contraction) {
      const std::size_t kept = contraction.kept();
      REQUIRE((kept == contraction.first() || kept == contraction.second()));
      const std::size_t gone = contraction.first() + contraction.second() - kept;
      told->places.at(kept) = contraction.target();
      told->places.erase(gone);
      told->kept_and_gone.emplace_back(kept, gone);
    }
    void vanish(const auto& faces) { told->vanished_faces += faces.size(); }
    void end() { ++told->ends; }
  };
  State begin(const GuardedSurface& surface) const {
    *told = {};
    told->vertex_count = surface.vertex_count;
    told->face_count = surface.face_count;
    for (const auto& [index, point] : surface.vertices)
      told->places[index] = point;
    for (const auto& [index, vertices] : surface.faces)
      told->faces.insert({vertices.begin(), vertices.end()});
    return {told};
  }
};

struct Recorder {
  std::vector<std::pair<std::size_t, std::size_t>> kept_and_gone;
  void begin(const RecordedSurface&) {}
  void record(const RecordedContraction& c) { kept_and_gone.emplace_back(c.kept, c.gone); }
  void end() {}
};

} // namespace

TEST_CASE("A guard keeps what depends on all contractions, in every order") {
  const Soup input = test::with_noise(test::torus(60, 30), 5, 0.01);
  const Report greedy = check_cells<false>(input);
  CHECK(greedy.rejected(Rejection::shape) > 0);
  CHECK(greedy.faces_after < greedy.faces_before / 2);
  check_cells<true>(input, RelaxedOrder{});
  check_cells<true>(input, RelaxedOrder{}, MemorylessQuadric{});
  check_cells<false>(input, EndpointPlacement{}, Topology::free);
  check_cells<false>(test::joined(input, test::sphere(2), {{3, 0, 0}}),
                     Topology::components_may_vanish);
}

TEST_CASE("A guard sees the surface of the input, and each contraction, by the input's indices") {
  Soup input =
      test::joined(test::with_noise(test::sphere(3), 2, 0.01), test::octahedron(), {{5, 0, 0}});
  input.points.insert(input.points.begin(), {{7, 7, 7}}); // of no face
  for (test::Triangle& t : input.triangles)
    for (auto& v : t)
      ++v;
  input.triangles.insert(input.triangles.begin(), {1, 1, 2}); // is none
  Soup soup = input;
  Told told;
  Recorder recorder;
  std::vector<std::size_t> image(input.points.size());
  const Report report =
      simplify(soup.points, soup.triangles, FaceCount{40}, Follower{&told}, record_into(recorder),
               parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  CHECK(told.vertex_count == input.points.size());
  CHECK(told.face_count == input.triangles.size());
  CHECK(told.faces.size() == input.triangles.size() - 1);
  CHECK((told.kept_and_gone == recorder.kept_and_gone));
  CHECK(told.kept_and_gone.size() == report.contractions);
  CHECK(told.ends == 1);
  std::size_t seen = 0; // what was allowed is what has been written, to the last bit
  for (const auto& [v, place] : told.places)
    if (image[v] != parameters::vanished) {
      CHECK(soup.points[image[v]] == place);
      ++seen;
    }
  CHECK(seen == soup.points.size());
}

namespace {

// Sums up by how much contractions change the enclosed volume, and allows no more than a limit.
struct VolumeLimit {
  static constexpr Topology topology = Topology::kept;
  static constexpr bool has_obstacles = true;
  double limit;
  double* change;

  static double volume(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    return dot(p, cross(q, r)) / 6;
  }
  struct State {
    double limit;
    double* change;
    static double change_by(const auto& contraction) {
      double sum = 0;
      for (const auto& f : contraction.faces())
        sum += volume(f.after, f.second, f.third) - volume(f.before, f.second, f.third);
      contraction.for_each_gone(
          [&](const auto& f) { sum -= volume(f.corners[0], f.corners[1], f.corners[2]); });
      return sum;
    }
    bool allows(const auto& contraction) const {
      return std::abs(*change + change_by(contraction)) <= limit;
    }
    void follow(const auto& contraction) { *change += change_by(contraction); }
  };
  State begin(const GuardedSurface&) const {
    *change = 0;
    return {limit, change};
  }
};

} // namespace

TEST_CASE("A guard sees the corners of all faces that change or go, before and after") {
  const Soup input = test::with_noise(test::torus(60, 30), 5, 0.02);
  const double volume = test::volume(input);
  double change = 0;
  for (const double limit : {1.0, 1e-4}) { // which is seldom in the way, and mostly
    Soup soup = input;
    const Report report =
        simplify(soup.points, soup.triangles, FaceCount{200}, VolumeLimit{limit * volume, &change});
    CHECK(report.faces_after == 200);
    CHECK(std::abs(test::volume(soup) - volume - change) < 1e-12);
    CHECK(std::abs(change) <= limit * volume);
    CHECK((report.rejected(Rejection::filter) > 0) == (limit < 1));
  }
  Soup soup = input;
  CHECK_THROWS_AS(simplify(soup.points, soup.triangles, VolumeLimit{1, &change}, Topology::free),
                  std::invalid_argument);
}

TEST_CASE("A guard is told of parts that vanish") {
  Soup speck = test::octahedron();
  for (auto& p : speck.points)
    p = 0.02 * p;
  Soup soup = test::joined(test::sphere(3), speck, {{1.2, 0, 0}});
  Told told;
  const Report report = simplify(soup.points, soup.triangles, FaceCount{40},
                                 Topology::components_may_vanish, Follower{&told});
  CHECK(report.vanished_components == 1);
  CHECK(told.vanished_faces > 0);
  CHECK(2 * told.kept_and_gone.size() + told.vanished_faces ==
        report.faces_before - report.faces_after);
}

TEST_CASE("Where floats are written, a guard sees the places that are written") {
  const Soup input = test::with_noise(test::torus(40, 20), 3, 0.02);
  std::vector<std::array<float, 3>> points;
  for (const auto& p : input.points)
    points.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  auto triangles = input.triangles;
  Told told;
  std::vector<std::size_t> image(points.size());
  simplify(points, triangles, FaceCount{300}, Follower{&told},
           parameters::vertex_to_vertex_map(CGAL::make_property_map(image)));
  for (const auto& [v, place] : told.places)
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(static_cast<double>(points[image[v]][i]) == place[i]);
}

TEST_CASE("A guard that allows all changes nothing, and one that is absent is not there") {
  const Soup input = test::with_noise(test::torus(40, 20), 3, 0.02);
  Soup plain = input, guarded = input, absent = input;
  simplify(plain.points, plain.triangles, FaceCount{300});
  simplify(guarded.points, guarded.triangles, FaceCount{300}, test::GuardArchetype{});
  CHECK(test::is_identical(plain, guarded));
  const std::optional<SameCell<false>> none;
  simplify(absent.points, absent.triangles, FaceCount{300}, none, AnyOrder(GreedyOrder{}));
  CHECK(test::is_identical(plain, absent));
  CHECK_NOTHROW(simplify(absent.points, absent.triangles, none, AnyOrder(RelaxedOrder{})));
}

TEST_CASE("A guard that does not work in passes is refused there, before anything is changed") {
  const Soup input = test::sphere(3);
  Soup soup = input;
  CHECK_THROWS_WITH(
      simplify(soup.points, soup.triangles, SameCell<false>{1}, AnyOrder(RelaxedOrder{})),
      Catch::Contains("needs GreedyOrder"));
  CHECK(test::is_identical(soup, input));
  struct Thrower : test::GuardArchetype {
    State begin(const GuardedSurface&) const { throw std::domain_error("not this one"); }
  };
  CHECK_THROWS_AS(simplify(soup.points, soup.triangles, Thrower{}), std::domain_error);
  CHECK(test::is_identical(soup, input));
}

TEST_CASE("Several guards hold together") {
  const Soup input = test::with_noise(test::torus(60, 30), 5, 0.01);
  Told told;
  const Report both = check_cells<false>(input, Follower{&told});
  CHECK(told.kept_and_gone.size() == both.contractions);
}

// Of the vertices that were followed, how many have left their cells, and is where they went where
// the result has them?
void check_followed(const Told& told, const Soup& input, const Soup& result) {
  const auto as_floats = [](const auto& p) {
    return std::array{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  };
  std::set<std::array<float, 3>> left, followed;
  for (const auto& p : result.points)
    left.insert(as_floats(p));
  std::size_t outside = 0;
  for (const auto& [index, place] : told.places) {
    followed.insert(as_floats(place));
    outside += SameCell<false>::cell(input.points[index], size_of_cell) !=
               SameCell<false>::cell(place, size_of_cell);
  }
  CHECK(left == followed);
  CHECK(outside == 0);
}

TEMPLATE_TEST_CASE("A guard sees meshes by their own indices", "", test::Mesh, test::Polyhedron,
                   test::FloatTriMesh) {
  // So many that the engine numbers them in another order.
  const Soup input = test::shuffled(test::with_noise(test::torus(100, 50), 5, 0.01), 3);
  auto mesh = test::convert<TestType>(input);
  Told told;
  const Report report =
      simplify(mesh, SameCell<false>{size_of_cell}, Follower{&told}, FaceCount{0});
  CHECK(report.rejected(Rejection::shape) > 0);
  CHECK(report.faces_after < report.faces_before / 2);
  CHECK(told.kept_and_gone.size() == report.contractions);
  check_followed(told, input, test::to_soup(mesh));
}

TEST_CASE("A guard holds with attributes, whatever carries them") {
  const Soup input = test::with_noise(test::torus(60, 30), 5, 0.01);
  std::vector<std::array<double, 3>> colors(input.points.size());
  for (std::size_t v = 0; v < colors.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
      colors[v][i] = 0.5 + 0.5 * std::sin(3 * input.points[v][i]);
  auto of_channel = colors;
  check_cells<false>(input, Colors{CGAL::make_property_map(of_channel)});
  Soup soup = input;
  std::vector<std::size_t> image(input.points.size());
  const auto with_colors = CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors));
  const Report report = simplify<ColorQuadric>(
      soup.points, soup.triangles, SameCell<false>{size_of_cell}, FaceCount{0},
      parameters::vertex_to_vertex_map(CGAL::make_property_map(image), with_colors));
  CHECK(report.rejected(Rejection::shape) > 0);
  CHECK(report.faces_after < report.faces_before / 2);
  CHECK(cells_left(input, soup, image) == 0);
}
