// Results to the last bit, as they were when the table was made: a change that is to change none of
// them shows here if it does. Where results change for the better, the table is made anew: what the
// test prints is its lines. The table holds for x86-64 and the C library of Debian 12, whose
// elementary functions are part of what it fixes.
#include "on_all.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <map>
#include <numbers>
#include <ostream>
#include <sstream>
#include <string>

namespace {

using namespace quadrille;
using namespace test;

// FNV-1a, of 64 bits.
class Digest {
public:
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte)
      value_ = (value_ ^ (value >> 8 * byte & 255)) * 0x100000001b3;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Position& p) {
    for (double x : p.coordinates)
      add(x);
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t digest_of(const Result& result) {
  Digest digest;
  for (const Position& p : result.soup.points)
    digest.add(p);
  for (const Triangle& t : result.soup.triangles)
    for (std::uint64_t v : t)
      digest.add(v);
  for (const std::vector<double>& values : result.attributes)
    for (double x : values)
      digest.add(x);
  digest.add(result.report.error);
  digest.add(result.report.distance_bound);
  digest.add(std::uint64_t{result.report.contractions});
  for (std::size_t cause = 0; cause < rejection_causes; ++cause)
    if (const auto rejection = static_cast<Rejection>(cause);
        rejection != Rejection::seam && rejection != Rejection::texture &&
        rejection != Rejection::hull && rejection != Rejection::volume &&
        rejection != Rejection::self_intersection && rejection != Rejection::normal_deviation &&
        rejection != Rejection::chord) // the table is older
      digest.add(std::uint64_t{result.report.rejections[cause]});
  return digest.value();
}

const std::map<std::string, std::uint64_t> expected{
#include "digests.inc"
};

#if defined(__x86_64__) && defined(__GLIBC__)
constexpr bool has_table = true;
#else
constexpr bool has_table = false;
#endif

void check(const std::string& name, const Result& result) {
  if (!has_table)
    return;
  const std::uint64_t digest = digest_of(result);
  const auto found = expected.find(name);
  if (found != expected.end() && found->second == digest) {
    SUCCEED();
    return;
  }
  std::ostringstream line;
  line << "{\"" << name << "\", 0x" << std::hex << std::setw(16) << std::setfill('0') << digest
       << "},";
  FAIL_CHECK("the table says otherwise than\n" << line.str());
}

// Three walls with a common edge on a plate, and a part that touches it in a vertex.
Soup non_manifold() {
  return joined(surface_of_cubes(6, 6, 6, [](int x, int y, int z) { return (x ^ y ^ z) % 3 == 0; }),
                with_noise(open_cylinder(24, 12), 3, 0.01), {{0.5, 0.25, 6}});
}

Soup terrain() {
  return mapped(with_noise(grid(40, 31), 5, 0.02), [](const Position& p) {
    return Position{{p[0] * 0.3, p[1], 0.1 * p[0] * p[1] + p[2]}};
  });
}

Soup model(const std::string& name) {
  if (name == "terrain")
    return terrain();
  if (name == "non-manifold")
    return non_manifold();
  if (name == "parts")
    return joined(random_closed(3), plate_with_holes(3, 2), {{4, 0, 0}});
  return to_soup(read_model(name));
}

const char* const models[] = {"bunny00", "mannequin-devil", "terrain", "non-manifold", "parts"};

// A filter that refuses slivers by 4√3 · area / Σ|edge|².
struct Compactness {
  using ScaleFree = Compactness;
  static constexpr Rejection cause = Rejection::shape;

  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces()) {
      const double after = of(face.after, face.second, face.third);
      if (after < 0.05 && after < of(face.before, face.second, face.third))
        return false;
    }
    return true;
  }

  static double of(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    const double edges = squared_distance(p, q) + squared_distance(q, r) + squared_distance(r, p);
    return edges > 0 ? 2 * std::numbers::sqrt3 *
                           std::sqrt(squared_length(double_area_vector(p, q, r))) / edges
                     : 0;
  }
};

// Of a soup, on every model.
template <class... Policies>
void check_all(const std::string& mode, const Policies&... policies) {
  for (const std::string name : models)
    check(name + ", " + mode, OnSoup::run(model(name), policies...));
}

} // namespace

TEST_CASE("The same bits as before, by the default order") {
  check_all("quadric", Quadric{}, FaceRatio{0.1});
  check_all("quadric to few", Quadric{}, FaceCount{30});
  check_all("memoryless", MemorylessQuadric{}, FaceRatio{0.1});
  check_all("end points", Quadric{}, EndpointPlacement{}, Compactness{}, FaceRatio{0.2});
}

#ifdef QUADRILLE_WITH_COMPILED // with the headers alone each takes an engine
TEST_CASE("The same bits as before, of other costs") {
  check_all("thin features", ThinFeatureQuadric{}, FaceRatio{0.1});
  check_all("edge length", EdgeLength{}, MidpointPlacement{}, FaceRatio{0.2});
  check_all("colours", ColorQuadric{}, FaceRatio{0.1});
  check_all("texture in passes", TextureQuadric{}, RelaxedOrder{}, FaceRatio{0.1});
}
#endif

TEST_CASE("The same bits as before, in passes") {
  check_all("quadric in passes", Quadric{}, RelaxedOrder{}, FaceRatio{0.1});
  check_all("memoryless in passes", MemorylessQuadric{}, RelaxedOrder{}, FaceRatio{0.1});
  check_all("free in passes", Quadric{}, RelaxedOrder{}, Topology::free, FaceRatio{0.1});
}

TEST_CASE("The same bits as before, free, with other pairs and with bounds") {
  check_all("free", Quadric{}, Topology::free, FaceRatio{0.1});
  for (const std::string name : models) {
    const Soup soup = model(name);
    const ThresholdPairs pairs{0.005 * diagonal(soup)};
    check(name + ", pairs", OnSoup::run(soup, Quadric{}, pairs, FaceRatio{0.1}));
  }
  check_all("bounds", Quadric{}, DistanceLimit{0.01});
  check_all("bounds in passes", Quadric{}, RelaxedOrder{}, DistanceLimit{0.01});
}

TEST_CASE("The same bits as before, of meshes") {
  for (const std::string name : models) {
    if (name == "non-manifold")
      continue;
    check(name + ", mesh", OnMesh<Mesh>::run(model(name), Quadric{}, FaceRatio{0.1}));
    check(name + ", mesh, free",
          OnMesh<Mesh>::run(model(name), Quadric{}, Topology::free, FaceRatio{0.1}));
  }
}
