#ifndef QUADRILLE_EXAMPLES_GLTF_CHANNELS_H
#define QUADRILLE_EXAMPLES_GLTF_CHANNELS_H

#include "../mesh_channels.h"
#include "primitive.h"

#include <quadrille/channels.h>
#include <quadrille/compiled.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// An attribute of some of the primitives of a mesh, as a channel of all of its faces. Those of
/// primitives that do not have it are at the first value.
struct GltfChannel {
  AttributeKind kind;
  std::string name;
  std::optional<std::size_t> target;
  quadrille::SoupChannel values;
};

/// The attributes of a mesh on their way through `simplify`.
class GltfChannels {
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool has(AttributeKind kind) const {
    return std::any_of(channels_.begin(), channels_.end(),
                       [&](const GltfChannel& channel) { return channel.kind == kind; });
  }

  /// Takes the values of an attribute in and returns the number of its channel, `none` for those
  /// that are no channels. `first` gets the index of the first value.
  std::size_t add(const GltfAttribute& attribute, std::size_t& first) {
    const std::size_t number = channel_of(attribute);
    if (number == none)
      return none;
    auto& [components, values, triangles] = channels_[number].values;
    first = values.size() / components;
    for (std::size_t v = 0; v < attribute.elements.size(); ++v) {
      const Element element = attribute.elements[v];
      values.insert(values.end(), element.begin(), element.begin() + difference(components));
    }
    return number;
  }

  /// The corners of the next face, for all channels: what `indices` says of a channel.
  template <class Indices>
  void add_face(Indices indices) {
    for (std::size_t channel = 0; channel < channels_.size(); ++channel)
      channels_[channel].values.triangles.push_back(indices(channel));
  }

  Element value(std::size_t channel, std::size_t face, std::size_t corner) const {
    const auto& [components, values, triangles] = channels_[channel].values;
    Element element{};
    std::copy_n(values.begin() + difference(components * triangles[face][corner]), components,
                element.begin());
    return element;
  }

  const std::vector<GltfChannel>& all() const { return channels_; }

  /// Those that it leaves.
  void take(std::vector<quadrille::SoupChannel> channels) {
    for (std::size_t i = 0; i < channels_.size(); ++i)
      channels_[i].values = std::move(channels[i]);
  }

private:
  /// The channel that an attribute belongs to, which is made if there is none.
  std::size_t channel_of(const GltfAttribute& attribute) {
    if (attribute.kind == AttributeKind::position || attribute.kind == AttributeKind::name ||
        attribute.kind == AttributeKind::skin)
      return none;
    for (std::size_t i = 0; i < channels_.size(); ++i)
      if (channels_[i].kind == attribute.kind && channels_[i].name == attribute.name &&
          channels_[i].target == attribute.target)
        return i;
    channels_.push_back({attribute.kind, attribute.name, attribute.target, {}});
    quadrille::SoupChannel& values = channels_.back().values;
    values.components = components_of(attribute.kind);
    values.values.resize(values.components);
    return channels_.size() - 1;
  }

  static std::size_t components_of(AttributeKind kind) {
    const bool is_direction = kind == AttributeKind::normal || kind == AttributeKind::tangent;
    return kind == AttributeKind::texture ? 2 : is_direction ? 3 : 4;
  }

  static std::ptrdiff_t difference(std::size_t count) { return static_cast<std::ptrdiff_t>(count); }

  std::vector<GltfChannel> channels_;
};

} // namespace quadrille_examples

#endif
