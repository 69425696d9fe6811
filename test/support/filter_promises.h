#ifndef TEST_SUPPORT_FILTER_PROMISES_H
#define TEST_SUPPORT_FILTER_PROMISES_H

/// \file
/// What filters promise of a result, by nothing but the input and what has become of its faces and
/// vertices.

#include "soups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
#include <vector>

namespace test {

/// A filter lets a face be as bad as it says, or as the face of the input was that it has been. By
/// induction over all contractions that holds of each level of a recording.
class FilterPromises {
public:
  /// `input_faces`: which face of the input each face has been; `images`: which point of the result
  /// each one of the input has become.
  FilterPromises(const Soup& input, const Soup& result,
                 const std::vector<std::uint32_t>& input_faces,
                 const std::vector<std::uint32_t>& images)
      : input_(input), result_(result), input_faces_(input_faces), images_(images) {}

  /// By how many degrees an angle is smaller than SmallestAngle says, at most.
  double lost_degrees(double degrees) const {
    return worst([&](const Triangle& now, const Triangle& before) {
      return std::min(degrees, smallest_angle(input_, before)) - smallest_angle(result_, now);
    });
  }
  /// By what part of it an edge is longer than LongestEdge says, at most. An edge of a face of the
  /// result is that between the same corners as in the input.
  double gained_length(double length) const {
    return worst([&](const Triangle& now, const Triangle& before) {
      double worst = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = before[i], w = before[(i + 1) % 3];
        const double most = std::max(length, distance(input_.points[v], input_.points[w]));
        worst = std::max(worst, side_between(now, images_[v], images_[w]) / most - 1);
      }
      return worst;
    });
  }
  /// By how many a vertex has more faces than HighestDegree says.
  double gained_faces(std::size_t degree) const {
    const std::vector<std::size_t> before = degrees(input_), now = degrees(result_);
    std::vector<std::size_t> most(now.size(), degree);
    for (std::size_t v = 0; v < images_.size(); ++v)
      if (images_[v] < most.size())
        most[images_[v]] = std::max(most[images_[v]], before[v]);
    double worst = 0;
    for (std::size_t v = 0; v < now.size(); ++v)
      worst = std::max(worst, double(now[v]) - double(most[v]));
    return worst;
  }

private:
  template <class Measure>
  double worst(Measure measure) const {
    double worst = 0;
    for (std::size_t f = 0; f < result_.triangles.size(); ++f)
      worst = std::max(worst, measure(result_.triangles[f], input_.triangles[input_faces_[f]]));
    return worst;
  }

  static double distance(const Position& p, const Position& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  /// 0 where the face has no such side.
  double side_between(const Triangle& now, std::uint32_t v, std::uint32_t w) const {
    const bool has =
        std::count(now.begin(), now.end(), v) + std::count(now.begin(), now.end(), w) == 2;
    return has ? distance(result_.points[v], result_.points[w]) : HUGE_VAL;
  }
  static std::array<double, 3> lengths(const Soup& soup, const Triangle& t) {
    const auto& p = soup.points;
    return {distance(p[t[1]], p[t[2]]), distance(p[t[2]], p[t[0]]), distance(p[t[0]], p[t[1]])};
  }
  /// By half-angle formulas of Kahan's, which are right for needles as well.
  static double smallest_angle(const Soup& soup, const Triangle& t) {
    std::array<double, 3> sides = lengths(soup, t);
    std::sort(sides.begin(), sides.end());
    const auto& [c, b, a] = sides; // the angle is across the least one
    const double above = (c + (a - b)) * (c - (a - b)), below = (a + b + c) * ((a - c) + b);
    return below > 0
               ? 2 * std::atan(std::sqrt(std::max(0.0, above) / below)) * 180 / std::numbers::pi
               : 0;
  }
  /// Faces of the same three vertices count once.
  static std::vector<std::size_t> degrees(const Soup& soup) {
    std::vector<std::size_t> degrees(soup.points.size());
    std::set<std::array<std::uint32_t, 3>> known;
    for (std::array<std::uint32_t, 3> t : soup.triangles) {
      const auto [a, b, c] = t;
      if (a == b || b == c || c == a)
        continue;
      std::sort(t.begin(), t.end());
      if (known.insert(t).second)
        for (const std::uint32_t v : t)
          ++degrees[v];
    }
    return degrees;
  }

  const Soup& input_;
  const Soup& result_;
  const std::vector<std::uint32_t>& input_faces_;
  const std::vector<std::uint32_t>& images_;
};

} // namespace test

#endif // TEST_SUPPORT_FILTER_PROMISES_H
