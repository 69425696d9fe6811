#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_WEIGHTS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_WEIGHTS_H

#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/complex/edge_sides.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// Returns the length that a step of 1 in an attribute would count as if the attribute and the
/// shape were equally hard to predict from their neighbourhood: over pairs of faces with an edge in
/// common, the median of (distance of the far corner of the one from the plane of the other) /
/// (difference of its values from those to which the other extends). Noisy attributes get a small
/// weight, and smooth ones a large one. It uses at most about 1000 vertices; the result is the same
/// for any order of the faces.
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
    const Vector<3> offset = far.place - face[0].place, normal = cross(to_second, to_third);
    const double squared = squared_length(normal);
    if (!(squared > 0))
      return;
    const double s = dot(cross(offset, to_third), normal) / squared;
    const double t = dot(cross(to_second, offset), normal) / squared;
    double sum = 0;
    for (std::size_t c = 0; c < channel_.components; ++c) {
      const auto value = [&](const Corner& corner) { return channel_.value(corner.value, c); };
      const double first = value(face[0]);
      const double off =
          value(far) - (first + s * (value(face[1]) - first) + t * (value(face[2]) - first));
      sum += off * off;
    }
    const double distance = std::abs(dot(offset, normal)) / std::sqrt(squared);
    ratios.push_back((distance + std::sqrt(squared_length(to_second)) / 50) /
                     (std::sqrt(sum / static_cast<double>(channel_.components)) + least_step_));
  }

  const ChannelInput& channel_;
  const Numbering& numbering_;
  const TriangleComplex& complex_;
  const Positions& positions_;
  double least_step_;
};

/// How a channel counts. The squares of the lengths, in the engine's unit, that a step of 1 in each
/// component counts as; and how much more than these the faces of each label, or none.
struct ChannelWeights {
  std::vector<double> squared, factors;
};

/// How a channel lies on a surface: areas, and the range of its values at faces.
class ChannelExtent {
public:
  template <class Numbering, class Positions>
  ChannelExtent(const ChannelInput& channel, const Numbering& numbering,
                const TriangleComplex& complex, const Positions& positions,
                const Array<Index>& labels)
      : low_(channel.components, (std::numeric_limits<double>::max)()),
        high_(channel.components, std::numeric_limits<double>::lowest()) {
    if (channel.is_texture())
      add_areas(channel, numbering, complex, positions, labels);
    if (channel.corners.empty()) {
      for (Index v = 0; v < complex.vertex_capacity(); ++v)
        if (complex.has_faces(v))
          add_value(channel, numbering.vertices[v]);
      return;
    }
    Array<unsigned char> is_used(channel.size(), 0, complex.arena());
    for (Index face = 0; face < complex.face_capacity(); ++face)
      if (!complex.is_removed(face))
        for (Index value : channel.corners[numbering.faces[face]])
          is_used[value] = 1;
    for (Index value = 0; value < is_used.size(); ++value)
      if (is_used[value])
        add_value(channel, value);
  }

  /// Area of the surface / area of the texture; 0 if either is 0.
  double squared_length_of_texture() const {
    Areas sum;
    for (const Areas& areas : areas_)
      sum = {sum.surface + areas.surface, sum.texture + areas.texture};
    return sum.ratio();
  }
  /// Returns the factor by which that differs at a label; 1 if it is undefined.
  std::vector<double> factors_by_label() const {
    const double all = squared_length_of_texture();
    std::vector<double> factors;
    for (const Areas& areas : areas_)
      factors.push_back(all > 0 && areas.ratio() > 0 ? areas.ratio() / all : 1);
    return factors;
  }
  /// The largest of the components.
  double range() const {
    double range = 0;
    for (std::size_t c = 0; c < low_.size(); ++c)
      range = (std::max)(range, high_[c] - low_[c]);
    return range;
  }

private:
  template <class Numbering, class Positions>
  void add_areas(const ChannelInput& channel, const Numbering& numbering,
                 const TriangleComplex& complex, const Positions& positions,
                 const Array<Index>& labels) {
    areas_.resize(labels.empty() ? 1 : *std::max_element(labels.begin(), labels.end()) + 1);
    for (Index face = 0; face < complex.face_capacity(); ++face) {
      if (complex.is_removed(face))
        continue;
      const auto& v = complex.vertices(face);
      std::array<Index, 3> values;
      for (std::size_t i = 0; i < 3; ++i)
        values[i] = channel.value_at(numbering.faces[face], i, numbering.vertices[v[i]]);
      Areas& areas = areas_[labels.empty() ? 0 : labels[face]];
      areas.surface += std::sqrt(squared_length(double_area_vector(
          space(positions[v[0]]), space(positions[v[1]]), space(positions[v[2]]))));
      areas.texture += texture_area(channel, values);
    }
  }
  void add_value(const ChannelInput& channel, Index value) {
    for (std::size_t c = 0; c < channel.components; ++c) {
      low_[c] = (std::min)(low_[c], channel.value(value, c));
      high_[c] = (std::max)(high_[c], channel.value(value, c));
    }
  }
  static double texture_area(const ChannelInput& channel, const std::array<Index, 3>& values) {
    const double* const all = channel.values.data();
    const auto difference = [&](std::size_t i, std::size_t c) {
      return all[2 * values[i] + c] - all[2 * values[0] + c];
    };
    return std::abs(difference(1, 0) * difference(2, 1) - difference(1, 1) * difference(2, 0));
  }

  struct Areas {
    double surface = 0, texture = 0; // twice
    double ratio() const { return surface > 0 && texture > 0 ? surface / texture : 0; }
  };

  std::vector<double> low_, high_;
  std::vector<Areas> areas_; // of each label
};

/// The length that a step of 1 in a channel that is no texture counts as by default. `diagonal` and
/// `range` are above 0. Normals belong to the shape, so they count nearly as much.
template <class Numbering, class Positions>
double default_weight(const ChannelInput& channel, const Numbering& numbering,
                      const TriangleComplex& complex, const Positions& positions, double diagonal,
                      double range) {
  const double usual = 0.02 * diagonal / range;
  const bool is_normal = channel.attribute == Attribute::normal;
  if (!is_normal && channel.attribute != Attribute::color)
    return usual;
  const std::optional<double> even =
      EvenWeight(channel, numbering, complex, positions, range).find();
  if (!even)
    return usual;
  return is_normal ? std::clamp(1.1 * *even, 0.1 * usual, 2 * usual)
                   : std::clamp(0.5 * *even, 0.05 * usual, usual);
}

/// Returns the weights of a channel: see ChannelOptions. `labels`: of each face; or empty. Throws
/// std::invalid_argument if these are too large or too small to be compared with the lengths of the
/// surface.
template <class Numbering, class Positions, std::size_t N>
ChannelWeights channel_weights(const ChannelInput& channel, const Numbering& numbering,
                               const TriangleComplex& complex, const Positions& positions,
                               const Array<Index>& labels, const Scale<N>& scale) {
  const ChannelExtent extent(channel, numbering, complex, positions, labels);
  const double range = extent.range();
  double by_default = 1;
  ChannelWeights weights;
  const bool is_given = !channel.weights.empty();
  if (channel.is_texture() && extent.squared_length_of_texture() > 0) {
    by_default = std::sqrt(extent.squared_length_of_texture());
    if (!is_given && !labels.empty())
      weights.factors = extent.factors_by_label();
  } else if (!is_given && range > 0 && scale.diagonal() > 0)
    by_default = default_weight(channel, numbering, complex, positions,
                                scale.length_from_mesh(scale.diagonal()), range);
  // A default is bounded: what it makes of a texture of no size is not the user's fault.
  const double greatest = range > 0 ? (std::min)(0x1p150, 0x1p30 / range) : 0x1p150;
  for (std::size_t c = 0; c < channel.components; ++c) {
    const double weight =
        channel.importance * (!is_given ? std::clamp(by_default, 0x1p-150, greatest)
                                        : scale.length_from_mesh(channel.weights[c]));
    weights.squared.push_back(weight * weight);
    if (!(weight * weight > 0x1p-400 && weight * weight < 0x1p400) || !(weight * range < 0x1p40))
      throw std::invalid_argument(
          "quadrille::simplify: component " + std::to_string(c) +
          " of a channel, with values of a range of " + text_of(range) + ", weighs " +
          text_of(scale.length_of_mesh(weight)) +
          ": too large or too small to be compared with lengths of the surface");
  }
  return weights;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_WEIGHTS_H
