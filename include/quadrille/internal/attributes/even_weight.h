#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_EVEN_WEIGHT_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_EVEN_WEIGHT_H

#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/complex/edge_sides.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace quadrille::internal {

/// The length that a step of 1 in an attribute would count as if the attribute and the shape were
/// equally hard to tell from what is beside: over pairs of faces with an edge in common, the median
/// of (distance of the far corner of the one from the plane of the other) / (difference of its
/// values from those to which the other extends). Attributes that are noise get little, and smooth
/// ones much. Of at most about 1000 vertices; the same for any order of the faces.
template <class Numbering, class Positions>
class EvenWeight {
public:
  /// A two-hundredth of `range` counts as nothing, as a fiftieth of the edge does.
  EvenWeight(const ChannelInput& channel, const Numbering& numbering,
             const TriangleComplex& complex, const Positions& positions, double range)
      : channel_(channel), numbering_(numbering), complex_(complex), positions_(positions),
        least_step_(range / 200) {}

  /// None if there is no edge of two faces over which the attribute is continuous.
  std::optional<double> find() const {
    std::vector<double> ratios;
    const std::size_t step = complex_.vertex_capacity() / 1000 + 1;
    EdgeSides edges;
    for (std::size_t v = 0; v < complex_.vertex_capacity(); v += step) {
      edges.gather(complex_, static_cast<Index>(v));
      edges.for_each([&](Index w, const auto& sides) {
        if (sides.size() == 2)
          add(sides[0].second, sides[1].second, static_cast<Index>(v), w, ratios);
      });
    }
    if (ratios.empty())
      return std::nullopt;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
  }

private:
  struct Corner {
    Vector<3> place;
    Index value;
  };
  // The ends of the edge, in their order, and the far corner.
  std::array<Corner, 3> corners(Index face, Index v, Index w) const {
    std::array<Corner, 3> corners;
    const auto& vertices = complex_.vertices(face);
    for (std::size_t i = 0; i < 3; ++i)
      corners[vertices[i] == v   ? 0
              : vertices[i] == w ? 1
                                 : 2] = {
          space(positions_[vertices[i]]),
          channel_.value_at(numbering_.faces[face], i, numbering_.vertices[vertices[i]])};
    return corners;
  }

  void add(Index face, Index other, Index v, Index w, std::vector<double>& ratios) const {
    const auto a = corners(face, v, w), b = corners(other, v, w);
    if (!channel_.are_equal(a[0].value, b[0].value) || !channel_.are_equal(a[1].value, b[1].value))
      return;
    add_extended(a, b[2], ratios);
    add_extended(b, a[2], ratios);
  }
  void add_extended(const std::array<Corner, 3>& face, const Corner& far,
                    std::vector<double>& ratios) const {
    const Vector<3> to_second = face[1].place - face[0].place;
    const Vector<3> to_third = face[2].place - face[0].place;
    const Vector<3> way = far.place - face[0].place, normal = cross(to_second, to_third);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return;
    const double s = dot(cross(way, to_third), normal) / squared;
    const double t = dot(cross(to_second, way), normal) / squared;
    double sum = 0;
    for (std::size_t c = 0; c < channel_.components; ++c) {
      const auto value = [&](const Corner& corner) { return channel_.value(corner.value, c); };
      const double first = value(face[0]);
      const double off =
          value(far) - (first + s * (value(face[1]) - first) + t * (value(face[2]) - first));
      sum += off * off;
    }
    const double distance = std::abs(dot(way, normal)) / std::sqrt(squared);
    ratios.push_back((distance + std::sqrt(squared_length(to_second)) / 50) /
                     (std::sqrt(sum / static_cast<double>(channel_.components)) + least_step_));
  }

  const ChannelInput& channel_;
  const Numbering& numbering_;
  const TriangleComplex& complex_;
  const Positions& positions_;
  double least_step_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_EVEN_WEIGHT_H
