#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_TOLD_CHANNELS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_TOLD_CHANNELS_H

#include <quadrille/internal/attributes/channel.h>
#include <quadrille/internal/core/base/index.h>

#include <cstddef>
#include <span>
#include <vector>

namespace quadrille::internal {

/// A channel of the engine as a recorder is told of it.
struct ToldChannel {
  std::size_t number;   ///< of the channel of the call
  Index first_wedge;    ///< what is added to the numbers of its wedges
  bool is_of_backs;     ///< are its values those of backs?
  bool has_wedges;      ///< or is its value a number of each vertex?
  std::size_t of_backs; ///< which channel has the values of backs; itself if they have the same
};

/// All channels of a surface. Where backs have values of their own these are further wedges of the
/// channel. `back_channels`: see BackValues; empty if there are no backs.
inline std::vector<ToldChannel> told_channels(std::span<const Channel> channels,
                                              const std::vector<std::size_t>& back_channels,
                                              std::size_t vertices) {
  std::vector<ToldChannel> told(channels.size());
  for (std::size_t c = 0; c < told.size(); ++c)
    told[c] = {c, 0, false, channels[c].has_seams(), c};
  for (std::size_t c = 0; c < back_channels.size(); ++c)
    if (const std::size_t backs = back_channels[c]; backs != c) {
      const auto wedges = static_cast<Index>(channels[c].wedge_count(vertices));
      told[c].has_wedges = true;
      told[c].of_backs = backs;
      told[backs] = {c, wedges, true, true, backs};
    }
  return told;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_TOLD_CHANNELS_H
