#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNELS_LEFT_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNELS_LEFT_H

#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// What the channels of a surface have become, by the numbers that the caller has given them. The
/// wedges of backs come after all others.
struct ChannelsLeft {
  std::vector<Channel> channels;
  std::vector<std::size_t> back_channels; ///< see BackChannels

  /// Of a face of the complex at a vertex, or of its back.
  Index wedge(const TriangleComplex& complex, std::size_t c, Index face, Index v,
              bool is_back) const {
    const bool is_other = is_back && has_back_channel(c);
    return is_other ? wedges_of(complex, c) + channel_of_backs(c).wedge(complex, face, v)
                    : channels[c].wedge(complex, face, v);
  }
  /// How many numbers of wedges a channel may use.
  std::size_t wedge_count(const TriangleComplex& complex, std::size_t c) const {
    return has_back_channel(c)
               ? wedges_of(complex, c) + channel_of_backs(c).wedge_count(complex.vertex_capacity())
               : wedges_of(complex, c);
  }
  std::size_t components(std::size_t c) const { return channels[c].components(); }
  double value(const TriangleComplex& complex, std::size_t c, Index wedge,
               std::size_t component) const {
    const auto [channel, number] = channel_and_wedge(complex, c, wedge);
    return channel->value(number, component);
  }
  Index origin(const TriangleComplex& complex, std::size_t c, Index wedge) const {
    const auto [channel, number] = channel_and_wedge(complex, c, wedge);
    return channel->origin(number);
  }

private:
  bool has_back_channel(std::size_t c) const {
    return !back_channels.empty() && back_channels[c] != c;
  }
  const Channel& channel_of_backs(std::size_t c) const { return channels[back_channels[c]]; }
  Index wedges_of(const TriangleComplex& complex, std::size_t c) const {
    return static_cast<Index>(channels[c].wedge_count(complex.vertex_capacity()));
  }
  std::pair<const Channel*, Index> channel_and_wedge(const TriangleComplex& complex, std::size_t c,
                                                     Index wedge) const {
    if (!has_back_channel(c) || wedge < wedges_of(complex, c))
      return {&channels[c], wedge};
    return {&channel_of_backs(c), wedge - wedges_of(complex, c)};
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNELS_LEFT_H
