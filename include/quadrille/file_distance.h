// SPDX-License-Identifier: MIT
//
// Measures how far apart two surfaces are that lie in files and do not fit into memory, and
// verifies the claims made of a result. This header only measures, and quadrille/file.h never
// includes it.

#ifndef QUADRILLE_FILE_DISTANCE_H
#define QUADRILLE_FILE_DISTANCE_H

#include <quadrille/distance.h>
#include <quadrille/file_report.h>
#include <quadrille/internal/file/chunked_distance.h>
#include <quadrille/internal/file/chunked_nearest.h>
#include <quadrille/internal/file/chunked_surface.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/job_lock.h>
#include <quadrille/internal/file/job_watch.h>
#include <quadrille/internal/file/surface_source.h>
#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/distance_findings.h>
#include <quadrille/verdict.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

namespace internal {

/// The folder in which two files are compared; it is removed afterwards.
class FolderOfCheck {
public:
  explicit FolderOfCheck(const std::filesystem::path& scratch) : folder_(scratch), lock_(folder_) {
    if (folder_.phase_at_work() > 0)
      fail_file(folder_.path(), "has a job in it: choose another folder to compare files in");
    folder_.remove_phases();
  }
  FolderOfCheck(const FolderOfCheck&) = delete;
  FolderOfCheck& operator=(const FolderOfCheck&) = delete;
  ~FolderOfCheck() {
    try {
      if (folder_.phase_at_work() == 0)
        lock_.remove_job();
    } catch (const std::exception&) { // a folder that cannot be removed stays
    }
  }

  const JobFolder& folder() const { return folder_; }

private:
  JobFolder folder_;
  JobLock lock_;
};

/// Two files, cut into chunks that are compared.
class FileComparison {
public:
  /// `a` may have tolerances, under a name.
  FileComparison(const SurfaceFiles& a, const SurfaceFiles& b, const OutOfCore& options,
                 const std::string& tolerance = {})
      : options_(options), folder_(options.scratch), a_(cut(1, a, tolerance, 0)),
        b_(cut(2, b, {}, 0.1)), box_(a_.box_in_file() + b_.box_in_file()), frame_(box_) {
    a_.enter(frame_);
    b_.enter(frame_);
  }

  SurfaceDistance distance(const DistanceSampling& sampling) const {
    const auto ab = one_sided(a_, b_, sampling, 0.2), ba = one_sided(b_, a_, sampling, 0.6);
    return symmetric_distance(ab, ba, frame_);
  }

  Verdict verdict(const Claims& claims) const {
    Verdict verdict;
    CheckProgress progress = reported_progress(claims.distance_both_ways ? 2 : 1);
    DistanceFindings::look(claims, apart(DistanceFindings::least(claims), progress), progress,
                           verdict);
    return verdict;
  }

  /// Verifies the tolerances.
  Verdict verdict_of_tolerances() const {
    Verdict verdict;
    CheckProgress progress = reported_progress(2);
    DistanceFindings::look_at_tolerances(apart(frame_.from(a_.least_allowance()), progress),
                                         progress, verdict);
    return verdict;
  }

private:
  // Bounds the size of a chunk that is measured, with the faces that it is measured against. Chunks
  // may have twice as many faces as intended.
  static constexpr std::uint64_t base = 64'000'000, bytes_of_face = 1000;
  std::size_t most_faces() const {
    const std::uint64_t fit = ((std::max)(options_.memory, base) - base) / bytes_of_face;
    return static_cast<std::size_t>(
        options_.chunk_faces > 0 ? options_.chunk_faces : std::max<std::uint64_t>(fit, 10'000));
  }

  CheckProgress reported_progress(std::size_t stages) const {
    return {[&](double fraction) { return notify(0.2 + 0.8 * fraction), true; }, stages};
  }
  ChunkedDistance apart(double expected, CheckProgress& progress) const {
    return {a_, b_, frame_, diagonal(box_), expected, most_faces(), progress};
  }

  ChunkedSurface cut(unsigned number, const SurfaceFiles& files, const std::string& tolerance,
                     double begin) const {
    SurfaceSource source = SurfaceSource::shape_of(files.paths, tolerance);
    const std::optional<std::size_t> place = source.scalars().tolerance();
    const PlyInput& input =
        source.surface(folder_.folder(), options_.memory / 2, [&] { notify(begin); });
    ChunkedSurface surface(folder_.folder(), number, input, place, most_faces(),
                           options_.memory / 16,
                           [&](double fraction) { notify(begin + 0.1 * fraction); });
    folder_.folder().remove_welded();
    return surface;
  }

  // Measures the one-sided distance, as one_sided_distance() does in memory.
  OneSidedDistance one_sided(const ChunkedSurface& from, const ChunkedSurface& to,
                             const DistanceSampling& sampling, double begin) const {
    std::optional<StripSampling> strips;
    if (from.area() > 0 && sampling.samples > 0)
      strips.emplace(from.area(), sampling);
    double sum = 0, largest = 0;
    std::size_t count = 0;
    for (std::size_t p = 0; p < from.size(); ++p) {
      std::vector<DistancePoint> points;
      const std::size_t samples = add_points(from, p, strips, points);
      const double done = begin + 0.4 * static_cast<double>(p) / static_cast<double>(from.size());
      const std::vector<double> squares =
          ChunkedNearest(to, points).squared_distances([&] { notify(done); });
      for (std::size_t i = 0; i < squares.size(); ++i) {
        sum += i < samples ? squares[i] : 0;
        largest = (std::max)(largest, squares[i]);
      }
      count += samples;
    }
    return {std::sqrt(sum / static_cast<double>(count)), std::sqrt(largest)};
  }

  // Returns how many of the points are samples, which come first.
  static std::size_t add_points(const ChunkedSurface& from, std::size_t p,
                                std::optional<StripSampling>& strips,
                                std::vector<DistancePoint>& points) {
    const DistanceSurface chunk = from.chunk(p);
    if (strips) {
      for (const DistanceTriangle& face : chunk.triangles)
        strips->take(face, points);
      if (p + 1 == from.size())
        strips->end(points);
    }
    const std::size_t samples = points.size();
    points.insert(points.end(), chunk.vertices.begin(), chunk.vertices.end());
    return strips ? samples : points.size();
  }

  void notify(double fraction) const {
    FileStatus status;
    status.stage = FileStage::check;
    status.progress = fraction;
    if (options_.proceed && !options_.proceed(status))
      throw JobCancelled();
  }

  const OutOfCore& options_;
  FolderOfCheck folder_;
  ChunkedSurface a_, b_;
  CGAL::Bbox_3 box_;
  DistanceFrame frame_;
};

} // namespace internal

/// Returns the sampled distance between two surfaces in files, as surface_distance() does for
/// surfaces in memory. It takes as many samples, at other places, and all vertices.
///
/// The files are those that simplify_file reads and writes. They are cut into compact chunks in
/// `options.scratch`, in a folder of their own that is removed at the end, with about 30 bytes for
/// each face of both. A chunk is measured against the chunks of the other surface near it, one at a
/// time, so that the limit `options.memory` is kept. The only other options that apply are
/// `chunk_faces` and `proceed`, which receives FileStage::check and the progress.
///
/// Complexity: O((n + s) log n) for n faces and s samples, if the two surfaces are close to each
/// other. Throws std::runtime_error with the name of the file for a file that cannot be read or has
/// no faces, and for a scratch folder that contains a job; and internal::JobCancelled if `proceed`
/// ends it.
inline SurfaceDistance file_distance(const SurfaceFiles& a, const SurfaceFiles& b,
                                     const OutOfCore& options,
                                     const DistanceSampling& sampling = {}) {
  return internal::FileComparison(a, b, options).distance(sampling);
}

/// Verifies that a result in a file keeps the distances claimed of it, as verify() does for
/// surfaces in memory: by subdividing faces, not by samples.
///
/// Claims may be about distances, in one direction or both. For other claims, which need the whole
/// surface, it throws std::invalid_argument. `options.tolerance` claims the tolerances that the
/// input has under that name (see ToleranceLimit), in addition to distances or instead of them.
/// `claims.progress` is ignored, and `options.proceed` is called. A chunk is measured against all
/// faces within the claimed distance. This keeps the limit `options.memory` as long as these are no
/// more faces than a chunk has: a result that breaks its claim by far takes more. Otherwise as
/// file_distance().
inline Verdict verify_files(const SurfaceFiles& input, const SurfaceFiles& result,
                            const Claims& claims, const OutOfCore& options) {
  internal::DistanceFindings::require_sense(claims);
  if (!claims.tolerances.empty() || claims.no_self_intersection || claims.solid ||
      claims.normal_deviation)
    throw std::invalid_argument(
        "quadrille::verify_files: only distances, and tolerances by the name of a property, "
        "can be claimed of files");
  Verdict verdict;
  if (claims.are_distances_claimed())
    verdict = internal::FileComparison(input, result, options).verdict(claims);
  if (!options.tolerance.empty())
    for (Finding& finding : internal::FileComparison(input, result, options, options.tolerance)
                                .verdict_of_tolerances()
                                .findings)
      verdict.findings.push_back(std::move(finding));
  return verdict;
}

} // namespace quadrille

#endif // QUADRILLE_FILE_DISTANCE_H
