#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_THINNED_LINE_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_THINNED_LINE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Selects the points of a polyline that stay when it is simplified: the ends, and so many that
/// each of the others is within a tolerance of the segment between its two remaining neighbours. A
/// loop, which begins and ends at the same point, keeps at least three points if it has as many.
/// Time O(n²) in the worst case and O(n log n) as a rule.
///
/// Source: Douglas and Peucker 1973; a segment that is too far from some point is split at the
/// farthest one.
class ThinnedLine {
public:
  /// `line`: indices of points, two at least.
  static std::vector<bool> of(std::span<const Vector<3>> points, std::span<const Index> line,
                              double tolerance) {
    return ThinnedLine(points, line).thinned(tolerance * tolerance);
  }

private:
  ThinnedLine(std::span<const Vector<3>> points, std::span<const Index> line)
      : points_(points), line_(line), stays_(line.size()) {}

  std::vector<bool> thinned(double squared_tolerance) {
    stays_.front() = stays_.back() = true;
    std::vector<std::array<std::size_t, 2>> sections{{0, line_.size() - 1}};
    while (!sections.empty()) {
      const auto [begin, end] = sections.back();
      sections.pop_back();
      const auto [farthest, squared] = farthest_between(begin, end);
      if (farthest == begin || !(squared > squared_tolerance || line_[begin] == line_[end]))
        continue;
      stays_[farthest] = true;
      sections.push_back({begin, farthest});
      sections.push_back({farthest, end});
    }
    if (line_.front() == line_.back())
      keep_third();
    return std::move(stays_);
  }

  // Keeps a third point of a loop that would be left with its ends and one point.
  void keep_third() {
    if (std::count(stays_.begin(), stays_.end(), true) != 3)
      return;
    const auto second = static_cast<std::size_t>(std::find(stays_.begin() + 1, stays_.end(), true) -
                                                 stays_.begin());
    const auto one = farthest_between(0, second);
    const auto other = farthest_between(second, line_.size() - 1);
    stays_[other.second > one.second || one.first == 0 ? other.first : one.first] = true;
  }

  // Returns the place where the line is farthest from the segment between two of its places, and
  // the squared distance; the first place if there is none in between.
  std::pair<std::size_t, double> farthest_between(std::size_t begin, std::size_t end) const {
    const Vector<3> p = points_[line_[begin]], d = points_[line_[end]] - p;
    const double length = squared_length(d);
    std::pair<std::size_t, double> farthest{begin, -1};
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Vector<3> x = points_[line_[i]] - p;
      const double along = length > 0 ? std::clamp(dot(x, d) / length, 0.0, 1.0) : 0;
      if (const double squared = squared_length(x - along * d); squared > farthest.second)
        farthest = {i, squared};
    }
    return farthest;
  }

  std::span<const Vector<3>> points_;
  std::span<const Index> line_;
  std::vector<bool> stays_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_THINNED_LINE_H
