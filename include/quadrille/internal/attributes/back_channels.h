#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_BACK_CHANNELS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_BACK_CHANNELS_H

#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The values that backs have beside their fronts, told as channels of the fronts.
class BackChannels {
public:
  BackChannels(const TriangleComplex& complex, const InputIndices& faces,
               std::vector<ChannelInput>& channels)
      : complex_(complex), faces_(faces), channels_(channels) {}

  /// Appends a channel of the values that backs have for each channel in which they differ from
  /// their fronts. Returns which channel these are, of each that there was; its own number where
  /// there is none.
  std::vector<std::size_t> add() {
    std::vector<std::size_t> numbers;
    const std::size_t count = channels_.size();
    for (std::size_t c = 0; c < count; ++c) {
      std::optional<ChannelInput> backs = channel_of_backs(channels_[c]);
      numbers.push_back(backs ? channels_.size() : c);
      if (backs)
        channels_.push_back(*std::move(backs));
    }
    return numbers;
  }

private:
  // A vertex that has one value has it on both sides. Faces without a back have one value
  // throughout, which costs nothing.
  std::optional<ChannelInput> channel_of_backs(const ChannelInput& channel) const {
    if (channel.corners.empty())
      return std::nullopt;
    const Backs& backs = complex_.backs();
    bool differs = false;
    std::optional<Index> first;
    auto corners = channel.corners;
    for_each_face(complex_, [&](Index face) {
      if (!backs.has(face))
        return;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index value = channel.corners[backs.input_face(face)][backs.opposite(face, i)];
        differs |= !channel.are_equal(channel.corners[faces_[face]][i], value);
        corners[faces_[face]][i] = value;
        first = first.value_or(value);
      }
    });
    if (!differs)
      return std::nullopt;
    for_each_face(complex_, [&](Index face) {
      if (!backs.has(face))
        corners[faces_[face]] = {*first, *first, *first};
    });
    ChannelInput result = channel;
    result.corners = std::move(corners);
    return result;
  }

  const TriangleComplex& complex_;
  const InputIndices& faces_;
  std::vector<ChannelInput>& channels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_BACK_CHANNELS_H
