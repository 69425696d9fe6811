// If memory runs out, at whichever moment, the surface is as it was.

#include "meshes.h"
#include "snapshot.h"
#include "soups.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Polyhedron_3.h>
#include <boost/property_map/property_map.hpp>
#include <quadrille/attribute_quadric.h>
#include <quadrille/cluster.h>
#include <quadrille/distance_limits.h>
#include <quadrille/levels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

std::size_t allocations_left = 0; // the last of them fails; 0: none does

bool is_short_of_memory() {
  return allocations_left > 0 && --allocations_left == 0;
}

} // namespace

// Not inlined: g++ would take the pairs of new and free, malloc and delete for mistakes.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (!is_short_of_memory())
    if (void* p = std::malloc(size))
      return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return is_short_of_memory() ? nullptr : std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

namespace {

using namespace quadrille;
using test::Mesh;
using test::PointSoup;
using test::snapshot;
using test::Snapshot;
using test::Soup;
using Polyhedron = CGAL::Polyhedron_3<test::Kernel>;

// The n-th allocation in its scope fails.
class Shortage {
public:
  explicit Shortage(std::size_t n) { allocations_left = n; }
  Shortage(const Shortage&) = delete;
  Shortage& operator=(const Shortage&) = delete;
  ~Shortage() { allocations_left = 0; }

  bool has_come() const { return allocations_left == 0; }
};

// Calls simplify(surface) so that its n-th allocation fails, for each n up to 2000 and then for
// some, until it needs no more. Returns the greatest n for which it failed.
template <class Surface, class Simplify>
std::size_t survive_shortages(const Surface& input, Simplify simplify) {
  Surface expected = input, surface = input;
  simplify(expected);
  const Snapshot before = snapshot(input), after = snapshot(expected);
  REQUIRE(before != after);
  std::size_t greatest = 0;
  for (std::size_t n = 1;; n += 1 + (n < 2000 ? 0 : n / 16)) {
    CAPTURE(n);
    bool has_come = false, has_failed = false;
    try {
      const Shortage shortage(n);
      simplify(surface);
      has_come = shortage.has_come();
    } catch (const std::bad_alloc&) {
      has_failed = true;
    }
    REQUIRE((snapshot(surface) == (has_failed ? before : after)));
    REQUIRE(test::is_sound(surface));
    if (has_failed)
      greatest = n;
    else if (has_come)
      surface = input; // it could do without, as std::stable_sort can
    else
      return greatest;
  }
}

template <class Surface>
Surface make(const Soup& soup) {
  return test::make_mesh<Surface>(soup);
}
template <>
PointSoup make(const Soup& soup) {
  return PointSoup(soup);
}

template <class Cost = internal::NotGiven, class M, class... Arguments>
void run(M& mesh, const Arguments&... arguments) {
  simplify<Cost>(mesh, arguments...);
}
template <class Cost = internal::NotGiven, class... Arguments>
void run(PointSoup& soup, const Arguments&... arguments) {
  simplify<Cost>(soup.points, soup.triangles, arguments...);
}

// CGAL's Kd_tree, which ThresholdPairs asks, leaks if memory runs out while it is built.
struct ClosePairs {
  static constexpr bool includes_edges = true;
  void operator()(const SurfaceView& surface, auto&& emit) const {
    for (std::size_t i = 0; i < surface.points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (squared_distance(surface.points[i], surface.points[j]) < 0.1 * 0.1)
          emit(i, j);
  }
};

Soup plate() {
  return test::with_noise(test::plate_with_holes(3, 2), 1, 0.02);
}

} // namespace

TEMPLATE_TEST_CASE("A surface is as it was if memory runs out", "", Mesh, Polyhedron, PointSoup) {
  const auto survive = [](const Soup& soup, const auto&... arguments) {
    return survive_shortages(make<TestType>(soup),
                             [&](TestType& surface) { run(surface, arguments...); });
  };
  const Soup open = test::with_holes(plate(), 1, 20);
  CHECK(survive(open, FaceCount{60}) > 20);
  CHECK(survive(open, FaceCount{60}, MemorylessQuadric{}) > 20);
  CHECK(survive(open, FaceCount{60}, RelaxedOrder{}) > 20);
  CHECK(survive(open, FaceCount{60}, RelaxedOrder{.refresh = true}) > 20);
  CHECK(survive(open, DistanceLimit::relative(0.01)) > 20);

  // Contracted with each other, these two need a vertex twice.
  const Soup neighbours = test::joined(test::sphere(2), test::sphere(2), {{2.02, 0, 0}});
  CHECK(survive(neighbours, FaceCount{60}, ClosePairs{}) > 20);
}

TEST_CASE("Colours are as they were if memory runs out") {
  Mesh mesh = test::make_mesh(plate());
  PointSoup soup(plate());
  using Colors = std::vector<CGAL::IO::Color>;
  Colors before;
  unsigned char shade = 0;
  while (before.size() < soup.points.size())
    before.emplace_back(shade += 7, 99, 7);
  Colors colors;
  const auto map = [&](const auto& indices) {
    return CGAL::parameters::vertex_color_map(
        boost::make_iterator_property_map(colors.begin(), indices));
  };
  const auto survive = [&](const auto& surface, const auto& indices) {
    const Snapshot snapshot_before = snapshot(surface);
    bool has_failed = true;
    for (std::size_t n = 1; has_failed; ++n) {
      CAPTURE(n);
      auto changed = surface;
      colors = before;
      try {
        const Shortage shortage(n);
        run<ColorQuadric>(changed, FaceCount{60}, map(indices));
        has_failed = shortage.has_come();
      } catch (const std::bad_alloc&) {
        REQUIRE((colors == before));
        REQUIRE((snapshot(changed) == snapshot_before));
      }
    }
    CHECK(colors != before);
  };
  survive(mesh, get(boost::vertex_index, mesh));
  survive(soup, boost::typed_identity_property_map<std::size_t>());
}

TEMPLATE_TEST_CASE("Levels are as they were if memory runs out", "", Mesh, PointSoup) {
  Levels levels;
  PointSoup soup(plate());
  simplify(soup.points, soup.triangles, FaceCount{400}, record_into(levels));
  std::size_t faces = levels.coarsest().faces;
  const auto simplify_recorded = [&](TestType& surface) {
    try {
      run(surface, FaceCount{300}, record_into(levels));
      faces = 300;
    } catch (const std::bad_alloc&) {
      CHECK(levels.coarsest().faces == faces);
      CHECK(levels.at(FaceCount{faces}).triangles.size() == faces);
      throw;
    }
  };
  CHECK(survive_shortages(make<TestType>(plate()), simplify_recorded) > 20);
}

TEST_CASE("A soup is as it was if memory runs out while it is clustered") {
  for (const ClusterCells& cells : {ClusterCells(Grid{4, 4, 4}), ClusterCells(FaceCount{60})})
    CHECK(survive_shortages(PointSoup(plate()), [&](PointSoup& soup) {
            cluster_vertices(soup.points, soup.triangles, cells, ClusterPlacement::quadric);
          }) > 20);
}
