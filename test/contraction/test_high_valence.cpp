// Hubs, vertices of very many faces: the work at them grows as their faces do, and what is gathered
// there says as much as the whole star.
#include "arrays.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>

#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/relaxed_order.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;

Position on_circle(double turn, double radius, double z) {
  const double angle = 2 * std::numbers::pi * turn;
  return {{radius * std::cos(angle), radius * std::sin(angle), z}};
}

// A fan around vertex 0: every other vertex of its rim lies further in, and higher.
Soup saw_of_height(std::uint32_t n, double height) {
  Soup soup{{{{0, 0, 0}}}, {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    soup.points.push_back(on_circle(double(i) / n, i % 2 == 0 ? 0.6 : 1, i % 2 == 0 ? 0 : height));
    soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return soup;
}

Soup saw(std::uint32_t n) {
  return saw_of_height(n, 0.3);
}
Soup flat_saw(std::uint32_t n) {
  return saw_of_height(n, 0);
}

// Two such fans with a common rim.
Soup crown(std::uint32_t n) {
  Soup soup = saw(n / 2);
  const auto below = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back({{0, 0, -1}});
  for (std::uint32_t i = 0; i < n / 2; ++i)
    soup.triangles.push_back({below, 1 + (i + 1) % (n / 2), 1 + i});
  return soup;
}

// Faces that share vertex 0 and nothing else.
Soup petals(std::uint32_t n) {
  Soup soup{{{{0, 0, 0}}}, {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    soup.points.push_back(on_circle(double(i) / n, 1, 0.1 * std::sin(i)));
    soup.points.push_back(on_circle((i + 0.4) / n, 1, 0));
    soup.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  return soup;
}

// Faces that share the edge of vertices 0 and 1.
Soup fins(std::uint32_t n) {
  Soup soup{{{{0, 0, 0}}, {{0, 0, 1}}}, {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    soup.points.push_back(on_circle(double(i) / n, 1 + 0.1 * std::sin(i), 0.5));
    soup.triangles.push_back({0, 1, 2 + i});
  }
  return soup;
}

// Narrow strips that share vertex 0, of five faces each.
Soup spokes(std::uint32_t n) {
  Soup soup{{{{0, 0, 0}}}, {}};
  for (std::uint32_t i = 0; i < n / 5; ++i) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (std::uint32_t k = 0; k < 6; ++k)
      soup.points.push_back(
          on_circle((i + 0.3 * (k % 2)) * 5 / n, 1 + k / 2, 0.1 * std::sin(i + k / 2)));
    soup.triangles.push_back({0, first, first + 1});
    for (std::uint32_t k = 0; k < 4; ++k)
      soup.triangles.push_back({first + k + k % 2, first + k + 1 - k % 2, first + k + 2});
  }
  return soup;
}

struct Shape {
  std::string name;
  std::function<Soup(std::uint32_t)> of_faces;
};
const std::vector<Shape> shapes{{"saw", saw},       {"flat saw", flat_saw}, {"crown", crown},
                                {"petals", petals}, {"fins", fins},         {"spokes", spokes}};

// A cost, and how often it is asked.
template <class Cost>
struct Counted : Cost {
  std::size_t* evaluations;

  explicit Counted(std::size_t& count) : evaluations(&count) {}
  double operator()(const auto& pair, const Vector<3>& x) const {
    ++*evaluations;
    return Cost::operator()(pair, x);
  }
};

// A filter, and how many faces it is shown.
struct CountedFlip : NormalFlip {
  std::size_t* faces;

  explicit CountedFlip(std::size_t& count) : faces(&count) {}
  bool allows(const auto& contraction) const {
    for (const auto& f : contraction.faces())
      *faces += sizeof(f) > 0;
    return NormalFlip::allows(contraction);
  }
};

struct Work {
  std::size_t faces_left, steps;
};

template <class Cost, class Placement, class... Others>
Work work(const Soup& soup, const Others&... others) {
  std::vector<std::array<double, 3>> points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  std::vector<test::Triangle> triangles = soup.triangles;
  std::size_t steps = 0;
  simplify(points, triangles, Counted<Cost>(steps), Placement{}, CountedFlip(steps), others...);
  return {triangles.size(), steps};
}

// Twice the faces may take little more than twice the work, and no more than some steps for each.
template <class Cost, class Placement, class... Others>
void require_linear_work(const std::string& call, const Others&... others) {
  for (const Shape& shape : shapes) {
    const std::uint32_t n = 6000;
    const Work once = work<Cost, Placement>(shape.of_faces(n), others...);
    const Work twice = work<Cost, Placement>(shape.of_faces(2 * n), others...);
    INFO(shape.name << ", " << call << ": " << once.steps << " steps to " << once.faces_left
                    << " faces, " << twice.steps << " to " << twice.faces_left);
    // Or so few that they tell of no growth.
    CHECK((double(twice.steps) < 2.6 * double(once.steps) || twice.steps < 32 * 2 * n));
    CHECK(once.steps < 1000 * n);
  }
}

template <class Cost, class Placement>
void require_linear_work_by(const std::string& cost) {
  require_linear_work<Cost, Placement>(cost + " to a tenth", FaceRatio{0.1});
  require_linear_work<Cost, Placement>(cost + " within a limit", DistanceLimit{0.01});
  require_linear_work<Cost, Placement>(cost + " in passes", FaceRatio{0.1}, RelaxedOrder{});
  require_linear_work<Cost, Placement>(cost + ", topology free", FaceRatio{0.1}, Topology::free);
}

} // namespace

TEST_CASE("Quadrics at hubs take work in proportion to the faces") {
  require_linear_work_by<Quadric, OptimalPlacement>("quadric");
}
TEST_CASE("Memoryless quadrics at hubs take work in proportion to the faces") {
  require_linear_work_by<MemorylessQuadric, OptimalPlacement>("memoryless");
}
TEST_CASE("Edge lengths at hubs take work in proportion to the faces") {
  require_linear_work_by<EdgeLength, MidpointPlacement>("length");
}

TEST_CASE("The star beside a hub says of topology what the whole star says") {
  using namespace quadrille::internal;
  for (const Shape& shape : shapes) {
    const Soup soup = shape.of_faces(700);
    TriangleComplex complex(soup.points.size(), test::array_of(soup.triangles));
    VertexLabels labels(complex.vertex_capacity());
    const LinkCondition condition(complex, [&](std::size_t) -> VertexLabels& { return labels; });
    PairStar whole, beside;
    std::size_t pairs = 0;
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      for (const auto& triangle : soup.triangles)
        for (Index w : triangle) {
          const Index high_valence = complex.high_valence_vertices().of_pair(v, w);
          if (v >= w || high_valence == none ||
              std::find(triangle.begin(), triangle.end(), v) == triangle.end())
            continue;
          ++pairs;
          whole.gather(complex, v, w);
          beside.gather_at_high_valence(complex, v, w, high_valence);
          INFO(shape.name << " " << v << " " << w);
          CHECK(beside.shared.size() == whole.shared.size());
          CHECK(beside.first.size() + beside.second.size() < 16);
          if (!beside.may_meet_high_valence)
            CHECK(condition.holds(beside, v, w, labels) == condition.holds(whole, v, w, labels));
          else
            CHECK(!condition.holds(beside, v, w, labels));
        }
    CHECK(pairs >= 140);
  }
}

TEST_CASE("The list of a hub grows and shrinks as its faces do") {
  using namespace quadrille::internal;
  const Soup soup = saw(400);
  TriangleComplex complex(soup.points.size(), test::array_of(soup.triangles), true);
  CHECK(complex.high_valence_vertices().has(0));
  CHECK(complex.high_valence_vertices().of_pair(0, 7) == 0);
  CHECK(complex.high_valence_vertices().of_pair(7, 8) == none);
  std::size_t reviews = 0, left = 400;
  for (Index v = 1; v < 400 && complex.high_valence_vertices().any();
       v += 2, left -= 1) { // into the next one
    complex.for_each_corner(v, [&](Index face, Index i) {
      if (star_face_at(complex, face, i).has(v + 1))
        complex.remove_face(face);
    });
    complex.merge(v + 1, v);
    complex.review_high_valence([&](Index high_valence) {
      ++reviews;
      CHECK(high_valence == 0);
      CHECK(complex.degree_bound(0) == left - 1);
    });
  }
  CHECK(reviews > 1);
  CHECK(reviews < 10);
}
