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
/// What a recorder is told of a simplification: `simplify(mesh, FaceCount{100},
/// record_into(recorder))`. Levels is one; a user's own may write a log, or another format of
/// progressive meshes.

namespace quadrille {

/// A vertex, a face or a wedge by its number: those of a mesh in the order of `vertices(mesh)` and
/// `faces(mesh)`, those of a soup by their indices; with SplitVertices, the places of its points in
/// the order of the first one at each.
using RecordedIndex = std::uint32_t;
/// In the place of an index: there is none.
inline constexpr RecordedIndex not_recorded = ~RecordedIndex{0};

/// A channel of attributes: see channels.h. Values are as a simplification would write them, as
/// doubles; those of NewValues::recomputed are those of least cost.
struct RecordedChannel {
  std::size_t components; ///< how many numbers a value has
  /// Of each input face, the wedges of its corners; not_recorded for faces that are not there.
  /// Empty for a channel without seams, whose values are among the numbers of each vertex.
  std::vector<std::array<RecordedIndex, 3>> corners;
  std::vector<double> values; ///< of each wedge, `components` numbers
};

/// The surface before the first contraction.
struct RecordedSurface {
  std::size_t dimension; ///< 3, and how many attributes the cost reads
  /// How many numbers each vertex has: `dimension`, and the components of each channel without
  /// seams, in the order of the call.
  std::size_t width;
  std::vector<double> values; ///< of each input vertex these numbers, in the mesh's units
  /// The vertices of each input face; not_recorded, three times, for faces that are not there from
  /// the beginning: degenerate ones, and doubled ones where they are dropped. Both sides of a sheet
  /// are there, and go at the same time.
  std::vector<std::array<RecordedIndex, 3>> triangles;
  std::vector<RecordedChannel> channels; ///< in the order of the call
  bool knows_distances; ///< does a stop policy ask for distances, so that contractions tell them?
  bool knows_both_ways; ///< and both ways, so that they tell the greater of both?
};

/// What a contraction does to a wedge of a channel that has seams.
struct RecordedWedge {
  std::size_t channel;                   ///< of RecordedSurface::channels
  RecordedIndex wedge;                   ///< of the channel, by its number
  std::span<const RecordedIndex> joined; ///< wedges that have become it
  std::span<const double> values;        ///< afterwards
};

/// A contraction. Vertices, faces and wedges that lose their last face, or corner, are gone with
/// it.
struct RecordedContraction {
  /// The vertex that is left; not_recorded where faces are only removed.
  RecordedIndex kept = not_recorded;
  RecordedIndex gone = not_recorded; ///< the vertex that has become it; the same
  std::span<const double> values;    ///< of the one that is left, afterwards: see RecordedSurface
  double error = 0;                  ///< as a distance: see Report::error
  double distance_bound = 0;         ///< of the faces that it changes: see knows_distances
  std::span<const RecordedIndex> removed_faces; ///< by their numbers
  std::span<const RecordedWedge> wedges; ///< those at the vertex that is left, of all channels
};

/// A pair that has been refused; it may come again, when something has changed beside it.
struct RecordedRefusal {
  /// An end of the pair; not_recorded for a part that may not vanish.
  RecordedIndex first = not_recorded;
  RecordedIndex second = not_recorded; ///< the other end; the same
  Rejection cause;                     ///< why
  double error; ///< of the contraction, had it been done, as a distance: see Report::error
};

/// **Recorder**: what is told of all contractions? If one of its calls throws, the mesh stays as it
/// was.
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
/// - `recorder.refuse(refusal)`: each RecordedRefusal that Report counts.
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
