#ifndef QUADRILLE_EXAMPLES_GLTF_CHANNELS_H
#define QUADRILLE_EXAMPLES_GLTF_CHANNELS_H

#include "../attributes/mesh_channels.h"
#include "../mesh/follow_triangles.h"
#include "primitive.h"

#include <quadrille/channels.h>
#include <quadrille/compiled.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// An attribute of some of the primitives of a mesh, as a channel of all of its faces. Those of
/// primitives that do not have it are at the first value. The signs of tangents, which have no
/// values in between, are a channel of their own, of the kind of names.
struct GltfChannel {
  AttributeKind kind;
  std::string name;
  std::optional<std::size_t> target;
  quadrille::SoupChannel values;

  bool is_of(const GltfChannel& other) const {
    return kind == other.kind && name == other.name && target == other.target;
  }
};

/// Components of an attribute that are a channel, or the first of it.
struct ChannelPart {
  std::size_t channel; ///< its number
  std::size_t first;   ///< of the components
  std::size_t count;   ///< how many they are
};

/// The attributes of a mesh on their way through `simplify`.
class GltfChannels {
public:
  static constexpr const char* charts = " charts"; // no attribute has such a name

  bool has(AttributeKind kind) const {
    return std::any_of(channels_.begin(), channels_.end(), [&](const GltfChannel& channel) {
      return channel.kind == kind && channel.name != charts;
    });
  }

  /// The channels that an attribute belongs to, which are made if there are none.
  std::vector<ChannelPart> components_of(const GltfAttribute& attribute) {
    using Kind = AttributeKind;
    if (attribute.kind == Kind::position || attribute.kind == Kind::skin || attribute.is_label)
      return {};
    const std::size_t size = attribute.elements.type().components;
    if (attribute.kind == Kind::tangent)
      return {{number_of(attribute, Kind::tangent, 3), 0, 3},
              {number_of(attribute, Kind::name, 1), 3, 1}};
    return {{number_of(attribute, attribute.kind, components_of(attribute.kind)), 0, size}};
  }

  /// Takes the values of a part of an attribute in. Returns the index of the first.
  std::size_t add(const GltfAttribute& attribute, const ChannelPart& part) {
    auto& [components, values, triangles] = channels_[part.channel].values;
    const std::size_t first = values.size() / components;
    for (std::size_t v = 0; v < attribute.elements.size(); ++v) {
      const Element element = attribute.elements[v];
      const auto begin = element.begin() + difference(part.first);
      values.insert(values.end(), begin, begin + difference(components));
    }
    return first;
  }

  /// The corners of the next face, for all channels: what `indices` says of a channel.
  template <class Indices>
  void add_face(Indices indices) {
    for (std::size_t channel = 0; channel < channels_.size(); ++channel)
      channels_[channel].values.triangles.push_back(indices(channel));
  }

  /// A texture that is of no attribute, but holds borders. All faces are there.
  void add_charts(const CornerValues<2>& corners) {
    quadrille::SoupChannel values{2, {0, 0}, {}};
    for (const std::array<double, 2>& value : corners.values)
      values.values.insert(values.values.end(), value.begin(), value.end());
    for (std::array<std::uint32_t, 3> triangle : corners.triples) {
      for (std::uint32_t& corner : triangle)
        ++corner; // behind what stands first
      values.triangles.push_back(triangle);
    }
    channels_.push_back({AttributeKind::texture, charts, std::nullopt, std::move(values)});
  }

  /// Gives an element at a corner of a face what the channel of a part has there.
  void copy_to(Element& element, const ChannelPart& part, std::size_t face,
               std::size_t corner) const {
    const auto& [components, values, triangles] = channels_[part.channel].values;
    std::copy_n(values.begin() + difference(components * triangles[face][corner]), part.count,
                element.begin() + difference(part.first));
  }

  const std::vector<GltfChannel>& all() const { return channels_; }

  /// Those that it leaves.
  void take(std::vector<quadrille::SoupChannel> channels) {
    for (std::size_t i = 0; i < channels_.size(); ++i)
      channels_[i].values = std::move(channels[i]);
  }

  /// Keeps what the corners of some faces have.
  void keep_faces(const std::vector<std::size_t>& kept) {
    for (GltfChannel& channel : channels_)
      follow_triangles(channel.values.triangles, kept);
  }

private:
  /// The channel of a kind that an attribute belongs to, which is made if there is none.
  std::size_t number_of(const GltfAttribute& attribute, AttributeKind kind,
                        std::size_t components) {
    GltfChannel channel{kind, attribute.name, attribute.target, {}};
    for (std::size_t i = 0; i < channels_.size(); ++i)
      if (channels_[i].is_of(channel))
        return i;
    channel.values.components = components;
    channel.values.values.resize(components);
    channels_.push_back(std::move(channel));
    return channels_.size() - 1;
  }

  static std::size_t components_of(AttributeKind kind) {
    return kind == AttributeKind::texture ? 2 : kind == AttributeKind::normal ? 3 : 4;
  }

  static std::ptrdiff_t difference(std::size_t count) { return static_cast<std::ptrdiff_t>(count); }

  std::vector<GltfChannel> channels_;
};

} // namespace quadrille_examples

#endif
