// Hulls enclose the input, at every contraction and in the end, for coordinates as they are
// written.
#include "contractions.h"
#include "mesh_types.h"
#include "meshes.h"
#include "soups.h"
#include "winding_number.h"

#include <quadrille/distance_limits.h>
#include <quadrille/hull.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace quadrille;
using internal::Index;
using test::Position;
using test::Soup;

// --- The quadratic programme
// -----------------------------------------------------------------------

using internal::HalfSpace;

// By trying all sets of up to three planes.
std::optional<double> least_by_brute_force(const std::vector<HalfSpace>& half_spaces,
                                           const SymmetricMatrix<3>& hessian,
                                           const Position& least) {
  const auto value = [&](const Position& x) { return dot(x - least, hessian * (x - least)); };
  const Factorization<3> factorization(hessian);
  std::optional<double> best;
  const auto try_point = [&](const Position& x) {
    for (const HalfSpace& h : half_spaces)
      if (dot(h.normal, x) < h.offset - 1e-9)
        return;
    best = std::min(best.value_or(value(x)), value(x));
  };
  // The point of least value on some planes, one after the other: each leaves a direction less.
  const auto try_planes = [&](const std::vector<HalfSpace>& planes) {
    Position x = least;
    std::vector<Position> across; // directions, conjugate to each other
    for (const HalfSpace& h : planes) {
      Position push = factorization.solve(h.normal);
      for (const Position& d : across)
        push -= (dot(d, hessian * push) / dot(d, hessian * d)) * d;
      x += ((h.offset - dot(h.normal, x)) / dot(h.normal, push)) * push;
      across.push_back(push);
    }
    try_point(x);
  };
  const std::size_t n = half_spaces.size();
  try_point(least);
  for (std::size_t i = 0; i < n; ++i) {
    try_planes({half_spaces[i]});
    for (std::size_t j = 0; j < i; ++j) {
      try_planes({half_spaces[i], half_spaces[j]});
      for (std::size_t k = 0; k < j; ++k)
        try_planes({half_spaces[i], half_spaces[j], half_spaces[k]});
    }
  }
  return best;
}

Position random_unit(test::Random& random) {
  for (;;) {
    const Position p{{random(-1, 1), random(-1, 1), random(-1, 1)}};
    if (const double squared = squared_length(p); squared > 0.01 && squared < 1)
      return 1 / std::sqrt(squared) * p;
  }
}

// --- Single contractions
// ---------------------------------------------------------------------------

template <class Surface>
std::optional<Index> random_neighbour(Surface& surface, Index v, test::Random& random) {
  std::vector<Index> neighbours;
  surface.complex().for_each_corner(v, [&](Index face, Index i) {
    neighbours.push_back(internal::star_face_at(surface.complex(), face, i).second);
  });
  if (neighbours.empty())
    return std::nullopt;
  return neighbours[random.below(neighbours.size())];
}

// Does x lie on the right side, or in the plane, of each face at a or b? `sign` is 1 for outside.
template <class Surface>
bool is_beyond_all(const Surface& surface, Index a, Index b, const Position& x, int sign) {
  for (Index face = 0; face < surface.complex().face_capacity(); ++face) {
    if (surface.complex().is_removed(face))
      continue;
    const auto [i, j, k] = surface.complex().vertices(face);
    if (i != a && i != b && j != a && j != b && k != a && k != b)
      continue;
    if (sign * test::orientation(test::position(surface, i), test::position(surface, j),
                                 test::position(surface, k), x) <
        0)
      return false;
  }
  return true;
}

// Contracts random edges and checks each. Returns how many were contracted.
template <class Cost, class Placement>
std::size_t contract_and_check(const Soup& soup, int sign, bool are_floats) {
  const auto policies = internal::pick_policies<Cost, Placement>();
  auto input = test::input_of(soup);
  input.writes_floats = are_floats;
  const auto box = input.box();
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(std::move(input), box,
                                                                            policies);
  test::Random random(5);
  std::size_t contracted = 0;
  for (std::size_t trial = 0; trial < 2 * soup.points.size(); ++trial) {
    const Index v = random.below(soup.points.size());
    const auto w = random_neighbour(surface, v, random);
    if (!w)
      continue;
    const auto [a, b] = std::minmax(v, *w);
    auto candidate = surface.evaluator().evaluate(a, b);
    const internal::GatheredStar star(surface.complex(), a, b, surface.scratch());
    if (!surface.evaluator().resolve(candidate, *star))
      continue;
    typename decltype(surface)::Contraction contraction(candidate, star);
    if (surface.checks().rejection(contraction))
      continue;
    const Position x = contraction.target();
    CHECK(is_beyond_all(surface, a, b, x, sign));
    if (are_floats)
      for (double coordinate : x.coordinates)
        CHECK(static_cast<double>(static_cast<float>(coordinate)) == coordinate);
    surface.apply(contraction, internal::AtOnce{});
    surface.progress().count(surface.scratch().counters);
    ++contracted;
  }
  return contracted;
}

// --- Whole results
// ---------------------------------------------------------------------------------

// Is every input vertex inside, and does no winding number of a random point fall? For an inner
// hull the other way round.
void check_encloses(const Soup& outer, const Soup& inner, std::size_t random_points) {
  const test::WindingNumber of_outer(outer), of_inner(inner);
  std::size_t outside = 0, fallen = 0, seen = 0;
  for (const Position& p : inner.points)
    if (const auto winding = of_outer(p)) // else on it
      outside += *winding < 1;
  const double reach = test::diagonal(outer);
  test::Random random(3);
  for (std::size_t i = 0; i < random_points; ++i) {
    const Position& near = inner.points[random.below(inner.points.size())];
    const Position q = near + 0.05 * reach * random(0, 1) * random_unit(random);
    const auto before = of_inner(q), after = of_outer(q);
    if (before && after) {
      ++seen;
      fallen += *after < *before;
    }
  }
  CHECK(outside == 0);
  CHECK(fallen == 0);
  CHECK(2 * seen >= random_points);
}

// Two spheres that pass through each other, as one surface.
Soup crossed_spheres() {
  return test::joined(test::sphere(3), test::tilted(test::sphere(3)), {{0.7, 0.2, 0.1}});
}

// A ball with a bubble, whose faces look into it.
Soup ball_with_bubble() {
  Soup bubble = test::mapped(test::sphere(2), [](const Position& p) { return 0.6 * p; });
  for (test::Triangle& t : bubble.triangles)
    std::swap(t[0], t[1]);
  return test::joined(test::sphere(3), bubble);
}

Soup noisy_torus() {
  return test::with_noise(test::torus(40, 20), 4, 0.02);
}

template <class Hull, class Cost = MemorylessQuadric, class... Arguments>
Soup hull_of(const Soup& soup, std::size_t faces, const Arguments&... arguments) {
  test::PointSoup result(soup);
  const Report report =
      simplify<Cost, Hull>(result.points, result.triangles, FaceCount{faces}, arguments...);
  INFO(report);
  CHECK(report.faces_after < report.faces_before);
  CHECK(std::abs(*report.volume_before - double(test::exact_volume(soup))) <=
        1e-12 * std::abs(*report.volume_before));
  CHECK(std::abs(*report.volume_after - double(test::exact_volume(test::to_soup(result)))) <=
        1e-12 * std::abs(*report.volume_after));
  return test::to_soup(result);
}

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("The quadratic programme finds what brute force finds") {
  test::Random random(1);
  std::size_t empty = 0, found = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const std::size_t n = 1 + random.below(6);
    const Position shift = 0.5 * random_unit(random);
    std::vector<HalfSpace> half_spaces;
    for (std::size_t i = 0; i < n; ++i) {
      const Position normal = random_unit(random);
      half_spaces.push_back({normal, dot(normal, shift) + random(-0.2, trial % 3 == 0 ? 0.4 : 0)});
    }
    SymmetricMatrix<3> hessian;
    for (int i = 0; i < 3; ++i)
      hessian += SymmetricMatrix<3>::outer_product(random_unit(random), random(0.2, 2));
    hessian.add_to_diagonal(0.1);
    const Position least = random_unit(random);
    const Factorization<3> factorization(hessian);
    const auto x = internal::LeastInHalfSpaces(half_spaces, factorization, 0, 1e-9)(least);
    const auto best = least_by_brute_force(half_spaces, hessian, least);
    CAPTURE(trial);
    REQUIRE(x.has_value() == best.has_value());
    ++(x ? found : empty);
    if (x) {
      for (const HalfSpace& h : half_spaces)
        CHECK(dot(h.normal, *x) >= h.offset - 2e-9);
      CHECK(std::abs(dot(*x - least, hessian * (*x - least)) - *best) <= 1e-6 * (1 + *best));
    }
  }
  CHECK(found > 100);
  CHECK(empty > 2);
}

TEST_CASE("Each contraction goes beyond the planes of all faces around it, exactly") {
  for (const Soup& soup : {test::large(test::sphere(3)), test::large(noisy_torus()),
                           test::large(test::tilted(test::cube(5))), test::large(crossed_spheres()),
                           test::large(test::with_noise(test::plate_with_holes(2, 4), 3, 0.03))}) {
    CHECK(contract_and_check<MemorylessQuadric, OuterHull>(soup, 1, false) >
          soup.points.size() / 3);
    CHECK(contract_and_check<MemorylessQuadric, InnerHull>(soup, -1, false) >
          soup.points.size() / 4);
  }
}

TEST_CASE("Where the input's coordinates are floats, it is their rounding that is checked") {
  for (const Soup& soup :
       {test::as_floats(test::large(test::sphere(3))), test::as_floats(test::large(noisy_torus())),
        test::as_floats(test::mapped(test::large(noisy_torus()), [](const Position& p) {
          return p + Position{{0x1p24, -0x1p25, 0x1p23}};
        }))})
    CHECK(contract_and_check<MemorylessQuadric, OuterHull>(soup, 1, true) > soup.points.size() / 3);
}

TEST_CASE("An outer hull encloses the input, also where it passes through itself") {
  check_encloses(hull_of<OuterHull>(test::sphere(4), 200), test::sphere(4), 400);
  check_encloses(hull_of<OuterHull>(noisy_torus(), 300), noisy_torus(), 400);
  check_encloses(hull_of<OuterHull>(crossed_spheres(), 200), crossed_spheres(), 400);
  check_encloses(hull_of<OuterHull>(ball_with_bubble(), 120), ball_with_bubble(), 400);
  check_encloses(hull_of<OuterHull, Quadric>(noisy_torus(), 300), noisy_torus(), 400);
  const Soup far = test::mapped(noisy_torus(), [](const Position& p) {
    return p + Position{{1e6, -2e6, 5e5}};
  });
  check_encloses(hull_of<OuterHull>(far, 300), far, 400);
}

TEST_CASE("An inner hull is enclosed by the input") {
  for (const Soup& soup : {test::sphere(4), noisy_torus(), ball_with_bubble()})
    check_encloses(soup, hull_of<InnerHull>(soup, 300), 400);
}

TEST_CASE("A cow and a part of a machine are enclosed, and their volume grows") {
  for (const char* name : {"fandisk", "cow"}) {
    CAPTURE(name);
    test::Mesh mesh = test::read_model(name);
    const Soup input = test::to_soup(mesh);
    const Report report = simplify<MemorylessQuadric, OuterHull>(mesh, FaceCount{800});
    INFO(report);
    mesh.collect_garbage();
    CHECK(test::is_valid_triangle_mesh(mesh));
    CHECK(report.faces_after == 800);
    CHECK(*report.volume_after >= *report.volume_before);
    check_encloses(test::to_soup(mesh), input, 100);
  }
}

TEST_CASE("Meshes of any type get hulls") {
  const Soup soup = noisy_torus();
  const auto check = [&]<class M>(M mesh) {
    const Soup input = test::to_soup(mesh);
    const Report report = simplify<MemorylessQuadric, OuterHull>(mesh, FaceCount{300});
    CHECK(report.faces_after == 300);
    if constexpr (requires { mesh.collect_garbage(); })
      mesh.collect_garbage();
    else if constexpr (requires { mesh.garbage_collection(); })
      mesh.garbage_collection();
    check_encloses(test::to_soup(mesh), input, 100);
  };
  check(test::convert<test::Mesh>(soup));
  check(test::convert<test::Polyhedron>(soup));
  check(test::convert<test::CellComplex>(soup));
  check(test::convert<test::TriMesh>(soup)); // CGAL rounds its doubles to floats
  check(test::convert<test::FloatTriMesh>(soup));
}

TEST_CASE("A soup of floats is enclosed as it is written") {
  const Soup soup = test::as_floats(noisy_torus());
  std::vector<std::array<float, 3>> points;
  for (const Position& p : soup.points)
    points.push_back({float(p[0]), float(p[1]), float(p[2])});
  auto triangles = soup.triangles;
  simplify<MemorylessQuadric>(points, triangles, OuterHull{}, FaceCount{200});
  Soup hull{{}, triangles};
  for (const auto& p : points)
    hull.points.push_back({{p[0], p[1], p[2]}});
  CHECK(triangles.size() == 200);
  check_encloses(hull, soup, 400);
}

TEST_CASE("What is flat stays where it is, up to rounding: a cube becomes a cube") {
  for (const int n : {4, 7}) {
    const Soup result = hull_of<OuterHull>(test::cube(n), 12);
    CHECK(result.triangles.size() == 12);
    CHECK(std::abs(test::volume(result) - 1) < 1e-12);
    CHECK(hull_of<InnerHull>(test::cube(n), 12).triangles.size() == 12);
  }
}

TEST_CASE("Passes, limits, fixed vertices and labels go with hulls") {
  const Soup soup = test::with_noise(test::torus(80, 40), 4, 0.005);
  const auto check = [&](const auto&... arguments) {
    check_encloses(hull_of<OuterHull>(soup, 700, arguments...), soup, 30);
  };
  check(RelaxedOrder{});
  std::vector<int> is_fixed(soup.points.size(), 0), labels(soup.triangles.size());
  for (std::size_t v = 0; v < is_fixed.size(); v += 100)
    is_fixed[v] = 1;
  for (std::size_t t = 0; t < labels.size(); ++t)
    labels[t] = t < labels.size() / 2;
  check(CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_fixed)));
  check(Labels{CGAL::make_property_map(labels)});
  test::PointSoup limited(soup);
  const Report report = simplify<MemorylessQuadric, OuterHull>(limited.points, limited.triangles,
                                                               DistanceLimit{0.02});
  CHECK(report.distance_bound <= 0.02);
  CHECK(report.faces_after < 2700);
  check_encloses(test::to_soup(limited), soup, 30);
}

TEST_CASE("A surface that encloses nothing has no hull, and stays as it is") {
  const auto message = [](const Soup& soup, const auto&... arguments) {
    test::PointSoup changed(soup);
    const std::string text = message_of([&] {
      simplify<Quadric, OuterHull>(changed.points, changed.triangles, FaceCount{4}, arguments...);
    });
    CHECK(test::is_identical(test::to_soup(changed), soup));
    return text;
  };
  Soup open = test::sphere(2);
  open.triangles.erase(open.triangles.begin()); // three edges have a face less
  CHECK(contains(message(open), " 3 edges have different numbers of faces"));
  Soup turned = test::sphere(2);
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  CHECK(contains(message(turned), " 3 edges have different numbers of faces"));
  CHECK(contains(message(test::grid(3, 3)), " 12 edges have different numbers of faces"));
  Soup inward = test::sphere(2);
  for (test::Triangle& t : inward.triangles)
    std::swap(t[0], t[1]);
  CHECK(contains(message(inward), "oriented inwards"));
  CHECK(contains(message(test::sphere(2), Topology::free), "keeps the topology"));
  CHECK(contains(message(test::sphere(2), Topology::components_may_vanish), "keeps the topology"));
  CHECK(contains(message(test::sphere(2), ThresholdPairs{1}), "keeps the topology"));
}
