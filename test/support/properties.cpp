#include "properties.h"

#include "farthest.h"
#include "filter_promises.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

namespace test {

namespace {

using namespace quadrille;

/// The same for all triangles on the same vertices; or, if sides are told apart, for those of them
/// that run the same way round.
Triangle key_of(Triangle t, bool reports_sides) {
  if (reports_sides)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  else
    std::sort(t.begin(), t.end());
  return t;
}

} // namespace

Soup cleaned(Soup soup, bool reports_sides) {
  std::set<Triangle> seen;
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
           !seen.insert(key_of(t, reports_sides)).second;
  });
  return soup;
}

bool is_clean(const Soup& soup, bool may_have_reverse_faces) {
  std::set<Triangle> seen;
  std::set<std::uint32_t> used;
  for (const Triangle& t : soup.triangles) {
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || sorted[2] >= soup.points.size() ||
        !seen.insert(may_have_reverse_faces ? key_of(t, true) : sorted).second)
      return false;
    used.insert(t.begin(), t.end());
  }
  return used.size() == soup.points.size() && is_finite(soup);
}

Seen::Seen(const Asked& asked_surface, const Result& its_result)
    : asked(asked_surface), result(its_result), before(cleaned(asked.soup, !asked.is_mesh)),
      topology_before(topology_of(before)) {}

const SoupTopology& Seen::topology_after() const {
  if (!topology_after_)
    topology_after_ = topology_of(after());
  return *topology_after_;
}

namespace {

/// The first of some sentences of which what they say does not hold.
class Complaint {
public:
  void require(bool holds, const std::string& what) {
    if (!holds && text_.empty())
      text_ = what;
  }
  std::string text() const { return text_; }

private:
  std::string text_;
};

std::size_t count_non_manifold_edges(const Soup& soup) {
  std::map<std::array<std::uint32_t, 2>, int> faces;
  for (const auto& [a, b, c] : soup.triangles)
    for (const auto& [v, w] : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)})
      ++faces[{v, w}];
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const auto& e) { return e.second > 2; }));
}

double squared_distance_to_segment(const Position& x, const Position& p, const Position& q) {
  const double length = squared_distance(p, q);
  const double t = length > 0 ? std::clamp(dot(x - p, q - p) / length, 0.0, 1.0) : 0;
  return squared_distance(x, p + t * (q - p));
}

double squared_distance_to_triangle(const Position& x, const Position& p, const Position& q,
                                    const Position& r) {
  double least =
      std::min({squared_distance_to_segment(x, p, q), squared_distance_to_segment(x, q, r),
                squared_distance_to_segment(x, r, p)});
  const Position n = cross(q - p, r - p);
  const auto is_left = [&](const Position& a, const Position& b) {
    return dot(cross(b - a, x - a), n) >= 0;
  };
  if (squared_length(n) > 0 && is_left(p, q) && is_left(q, r) && is_left(r, p))
    least = std::min(least, dot(x - p, n) * dot(x - p, n) / squared_length(n));
  return least;
}

// The Euler characteristic of each part and how many borders it has, in order.
std::multiset<std::array<std::ptrdiff_t, 2>> topologies_of_parts(const Soup& soup) {
  detail::Partition parts(soup.points.size());
  for (const auto& [a, b, c] : soup.triangles)
    parts.merge(a, b), parts.merge(b, c);
  std::map<std::uint32_t, Soup> by_root;
  for (const Triangle& t : soup.triangles) {
    Soup& part = by_root[parts.root(t[0])];
    part.points = soup.points;
    part.triangles.push_back(t);
  }
  std::multiset<std::array<std::ptrdiff_t, 2>> result;
  for (const auto& [root, part] : by_root) {
    const SoupTopology topology = topology_of(part);
    result.insert({static_cast<std::ptrdiff_t>(topology.euler()),
                   static_cast<std::ptrdiff_t>(topology.boundary_loops)});
  }
  return result;
}

// Cancelled before the first contraction a surface is as it was, with all that is odd about it.
bool is_untouched(const Seen& seen) {
  return seen.report().stop == StopReason::cancelled && seen.report().contractions == 0;
}

std::string valid(const Seen& seen) {
  Complaint complaint;
  complaint.require(is_finite(seen.after()), "a point is not finite");
  if (!seen.asked.attributes.empty())
    complaint.require(seen.result.attributes.size() >= seen.after().points.size(),
                      "attributes are missing");
  for (const std::vector<double>& values : seen.result.attributes)
    for (const double x : values)
      complaint.require(std::isfinite(x), "an attribute is not finite");
  for (const Triangle& t : seen.after().triangles)
    for (std::uint32_t v : t)
      complaint.require(v < seen.after().points.size(), "an index of no point");
  if (is_untouched(seen))
    complaint.require(seen.report().faces_after == seen.report().faces_before,
                      "faces went though nothing was done");
  return complaint.text();
}

std::string clean(const Seen& seen) {
  Complaint complaint;
  const SoupTopology& topology = seen.topology_after();
  complaint.require(!topology.has_collapsed_faces, "a face with two equal corners");
  const bool has_sides = seen.topology_before.has_duplicate_faces && !seen.asked.is_mesh;
  complaint.require(cleaned(seen.after(), has_sides).triangles.size() ==
                            seen.after().triangles.size() ||
                        seen.report().duplicated_vertices > 0,
                    "a duplicate face");
  complaint.require(topology.vertices == seen.after().points.size(), "a point of no face");
  return complaint.text();
}

std::string counts(const Seen& seen) {
  Complaint complaint;
  const Report& report = seen.report();
  const SoupTopology& before = seen.topology_before;
  complaint.require(report.faces_before == seen.asked.soup.triangles.size(), "faces_before");
  complaint.require(seen.asked.is_mesh || report.counted_faces == seen.before.triangles.size(),
                    "counted_faces");
  complaint.require(report.vertices_before == seen.asked.soup.points.size(), "vertices_before");
  complaint.require(report.faces_after == seen.after().triangles.size(), "faces_after");
  complaint.require(report.vertices_after == seen.after().points.size(), "vertices_after");
  complaint.require(report.contractions + report.vertices_after - report.duplicated_vertices <=
                        before.vertices,
                    "more contractions than vertices are gone");
  complaint.require(report.error >= 0 && std::isfinite(report.error),
                    "the error is not a distance");
  complaint.require(report.components_before == before.components, "components_before");
  complaint.require(!seen.asked.is_by_edges || report.non_edge_contractions == 0,
                    "non_edge_contractions");
  if (report.duplicated_vertices > 0)
    return complaint.text(); // the numbers are those of the surface before it is taken apart
  const SoupTopology& after = seen.topology_after();
  complaint.require(report.components_after == after.components, "components_after");
  complaint.require(report.non_manifold_edges == count_non_manifold_edges(seen.after()),
                    "non_manifold_edges");
  complaint.require((report.non_manifold_edges == 0 && report.non_manifold_vertices == 0) ==
                        after.is_manifold,
                    "non_manifold_vertices");
  return complaint.text();
}

std::string target(const Seen& seen) {
  const Asked& asked = seen.asked;
  const Report& report = seen.report();
  Complaint complaint;
  if (report.stop == StopReason::cancelled) {
    complaint.require(asked.may_be_cancelled, "cancelled by nobody");
    return complaint.text();
  }
  Status status;
  status.initial_faces = seen.before.triangles.size();
  status.initial_vertices = seen.topology_before.vertices;
  status.faces = report.faces_after;
  status.vertices = report.vertices_after - report.duplicated_vertices;
  status.contractions = report.contractions;
  const bool is_met = is_target_reached(report.stop);
  if (asked.stop && asked.stops_at_distance) {
    // What may be nothing but rounding passes any limit: see DistanceLimit.
    status.next_distance =
        std::max(0.0, report.distance_bound - 0x1p-39 * greatest_coordinate(seen.before));
    complaint.require(!asked.stop(status), "the result is beyond the limit");
  } else if (asked.stop) {
    complaint.require(asked.stop(status) == is_met, "it and the reason to stop do not agree");
  }
  if (asked.contractions && is_met)
    complaint.require(report.contractions == *asked.contractions, "contractions after it was met");
  return complaint.text();
}

// At the corners and in the middle of each face.
std::string distance_bound(const Seen& seen) {
  const Soup &before = seen.before, &after = seen.after();
  if (before.triangles.empty() || before.triangles.size() * after.triangles.size() > 20'000)
    return {};
  const double size = diagonal(before);
  if (!(size > 1e-60 && size < 1e60))
    return {}; // squares over- or underflow here
  double far = 0;
  for (const Position& p : before.points)
    far = std::max(far, std::sqrt(squared_length(p)));
  const double limit = seen.report().distance_bound * (1 + 1e-6) + 1e-9 * size + 1e-14 * far;
  const auto is_near = [&](const Position& x) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : before.triangles)
      nearest = std::min(nearest, squared_distance_to_triangle(x, before.points[a],
                                                               before.points[b], before.points[c]));
    return std::sqrt(nearest) <= limit;
  };
  for (const auto& [a, b, c] : after.triangles) {
    const Position &p = after.points[a], &q = after.points[b], &r = after.points[c];
    if (!is_near(p) || !is_near(1.0 / 3 * (p + q + r)))
      return "the result is further away";
  }
  return {};
}

std::set<std::array<double, 3>> places_of(const Soup& soup) {
  std::set<std::array<double, 3>> places;
  for (const Position& p : soup.points)
    places.insert(p.coordinates);
  return places;
}

std::string constraints(const Seen& seen) {
  const Soup &before = seen.before, &after = seen.after();
  Complaint complaint;
  const std::set<std::array<double, 3>> there = places_of(after);
  if (!seen.asked.is_fixed.empty())
    for (const Triangle& t : before.triangles)
      for (std::uint32_t v : t)
        complaint.require(!seen.asked.is_fixed[v] || there.contains(before.points[v].coordinates),
                          "a fixed vertex is gone");
  std::set<std::array<std::array<double, 3>, 2>> edges;
  if (!seen.asked.kept.empty())
    for (const Triangle& t : after.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          edges.insert({after.points[t[i]].coordinates, after.points[t[j]].coordinates});
  for (const auto& [v, w] : seen.asked.kept)
    complaint.require(edges.contains({before.points[v].coordinates, before.points[w].coordinates}),
                      "a constrained edge is gone");
  return complaint.text();
}

// Each part of the result has the topology of another one of the input.
std::string topology_of_parts(const Seen& seen) {
  const SoupTopology &before = seen.topology_before, &after = seen.topology_after();
  Complaint complaint;
  complaint.require(after.components + seen.report().vanished_components == before.components,
                    "the count of parts that vanished");
  complaint.require(before.components == 0 || after.components > 0, "nothing is left");
  if (!before.is_manifold)
    return complaint.text();
  complaint.require(after.is_manifold, "no manifold any more");
  const auto parts_before = topologies_of_parts(seen.before),
             parts_after = topologies_of_parts(seen.after());
  complaint.require(std::includes(parts_before.begin(), parts_before.end(), parts_after.begin(),
                                  parts_after.end()),
                    "that of a part changed");
  return complaint.text();
}

std::string topology(const Seen& seen) {
  if (seen.asked.topology == Topology::components_may_vanish)
    return topology_of_parts(seen);
  Complaint complaint;
  complaint.require(seen.report().vanished_components == 0 || seen.asked.topology == Topology::free,
                    "parts vanished");
  if (seen.asked.topology != Topology::kept)
    return complaint.text();
  const SoupTopology& before = seen.topology_before;
  SoupTopology after = seen.topology_after();
  complaint.require(after.components == before.components, "components changed");
  if (!before.is_oriented) // the faces that are left may be
    after.is_oriented = false;
  if (!before.is_manifold || is_same_topology(before, after))
    return complaint.text();
  std::ostringstream what;
  what << "it changed: " << before << " -> " << after;
  complaint.require(false, what.str());
  return complaint.text();
}

// Positions, and attributes with them, are those of a point of the input.
std::string endpoints(const Seen& seen) {
  if (!seen.asked.is_at_endpoints)
    return {};
  const bool has_attributes = !seen.asked.attributes.empty();
  const auto values_of = [&](const std::vector<std::vector<double>>& values, std::size_t v) {
    return has_attributes ? values[v] : std::vector<double>{};
  };
  std::set<std::pair<std::array<double, 3>, std::vector<double>>> there;
  const Soup &input = seen.asked.soup, &after = seen.after();
  for (std::size_t v = 0; v < input.points.size(); ++v)
    there.insert({input.points[v].coordinates, values_of(seen.asked.attributes, v)});
  for (std::size_t v = 0; v < after.points.size(); ++v)
    if (!there.contains({after.points[v].coordinates, values_of(seen.result.attributes, v)}))
      return "a position that is not of the input, or its attributes are not";
  return {};
}

// What a filter lets pass is as good as it says, or as the face of the input was.
template <class Bound, class Excess>
std::string filtered(const std::optional<Bound>& bound, double slack, Excess excess) {
  return bound && !(excess(*bound) <= slack) ? "a face is worse than allowed and than it was" : "";
}
FilterPromises promises_of(const Seen& seen) {
  return {seen.asked.soup, seen.after(), seen.result.input_faces, seen.result.images};
}
std::string smallest_angle(const Seen& seen) {
  return filtered(seen.asked.smallest_angle, 1e-5,
                  [&](double degrees) { return promises_of(seen).lost_degrees(degrees); });
}
std::string longest_edge(const Seen& seen) {
  return filtered(seen.asked.longest_edge, 1e-12,
                  [&](double length) { return promises_of(seen).gained_length(length); });
}
std::string degree(const Seen& seen) {
  return filtered(seen.asked.degree, 0,
                  [&](std::size_t degree) { return promises_of(seen).gained_faces(degree); });
}

// Measured by CGAL's tree, to the last bits.
std::string within_limits(const Seen& seen) {
  const Asked& asked = seen.asked;
  if (!asked.distance && !asked.distance_both_ways)
    return {};
  const Report& report = seen.report();
  const double rounding = 1e-13 * greatest_coordinate(asked.soup);
  Complaint complaint;
  complaint.require(farthest(seen.after(), asked.soup, 3) <= report.distance_bound + rounding,
                    "further away than told");
  if (asked.distance)
    complaint.require(report.distance_bound <= *asked.distance * (1 + 1e-6), "beyond the limit");
  if (std::isfinite(report.hausdorff_bound))
    complaint.require(farthest(asked.soup, seen.after(), 3) <= report.hausdorff_bound + rounding,
                      "the input is further away than told");
  if (asked.distance_both_ways)
    complaint.require(report.hausdorff_bound <= *asked.distance_both_ways * (1 + 1e-6),
                      "beyond the limit of both ways");
  return complaint.text();
}

// Of each face the least one of its corners, both ways.
std::string within_tolerances(const Seen& seen) {
  const Asked& asked = seen.asked;
  const Soup &input = asked.soup, &after = seen.after();
  if (asked.tolerances.empty() || !std::isfinite(seen.report().hausdorff_bound) ||
      after.triangles.empty())
    return {};
  const double rounding = 1e-11 * greatest_coordinate(input);
  const auto of_face = [&](const Triangle& t) {
    const auto& of = asked.tolerances;
    return std::min({of[t[0]], of[t[1]], of[t[2]]});
  };
  Complaint complaint;
  const Nearest nearest(after);
  std::map<double, Soup> faces; // by what they allow
  for (const Triangle& t : input.triangles) {
    faces[of_face(t)].triangles.push_back(t);
    for_each_point(input, t, 3, [&](const Position& p) {
      complaint.require(nearest.distance(p) <= of_face(t) + rounding, "the input is further away");
    });
  }
  std::map<double, Nearest> nearest_by_tolerance;
  for (auto& [tolerance, soup] : faces) {
    soup.points = input.points;
    nearest_by_tolerance.emplace(tolerance, soup);
  }
  for (const Triangle& t : after.triangles)
    for_each_point(after, t, 3, [&](const Position& p) {
      complaint.require(
          std::any_of(nearest_by_tolerance.begin(), nearest_by_tolerance.end(),
                      [&](const auto& n) { return n.second.distance(p) <= n.first + rounding; }),
          "the result is further away");
    });
  return complaint.text();
}

std::string same_topology(const Seen& seen) {
  const SoupTopology before = topology_of(seen.asked.soup), &after = seen.topology_after();
  return !before.is_manifold || (is_same_topology(before, after) && !after.has_duplicate_faces &&
                                 !after.has_collapsed_faces)
             ? ""
             : "it changed";
}

// How many parts, connected by edges, each label has.
std::map<std::int32_t, std::size_t> regions_of(const Soup& soup,
                                               const std::vector<std::int32_t>& labels) {
  std::map<std::int32_t, Soup> faces;
  for (std::size_t f = 0; f < labels.size(); ++f)
    faces[labels[f]].triangles.push_back(soup.triangles[f]);
  std::map<std::int32_t, std::size_t> regions;
  for (auto& [label, of_label] : faces) {
    of_label.points = soup.points;
    regions[label] = topology_of(of_label).components;
  }
  return regions;
}

// Pairs of labels of faces that have an edge in common.
std::set<std::array<std::int32_t, 2>> meetings_of(const Soup& soup,
                                                  const std::vector<std::int32_t>& of_face) {
  std::map<std::array<std::uint32_t, 2>, std::set<std::int32_t>> edges;
  for (std::size_t f = 0; f < of_face.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle& t = soup.triangles[f];
      const auto [v, w] = std::minmax(t[i], t[(i + 1) % 3]);
      edges[{v, w}].insert(of_face[f]);
    }
  std::set<std::array<std::int32_t, 2>> meetings;
  for (const auto& [edge, labels] : edges)
    if (labels.size() == 2)
      meetings.insert({*labels.begin(), *labels.rbegin()});
  return meetings;
}

std::string regions(const Seen& seen) {
  const Soup &before = seen.asked.soup, &after = seen.after();
  const auto &labels_before = seen.asked.labels, &labels_after = seen.result.labels;
  if (!labels_before.empty() && labels_after.size() != after.triangles.size())
    return "labels that are not one for each face";
  Complaint complaint;
  complaint.require(regions_of(before, labels_before) == regions_of(after, labels_after),
                    "another number of them");
  complaint.require(meetings_of(before, labels_before) == meetings_of(after, labels_after),
                    "others meet");
  return complaint.text();
}

constexpr std::array of_results{Property{"valid", valid},
                                Property{"clean", clean},
                                Property{"counts", counts},
                                Property{"target", target},
                                Property{"distance_bound", distance_bound},
                                Property{"constraints", constraints},
                                Property{"topology", topology},
                                Property{"endpoints", endpoints}};
constexpr std::array of_levels{Property{"smallest angle", smallest_angle},
                               Property{"longest edge", longest_edge}, Property{"degree", degree},
                               Property{"limits", within_limits}};
constexpr std::array of_files{Property{"topology", same_topology}, Property{"regions", regions},
                              Property{"limits", within_limits},
                              Property{"tolerances", within_tolerances}};

} // namespace

std::span<const Property> properties_of_results() {
  return of_results;
}
std::span<const Property> properties_of_levels() {
  return of_levels;
}
std::span<const Property> properties_of_files() {
  return of_files;
}

std::string broken(const Asked& asked, const Result& result, std::span<const Property> properties) {
  const Seen seen(asked, result);
  for (const Property& property : properties) {
    const std::string complaint = property.complaint(seen);
    if (!complaint.empty())
      return std::string(property.name) + ": " + complaint;
    if (is_untouched(seen))
      break;
  }
  return {};
}

} // namespace test
