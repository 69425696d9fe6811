#ifndef QUADRILLE_INTERNAL_CORE_APPEARANCE_NO_CHANNELS_H
#define QUADRILLE_INTERNAL_CORE_APPEARANCE_NO_CHANNELS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>

#include <tuple>
#include <type_traits>

/// \file
/// The engine's view of channels. <quadrille/channels.h> defines the channels of a call; a call
/// without channels requires only this header.

namespace quadrille::internal {

/// The channels of a surface: see channels.h.
template <class Cost>
class Channels;
/// The final values of channels: see channels.h.
struct ChannelsLeft;

/// Stands for them if a surface has no channels.
struct NoChannelsLeft {};

/// The seams of channels, of a surface that has none: see ChannelSeams.
struct NoChannelSeams {
  bool are_any_kept() const { return false; }
  bool are_at(Index, Index, Index, Index) const { return false; }
  bool are_changed_by(const PairStar&, Index, Index) const { return false; }
};

/// The channels of a surface that has none.
struct NoChannels {
  using Left = NoChannelsLeft;
  using Seams = NoChannelSeams;

  template <class Complex, class Geometry, class Memories>
  NoChannels(const Complex&, const Geometry&, Memories&) {}
  bool have_seams() const { return false; }
  NoChannelSeams seams() const { return {}; }
  void contract(const auto&) {}
  NoChannelsLeft take() { return {}; }
  static auto vertex_arrays(auto&) { return std::tuple<>(); }
};

template <class Policies>
using ChannelsOf =
    std::conditional_t<Policies::has_channels, Channels<typename Policies::Cost>, NoChannels>;
template <class Policies>
using ChannelsLeftOf = std::conditional_t<Policies::has_channels, ChannelsLeft, NoChannelsLeft>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_APPEARANCE_NO_CHANNELS_H
