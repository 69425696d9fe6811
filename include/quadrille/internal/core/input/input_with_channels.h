#ifndef QUADRILLE_INTERNAL_CORE_INPUT_INPUT_WITH_CHANNELS_H
#define QUADRILLE_INTERNAL_CORE_INPUT_INPUT_WITH_CHANNELS_H

#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/input/surface_input.h>

#include <utility>
#include <vector>

namespace quadrille::internal {

/// The data that an adapter reads from a surface with channels.
struct InputWithChannels : SurfaceInput<3> {
  using SurfaceInput<3>::SurfaceInput;
  explicit InputWithChannels(SurfaceInput<3> surface) : SurfaceInput<3>(std::move(surface)) {}

  std::vector<ChannelInput> channels;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_INPUT_INPUT_WITH_CHANNELS_H
