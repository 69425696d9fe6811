#ifndef QUADRILLE_TEST_CASES_CASES_H
#define QUADRILLE_TEST_CASES_CASES_H

#include "../support/meshes.h"
#include "../support/soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/order.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/report.h>
#include <quadrille/stop.h>

#include <CGAL/IO/Color.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// \file
/// Surfaces and policies made from bytes, those of a fuzzer or of a random generator, and what must
/// hold of every result.

namespace test {

/// Bytes as numbers; zeros when they have run out.
class Bytes {
public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }
  std::uint8_t byte();
  std::uint64_t word(); ///< of eight bytes
  std::size_t below(std::size_t n) { return byte() % n; }
  bool one_in(std::size_t n) { return below(n) == n - 1; } ///< false when they have run out

private:
  std::span<const std::uint8_t> bytes_;
};

struct Never {
  bool operator()(const quadrille::Status&) const { return false; }
};

struct AfterContractions {
  std::size_t count;
  bool operator()(const quadrille::Status& status) const { return status.contractions >= count; }
};

/// A stop policy that is known at run time.
struct AnyStop {
  std::variant<Never, quadrille::FaceCount, quadrille::FaceRatio, quadrille::VertexCount,
               quadrille::DistanceLimit, AfterContractions,
               quadrille::AnyOf<quadrille::FaceCount, quadrille::DistanceLimit>,
               quadrille::AllOf<quadrille::VertexCount, AfterContractions>>
      chosen;

  static constexpr quadrille::Needs needs = {.distance = true}; // some of them do

  bool operator()(const quadrille::Status& status) const {
    return std::visit([&](const auto& stop) -> bool { return stop(status); }, chosen);
  }
  bool is_passed(const quadrille::Status& status) const {
    return std::visit(
        [&](const auto& stop) {
          if constexpr (requires { stop.is_passed(status); })
            return stop.is_passed(status);
          else
            return false;
        },
        chosen);
  }
};

enum class CostName {
  quadric,
  memoryless,
  color,
  edge_length,
  attributes,
  thin_feature,
  channels ///< a Quadric beside labels, a texture, normals and colours, on a soup
};
enum class PlacementName { optimal, endpoint, midpoint };

/// A call of simplify.
struct Call {
  CostName cost = CostName::quadric;
  PlacementName placement = PlacementName::optimal;
  double boundary_weight = 100;
  double crease_degrees = 180;
  quadrille::Weighting weighting = quadrille::Weighting::by_area;
  double threshold = 0; ///< of the ThresholdPairs; 0 is the same as EdgePairs
  AnyStop stop;
  std::optional<quadrille::RelaxedOrder> relaxed; ///< GreedyOrder without it
  quadrille::Topology topology = quadrille::Topology::free;
  double flip_degrees = 90;
  double smallest_angle = 0; ///< in degrees
  std::size_t degree = std::numeric_limits<std::size_t>::max();
  std::size_t cancel_at = std::numeric_limits<std::size_t>::max(); ///< the call of the visitor
};

/// What TextureQuadric sees of a vertex.
using Numbers = std::array<double, 2>;

/// A surface with all that a call may look at.
struct Case {
  Soup soup;
  std::vector<CGAL::IO::Color> colors;            ///< one per point
  std::vector<Numbers> numbers;                   ///< one per point, for the cost `attributes`
  std::vector<bool> is_fixed;                     ///< one per point
  std::vector<std::array<std::uint32_t, 2>> kept; ///< constrained edges, for a mesh only
  std::uint64_t seed = 0;         ///< of labels and of values at corners, for `channels`
  std::optional<Numbers> weights; ///< of the numbers; the cost's own without them
  bool may_be_rejected = false;   ///< the numbers may be no lengths
  bool is_mesh = false; ///< a Surface_mesh and no soup; the soup is manifold and oriented then
  Call call;
};

std::ostream& operator<<(std::ostream&, const Call&);
std::ostream& operator<<(std::ostream&, const Case&); ///< with its soup as an OFF file

/// Small surfaces of any kind: manifold or glued at random, flat, folded, in one place, with
/// coordinates that are not finite and indices of no point. Larger ones with `size` 2 and above.
Case make_case(Bytes bytes, int size = 1);

/// What `simplify` has made of a case.
struct Outcome {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<CGAL::IO::Color> colors;
  std::vector<Numbers> numbers;
  quadrille::Report report;
};

/// Calls `simplify` as the case says. What it throws comes out; `outcome` is then what it has left.
void simplify(const Case& input, Outcome& outcome);

/// Simplifies and looks at the result: what is wrong with it, or nothing.
std::string violation(const Case& input);

/// A case with as few faces as easily found for which something is wrong still.
Case shrunk(Case input);

} // namespace test

#endif // QUADRILLE_TEST_CASES_CASES_H
