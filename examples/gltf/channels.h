#ifndef QUADRILLE_EXAMPLES_GLTF_CHANNELS_H
#define QUADRILLE_EXAMPLES_GLTF_CHANNELS_H

#include "../mesh_channels.h"
#include "../mesh_io/indexed_mesh.h"
#include "primitive.h"

#include <quadrille/channels.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// An attribute of some of the primitives of a mesh, as a channel of all of its faces. Those of
/// primitives that do not have it are at the first value.
struct GltfChannel {
  AttributeKind kind;
  std::string name;
  std::optional<std::size_t> target;
  CornerValues<4> corners;
};

/// How many channels of a kind a mesh may have. Each is an argument of `simplify`.
struct ChannelLimit {
  AttributeKind kind;
  std::size_t most;
  std::string_view what;
};
inline constexpr ChannelLimit channel_limits[] = {
    {AttributeKind::texture, 4, "sets of texture coordinates"},
    {AttributeKind::color, 2, "sets of colours"},
    {AttributeKind::normal, 1, "normals"},
    {AttributeKind::tangent, 1, "tangents"},
    {AttributeKind::number, 8, "attributes of its own and of its morph targets"}};

/// The attributes of a mesh on their way through `simplify`.
class GltfChannels {
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool has(AttributeKind kind) const { return find(kind, 0) != none; }

  /// Takes the values of an attribute in and returns the number of its channel, `none` for those
  /// that are no channels. `first` gets the index of the first value.
  std::size_t add(const GltfAttribute& attribute, std::size_t& first) {
    const std::size_t number = channel_of(attribute);
    if (number == none)
      return none;
    auto& values = channels_[number].corners.values;
    first = values.size();
    for (std::size_t v = 0; v < attribute.elements.size(); ++v)
      values.push_back(attribute.elements[v]);
    return number;
  }

  /// The corners of the next face, for all channels: what `indices` says of a channel.
  template <class Indices>
  void add_face(Indices indices) {
    for (std::size_t channel = 0; channel < channels_.size(); ++channel)
      channels_[channel].corners.triples.push_back(indices(channel));
  }

  const Element& value(std::size_t channel, std::size_t face, std::size_t corner) const {
    const CornerValues<4>& corners = channels_[channel].corners;
    return corners.values[corners.triples[face][corner]];
  }

  /// Calls simplify(argument...) with arguments for `quadrille::simplify`. One type of call serves
  /// all meshes: a channel without values is none.
  template <class Simplify>
  quadrille::Report take_through(Simplify simplify, const ChannelChoices& choices) {
    const auto texture = [&](std::size_t i) {
      CornerValues<4>& corners = corners_of(AttributeKind::texture, i);
      return quadrille::Texture(corners.values, corners.triples,
                                {.importance = choices.of_textures, .seams = choices.texture_seams});
    };
    const auto color = [&](std::size_t i) {
      CornerValues<4>& corners = corners_of(AttributeKind::color, i);
      return quadrille::Colors(corners.values, corners.triples,
                               {.importance = choices.of_colors});
    };
    const auto direction = [&](AttributeKind kind) {
      CornerValues<4>& corners = corners_of(kind, 0);
      return quadrille::Normals(corners.values, corners.triples,
                                {.importance = choices.of_normals});
    };
    const auto number = [&](std::size_t i) {
      CornerValues<4>& corners = corners_of(AttributeKind::number, i);
      return quadrille::Attributes(corners.values, corners.triples,
                                   {.importance = choices.of_normals, .weights = weights(i)});
    };
    return simplify(texture(0), texture(1), texture(2), texture(3), color(0), color(1),
                    direction(AttributeKind::normal), direction(AttributeKind::tangent), number(0),
                    number(1), number(2), number(3), number(4), number(5), number(6), number(7));
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
    for (const ChannelLimit& limit : channel_limits)
      if (attribute.kind == limit.kind && find(limit.kind, limit.most - 1) != none)
        throw std::runtime_error("a mesh with more than " + std::to_string(limit.most) + " " +
                                 std::string(limit.what) + " is not simplified");
    channels_.push_back({attribute.kind, attribute.name, attribute.target, {}});
    channels_.back().corners.values.emplace_back();
    return channels_.size() - 1;
  }

  /// The i-th channel of a kind; `none` if there are not so many.
  std::size_t find(AttributeKind kind, std::size_t i) const {
    for (std::size_t channel = 0; channel < channels_.size(); ++channel)
      if (channels_[channel].kind == kind && i-- == 0)
        return channel;
    return none;
  }
  CornerValues<4>& corners_of(AttributeKind kind, std::size_t i) {
    const std::size_t found = find(kind, i);
    return found == none ? no_corners_ : channels_[found].corners;
  }
  /// Displacements of positions are lengths as they are; others count by default.
  std::vector<double> weights(std::size_t i) const {
    const std::size_t found = find(AttributeKind::number, i);
    const bool are_lengths =
        found != none && channels_[found].target && channels_[found].name == "POSITION";
    return are_lengths ? std::vector<double>(4, 1.) : std::vector<double>();
  }

  std::vector<GltfChannel> channels_;
  CornerValues<4> no_corners_;
};

} // namespace quadrille_examples

#endif
