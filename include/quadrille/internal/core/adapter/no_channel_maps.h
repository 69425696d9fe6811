#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_NO_CHANNEL_MAPS_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_NO_CHANNEL_MAPS_H

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <vector>

/// \file
/// The adapters' view of the channels of a call: <quadrille/channels.h> defines the templates, and
/// a call without channels requires only this header.

namespace quadrille::internal {

template <class Channel>
class ChannelMap;
template <class Source>
struct MapOfSource;
template <class Mesh, class Maps>
class FaceGraphChannels;
template <class Maps>
class SoupChannels;
template <class Points, class Triangles, class PointMap, class Labels, class Maps>
class SplitSoupAdapter;

/// Are there any channels among these maps?
template <class Maps>
inline constexpr bool has_channels_in = !std::is_same_v<Maps, std::tuple<>>;

/// Channels of the user's as a tuple of their maps.
template <class... Channel>
auto channel_maps(const std::tuple<Channel...>& channels) {
  return std::apply(
      [](const auto&... channel) {
        return std::make_tuple(ChannelMap<std::remove_cvref_t<decltype(channel)>>(channel)...);
      },
      channels);
}

template <class Mesh>
class FaceGraphChannels<Mesh, std::tuple<>> {
public:
  explicit FaceGraphChannels(std::tuple<>) {}

  template <class Result, class VertexOf, class Halfedges>
  void write(const Result&, std::size_t, VertexOf, const Halfedges&) {}
  void undo() {}
  template <class Vertex>
  void copy(Vertex, Vertex) {}
};

template <>
class SoupChannels<std::tuple<>> {
public:
  struct Nothing {};

  explicit SoupChannels(std::tuple<>) {}

  template <class Result, class Faces>
  Nothing rewritten(const Result&, const Faces&) const {
    return {};
  }
  void swap(Nothing&) {}
  template <class Result, class... Points>
  Nothing values(const Result&, const Points&...) const {
    return {};
  }
  void write(Nothing) {}
  std::vector<std::size_t> of_points() const { return {}; }
  void undo() {}
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_NO_CHANNEL_MAPS_H
