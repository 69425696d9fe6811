#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_SPLIT_POINTS_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_SPLIT_POINTS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// The points that split vertices of a result need: one for each combination of a vertex and its
/// values in some channels. They come in the order of the points from which they stem.
class SplitPoints {
public:
  /// `faces` are numbers of the result in the order in which they are written, and `inputs` the
  /// triangles from which they come. Values of each channel in `channels` are distinguished.
  template <class Result, class Triangles>
  SplitPoints(const Result& result, const Array<Index>& faces, const Array<Index>& inputs,
              const Triangles& triangles, [[maybe_unused]] const std::vector<std::size_t>& channels)
      : number_(3 * faces.size()) {
    std::vector<Corner> corners;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        Corner corner{result.corners(faces[f])[i],
                      {},
                      origin_of(result, faces[f], i, inputs[faces[f]], triangles),
                      faces[f],
                      i,
                      3 * f + i};
        if constexpr (requires { result.components(std::size_t{}); })
          for (std::size_t c : channels)
            for (std::size_t k = 0; k < result.components(c); ++k)
              corner.values.push_back(result.value(c, result.wedge(c, faces[f], i), k));
        corners.push_back(std::move(corner));
      }
    std::sort(corners.begin(), corners.end());
    number(corners);
  }

  std::size_t size() const { return points_.size(); }
  /// The point of the input from which a point stems.
  Index origin(std::size_t point) const { return points_[point].origin; }
  /// Its vertex, in the numbers of the result.
  Index vertex(std::size_t point) const { return points_[point].vertex; }
  /// A corner that it is at: a face of the result, and the place in it.
  Index face(std::size_t point) const { return points_[point].face; }
  std::size_t corner(std::size_t point) const { return points_[point].corner; }
  /// The point at corner i of a face that is written.
  Index number(std::size_t face, std::size_t i) const { return number_[3 * face + i]; }

private:
  struct Corner {
    Index vertex;
    std::vector<double> values;
    Index origin;
    Index face;
    std::size_t corner, place;

    bool is_at_same_point(const Corner& other) const {
      return vertex == other.vertex && values == other.values;
    }
    friend bool operator<(const Corner& a, const Corner& b) {
      return std::tie(a.vertex, a.values, a.origin, a.place) <
             std::tie(b.vertex, b.values, b.origin, b.place);
    }
  };

  struct Point {
    Index origin, vertex, face;
    std::size_t corner;
  };

  // The point of a corner of a face; of the input face that it was, if the result says no more.
  template <class Result, class Triangles>
  static Index origin_of(const Result& result, Index face, std::size_t corner, Index input_face,
                         const Triangles& triangles) {
    if constexpr (requires { result.input_corner(face, corner); }) {
      const Index side = result.input_corner(face, corner);
      return static_cast<Index>(triangles[side / 3][side % 3]);
    } else {
      return static_cast<Index>(triangles[input_face][corner]);
    }
  }

  void number(const std::vector<Corner>& corners) {
    std::vector<Index> point_of(corners.size());
    std::vector<Point> points;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner& c = corners[k];
      if (k == 0 || !c.is_at_same_point(corners[k - 1]))
        points.push_back({c.origin, c.vertex, c.face, c.corner});
      point_of[k] = static_cast<Index>(points.size() - 1);
    }
    Array<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index i, Index j) { return points[i].origin < points[j].origin; });
    for (Index i : order)
      points_.push_back(points[i]);
    const Array<Index> rank = places(order, order.size());
    for (std::size_t k = 0; k < corners.size(); ++k)
      number_[corners[k].place] = rank[point_of[k]];
  }

  std::vector<Point> points_;
  std::vector<Index> number_; // of each corner of the faces that are written
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_SPLIT_POINTS_H
