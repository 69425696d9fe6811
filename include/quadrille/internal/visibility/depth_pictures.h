#ifndef QUADRILLE_INTERNAL_VISIBILITY_DEPTH_PICTURES_H
#define QUADRILLE_INTERNAL_VISIBILITY_DEPTH_PICTURES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/visibility/face_rays.h>
#include <quadrille/internal/visibility/ray_tree.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace quadrille::internal {

/// Sends parallel rays through the grid of a picture, for all faces at once: a z-buffer holds the
/// first and the last face on the line through the centre of each pixel. These are the faces from
/// which a ray along the line is free on one side.
///
/// A face counts as many of its pixels in a picture as it has units of area, spread over them, so
/// that each picture is two rays, one for each side of the face. Faces that are smaller than a
/// pixel, or seen from their edge, have none in some pictures. Source: Catmull, A subdivision
/// algorithm for computer display of curved surfaces, 1974 (z-buffer).
class DepthPictures {
public:
  /// `pictures`: how many, in directions spread evenly over the sphere.
  DepthPictures(const RayTree& tree, const FaceRays& rays, std::size_t pictures)
      : tree_(tree), rays_(rays), pictures_(pictures), is_tied_(tree.size(), 0) {
    choose_pixel();
  }

  std::size_t size() const { return pictures_; }

  /// Adds the rays of all pictures to counts, by slots. Returns false if the caller has ended it.
  template <class Report>
  bool look(Threads threads, std::vector<RayCounts>& counts, const Report& report) {
    if (tree_.size() == 0)
      return report(1);
    std::vector<Worker> workers(threads);
    bool goes_on = true;
    with_threads(threads, [&] {
      for (std::size_t first = 0; first < pictures_ && goes_on; first += threads) {
        const std::size_t count = (std::min)(std::size_t{threads}, pictures_ - first);
        parallel_for(threads, count,
                     [&](std::size_t i, std::size_t worker) { take(first + i, workers[worker]); });
        goes_on = report(static_cast<double>(first + count) / static_cast<double>(pictures_));
      }
    });
    for (const Worker& worker : workers)
      for (std::size_t slot = 0; slot < worker.counts.size(); ++slot) {
        counts[slot].add(worker.counts[slot], false);
        is_tied_[slot] |= worker.is_tied[slot];
      }
    return goes_on;
  }

  /// Has a face been at the same place as another one, so that a picture does not show which of
  /// them is seen?
  bool is_tied(std::size_t slot) const { return is_tied_[slot] != 0; }

private:
  struct Pixel {
    double near = std::numeric_limits<double>::infinity(),
           far = -std::numeric_limits<double>::infinity();
    Index near_face = none, far_face = none;
  };
  struct Sample {
    Index slot, pixel;
    bool is_front_near; // does its front look against the direction of the picture?
  };
  /// The arrays of a thread.
  struct Worker {
    std::vector<RayCounts> counts;
    std::vector<char> is_tied;
    std::vector<Pixel> pixels;
    std::vector<Vector<3>> points; // in units of pixels, and depths
    std::vector<Sample> samples;
    std::vector<Index> covered; // pixels of a face
  };
  /// A direction, and the axes of its picture.
  struct View {
    Vector<3> x, y, z;
    std::size_t width, height;
  };

  static constexpr double pixels_per_unit = 4;          // of area
  static constexpr std::size_t most_pixels = 4;         // for each face
  static constexpr std::size_t fewest_pixels = 1 << 16; // of a picture
  static constexpr double narrow = 8;                   // pixels
  static constexpr double least_distance = 1e-9;        // see RayTree

  void choose_pixel() {
    const double most = static_cast<double>((std::max)(fewest_pixels, most_pixels * tree_.size()));
    constexpr double extent = 12; // of the picture of a cube from -1 to 1, at most
    pixel_ = std::sqrt((std::max)(rays_.unit_area() / pixels_per_unit, extent / most));
  }

  // Directions are a Fibonacci lattice on half of the sphere; pictures are turned and moved against
  // each other.
  View view(std::size_t number, std::vector<Vector<3>>& points) const {
    const auto fraction = [](double x) { return x - std::floor(x); };
    const double i = static_cast<double>(number) + 0.5;
    const double z = i / static_cast<double>(pictures_), radius = std::sqrt((1 - z) * (1 + z)),
                 angle = 2 * std::numbers::pi * fraction(i / std::numbers::phi);
    View view;
    view.z = {{radius * std::cos(angle), radius * std::sin(angle), z}};
    const Vector<3> across{{-std::sin(angle), std::cos(angle), 0}}, up = cross(view.z, across);
    const double turn = 2 * std::numbers::pi * fraction(i * 0.7548776662466927);
    view.x = std::cos(turn) * across + std::sin(turn) * up;
    view.y = cross(view.z, view.x);
    points.clear();
    Box<3> box = Box<3>::none();
    for (const Vector<3>& p : tree_.points()) {
      points.push_back({{dot(view.x, p), dot(view.y, p), dot(view.z, p)}});
      box.add(points.back());
    }
    const double low_x = box.low[0] - fraction(i * 0.5698402909980532) * pixel_,
                 low_y = box.low[1] - fraction(i * 0.8191725133961645) * pixel_;
    for (Vector<3>& p : points) {
      p[0] = (p[0] - low_x) / pixel_;
      p[1] = (p[1] - low_y) / pixel_;
    }
    view.width = static_cast<std::size_t>((box.high[0] - low_x) / pixel_) + 2;
    view.height = static_cast<std::size_t>((box.high[1] - low_y) / pixel_) + 2;
    return view;
  }

  void take(std::size_t number, Worker& worker) const {
    const View view = this->view(number, worker.points);
    worker.counts.resize(tree_.size());
    worker.is_tied.resize(tree_.size());
    worker.pixels.assign(view.width * view.height, {});
    worker.samples.clear();
    for (Index slot = 0; slot < tree_.size(); ++slot)
      draw(slot, view, worker);
    count(worker);
  }

  /// A line through two points. Which side of it a pixel lies on has the same bits in both faces at
  /// an edge, so no pixel lies between these.
  struct Line {
    double a, b, c;
    Line(const std::vector<Vector<3>>& points, Index v, Index w, double sign) {
      const Vector<3>&p = points[(std::min)(v, w)], &q = points[(std::max)(v, w)];
      const double turn = v < w ? sign : -sign;
      a = turn * (p[1] - q[1]);
      b = turn * (q[0] - p[0]);
      c = turn * (p[0] * q[1] - p[1] * q[0]);
    }
  };

  /// Pixels of a row.
  struct Span {
    double first, last;
    /// Leaves out pixels where a x + c is negative, but for one next to it.
    void cut(double a, double c) {
      constexpr double least = 1e-3; // below, rounding may be more than a pixel
      if (a > least)
        first = (std::max)(first, std::floor(-c / a));
      else if (a < -least)
        last = (std::min)(last, std::ceil(-c / a));
    }
  };

  void draw(Index slot, const View& view, Worker& worker) const {
    const auto& [a, b, c] = tree_.triangle(slot);
    const Vector<3>&p = worker.points[a], &q = worker.points[b], &r = worker.points[c];
    const double left = std::ceil((std::min)((std::min)(p[0], q[0]), r[0])),
                 right = std::floor((std::max)((std::max)(p[0], q[0]), r[0])),
                 low = std::ceil((std::min)((std::min)(p[1], q[1]), r[1])),
                 high = std::floor((std::max)((std::max)(p[1], q[1]), r[1]));
    const double area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]); // doubled
    if (left > right || low > high || area == 0)
      return;
    const double sign = area > 0 ? 1 : -1;
    const Line at_p(worker.points, b, c, sign), at_q(worker.points, c, a, sign),
        at_r(worker.points, a, b, sign);
    const double to_q = (q[2] - p[2]) / std::abs(area), to_r = (r[2] - p[2]) / std::abs(area);
    worker.covered.clear();
    for (double y = low; y <= high; ++y) {
      const double p_y = at_p.b * y + at_p.c, q_y = at_q.b * y + at_q.c, r_y = at_r.b * y + at_r.c;
      Span span{left, right};
      if (right - left > narrow) // a thin face across the picture has few pixels in each row
        span.cut(at_p.a, p_y), span.cut(at_q.a, q_y), span.cut(at_r.a, r_y);
      if (!(span.first <= span.last))
        continue;
      std::size_t pixel =
          static_cast<std::size_t>(y) * view.width + static_cast<std::size_t>(span.first);
      for (double x = span.first; x <= span.last; ++x, ++pixel) {
        const double u = at_p.a * x + p_y, v = at_q.a * x + q_y, w = at_r.a * x + r_y;
        if ((std::min)((std::min)(u, v), w) >= 0) {
          put(worker, pixel, slot, p[2] + (v * to_q + w * to_r));
          worker.covered.push_back(static_cast<Index>(pixel));
        }
      }
    }
    const std::size_t size = worker.covered.size(), count = (std::min)(rays_.units(slot), size);
    for (std::size_t i = 0; i < count; ++i)
      worker.samples.push_back({slot, worker.covered[(i * size + size / 2) / count], area < 0});
  }

  static void put(Worker& worker, std::size_t number, Index slot, double depth) {
    Pixel& pixel = worker.pixels[number];
    if (depth < pixel.near + least_distance) {
      if (depth > pixel.near - least_distance)
        worker.is_tied[slot] = worker.is_tied[pixel.near_face] = 1;
      if (depth < pixel.near)
        pixel.near = depth, pixel.near_face = slot;
    }
    if (depth > pixel.far - least_distance) {
      if (depth < pixel.far + least_distance)
        worker.is_tied[slot] = worker.is_tied[pixel.far_face] = 1;
      if (depth > pixel.far)
        pixel.far = depth, pixel.far_face = slot;
    }
  }

  void count(Worker& worker) const {
    for (const auto& [slot, pixel, is_front_near] : worker.samples) {
      const std::size_t to_far = is_front_near ? 1 : 0;
      const Pixel& at = worker.pixels[pixel];
      add(worker.counts[slot], slot, 1 - to_far, at.near_face == slot);
      add(worker.counts[slot], slot, to_far, at.far_face == slot);
    }
  }
  void add(RayCounts& counts, Index slot, std::size_t side, bool is_free) const {
    if (side == 1 && rays_.is_covered(slot))
      return;
    ++counts.rays[side];
    counts.free[side] += is_free;
  }

  const RayTree& tree_;
  const FaceRays& rays_;
  std::size_t pictures_;
  std::vector<char> is_tied_; // by slots
  double pixel_ = 1;          // the side of a pixel
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_DEPTH_PICTURES_H
