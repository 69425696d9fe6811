#ifndef QUADRILLE_REPORT_H
#define QUADRILLE_REPORT_H

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <string_view>

namespace quadrille {

/// What a simplification is at, by the names of Report::seconds. Nobody is told of anything while
/// the surface is read.
enum class Stage {
  prepare,  ///< the surface has been read; what costs need of it is computed, then pairs are costed
  contract, ///< pairs are contracted, or refused
  write     ///< nothing more is contracted, and the surface is about to be rewritten
};

/// What a stop policy sees: the surface as it is just before the next contraction.
struct Status {
  std::size_t initial_faces = 0;    ///< of the input, without degenerate and doubled ones
  std::size_t initial_vertices = 0; ///< of the input, those with faces
  std::size_t faces = 0;            ///< now
  std::size_t vertices = 0;         ///< now
  /// The same of edges, of which one is one however many faces it has. Known to a stop policy that
  /// says Needs::edges, as EdgeCount; for others nothing is counted, and these are the greatest
  /// numbers that there are.
  std::size_t initial_edges = (std::numeric_limits<std::size_t>::max)();
  std::size_t edges = (std::numeric_limits<std::size_t>::max)(); ///< now
  std::size_t contractions = 0;                                  ///< so far
  /// The error of the contraction that comes next, as a distance in the mesh's units: see
  /// Report::error.
  double next_error = 0;
  /// What the contraction that comes next costs, with what tells equal costs apart, as the cost
  /// policy computes it in the mesh's units: see CostLimit. Known to a stop policy that says
  /// Needs::cost; for others nothing is, and this is infinity. It is 0
  /// where a stop policy is asked about the surface and not about a contraction.
  double next_cost = std::numeric_limits<double>::infinity();
  /// No point of the surface will be further from the input than that after the contraction that
  /// comes next, in the mesh's units. Known to a stop policy that says Needs::distance; for
  /// others nothing is, and this is infinity. It is 0 up to 2⁻⁴⁰ of
  /// the greatest coordinate, where it may be nothing but rounding; and once a policy stops at some
  /// distance, no greater one is looked for. See Report::distance_bound.
  double next_distance = std::numeric_limits<double>::infinity();
  /// No point of the input will be further from the surface than that: the other way round. Known
  /// to a stop policy that says Needs::distance_back, as HausdorffLimit; else infinity. It is 0,
  /// too, as long as next_distance is looked for, which comes first.
  double next_distance_back = std::numeric_limits<double>::infinity();
  /// No point will have used more of its tolerance than that part: see ToleranceLimit. Known to a
  /// stop policy that says Needs::tolerance; else infinity. It is 0, too, as long as distances are
  /// looked for, which come first.
  double next_tolerance = std::numeric_limits<double>::infinity();
  double diagonal = 0; ///< of the input's bounding box, in the mesh's units
  /// What a visitor sees: about which part of the contractions has been done, as far as the stop
  /// policy tells beforehand; 0 while the surface is prepared, 1 at the last call only.
  double progress = 0;
  Stage stage = Stage::prepare; ///< what a visitor sees
};

/// Why a simplification has ended.
enum class StopReason {
  target_met,    ///< the stop policy said so
  target_passed, ///< the same, a face or so beyond an exact count: a pair that meets it was not
                 ///< there, or not worth its price
  no_pair_left,  ///< every pair has been contracted
  all_pairs_rejected, ///< pairs are left, and each of them is refused by the topology or by a
                      ///< filter
  target_unreachable, ///< most of the surface is held by what is to be kept (topology, constraints,
                      ///< seams, filters), so the rest would have lost its shape on the way to the
                      ///< target. A coarser target ends with the same surface
  cancelled           ///< the visitor said so
};

/// Has the stop policy had its will, exactly or next to it?
constexpr bool is_target_reached(StopReason reason) {
  return reason == StopReason::target_met || reason == StopReason::target_passed;
}

/// Why a contraction was refused.
enum class Rejection {
  topology,    ///< the link condition does not hold: the contraction would change the topology
  constraint,  ///< an end or the edge itself is constrained
  normal_flip, ///< a face would turn over, or further than the filter allows
  shape,       ///< a good triangle would become a sliver
  degree,      ///< the vertex would have too many edges
  distance,    ///< the surface would leave the distance that the stop policy allows
  position,    ///< the placement gave a position that is not finite
  destruction, ///< what is left free of a surface that is held would lose its shape
  seam,    ///< a region of labels, or a chart of a texture, would not stay: see Labels and Texture
  texture, ///< a face would turn over in a texture: see Texture
  hull,    ///< no place that the planes around it allow: see OuterHull
  volume,  ///< no place that keeps the volume: see VolumeKeeping
  filter,  ///< a filter of the user's refused, or LongestEdge
  /// faces would intersect that do not: see NoSelfIntersection
  self_intersection,
  normal_deviation, ///< a normal would be too far from those of the input: see NormalDeviation
  chord, ///< an edge between two shared vertices would come about: see vertex_is_shared_map
};
inline constexpr std::size_t rejection_causes = 16; ///< how many there are

/// In words.
constexpr std::string_view to_string(Stage stage) {
  constexpr std::array<std::string_view, 3> names{"prepare", "contract", "write"};
  return names[static_cast<std::size_t>(stage)];
}

/// In words, as Report prints it.
constexpr std::string_view to_string(StopReason reason) {
  constexpr std::array<std::string_view, 6> names{"target met",         "target passed",
                                                  "no pair left",       "all pairs rejected",
                                                  "target unreachable", "cancelled"};
  return names[static_cast<std::size_t>(reason)];
}

/// How a Report names the cause of a refusal.
constexpr std::string_view to_string(Rejection cause) {
  constexpr std::array<std::string_view, rejection_causes> names{"topology",
                                                                 "constraint",
                                                                 "normal flip",
                                                                 "shape",
                                                                 "degree",
                                                                 "distance",
                                                                 "position",
                                                                 "destruction",
                                                                 "seam",
                                                                 "texture",
                                                                 "hull",
                                                                 "volume",
                                                                 "filter",
                                                                 "self-intersection",
                                                                 "normal deviation",
                                                                 "chord"};
  return names[static_cast<std::size_t>(cause)];
}

/// What `simplify` did. It prints itself in one line.
struct Report {
  std::size_t faces_before = 0;    ///< of the input, with degenerate and doubled ones
  std::size_t counted_faces = 0;   ///< the same without them: what stop policies count
  std::size_t faces_after = 0;     ///< of the result
  std::size_t vertices_before = 0; ///< of the input, with isolated ones
  std::size_t vertices_after = 0;  ///< of the result

  std::size_t contractions = 0;          ///< pairs of vertices made one
  std::size_t non_edge_contractions = 0; ///< those of them that had no face in common

  std::size_t components_before = 0; ///< parts of the input that no vertex connects
  std::size_t components_after = 0;  ///< the same of the result
  /// Those that went whole: see Topology::parts_may_vanish. Where topology is free, those of which
  /// no vertex is left, nor one that any of them has become.
  std::size_t vanished_parts = 0;
  /// How large the largest of them was: the diagonal of its bounding box, in the mesh's units.
  double largest_vanished_part = 0;
  std::size_t non_manifold_edges = 0;    ///< of the result: edges of three faces or more
  std::size_t non_manifold_vertices = 0; ///< of the result: neither a disc nor half a disc around
  std::size_t duplicated_vertices = 0;   ///< added to write a non-manifold result to a FaceGraph
  /// Faces of the input that were left out before the first contraction because another one on the
  /// same vertices is left. Of a soup, the two sides of a sheet are no such faces: both are left.
  std::size_t doubled_faces = 0;
  /// Faces that went because another one of the same corners is left, which has another label: of
  /// the input, or where topology is free.
  std::size_t doubled_labels = 0;

  StopReason stop = StopReason::no_pair_left; ///< why it has ended

  /// The largest error of any contraction, as a distance in the mesh's units; or how far a part
  /// that vanished lies from what is left, with its radius, if that is larger.
  ///
  /// For a quadric it is √(Q(x)/w): the root mean square distance from the new vertex x to the
  /// planes that it remembers, weighted as the quadric weights them (w is their sum). It is an
  /// estimate and no bound: it is measured at vertices only, to planes and not to triangles, and a
  /// plane may count up to three times. Where the surface is thin, as foils and blades are, planes
  /// of little area hide in that mean: there it is at least the way by which vertices have receded
  /// from the surface. For the distance between the surfaces call `surface_distance` of
  /// <quadrille/distance.h>.
  double error = 0;

  /// No point of the result is further from the input than that, in the mesh's units: an upper
  /// bound, up to the rounding of the mesh's own coordinates, and often several times the distance
  /// that can be measured. Known where a stop policy asks for it, as DistanceLimit does, else
  /// infinite. Roundings are included, so it may be beyond a limit that is less than 2⁻⁴⁰ of the
  /// greatest coordinate. It says nothing of the other direction, of the input's points that the
  /// result has lost, but that where topology is kept no border has receded further, and no part
  /// has vanished whose diameter is greater than the limit.
  double distance_bound = std::numeric_limits<double>::infinity();

  /// No point of the result is further from the input than that, and no point of the input further
  /// from the result: a bound of the Hausdorff distance of both, in the mesh's units, never less
  /// than distance_bound and as conservative. Known where a stop policy asks for both, as
  /// HausdorffLimit does, else infinite; and infinite where points of the input have got lost, with
  /// parts that vanish or faces that do, in a run that is not stopped by that.
  double hausdorff_bound = std::numeric_limits<double>::infinity();

  /// How much of its tolerance a point of the surface has used at most, and where.
  struct UsedTolerance {
    double part = 0; ///< of the tolerance: an upper bound, 1 where all of it may be used
    std::array<double, 3> place{}; ///< the middle of the face of which that is so
  };
  /// Known with ToleranceLimit.
  std::optional<UsedTolerance> used_tolerance;

  /// The volume that the surface encloses, in the mesh's units, cubed: the sum of its winding
  /// numbers over space, so negative where it is oriented inwards. Known with OuterHull,
  /// InnerHull and KeepSolid{}, and with VolumeKeeping where topology is kept and each vertex lies
  /// inside of an oriented surface without borders. Of the result it is that of coordinates before
  /// they are rounded to the mesh's number type.
  std::optional<double> volume_before;
  std::optional<double> volume_after; ///< the same of the result

  /// How many pairs of faces intersect beyond the vertices and edges that both have.
  struct SelfIntersections {
    std::size_t before = 0; ///< of the input, without degenerate and doubled faces
    std::size_t after = 0;  ///< of the result, all of which did in the input
  };
  /// Known with NoSelfIntersection and KeepSolid{}.
  std::optional<SelfIntersections> self_intersections;

  /// No normal of the result is further than that from those of the faces of the input that it
  /// stands for, in degrees: an upper bound, known with NormalDeviation.
  std::optional<double> normal_bound_degrees;

  /// How many contractions were refused, by cause. A pair counts each time that it is refused.
  std::array<std::size_t, rejection_causes> rejections{};
  /// How many contractions were refused for one cause.
  std::size_t rejected(Rejection cause) const {
    return rejections[static_cast<std::size_t>(cause)];
  }

  /// How long it took, by the clock.
  struct Seconds {
    double read = 0;     ///< the mesh and its attributes
    double prepare = 0;  ///< costs and pairs
    double contract = 0; ///< pairs
    double write = 0;    ///< the result into the mesh
    /// All of it.
    double total() const { return read + prepare + contract + write; }
  };
  Seconds seconds; ///< how long it took
};

/// Prints a report in one line, without an end of line; what is 0 or unknown is left out.
inline std::ostream& operator<<(std::ostream& out, const Report& report) {
  out << report.faces_before << " -> " << report.faces_after << " faces, " << report.vertices_before
      << " -> " << report.vertices_after << " vertices, " << report.contractions
      << " contractions, stopped: " << to_string(report.stop) << ", error " << report.error;
  if (report.distance_bound < std::numeric_limits<double>::infinity())
    out << ", within " << report.distance_bound << " of the input";
  if (report.hausdorff_bound < std::numeric_limits<double>::infinity())
    out << ", " << report.hausdorff_bound << " both ways";
  if (report.used_tolerance)
    out << ", " << report.used_tolerance->part << " of the tolerance used";
  if (report.volume_before && report.volume_after)
    out << ", volume " << *report.volume_before << " -> " << *report.volume_after;
  if (report.self_intersections)
    out << ", self-intersections " << report.self_intersections->before << " -> "
        << report.self_intersections->after;
  if (report.normal_bound_degrees)
    out << ", normals within " << *report.normal_bound_degrees << " degrees";
  if (report.non_edge_contractions > 0)
    out << ", " << report.non_edge_contractions << " contractions of no edge";
  if (report.components_before != report.components_after)
    out << ", " << report.components_before << " -> " << report.components_after << " components";
  if (report.vanished_parts > 0)
    out << ", " << report.vanished_parts << " parts vanished, of sizes up to "
        << report.largest_vanished_part;
  if (report.non_manifold_edges + report.non_manifold_vertices > 0)
    out << ", " << report.non_manifold_edges << " non-manifold edges, "
        << report.non_manifold_vertices << " non-manifold vertices";
  if (report.doubled_faces > 0)
    out << ", " << report.doubled_faces << " doubled faces left out";
  if (report.doubled_labels > 0)
    out << ", " << report.doubled_labels << " doubled faces of other labels";
  const char* separator = ", rejected: ";
  for (std::size_t cause = 0; cause < rejection_causes; ++cause) {
    if (report.rejections[cause] == 0)
      continue;
    out << separator << report.rejections[cause] << ' ' << to_string(static_cast<Rejection>(cause));
    separator = ", ";
  }
  return out << ", " << report.seconds.total() << " s";
}

/// Which numbers of a Status a stop policy needs that are found out for those only that need them:
/// see StopPolicy. Others are told the greatest numbers that there are, or infinity.
struct Needs {
  bool distance = false;      ///< Status::next_distance, as DistanceLimit does
  bool distance_back = false; ///< Status::next_distance_back, as HausdorffLimit; implies `distance`
  bool tolerance = false;     ///< Status::next_tolerance, as ToleranceLimit; implies both of these
  bool cost = false;          ///< Status::next_cost, as CostLimit
  bool edges = false;         ///< Status::edges and initial_edges, as EdgeCount

  /// What either needs.
  friend constexpr Needs operator|(const Needs& a, const Needs& b) {
    return {a.distance || b.distance, a.distance_back || b.distance_back,
            a.tolerance || b.tolerance, a.cost || b.cost, a.edges || b.edges};
  }
  /// What both need.
  friend constexpr Needs operator&(const Needs& a, const Needs& b) {
    return {a.distance && b.distance, a.distance_back && b.distance_back,
            a.tolerance && b.tolerance, a.cost && b.cost, a.edges && b.edges};
  }
  /// Do both need the same?
  friend constexpr bool operator==(const Needs&, const Needs&) = default;
};

/// Watches a simplification, and may cancel it: a base for a user's own visitor, given as the CGAL
/// named parameter `visitor`.
///
/// A visitor is copied, as all that is given by name; `visitor(std::ref(v))` refers to v itself, so
/// that what it has gathered is there after the call. It need not be constant.
struct Visitor {
  /// Called by the thread that has called `simplify`:
  ///
  /// - when the surface has been read: no contractions, Status::progress 0, Stage::prepare
  /// - while it is prepared, several times, and where pairs are costed for the queue once for
  ///   65,536 vertices: the same
  /// - before the first pair is looked at: the same, but Stage::contract from here on
  /// - every few hundred pairs that are looked at, contracted or not, and after each pass of
  ///   RelaxedOrder
  /// - at the end, unless it has cancelled, just before the surface is rewritten: Status::progress
  ///   1, Stage::write. What it returns then has no effect.
  ///
  /// What becomes of each pair is told to a recorder instead: see record.h.
  ///
  /// Returning false ends the simplification with StopReason::cancelled: before the first
  /// contraction with the surface as it was, later with what has been done until then. So that
  /// Status::progress can be told, the stop policy is asked beforehand about counts to come.
  bool proceed(const Status& /*status*/) const { return true; }
};

/// **Visitor**: what is told of a simplification, and may cancel it?
///
/// **Has models** Visitor.
///
/// **Requirements**, for a `visitor`, which need not be constant:
///
/// - `visitor.proceed(status)`: a bool; `status` is a Status. When it is called: see Visitor.
template <class V>
concept VisitorPolicy = requires(V& visitor, const Status status) {
  { visitor.proceed(status) } -> std::convertible_to<bool>;
};

} // namespace quadrille

#endif // QUADRILLE_REPORT_H
