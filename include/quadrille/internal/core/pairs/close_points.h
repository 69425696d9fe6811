#ifndef QUADRILLE_INTERNAL_CORE_PAIRS_CLOSE_POINTS_H
#define QUADRILLE_INTERNAL_CORE_PAIRS_CLOSE_POINTS_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/pairs/face_points.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// Points in groups of those at one position, which are numbered by their positions. Trees of
/// points are made of groups: they would be as deep as the number of equal points in them.
class PointGroups {
public:
  explicit PointGroups(std::span<const Vector<3>> points)
      : points_(points), order_(points.size()), group_of_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
      const auto& a = points_[i].coordinates;
      const auto& b = points_[j].coordinates;
      return a < b || (a == b && i < j);
    });
    for (std::uint32_t k = 0; k < order_.size(); ++k) {
      if (k == 0 || points_[order_[k]] != points_[order_[k - 1]])
        first_.push_back(k);
      group_of_[order_[k]] = static_cast<std::uint32_t>(first_.size() - 1);
    }
    first_.push_back(static_cast<std::uint32_t>(order_.size()));
  }

  std::size_t count() const { return first_.size() - 1; }
  std::uint32_t group_of(std::uint32_t point) const { return group_of_[point]; }
  double size_of(std::uint32_t group) const { return first_[group + 1] - first_[group]; }
  const Vector<3>& position(std::uint32_t group) const { return points_[order_[first_[group]]]; }

  /// Returns the position of each group.
  std::vector<Vector<3>> positions() const {
    std::vector<Vector<3>> positions;
    positions.reserve(count());
    for (std::uint32_t group = 0; group < count(); ++group)
      positions.push_back(position(group));
    return positions;
  }

  /// Returns the points of a group, in order.
  std::span<const std::uint32_t> points_of(std::uint32_t group) const {
    return {order_.data() + first_[group], order_.data() + first_[group + 1]};
  }

private:
  std::span<const Vector<3>> points_;
  std::vector<std::uint32_t> order_;    // indices of points, by position, then by index
  std::vector<std::uint32_t> first_;    // of each group in that order, and its end
  std::vector<std::uint32_t> group_of_; // each point
};

/// Finds the pairs of points that are closer than t > 0; t² must neither over- nor underflow.
///
/// `Tree` is made of positions, which are all different. Its for_each_within(p, radius, visit)
/// calls visit(i) for each position that is closer to p than the radius, and perhaps for others:
/// each is tested here, so that all trees give the same pairs.
template <class Tree>
class ClosePoints {
public:
  /// Keeps a view of the points, of which there is at least one.
  ClosePoints(std::span<const Vector<3>> points, double t)
      : t_(t), groups_(points), tree_(groups_.positions()) {}

  /// All j > i closer to i than t, in order.
  void find_after(std::uint32_t i, std::vector<std::uint32_t>& near) const {
    near.clear();
    for_each_near(groups_.group_of(i), [&](std::uint32_t group) {
      const auto points = groups_.points_of(group);
      near.insert(near.end(), std::upper_bound(points.begin(), points.end(), i), points.end());
    });
    std::sort(near.begin(), near.end());
  }

  /// How many others are closer to i than t.
  double count(std::uint32_t i) const {
    double n = -1; // i itself
    for_each_near(groups_.group_of(i), [&](std::uint32_t group) { n += groups_.size_of(group); });
    return n;
  }

  /// The number of pairs, or only of those of the first groups if that is already above the limit.
  double count_pairs(double limit) const {
    double pairs = 0;
    for (std::uint32_t g = 0; g < groups_.count() && !(pairs > limit); ++g)
      for_each_near(g, [&](std::uint32_t other) {
        if (other == g)
          pairs += groups_.size_of(g) * (groups_.size_of(g) - 1) / 2;
        else if (other > g)
          pairs += groups_.size_of(g) * groups_.size_of(other);
      });
    return pairs;
  }

private:
  // The group itself is among them. The search of a tree need not be exact at the radius, so it
  // takes a larger one.
  template <class Visit>
  void for_each_near(std::uint32_t group, Visit visit) const {
    const Vector<3>& center = groups_.position(group);
    tree_.for_each_within(center, t_ * (1 + 1e-12), [&](std::uint32_t other) {
      if (squared_distance(center, groups_.position(other)) < t_ * t_)
        visit(other);
    });
  }

  double t_;
  PointGroups groups_;
  Tree tree_;
};

/// The threshold of a pair policy, and how it finds its pairs by a tree of points.
class PairThreshold {
public:
  PairThreshold(double t, bool is_relative) : t_(t), is_relative_(is_relative) {}

  /// Throws std::invalid_argument for a threshold that is negative or not finite.
  void validate() const {
    if (!(t_ >= 0) || !std::isfinite(t_))
      throw std::invalid_argument("quadrille::ThresholdPairs: the threshold " + text_of(t_) +
                                  " is not a distance");
  }

  /// Calls emit(i, j) for each pair of points i < j closer than t, ordered by i, then by j. Throws
  /// std::length_error, before the first call, if there are more of them than allowed.
  template <class Tree>
  void emit_pairs(const SurfaceView& surface, const EmitPair& emit) const {
    if (!(t_ > 0))
      return;
    const FacePoints points(surface);
    const double diagonal = points.diagonal();
    if (points.size() == 0 || (is_relative_ && diagonal == 0))
      return;
    const double t = is_relative_ ? t_ * diagonal : points.length_from_mesh(t_);
    const ClosePoints<Tree> finder(points.positions(),
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

  void require_few(const auto& finder, std::size_t points, double t) const {
    const double limit = most_pairs_a_vertex * static_cast<double>(points);
    const double pairs = finder.count_pairs(limit);
    if (pairs > limit)
      reject((std::max)(pairs, estimated_pairs(finder, points)), is_relative_ ? t : t_);
  }

  // Counting all pairs could take O(n²): up to a thousand vertices are looked at, in an order that
  // jumps about, until they have met enough others.
  static double estimated_pairs(const auto& finder, std::size_t points) {
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
        " pairs of vertices are closer than " + text_of(t) + ", more than the limit of " +
        std::to_string(most_pairs_a_vertex) + " per vertex");
  }

  double t_;
  bool is_relative_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_PAIRS_CLOSE_POINTS_H
