#ifndef TEST_SUPPORT_POINT_REPLAY_H
#define TEST_SUPPORT_POINT_REPLAY_H

#include "replay.h"
#include "soups.h"

#include <quadrille/internal/verify/distance_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

/// \file
/// Points of an input that are carried along by the contractions of a record, by nothing but that.

namespace test {

/// A point of the input, and where it has come to lie.
struct CarriedPoint {
  Position begin, now;
  std::uint32_t begin_face, face;
};

/// Each contraction takes each point of the old faces around its pair to the nearest point of the
/// new ones: no further than any map of the star does. Faces come and go as the record says.
class PointReplay {
public:
  /// About `count` points, spread by area, and at least one on each face.
  PointReplay(const Log& log, std::size_t count, std::uint64_t seed)
      : log_(log), values_(log.values), faces_(log.triangles), points_of_(faces_.size()),
        faces_of_(values_.size() / log.width), images_(faces_of_.size()) {
    std::iota(images_.begin(), images_.end(), 0);
    Random random(seed);
    double total = 0;
    for (std::uint32_t face = 0; face < faces_.size(); ++face)
      if (is_there(face)) {
        total += std::sqrt(squared_length(area_vector(face)));
        for (std::uint32_t v : faces_[face])
          faces_of_[v].push_back(face);
      }
    for (std::uint32_t face = 0; face < faces_.size(); ++face)
      if (is_there(face)) {
        const double share = std::sqrt(squared_length(area_vector(face))) / total;
        for (double n = std::max(1.0, std::floor(share * double(count) + random(0, 1))); n > 0; --n)
          add_point(face, random);
      }
  }

  /// Does all contractions. Throws std::logic_error for a point that has no face left to go to.
  void run() {
    for (const KeptContraction& c : log_.contractions)
      contract(c);
    for (std::uint32_t& image : images_)
      while (images_[image] != image)
        image = images_[image];
  }

  const std::vector<CarriedPoint>& points() const { return points_; }
  /// What each vertex of the input has become.
  std::vector<std::size_t> images() const { return {images_.begin(), images_.end()}; }
  /// All vertices of the input where those are that have become them, and the faces that are left.
  Soup surface() const {
    Soup soup;
    for (std::uint32_t v = 0; v < faces_of_.size(); ++v)
      soup.points.push_back(at(v));
    for (std::uint32_t face = 0; face < faces_.size(); ++face)
      if (is_there(face))
        soup.triangles.push_back(faces_[face]);
    return soup;
  }

private:
  bool is_there(std::uint32_t face) const { return faces_[face][0] != quadrille::not_recorded; }
  Position at(std::uint32_t v) const {
    const double* p = &values_[v * log_.width];
    return {{p[0], p[1], p[2]}};
  }
  Position area_vector(std::uint32_t face) const {
    const auto& [a, b, c] = faces_[face];
    return double_area_vector(at(a), at(b), at(c));
  }

  void add_point(std::uint32_t face, Random& random) {
    double s = random(0, 1), t = random(0, 1);
    if (s + t > 1)
      s = 1 - s, t = 1 - t;
    const auto& [a, b, c] = faces_[face];
    const Position p = (1 - s - t) * at(a) + s * at(b) + t * at(c);
    points_of_[face].push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back({p, p, face, face});
  }

  void contract(const KeptContraction& c) {
    std::vector<std::uint32_t> star;
    const auto take = [&](std::uint32_t face) {
      if (is_there(face))
        star.push_back(face);
    };
    for (const std::uint32_t v : {c.kept, c.gone})
      if (v != quadrille::not_recorded)
        std::for_each(faces_of_[v].begin(), faces_of_[v].end(), take);
    std::for_each(c.removed.begin(), c.removed.end(), take);
    std::sort(star.begin(), star.end());
    star.erase(std::unique(star.begin(), star.end()), star.end());
    std::vector<std::uint32_t> points;
    for (const std::uint32_t face : star)
      for (const std::uint32_t p : std::exchange(points_of_[face], {}))
        points.push_back(p);
    change(c, star);
    for (const std::uint32_t p : points)
      carry(points_[p], p, star);
  }

  /// The surface; leaves the new faces in `star`.
  void change(const KeptContraction& c, std::vector<std::uint32_t>& star) {
    for (const std::uint32_t face : c.removed)
      faces_[face].fill(quadrille::not_recorded);
    std::erase_if(star, [&](std::uint32_t face) { return !is_there(face); });
    if (c.kept == quadrille::not_recorded)
      return;
    images_[c.gone] = c.kept;
    for (const std::uint32_t face : star)
      std::replace(faces_[face].begin(), faces_[face].end(), c.gone, c.kept);
    faces_of_[c.kept] = star;
    faces_of_[c.gone].clear();
    std::copy(c.values.begin(), c.values.end(),
              values_.begin() + static_cast<std::ptrdiff_t>(c.kept * log_.width));
  }

  void carry(CarriedPoint& point, std::uint32_t number, const std::vector<std::uint32_t>& star) {
    namespace internal = quadrille::internal;
    const auto to = [](const Position& p) { return internal::DistancePoint(p[0], p[1], p[2]); };
    const internal::DistancePoint from = to(point.now);
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t face : star) {
      const auto& [a, b, c] = faces_[face];
      const auto q = internal::nearest_on_triangle({to(at(a)), to(at(b)), to(at(c))}, from);
      if (const double d = CGAL::squared_distance(from, q); d < least) {
        least = d;
        point.face = face;
        point.now = {{q.x(), q.y(), q.z()}};
      }
    }
    if (!(least < std::numeric_limits<double>::infinity()))
      throw std::logic_error("a point of the input has no face left to go to");
    points_of_[point.face].push_back(number);
  }

  const Log& log_;
  std::vector<double> values_;
  std::vector<Triangle> faces_;
  std::vector<std::vector<std::uint32_t>> points_of_, faces_of_; // of faces, of vertices
  std::vector<std::uint32_t> images_;
  std::vector<CarriedPoint> points_;
};

} // namespace test

#endif // TEST_SUPPORT_POINT_REPLAY_H
