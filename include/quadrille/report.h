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

/// The stages of a simplification, with the names of Report::seconds. Nothing is reported while the
/// surface is read.
enum class Stage {
  prepare,  ///< the surface has been read; data for the costs is computed, then pairs are costed
  contract, ///< pairs are contracted or rejected
  write     ///< no more contractions are done, and the surface is about to be rewritten
};

/// The state of the surface just before the next contraction, as a stop policy sees it.
struct Status {
  std::size_t initial_faces = 0;    ///< the faces of the input, without degenerate and doubled ones
  std::size_t initial_vertices = 0; ///< the vertices of the input, without isolated ones
  std::size_t faces = 0;            ///< now
  std::size_t vertices = 0;         ///< now
  /// The edges of the input. An edge counts once, however many faces it has. Edges are counted for
  /// stop policies that declare Needs::edges, as EdgeCount does; for others both numbers are the
  /// greatest ones of the type.
  std::size_t initial_edges = (std::numeric_limits<std::size_t>::max)();
  std::size_t edges = (std::numeric_limits<std::size_t>::max)(); ///< now
  std::size_t contractions = 0;                                  ///< so far
  /// The error of the next contraction, as a distance in the mesh's units: see Report::error.
  double next_error = 0;
  /// The cost of the next contraction, including the tie break, as the cost policy computes it in
  /// the mesh's units: see CostLimit. It is known to a stop policy that declares Needs::cost; for
  /// others it is infinity. It is 0 when a stop policy is called for the surface and not for a
  /// contraction.
  double next_cost = std::numeric_limits<double>::infinity();
  /// A bound on the distance of any point of the surface from the input after the next contraction,
  /// in the mesh's units. It is known to a stop policy that declares Needs::distance; for others it
  /// is infinity. A bound up to 2⁻⁴⁰ of the greatest coordinate is reported as 0, since it may be
  /// mere rounding. Once a policy stops at some distance, no greater one is computed. See
  /// Report::distance_bound.
  double next_distance = std::numeric_limits<double>::infinity();
  /// A bound on the reverse distance, of any point of the input from the surface. It is known to a
  /// stop policy that declares Needs::reverse_distance, as HausdorffLimit does; for others it is
  /// infinity. It is 0 while next_distance is still computed, which comes first.
  double next_reverse_distance = std::numeric_limits<double>::infinity();
  /// A bound on the fraction of its tolerance that any point has used: see ToleranceLimit. It is
  /// known to a stop policy that declares Needs::tolerance; for others it is infinity. It is 0
  /// while distances are still computed, which come first.
  double next_tolerance = std::numeric_limits<double>::infinity();
  double diagonal = 0; ///< the diagonal of the input's bounding box, in the mesh's units
  /// For visitors: the estimated fraction of the contractions that are done, as far as the stop
  /// policy lets it be predicted; 0 while the surface is prepared, and 1 at the last call only.
  double progress = 0;
  Stage stage = Stage::prepare; ///< for visitors: the current stage
};

/// The reason why a simplification has ended.
enum class StopReason {
  target_met,    ///< the stop policy was satisfied
  target_passed, ///< an exact count was missed by a face or so: no pair would have met it, or only
                 ///< a costly one
  no_pair_left,  ///< every pair has been contracted
  all_pairs_rejected, ///< pairs are left, but the topology or a filter rejects all of them
  target_unreachable, ///< constraints (topology, constrained vertices, seams, filters) keep most of
                      ///< the surface, so the rest would have lost its shape before the target was
                      ///< reached. A coarser target gives the same surface
  cancelled           ///< the visitor cancelled it
};

/// Returns whether the target was reached, exactly or almost.
constexpr bool is_target_reached(StopReason reason) {
  return reason == StopReason::target_met || reason == StopReason::target_passed;
}

/// The reason why a contraction was rejected.
enum class Rejection {
  topology,    ///< the link condition does not hold: the contraction would change the topology
  constraint,  ///< an end or the edge itself is constrained
  normal_flip, ///< a face would flip, or turn further than the filter allows
  shape,       ///< a good triangle would become a sliver
  degree,      ///< the vertex would have too many edges
  distance,    ///< the surface would exceed the distance that the stop policy allows
  position,    ///< the placement returned a position that is not finite
  destruction, ///< the free rest of a constrained surface would lose its shape
  seam,    ///< the topology of a region of labels, or of a chart of a texture, would change: see
           ///< Labels and Texture
  texture, ///< a face would flip in a texture: see Texture
  hull,    ///< no position satisfies the planes around the pair: see OuterHull
  volume,  ///< no position keeps the volume: see VolumeKeeping
  filter,  ///< a filter of the user, or LongestEdge
  /// Faces would intersect that do not yet: see NoSelfIntersection.
  self_intersection,
  normal_deviation, ///< a normal would be too far from those of the input: see NormalDeviation
  chord, ///< a new edge between two shared vertices would arise: see vertex_is_shared_map
};
inline constexpr std::size_t rejection_causes = 16; ///< the number of causes

/// Returns the name of a stage.
constexpr std::string_view to_string(Stage stage) {
  constexpr std::array<std::string_view, 3> names{"prepare", "contract", "write"};
  return names[static_cast<std::size_t>(stage)];
}

/// Returns the name of a reason, as Report prints it.
constexpr std::string_view to_string(StopReason reason) {
  constexpr std::array<std::string_view, 6> names{"target met",         "target passed",
                                                  "no pair left",       "all pairs rejected",
                                                  "target unreachable", "cancelled"};
  return names[static_cast<std::size_t>(reason)];
}

/// Returns the name of a cause, as Report prints it.
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

/// The report of `simplify`. It can be printed in one line.
struct Report {
  /// The faces of the input, including degenerate and doubled ones.
  std::size_t faces_before = 0;
  std::size_t counted_faces = 0;   ///< the number without these, which stop policies count
  std::size_t faces_after = 0;     ///< the faces of the result
  std::size_t vertices_before = 0; ///< the vertices of the input, including isolated ones
  std::size_t vertices_after = 0;  ///< the vertices of the result

  std::size_t contractions = 0;          ///< vertices merged into others
  std::size_t non_edge_contractions = 0; ///< contractions of two vertices without a common face

  std::size_t components_before = 0; ///< connected components of the input
  std::size_t components_after = 0;  ///< connected components of the result
  /// Components that were removed entirely: see Topology::components_may_vanish. If topology is
  /// free, components of which no vertex is left, nor any vertex that one of theirs has become.
  std::size_t vanished_components = 0;
  /// The size of the largest removed component: the diagonal of its bounding box, in the mesh's
  /// units.
  double largest_vanished_component = 0;
  /// Gaps across which components were joined before: see SoupOptions::join_gaps. Each is one
  /// component less.
  std::size_t joined_gaps = 0;
  std::size_t open_gaps = 0; ///< gaps that could not be joined: see GapChanges::open_gaps
  /// Handles and tunnels that were cut before: see SoupOptions::simplified_topology. The genus of
  /// the surface, that of all its components together, is by this number less.
  std::size_t cut_handles = 0;
  /// Components that were cut in two before.
  std::size_t split_components = 0;
  /// No point of the faces that close these cuts is further than this from the input, of which no
  /// point has moved; in the mesh's units. Distances and limits are those from the surface after
  /// the cuts, so a result within a limit is within the sum of both of the input.
  double cut_distance = 0;
  std::size_t split_vertices = 0; ///< vertices that were added before: see SoupOptions::manifold
  std::size_t split_edges = 0;    ///< edges that were split in their middle before, for the same
  std::size_t kept_planes = 0;    ///< plane regions that were kept: see KeepPlanes
  std::size_t non_manifold_edges = 0;    ///< edges of the result with at least three faces
  std::size_t non_manifold_vertices = 0; ///< vertices of the result whose faces form neither a
                                         ///< disc nor half a disc
  std::size_t duplicated_vertices = 0;   ///< added to write a non-manifold result to a FaceGraph
  /// Input faces that were left out before the first contraction because another face has the same
  /// vertices. In a soup the two sides of a double-sided face do not count here: both stay.
  std::size_t doubled_faces = 0;
  /// Faces that were removed because another face with the same corners but another label is left:
  /// in the input, or if topology is free.
  std::size_t doubled_labels = 0;

  StopReason stop = StopReason::no_pair_left; ///< the reason why it has ended

  /// The largest error of any contraction, as a distance in the mesh's units; or, if that is
  /// larger, the distance of a removed component from the rest plus its radius.
  ///
  /// For a quadric it is √(Q(x)/w): the root mean square distance from the new vertex x to the
  /// planes accumulated in its quadric, with the weights of the quadric (w is their sum). It is an
  /// estimate, not a bound: it is measured only at vertices, to planes instead of triangles, and a
  /// plane may count up to three times. Where the surface is thin, as in foils and blades, planes
  /// of little area hardly affect this mean; there the error is at least the displacement by which
  /// vertices have receded from the surface. For the distance between the surfaces call
  /// `surface_distance` of <quadrille/distance.h>.
  double error = 0;

  /// An upper bound on the distance of any point of the result from the input, in the mesh's units,
  /// up to the rounding of the mesh's own coordinates. It is often several times the measured
  /// distance. It is known if a stop policy needs it, as DistanceLimit does, and infinite
  /// otherwise. It includes rounding errors, so it may exceed a limit below 2⁻⁴⁰ of the greatest
  /// coordinate. It does not bound the reverse distance, of input points that the result has lost.
  /// But if topology is kept, no boundary has receded further, and no component has vanished whose
  /// diameter is greater than the limit.
  double distance_bound = std::numeric_limits<double>::infinity();

  /// An upper bound on the Hausdorff distance of result and input, in the mesh's units: no point of
  /// either is further from the other. It is never less than distance_bound, and as conservative.
  /// It is known if a stop policy needs both directions, as HausdorffLimit does, and infinite
  /// otherwise. It is also infinite if the result has lost points of the input, with vanished
  /// components or faces, in a run whose stop policy does not prevent this.
  double hausdorff_bound = std::numeric_limits<double>::infinity();

  /// The greatest fraction of its tolerance that any point of the surface has used, and its place.
  struct UsedTolerance {
    double fraction = 0; ///< the fraction: an upper bound, 1 if the whole tolerance may be used
    std::array<double, 3> place{}; ///< the centre of that face
  };
  /// It is known with ToleranceLimit.
  std::optional<UsedTolerance> used_tolerance;

  /// The volume that the surface encloses, in the mesh's units cubed: the integral of its winding
  /// number, which is negative if the surface is oriented inwards. It is known with OuterHull,
  /// InnerHull and KeepSolid{}, and with VolumeKeeping where topology is kept and each vertex lies
  /// inside an oriented surface without boundary. For the result it is computed before coordinates
  /// are rounded to the mesh's number type.
  std::optional<double> volume_before;
  std::optional<double> volume_after; ///< the volume of the result

  /// The numbers of pairs of faces that intersect outside of their common vertices and edges.
  struct SelfIntersections {
    std::size_t before = 0; ///< in the input, without degenerate and doubled faces
    std::size_t after = 0;  ///< in the result; all of them intersected in the input
  };
  /// They are known with NoSelfIntersection and KeepSolid{}.
  std::optional<SelfIntersections> self_intersections;

  /// An upper bound on the angle between any normal of the result and those of the input faces that
  /// its face stands for, in degrees. It is known with NormalDeviation.
  std::optional<double> normal_bound_degrees;

  /// The numbers of rejected contractions, by cause. A pair counts each time that it is rejected.
  std::array<std::size_t, rejection_causes> rejections{};
  /// Returns the number of contractions that were rejected for one cause.
  std::size_t rejected(Rejection cause) const {
    return rejections[static_cast<std::size_t>(cause)];
  }

  /// The wall-clock times of the stages.
  struct Seconds {
    double read = 0;     ///< reading the mesh and its attributes
    double prepare = 0;  ///< computing costs and pairs
    double contract = 0; ///< contracting pairs
    double write = 0;    ///< writing the result to the mesh
    /// Returns the total time.
    double total() const { return read + prepare + contract + write; }
  };
  Seconds seconds; ///< the time it took
};

namespace internal {

/// Prints which components and handles of a surface are gone.
inline void print_lost_components(std::ostream& out, const Report& report) {
  if (report.components_before != report.components_after)
    out << ", " << report.components_before << " -> " << report.components_after << " components";
  if (report.vanished_components > 0)
    out << ", " << report.vanished_components << " components vanished, of sizes up to "
        << report.largest_vanished_component;
  if (report.joined_gaps > 0)
    out << ", " << report.joined_gaps << " gaps joined";
  if (report.open_gaps > 0)
    out << ", " << report.open_gaps << " gaps left open";
  if (report.cut_handles > 0)
    out << ", " << report.cut_handles << " handles cut";
  if (report.split_components > 0)
    out << ", " << report.split_components << " components cut in two";
  if (report.cut_distance > 0)
    out << ", cuts closed within " << report.cut_distance << " of the input";
  if (report.split_vertices > 0)
    out << ", " << report.split_vertices << " vertices split";
  if (report.split_edges > 0)
    out << ", " << report.split_edges << " edges split";
}

} // namespace internal

/// Prints a report in one line, without an end of line; numbers that are 0 or unknown are left out.
inline std::ostream& operator<<(std::ostream& out, const Report& report) {
  out << report.faces_before << " -> " << report.faces_after << " faces, " << report.vertices_before
      << " -> " << report.vertices_after << " vertices, " << report.contractions
      << " contractions, stopped: " << to_string(report.stop) << ", error " << report.error;
  if (report.distance_bound < std::numeric_limits<double>::infinity())
    out << ", within " << report.distance_bound << " of the input";
  if (report.hausdorff_bound < std::numeric_limits<double>::infinity())
    out << ", " << report.hausdorff_bound << " both ways";
  if (report.used_tolerance)
    out << ", " << report.used_tolerance->fraction << " of the tolerance used";
  if (report.volume_before && report.volume_after)
    out << ", volume " << *report.volume_before << " -> " << *report.volume_after;
  if (report.self_intersections)
    out << ", self-intersections " << report.self_intersections->before << " -> "
        << report.self_intersections->after;
  if (report.normal_bound_degrees)
    out << ", normals within " << *report.normal_bound_degrees << " degrees";
  if (report.non_edge_contractions > 0)
    out << ", " << report.non_edge_contractions << " contractions without an edge";
  internal::print_lost_components(out, report);
  if (report.kept_planes > 0)
    out << ", " << report.kept_planes << " plane regions kept";
  if (report.non_manifold_edges + report.non_manifold_vertices > 0)
    out << ", " << report.non_manifold_edges << " non-manifold edges, "
        << report.non_manifold_vertices << " non-manifold vertices";
  if (report.doubled_faces > 0)
    out << ", " << report.doubled_faces << " duplicate faces left out";
  if (report.doubled_labels > 0)
    out << ", " << report.doubled_labels << " duplicate faces with other labels";
  const char* separator = ", rejected: ";
  for (std::size_t cause = 0; cause < rejection_causes; ++cause) {
    if (report.rejections[cause] == 0)
      continue;
    out << separator << report.rejections[cause] << ' ' << to_string(static_cast<Rejection>(cause));
    separator = ", ";
  }
  return out << ", " << report.seconds.total() << " s";
}

/// The numbers of a Status that are only computed for stop policies that declare them: see
/// StopPolicy. Other policies see the greatest numbers of the type, or infinity.
struct Needs {
  bool distance = false;         ///< Status::next_distance, as for DistanceLimit
  bool reverse_distance = false; ///< Status::next_reverse_distance, as for HausdorffLimit; implies
                                 ///< `distance`
  bool tolerance = false;        ///< Status::next_tolerance, as for ToleranceLimit; implies both of
                                 ///< these
  bool cost = false;             ///< Status::next_cost, as for CostLimit
  bool edges = false;            ///< Status::edges and initial_edges, as for EdgeCount

  /// Returns the union of both needs.
  friend constexpr Needs operator|(const Needs& a, const Needs& b) {
    return {a.distance || b.distance, a.reverse_distance || b.reverse_distance,
            a.tolerance || b.tolerance, a.cost || b.cost, a.edges || b.edges};
  }
  /// Returns the intersection of both needs.
  friend constexpr Needs operator&(const Needs& a, const Needs& b) {
    return {a.distance && b.distance, a.reverse_distance && b.reverse_distance,
            a.tolerance && b.tolerance, a.cost && b.cost, a.edges && b.edges};
  }
  /// Compares needs.
  friend constexpr bool operator==(const Needs&, const Needs&) = default;
};

/// Watches a simplification, and may cancel it: a base for a user's own visitor, given as the CGAL
/// named parameter `visitor`.
///
/// A visitor is copied, as all named parameters are. `visitor(std::ref(v))` refers to v itself, so
/// that its data is available after the call. It need not be constant.
struct Visitor {
  /// The thread that has called `simplify` calls it:
  ///
  /// - when the surface has been read: no contractions, Status::progress 0, Stage::prepare
  /// - several times while the surface is prepared, and once for every 65,536 vertices while pairs
  ///   are costed for the queue: with the same values
  /// - before the first pair is considered: with the same values, but Stage::contract from here on
  /// - after every few hundred pairs, contracted or not, and after each pass of RelaxedOrder
  /// - at the end, unless it has cancelled, just before the surface is rewritten: Status::progress
  ///   1, Stage::write. The return value then has no effect.
  ///
  /// A recorder receives each contraction: see record.h.
  ///
  /// Returning false ends the simplification with StopReason::cancelled: before the first
  /// contraction the surface is unchanged, later it has the contractions done so far. To compute
  /// Status::progress, the stop policy is called beforehand for lower counts.
  bool proceed(const Status& /*status*/) const { return true; }
};

/// **Visitor**: receives the progress of a simplification and may cancel it.
///
/// **Has models** Visitor.
///
/// **Requirements**, for a `visitor`, which need not be constant:
///
/// - `visitor.proceed(status)`: a bool; `status` is a Status. Visitor says when it is called.
template <class V>
concept VisitorPolicy = requires(V& visitor, const Status status) {
  { visitor.proceed(status) } -> std::convertible_to<bool>;
};

} // namespace quadrille

#endif // QUADRILLE_REPORT_H
