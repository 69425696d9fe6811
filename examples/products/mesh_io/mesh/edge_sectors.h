#ifndef QUADRILLE_EXAMPLES_MESH_IO_EDGE_SECTORS_H
#define QUADRILLE_EXAMPLES_MESH_IO_EDGE_SECTORS_H

#include "indexed_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// A face at an edge between two places: its third corner, and whether it runs from the first end
/// to the second.
struct EdgeFace {
  Point third;
  bool runs_up;
};

/// Which of several faces at an edge belong together, if each side of the surface is that of a
/// solid: going round the edge, a face behind which the solid begins and the next one, where it
/// ends. So of two bodies that touch along an edge each keeps its own two faces.
class EdgeSectors {
public:
  /// Pairs of indices of `faces`; none if faces on both sides of a solid do not follow each other
  /// all the way round. Normals point out of it, or into it.
  static std::vector<std::pair<std::size_t, std::size_t>> pairs(const Point& begin,
                                                                const Point& end,
                                                                const std::vector<EdgeFace>& faces,
                                                                bool is_inside_out) {
    EdgeSectors sectors(begin, end, faces, is_inside_out);
    sectors.sort();
    std::vector<std::pair<std::size_t, std::size_t>> result;
    const std::size_t count = faces.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t face = sectors.order_[i].face;
      const std::size_t next = sectors.order_[(i + 1) % count].face;
      if (faces[face].runs_up == faces[next].runs_up)
        return {};
      if (sectors.begins_solid(face))
        result.emplace_back(face, next);
    }
    return result;
  }

private:
  using Direction = Point::R::Vector_3;

  struct Spoke {
    double angle;
    std::size_t face;
  };

  /// Angles are measured from the first face, positive against the clock for who looks from the end
  /// of the edge to its begin.
  EdgeSectors(const Point& begin, const Point& end, const std::vector<EdgeFace>& faces,
              bool is_inside_out)
      : faces_(faces), is_inside_out_(is_inside_out) {
    const Direction axis = scaled(end - begin);
    const auto across = [&](const Point& p) {
      const Direction v = scaled(p - begin);
      return v - axis * (v * axis / axis.squared_length());
    };
    const Direction first = across(faces.front().third);
    const Direction second = CGAL::cross_product(axis, first);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Direction v = across(faces[i].third);
      order_.push_back({std::atan2(v * second / std::sqrt(axis.squared_length()), v * first), i});
    }
  }

  /// Lest squares of coordinates over- or underflow.
  static Direction scaled(const Direction& v) {
    const double greatest = std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    return greatest > 0 ? Direction(v.x() / greatest, v.y() / greatest, v.z() / greatest) : v;
  }

  /// The normal of a face that runs up points against the clock.
  bool begins_solid(std::size_t face) const { return faces_[face].runs_up == is_inside_out_; }

  /// Round the edge, beginning behind the widest gap. Of faces at one angle, those come first where
  /// a solid ends.
  void sort() {
    std::sort(order_.begin(), order_.end(), [](const Spoke& a, const Spoke& b) {
      return std::pair(a.angle, a.face) < std::pair(b.angle, b.face);
    });
    std::size_t widest = 0;
    double width = order_.front().angle + 2 * std::numbers::pi - order_.back().angle;
    for (std::size_t i = 1; i < order_.size(); ++i)
      if (order_[i].angle - order_[i - 1].angle > width) {
        width = order_[i].angle - order_[i - 1].angle;
        widest = i;
      }
    std::rotate(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(widest), order_.end());
    for (auto begin = order_.begin(); begin != order_.end();) {
      const auto end = std::find_if(begin, order_.end(),
                                    [&](const Spoke& spoke) { return !are_one(*begin, spoke); });
      std::stable_partition(begin, end, [&](const Spoke& s) { return !begins_solid(s.face); });
      begin = end;
    }
  }

  static bool are_one(const Spoke& a, const Spoke& b) {
    const double apart = std::abs(std::remainder(a.angle - b.angle, 2 * std::numbers::pi));
    return apart < 1e-6; // which coordinates of single precision tell apart
  }

  const std::vector<EdgeFace>& faces_;
  bool is_inside_out_;
  std::vector<Spoke> order_;
};

} // namespace quadrille_examples

#endif
