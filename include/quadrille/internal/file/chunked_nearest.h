#ifndef QUADRILLE_INTERNAL_FILE_CHUNKED_NEAREST_H
#define QUADRILLE_INTERNAL_FILE_CHUNKED_NEAREST_H

#include <quadrille/internal/file/chunked_surface.h>
#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/distance_tree.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Measures the distances of points from an out-of-core surface, of which one chunk at a time is in
/// memory. Each point is searched for first in the chunk whose box is nearest to it, and then in
/// the chunks whose boxes are nearer than the distance found.
class ChunkedNearest {
public:
  ChunkedNearest(const ChunkedSurface& surface, const std::vector<DistancePoint>& points)
      : surface_(surface), points_(points), homes_(points.size()),
        squares_(points.size(), std::numeric_limits<double>::infinity()) {}

  /// Returns the squared distance of each point. `ask()` is called before each chunk, and may
  /// throw.
  template <class Ask>
  std::vector<double> squared_distances(const Ask& ask) {
    sort_chunks();
    find_homes();
    std::vector<std::vector<std::size_t>> at_home(surface_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      at_home[homes_[i]].push_back(i);
    for (std::size_t chunk = 0; chunk < at_home.size(); ++chunk)
      if (!at_home[chunk].empty()) {
        ask();
        look_into(chunk, at_home[chunk]);
      }
    for (const auto& [distance, chunk] : chunks_) {
      if (distance >= *std::max_element(squares_.begin(), squares_.end()))
        break;
      ask();
      look_into(chunk, nearer_than_found(chunk));
    }
    return std::move(squares_);
  }

private:
  void sort_chunks() {
    const CGAL::Bbox_3 place = bounding_box(points_);
    for (std::size_t chunk = 0; chunk < surface_.size(); ++chunk)
      chunks_.emplace_back(squared_distance(surface_.box(chunk), place), chunk);
    std::sort(chunks_.begin(), chunks_.end());
  }

  double to_box(std::size_t chunk, std::size_t point) const {
    return squared_distance(surface_.box(chunk), points_[point].bbox());
  }

  void find_homes() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [distance, chunk] : chunks_) {
        if (distance >= least)
          break;
        if (const double d = to_box(chunk, i); d < least) {
          least = d;
          homes_[i] = chunk;
        }
      }
    }
  }

  std::vector<std::size_t> nearer_than_found(std::size_t chunk) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (homes_[i] != chunk && to_box(chunk, i) < squares_[i])
        found.push_back(i);
    return found;
  }

  // After a distance has been found for every point, only faces within the greatest one count.
  void look_into(std::size_t chunk, const std::vector<std::size_t>& points) {
    if (points.empty())
      return;
    CGAL::Bbox_3 place;
    double farthest = 0;
    for (const std::size_t i : points) {
      place += points_[i].bbox();
      farthest = (std::max)(farthest, squares_[i]);
    }
    const std::vector<DistanceTriangle> faces =
        surface_.near(chunk, grown(place, std::sqrt(farthest)));
    if (faces.empty())
      return;
    const DistanceTree tree(faces);
    for (const std::size_t i : points)
      squares_[i] = (std::min)(squares_[i], tree.squared_distance(points_[i]));
  }

  const ChunkedSurface& surface_;
  const std::vector<DistancePoint>& points_;
  std::vector<std::pair<double, std::size_t>> chunks_; // sorted by their distance from all points
  std::vector<std::size_t> homes_;                     // of each point
  std::vector<double> squares_;                        // of the least distance found so far
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNKED_NEAREST_H
