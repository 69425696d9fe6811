#ifndef QUADRILLE_RECORDED_H
#define QUADRILLE_RECORDED_H

#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

/// \file
/// The events that a recorder receives from a simplification: `simplify(mesh, FaceCount{100},
/// record_into(recorder))`. Levels is a recorder; a user's own may write a log, or another format
/// of progressive meshes.

namespace quadrille {

/// The number of a vertex, a face or a wedge: for a mesh in the order of `vertices(mesh)` and
/// `faces(mesh)`, for a soup its index; with SplitVertices the distinct positions are numbered, in
/// the order of the first point at each.
using RecordedIndex = std::uint32_t;
/// The value of an index that stands for no element.
inline constexpr RecordedIndex not_recorded = ~RecordedIndex{0};

/// A channel of attributes: see channels.h. Values are those that a simplification would write, as
/// doubles; for NewValues::recomputed they are those of least cost.
struct RecordedChannel {
  std::size_t components; ///< the number of components of a value
  /// For each input face, the wedges of its corners; not_recorded for faces that are not in the
  /// surface. It is empty for a channel without seams, whose values are among the numbers of each
  /// vertex.
  std::vector<std::array<RecordedIndex, 3>> corners;
  std::vector<double> values; ///< `components` numbers for each wedge
};

/// The surface before the first contraction.
struct RecordedSurface {
  std::size_t dimension; ///< 3 plus the number of attributes that the cost reads
  /// The number of values of each vertex: `dimension`, and the components of each channel without
  /// seams, in the order of the call.
  std::size_t width;
  std::vector<double> values; ///< the values of each input vertex, in the mesh's units
  /// The vertices of each input face; three times not_recorded for faces that are not in the
  /// surface from the start: degenerate ones, and doubled ones if they are dropped. Both sides of a
  /// double-sided face are in it, and are removed at the same time.
  std::vector<std::array<RecordedIndex, 3>> triangles;
  std::vector<RecordedChannel> channels; ///< in the order of the call
  bool knows_distances; ///< true if a stop policy needs distances, so that contractions contain
                        ///< them
  bool knows_both_ways; ///< true if it needs both directions, so that contractions contain the
                        ///< greater distance
};

/// The effect of a contraction on a wedge of a channel with seams.
struct RecordedWedge {
  std::size_t channel;                   ///< an index of RecordedSurface::channels
  RecordedIndex wedge;                   ///< the number of the wedge in its channel
  std::span<const RecordedIndex> joined; ///< wedges that were merged into it
  std::span<const double> values;        ///< its values after the contraction
};

/// A contraction. Vertices, faces and wedges that lose their last face or corner are removed with
/// it.
struct RecordedContraction {
  /// The vertex that is left; not_recorded if faces are only removed.
  RecordedIndex kept = not_recorded;
  RecordedIndex gone = not_recorded; ///< the vertex that was merged into it; not_recorded in the
                                     ///< same case
  std::span<const double> values;    ///< the values of the kept vertex after the contraction: see
                                     ///< RecordedSurface
  double error = 0;                  ///< as a distance: see Report::error
  double distance_bound = 0;         ///< for the faces that it changes: see knows_distances
  std::span<const RecordedIndex> removed_faces; ///< the numbers of the removed faces
  std::span<const RecordedWedge> wedges;        ///< the wedges at the kept vertex, for all channels
};

/// A rejected pair; it may be tried again when something has changed next to it.
struct RecordedRejection {
  /// An end of the pair; not_recorded for a component that may not vanish.
  RecordedIndex first = not_recorded;
  RecordedIndex second = not_recorded; ///< the other end; not_recorded in the same case
  Rejection cause;                     ///< the cause of the rejection
  double error; ///< the error that the contraction would have had, as a distance: see Report::error
};

/// **Recorder**: receives all contractions. If one of its calls throws, the mesh is unchanged.
///
/// **Has models** Levels.
///
/// **Requirements**, for a `recorder`:
///
/// - `recorder.begin(surface)`: before the first contraction, with a RecordedSurface of its own.
/// - `recorder.record(contraction)`: each RecordedContraction in order. What it refers to is there
///   during the call only.
/// - `recorder.end()`: after the last one, before the mesh is changed.
///
/// **Used where there**:
///
/// - `recorder.reject(rejection)`: each RecordedRejection that Report counts.
/// - `recorder.stop(reason)`: a StopReason, just before the end.
template <class R>
concept ContractionRecorder = requires(R& recorder, RecordedSurface surface,
                                       const RecordedContraction& contraction) {
  recorder.begin(std::move(surface));
  recorder.record(contraction);
  recorder.end();
};

template <ContractionRecorder R>
struct RecordInto; // is in <quadrille/record.h>

} // namespace quadrille

#endif // QUADRILLE_RECORDED_H
