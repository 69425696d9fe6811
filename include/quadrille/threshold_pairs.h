#ifndef QUADRILLE_THRESHOLD_PAIRS_H
#define QUADRILLE_THRESHOLD_PAIRS_H

// This header includes CGAL's kd-tree, which is GPL: a program that includes it comes under the GPL
// (or CGAL's commercial licence). <quadrille/simplify.h> does not include it.

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/pairs/close_points.h>
#include <quadrille/internal/core/pairs/face_points.h>
#include <quadrille/pairs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille {

/// The edges of the surface, and all pairs of vertices that are closer than a threshold t at the
/// beginning: components that lie close to each other are joined. A pair at exactly the distance t
/// does not count.
///
/// Points that no face uses make no pairs. A t of less than 2^-1000 times the largest coordinate
/// counts as that.
///
/// The pairs are found with CGAL's kd-tree, in O(n log n + pairs) for n vertices.
/// Source: Garland and Heckbert 1997, section 3.2.
class ThresholdPairs {
public:
  static constexpr bool includes_edges = true;  ///< edges are pairs, too
  static constexpr bool ignores_indices = true; ///< the engine may reorder points

  /// t is in the mesh's units, at least 0 and finite. A vertex can have O(n) others within t, so
  /// more than 64 times as many pairs as vertices are rejected.
  explicit ThresholdPairs(double t) : t_(t) {}

  /// t as a fraction of the diagonal of the bounding box.
  static ThresholdPairs relative(double fraction) {
    ThresholdPairs pairs(fraction);
    pairs.is_relative_ = true;
    return pairs;
  }

  /// Throws std::invalid_argument for a threshold that is negative or not finite.
  void validate() const {
    if (!(t_ >= 0) || !std::isfinite(t_))
      throw std::invalid_argument("quadrille::ThresholdPairs: the threshold " +
                                  internal::text_of(t_) + " is not a distance");
  }

  /// Calls emit(i, j) for each pair of points i < j closer than t, ordered by i, then by j. Throws
  /// std::length_error, before the first call, if there are more of them than allowed.
  void operator()(const SurfaceView& surface, const EmitPair& emit) const {
    if (!(t_ > 0))
      return;
    const internal::FacePoints points(surface);
    const double diagonal = points.diagonal();
    if (points.size() == 0 || (is_relative_ && diagonal == 0))
      return;
    const double t = is_relative_ ? t_ * diagonal : points.length_from_mesh(t_);
    const internal::ClosePoints finder(points.positions(),
                                       std::clamp(t, points.least, points.greatest));
    require_few(finder, points.size(), points.length_of_mesh(t));
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      finder.find_after(i, near);
      for (std::uint32_t j : near)
        emit(points.index(i), points.index(j));
    }
  }

private:
  static constexpr int most_pairs_a_vertex = 64;

  void require_few(const internal::ClosePoints& finder, std::size_t points, double t) const {
    const double limit = most_pairs_a_vertex * static_cast<double>(points);
    const double pairs = finder.count_pairs(limit);
    if (pairs > limit)
      reject((std::max)(pairs, estimated_pairs(finder, points)), is_relative_ ? t : t_);
  }

  // Counting all pairs could take O(n²): up to a thousand vertices are looked at, in an order that
  // jumps about, until they have met enough others.
  static double estimated_pairs(const internal::ClosePoints& finder, std::size_t points) {
    const std::size_t samples = (std::min<std::size_t>)(points, 1000);
    const std::size_t jump = 1627; // a prime, so that no vertex comes twice
    double count = 0;
    std::size_t n = 0;
    for (; n < samples && count < 1e7; ++n)
      count += finder.count(static_cast<std::uint32_t>(n * jump % samples * (points / samples)));
    return count / static_cast<double>(n) * static_cast<double>(points) / 2;
  }

  [[noreturn]] void reject(double pairs, double t) const {
    throw std::length_error(
        "quadrille::ThresholdPairs: about " + std::to_string(std::llround(pairs)) +
        " pairs of vertices are closer than " + internal::text_of(t) + ", more than the limit of " +
        std::to_string(most_pairs_a_vertex) + " per vertex");
  }

  double t_;
  bool is_relative_ = false;
};

} // namespace quadrille

#endif // QUADRILLE_THRESHOLD_PAIRS_H
