#ifndef QUADRILLE_INTERNAL_SURFACE_CHANNEL_WEIGHTS_H
#define QUADRILLE_INTERNAL_SURFACE_CHANNEL_WEIGHTS_H

#include <quadrille/internal/base/text.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/surface/channel_input.h>
#include <quadrille/internal/surface/scale.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// How a channel lies on a surface: areas, and the range of its values at faces.
class ChannelExtent {
public:
  template <class Numbering, class Positions>
  ChannelExtent(const ChannelInput& channel, const Numbering& numbering,
                const TriangleComplex& complex, const Positions& positions)
      : low_(channel.components, (std::numeric_limits<double>::max)()),
        high_(channel.components, std::numeric_limits<double>::lowest()) {
    for (Index face = 0; face < complex.face_capacity(); ++face) {
      if (complex.is_removed(face))
        continue;
      const auto& v = complex.vertices(face);
      std::array<Index, 3> values;
      for (std::size_t i = 0; i < 3; ++i)
        values[i] = channel.value_at(numbering.faces[face], i, numbering.vertices[v[i]]);
      add_values(channel, values);
      area_ += std::sqrt(squared_length(
          normal_vector(space(positions[v[0]]), space(positions[v[1]]), space(positions[v[2]]))));
    }
  }

  /// √(area of the surface / area of the texture); 0 if either is 0.
  double length_of_texture() const {
    return area_ > 0 && texture_area_ > 0 ? std::sqrt(area_ / texture_area_) : 0;
  }
  /// The largest of the components.
  double range() const {
    double range = 0;
    for (std::size_t c = 0; c < low_.size(); ++c)
      range = (std::max)(range, high_[c] - low_[c]);
    return range;
  }

private:
  void add_values(const ChannelInput& channel, const std::array<Index, 3>& values) {
    for (std::size_t c = 0; c < channel.components; ++c)
      for (Index value : values) {
        low_[c] = (std::min)(low_[c], channel.value(value, c));
        high_[c] = (std::max)(high_[c], channel.value(value, c));
      }
    if (!channel.is_texture)
      return;
    const auto difference = [&](std::size_t i, std::size_t c) {
      return channel.value(values[i], c) - channel.value(values[0], c);
    };
    texture_area_ +=
        std::abs(difference(1, 0) * difference(2, 1) - difference(1, 1) * difference(2, 0));
  }

  std::vector<double> low_, high_;
  double area_ = 0, texture_area_ = 0; // twice
};

/// The squares of the lengths, in the engine's unit, that a step of 1 in each component of a
/// channel counts as: see ChannelOptions. Throws std::invalid_argument if these are no lengths that
/// can be told beside those of the surface.
template <class Numbering, class Positions, std::size_t N>
std::vector<double> squared_channel_weights(const ChannelInput& channel, const Numbering& numbering,
                                            const TriangleComplex& complex,
                                            const Positions& positions, const Scale<N>& scale) {
  constexpr double part_of_diagonal = 0.02;
  const ChannelExtent extent(channel, numbering, complex, positions);
  const double range = extent.range();
  double by_default = 1;
  if (channel.is_texture && extent.length_of_texture() > 0)
    by_default = extent.length_of_texture();
  else if (range > 0 && scale.diagonal() > 0)
    by_default = part_of_diagonal * scale.length_from_mesh(scale.diagonal()) / range;
  std::vector<double> squared;
  for (std::size_t c = 0; c < channel.components; ++c) {
    const double weight =
        channel.importance *
        (channel.weights.empty() ? by_default : scale.length_from_mesh(channel.weights[c]));
    squared.push_back(weight * weight);
    if (!std::isnormal(weight * weight) || !(weight * range < 0x1p40))
      throw std::invalid_argument("quadrille::simplify: component " + std::to_string(c) +
                                  " of a channel, of a range of " + text_of(range) + ", weighs " +
                                  text_of(scale.length_of_mesh(weight)) +
                                  ": that is no length beside those of the surface");
  }
  return squared;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_SURFACE_CHANNEL_WEIGHTS_H
