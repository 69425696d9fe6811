#ifndef QUADRILLE_INTERNAL_FILE_CHUNKED_SURFACE_H
#define QUADRILLE_INTERNAL_FILE_CHUNKED_SURFACE_H

#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/first_chunks.h>
#include <quadrille/internal/file/input_survey.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/loaded_chunk.h>
#include <quadrille/internal/file/phase_plan.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/verify/allowed_faces.h>
#include <quadrille/internal/verify/distance_surface.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Returns a box that is larger by this length on all sides.
inline CGAL::Bbox_3 grown(const CGAL::Bbox_3& box, double by) {
  return {(box.min)(0) - by, (box.min)(1) - by, (box.min)(2) - by,
          (box.max)(0) + by, (box.max)(1) + by, (box.max)(2) + by};
}

/// Returns the squared distance between two boxes.
inline double squared_distance(const CGAL::Bbox_3& a, const CGAL::Bbox_3& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double d = (std::max)({(a.min)(i) - (b.max)(i), 0.0, (b.min)(i) - (a.max)(i)});
    sum += d * d;
  }
  return sum;
}

/// A surface that is cut into compact chunks. They lie in the folder of a job, as those of its
/// phases do, and one at a time is in memory.
class ChunkedSurface {
public:
  /// `number` is the number of the phase whose names the files have; `tolerance` is the index of
  /// the tolerance among the scalars of vertices, if there is one. `notify(fraction)` is called now
  /// and then, and may throw.
  template <class Notify>
  ChunkedSurface(const JobFolder& folder, unsigned number, const PlyInput& input,
                 std::optional<std::size_t> tolerance, std::uint64_t chunk_faces,
                 std::uint64_t buffers, Notify notify)
      : folder_(folder), tolerance_(tolerance) {
    const InputSurvey survey(input, tolerance, [&](double fraction) { notify(fraction / 2); });
    plan_.phase = number;
    plan_.input = survey.facts();
    folder_.begin_phase(number);
    const std::uint64_t all = plan_.input.used_vertices;
    const std::uint64_t chunks = plan_.input.counted_faces / chunk_faces + 1;
    const std::uint64_t most = chunks == 1 ? all : (std::max)(all / chunks, least_vertices);
    plan_.chunks = FirstChunks(input, survey)
                       .write(folder_, number, most, buffers,
                              [&](double fraction) { notify((1 + fraction) / 2); })
                       .chunks();
    WholeFile no_boundaries(folder_.boundaries(number));
    no_boundaries.finish();
    plan_.boundaries.checksum = Checksum().value();
  }

  /// The box of the vertices that faces use, in their unit.
  CGAL::Bbox_3 box_in_file() const {
    const auto& [low, high] = plan_.input.box;
    return {low[0], low[1], low[2], high[0], high[1], high[2]};
  }
  std::uint64_t faces() const { return plan_.input.counted_faces; }

  /// Sets the frame that applies from now on.
  void enter(const DistanceFrame& frame) {
    frame_ = frame;
    boxes_.clear();
    area_ = 0;
    for (std::size_t p = 0; p < size(); ++p) {
      const LoadedChunk loaded = load(p);
      const DistanceSurface surface = surface_of(loaded);
      boxes_.push_back(bounding_box(surface.vertices));
      area_ += surface.area();
      for (const auto& corners : loaded.triangles) {
        least_ = (std::min)(least_, allowance(loaded, corners));
        greatest_ = (std::max)(greatest_, allowance(loaded, corners));
      }
    }
  }

  std::size_t size() const { return plan_.chunks.size(); }
  double area() const { return area_; }
  const CGAL::Bbox_3& box(std::size_t p) const { return boxes_[p]; }
  /// The least distance that faces allow, as faces() returns it; 0 without tolerances.
  double least_allowance() const { return least_; }
  double greatest_allowance() const { return greatest_; }

  DistanceSurface chunk(std::size_t p) const { return surface_of(load(p)); }

  /// Returns the faces of a chunk; each allows points at a distance up to the least tolerance of
  /// its corners.
  std::vector<AllowedFaces::Face> faces(std::size_t p) const {
    const LoadedChunk loaded = load(p);
    const DistanceSurface surface = surface_of(loaded);
    std::vector<AllowedFaces::Face> faces;
    faces.reserve(surface.triangles.size());
    for (std::size_t f = 0; f < surface.triangles.size(); ++f)
      faces.push_back({surface.triangles[f], allowance(loaded, loaded.triangles[f])});
    return faces;
  }

  /// Returns the faces of a chunk whose boxes meet this one.
  std::vector<DistanceTriangle> near(std::size_t p, const CGAL::Bbox_3& place) const {
    std::vector<DistanceTriangle> faces = chunk(p).triangles;
    std::erase_if(faces, [&](const DistanceTriangle& t) { return !do_overlap(t.bbox(), place); });
    return faces;
  }
  /// Returns such faces of all chunks; nothing if there are more than `most`.
  std::optional<std::vector<AllowedFaces::Face>> near(const CGAL::Bbox_3& place,
                                                      std::size_t most) const {
    std::vector<AllowedFaces::Face> near;
    for (std::size_t p = 0; p < size(); ++p)
      if (do_overlap(boxes_[p], place))
        for (const AllowedFaces::Face& face : faces(p))
          if (do_overlap(face.triangle.bbox(), place)) {
            if (near.size() == most)
              return std::nullopt;
            near.push_back(face);
          }
    return near;
  }

private:
  LoadedChunk load(std::size_t p) const { return LoadedChunk::read(folder_, plan_, p, 0); }

  DistanceSurface surface_of(const LoadedChunk& loaded) const {
    DistanceSurface surface = distance_surface({loaded.positions, loaded.triangles});
    frame_.apply(surface);
    return surface;
  }

  double allowance(const LoadedChunk& loaded, const std::array<Index, 3>& corners) const {
    if (!tolerance_)
      return 0;
    const std::size_t scalars = plan_.input.ranges.low.size();
    const auto of_corner = [&](Index v) { return loaded.scalars[v * scalars + *tolerance_]; };
    return frame_.to(
        (std::min)({of_corner(corners[0]), of_corner(corners[1]), of_corner(corners[2])}));
  }

  // Smaller chunks would consist mostly of boundaries.
  static constexpr std::uint64_t least_vertices = 1000;

  JobFolder folder_;
  PhasePlan plan_;                       // the facts that LoadedChunk requires
  std::optional<std::size_t> tolerance_; // its index among the scalars of a vertex
  DistanceFrame frame_{CGAL::Bbox_3()};
  std::vector<CGAL::Bbox_3> boxes_;
  double area_ = 0;
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNKED_SURFACE_H
