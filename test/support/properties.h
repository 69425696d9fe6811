#ifndef QUADRILLE_TEST_SUPPORT_PROPERTIES_H
#define QUADRILLE_TEST_SUPPORT_PROPERTIES_H

#include "soups.h"

#include <quadrille/pairs.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// What must hold of a result, whatever the surface, what holds it, and the policies: each property
/// is a function of what was asked and of what came out. A test makes both and picks a list.

namespace test {

/// What was given to a run and what was asked of it, as far as properties look at it.
struct Asked {
  Soup soup;
  bool is_mesh =
      false; ///< of which no two faces have the same corners, not even a face and its back
  std::vector<std::vector<double>> attributes;    ///< of each point, if the cost looks at them
  std::vector<bool> is_fixed;                     ///< one per point, or empty
  std::vector<std::array<std::uint32_t, 2>> kept; ///< constrained edges
  quadrille::Topology topology = quadrille::Topology::kept;
  bool is_by_edges = true;      ///< no pairs but edges
  bool is_at_endpoints = false; ///< the placement is at one end of each pair
  bool may_be_cancelled = false;

  /// Is the target met there? Not looked at if there is none.
  std::function<bool(const quadrille::Status&)> stop;
  bool stops_at_distance = false;          ///< the target is a limit of the distance
  std::optional<std::size_t> contractions; ///< the target is so many of them

  /// What filters and limits allow, each if it was asked for.
  std::optional<double> smallest_angle, longest_edge, distance, distance_both_ways;
  std::optional<std::size_t> degree;
  std::vector<double> tolerances; ///< of each point, or empty

  std::vector<std::int32_t> labels; ///< of each face, or empty
};

/// What came out.
struct Result {
  Soup soup;
  std::vector<std::vector<double>> attributes; ///< of each point, if the cost looks at them
  quadrille::Report report;
  std::vector<std::uint32_t> images; ///< which point each one of the input has become, if known
  std::vector<std::uint32_t> input_faces; ///< which face of the input each face has been, if known
  std::vector<std::int32_t> labels;       ///< of each face, or empty
};

/// What properties see: both, without faces that are none, and their topologies.
class Seen {
public:
  Seen(const Asked& asked, const Result& result);

  const Asked& asked;
  const Result& result;
  Soup before; ///< without triangles that have two equal corners, and without doubles
  SoupTopology topology_before;

  const Soup& after() const { return result.soup; }
  const quadrille::Report& report() const { return result.report; }
  /// The indices must be valid.
  const SoupTopology& topology_after() const;

private:
  mutable std::optional<SoupTopology> topology_after_;
};

struct Property {
  std::string_view name;
  std::string (*complaint)(const Seen&); ///< nothing where it holds, or does not apply
};

/// Of any result of `simplify`: valid and clean, a report that tells what there is, a target that
/// is met or a reason why not, a bound of the distance, constraints, topology, and positions at
/// ends.
std::span<const Property> properties_of_results();
/// Of surfaces with `images` and `input_faces`, as levels have them: what filters and limits
/// promise from the first contraction to the last. Of the report they look at its bounds only.
std::span<const Property> properties_of_levels();
/// Of surfaces in files, which keep their topology, with labels of faces: regions, limits and
/// tolerances. Of the report they look at its bounds only.
std::span<const Property> properties_of_files();

/// The first property that does not hold, with what is wrong; or nothing.
std::string broken(const Asked& asked, const Result& result,
                   std::span<const Property> properties = properties_of_results());

/// The triangles without those that have two equal corners and without doubles; those on the same
/// vertices that run the other way round are no doubles if sides are told apart.
Soup cleaned(Soup soup, bool reports_sides);

/// Neither degenerate nor duplicate faces, but for those with a back if there may be any; no point
/// without a face, all finite.
bool is_clean(const Soup& soup, bool may_have_reverse_faces = false);

} // namespace test

#endif // QUADRILLE_TEST_SUPPORT_PROPERTIES_H
