#ifndef QUADRILLE_THRESHOLD_PAIRS_H
#define QUADRILLE_THRESHOLD_PAIRS_H

// This header includes CGAL's kd-tree, which is GPL: a program that includes it comes under the GPL
// (or CGAL's commercial licence). <quadrille/simplify.h> does not include it.

#include <quadrille/pairs.h>
#include <quadrille/vector.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// The edges of the surface, and all pairs of vertices that are closer than a threshold t at the
/// beginning: parts that lie close to each other join. A pair at exactly the distance t does not
/// count, so t = 0 is the same as EdgePairs.
///
/// The pairs are found with CGAL's kd-tree, in O(n log n + pairs) for n vertices.
/// Source: Garland and Heckbert 1997, section 3.2.
class ThresholdPairs {
public:
  static constexpr bool includes_edges = true;
  static constexpr bool ignores_indices = true;

  /// t is in the mesh's units, at least 0 and finite. A vertex can have O(n) others within t, so
  /// a number of pairs above `max_pairs_per_vertex` times that of vertices is refused.
  explicit ThresholdPairs(double t, double max_pairs_per_vertex = 64)
      : t_(t), max_pairs_per_vertex_(max_pairs_per_vertex) {}

  /// t as a fraction of the diagonal of the bounding box.
  static ThresholdPairs relative(double fraction, double max_pairs_per_vertex = 64) {
    ThresholdPairs pairs(fraction, max_pairs_per_vertex);
    pairs.is_relative_ = true;
    return pairs;
  }

  /// Throws std::invalid_argument for a threshold that is negative or not finite, and for a limit
  /// that is negative or not a number.
  void validate() const {
    if (!(t_ >= 0) || !std::isfinite(t_))
      throw std::invalid_argument("quadrille::ThresholdPairs: the threshold " + std::to_string(t_) +
                                  " is not a distance");
    if (!(max_pairs_per_vertex_ >= 0))
      throw std::invalid_argument("quadrille::ThresholdPairs: the limit of " +
                                  std::to_string(max_pairs_per_vertex_) +
                                  " pairs a vertex is no number of pairs");
  }

  /// Calls emit(i, j) for each pair of points i < j closer than t, ordered by i, then by j. Throws
  /// std::length_error, before the first call, if there are more of them than allowed.
  void operator()(const SurfaceView& surface, const EmitPair& emit) const {
    const double t = is_relative_ ? t_ * diagonal(surface.points) : t_;
    if (!(t > 0) || surface.points.empty()) // CGAL's tree is never empty
      return;
    const Finder finder(surface.points);
    require_few(finder, surface.points.size(), t);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < surface.points.size(); ++i) {
      finder.find_after(i, t, near);
      for (std::uint32_t j : near)
        emit(i, j);
    }
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Entry = std::pair<Kernel::Point_3, std::uint32_t>;
  using Traits = CGAL::Search_traits_adapter<Entry, CGAL::First_of_pair_property_map<Entry>,
                                             CGAL::Search_traits_3<Kernel>>;

  class Finder {
  public:
    explicit Finder(std::span<const Vector<3>> points) : points_(points) {
      std::vector<Entry> entries;
      entries.reserve(points.size());
      for (std::uint32_t i = 0; i < points.size(); ++i)
        entries.emplace_back(point(i), i);
      tree_.insert(entries.begin(), entries.end());
      tree_.build();
    }

    // All j > i closer to i than t, in order.
    void find_after(std::uint32_t i, double t, std::vector<std::uint32_t>& near) const {
      near.clear();
      for_each_near(i, t, [&](std::uint32_t j) {
        if (j > i)
          near.push_back(j);
      });
      std::sort(near.begin(), near.end());
    }

    std::size_t count(std::uint32_t i, double t) const {
      std::size_t n = 0;
      for_each_near(i, t, [&](std::uint32_t) { ++n; });
      return n;
    }

  private:
    // The sphere of CGAL is not exact at its surface: it is taken larger, and each hit is tested.
    template <class Visit>
    void for_each_near(std::uint32_t i, double t, Visit visit) const {
      const auto test = [&](const Entry& entry) {
        if (entry.second != i && squared_distance(points_[i], points_[entry.second]) < t * t)
          visit(entry.second);
      };
      const CGAL::Fuzzy_sphere<Traits> sphere(point(i), t * (1 + 1e-12));
      tree_.search(boost::make_function_output_iterator(std::cref(test)), sphere);
    }

    Kernel::Point_3 point(std::uint32_t i) const {
      return {points_[i][0], points_[i][1], points_[i][2]};
    }

    std::span<const Vector<3>> points_;
    CGAL::Kd_tree<Traits> tree_;
  };

  void require_few(const Finder& finder, std::size_t points, double t) const {
    const double limit = max_pairs_per_vertex_ * static_cast<double>(points);
    double pairs = 0;
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < points; ++i) {
      finder.find_after(i, t, near);
      pairs += static_cast<double>(near.size());
      if (pairs > limit)
        refuse(finder, points, t);
    }
  }

  // Counting all pairs could take O(n²): it is done at a thousand vertices.
  [[noreturn]] void refuse(const Finder& finder, std::size_t points, double t) const {
    const std::size_t step = std::max<std::size_t>(1, points / 1000);
    double count = 0, samples = 0;
    for (std::size_t i = 0; i < points; i += step, ++samples)
      count += static_cast<double>(finder.count(static_cast<std::uint32_t>(i), t));
    const double pairs = count / samples * static_cast<double>(points) / 2;
    throw std::length_error("quadrille::ThresholdPairs: about " +
                            std::to_string(std::llround(pairs)) +
                            " pairs of vertices are closer than " + std::to_string(t) +
                            ", more than the limit of " + std::to_string(max_pairs_per_vertex_) +
                            " a vertex (the second argument of ThresholdPairs)");
  }

  static double diagonal(std::span<const Vector<3>> points) {
    if (points.empty())
      return 0;
    Vector<3> low = points[0], high = points[0];
    for (const Vector<3>& p : points)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  }

  double t_;
  double max_pairs_per_vertex_;
  bool is_relative_ = false;
};

} // namespace quadrille

#endif // QUADRILLE_THRESHOLD_PAIRS_H
