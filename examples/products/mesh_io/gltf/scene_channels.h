#ifndef QUADRILLE_EXAMPLES_GLTF_SCENE_CHANNELS_H
#define QUADRILLE_EXAMPLES_GLTF_SCENE_CHANNELS_H

#include "../attributes/mesh_channels.h"
#include "channels.h"
#include "placement.h"
#include "surface.h"

#include <quadrille/channels.h>
#include <quadrille/compiled.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The channels of all surfaces of a scene: those of one kind and name are one. Faces of surfaces
/// that do not have it are at its first value.
class GltfSceneChannels {
public:
  GltfSceneChannels(const std::vector<GltfSurface>& surfaces,
                    const std::vector<const GltfPlacement*>& placements)
      : numbers_(surfaces.size()) {
    std::size_t faces = 0;
    for (const GltfSurface& surface : surfaces)
      faces += surface.triangles.size();
    std::size_t first_face = 0;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      for (const GltfChannel& channel : surfaces[s].channels().all()) {
        numbers_[s].push_back(number_of(channel, faces));
        append(channel, *placements[s], first_face, channels_[numbers_[s].back()].values);
      }
      append_skin(surfaces[s], *placements[s], first_face, faces);
      first_face += surfaces[s].triangles.size();
    }
  }

  /// As `quadrille::simplified_soup` takes them. Ranges count as parts of such a length by default.
  std::vector<quadrille::SoupChannelView> views(const ChannelChoices& choices,
                                                double length) const {
    std::vector<quadrille::SoupChannelView> views;
    for (const GltfChannel& channel : channels_)
      views.push_back({.kind = kind_of(channel.kind),
                       .components = channel.values.components,
                       .values = channel.values.values,
                       .triangles = channel.values.triangles,
                       .options = options_of(channel, choices, length)});
    return views;
  }

  /// What is left of the channels of a surface, of which `faces` are left. `values` are what
  /// `quadrille::simplified_soup` has left of all.
  std::vector<quadrille::SoupChannel> part(std::size_t surface, const GltfPlacement& placement,
                                           const std::vector<std::size_t>& faces,
                                           const std::vector<quadrille::SoupChannel>& values) {
    std::vector<quadrille::SoupChannel> parts;
    for (const std::size_t number : numbers_[surface]) {
      const GltfChannel& channel = channels_[number];
      const double unit = is_length(channel) ? placement.largest.stretch() : 1;
      parts.push_back(part(values[number], faces, unit, placement.is_mirrored()));
    }
    return parts;
  }

private:
  static constexpr const char* skin = " skin"; // no attribute has such a name
  /// What has no values in between counts so much less than others: it changes by its whole range
  /// across an edge, or has no order. Then it goes where that is cheap, and the shape is as good as
  /// without it.
  static constexpr double part_of_names = 1. / 16;

  std::size_t number_of(const GltfChannel& channel, std::size_t faces) {
    for (std::size_t i = 0; i < channels_.size(); ++i)
      if (channels_[i].is_of(channel))
        return i;
    channels_.push_back({channel.kind, channel.name, channel.target, {}});
    quadrille::SoupChannel& values = channels_.back().values;
    values.components = channel.values.components;
    values.values.assign(values.components, 0);
    values.triangles.resize(faces);
    return channels_.size() - 1;
  }

  /// Displacements of positions, which are lengths.
  static bool is_length(const GltfChannel& channel) {
    return channel.kind == AttributeKind::number && channel.target && channel.name == "POSITION";
  }

  static void append(const GltfChannel& from, const GltfPlacement& placement, std::size_t face,
                     quadrille::SoupChannel& to) {
    const auto first = static_cast<std::uint32_t>(to.values.size() / to.components);
    const double unit = is_length(from) ? placement.largest.stretch() : 1;
    for (const double value : from.values.values)
      to.values.push_back(value * unit);
    for (std::array<std::uint32_t, 3> triangle : from.values.triangles) {
      for (std::uint32_t& corner : triangle)
        corner += first;
      if (placement.is_mirrored())
        std::swap(triangle[1], triangle[2]);
      to.triangles[face++] = triangle;
    }
  }

  /// How far joints move its points in the scene.
  void append_skin(const GltfSurface& surface, const GltfPlacement& placement, std::size_t face,
                   std::size_t faces) {
    if (!surface.has_skin() || !placement.skeleton)
      return;
    GltfChannel channel{AttributeKind::number, skin, std::nullopt, {}};
    channel.values.components = 3 * GltfSkeleton::poses;
    const Vector origin = placement.largest({});
    for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
      const std::vector<double> moves = surface.displacements(v, *placement.skeleton);
      for (std::size_t i = 0; i < moves.size(); i += 3) {
        const Vector moved = placement.largest({moves[i], moves[i + 1], moves[i + 2]});
        for (std::size_t c = 0; c < 3; ++c)
          channel.values.values.push_back(moved[c] - origin[c]);
      }
    }
    channel.values.triangles = surface.triangles;
    append(channel, placement, face, channels_[number_of(channel, faces)].values);
  }

  quadrille::SoupChannel part(const quadrille::SoupChannel& all,
                              const std::vector<std::size_t>& faces, double unit,
                              bool is_mirrored) {
    quadrille::SoupChannel part{all.components, {}, {}};
    part.values.assign(all.components, 0); // what stands first has no meaning
    std::vector<std::uint32_t> used;
    for (const std::size_t face : faces)
      used.insert(used.end(), all.triangles[face].begin(), all.triangles[face].end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t value : used)
      for (std::size_t c = 0; c < all.components; ++c)
        part.values.push_back(all.values[value * all.components + c] / unit);
    for (const std::size_t face : faces) {
      std::array<std::uint32_t, 3> triangle = all.triangles[face];
      for (std::uint32_t& corner : triangle)
        corner = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), corner) -
                                            used.begin() + 1);
      if (is_mirrored)
        std::swap(triangle[1], triangle[2]);
      part.triangles.push_back(triangle);
    }
    return part;
  }

  static quadrille::SoupChannelView::Kind kind_of(AttributeKind kind) {
    using Kind = quadrille::SoupChannelView::Kind;
    switch (kind) {
    case AttributeKind::texture:
      return Kind::texture;
    case AttributeKind::color:
      return Kind::colors;
    case AttributeKind::normal:
    case AttributeKind::tangent:
      return Kind::normals;
    default:
      return Kind::attributes;
    }
  }

  /// Displacements are lengths as they are, normals and colours count by default; others as well,
  /// but by the size of a mesh and not of the scene, in which meshes may be far from each other.
  /// What has no values in between holds nothing: a corner has one of those that there were.
  static quadrille::ChannelOptions options_of(const GltfChannel& channel,
                                              const ChannelChoices& choices, double length) {
    if (channel.name == GltfChannels::charts)
      return {};
    if (channel.kind == AttributeKind::texture)
      return {.importance = choices.of_textures, .seams = choices.texture_seams};
    quadrille::ChannelOptions options{.importance = channel.kind == AttributeKind::color
                                                        ? choices.of_colors
                                                        : choices.of_normals};
    if (channel.kind == AttributeKind::normal || channel.kind == AttributeKind::color)
      return options;
    if (channel.kind == AttributeKind::name)
      options.new_values = quadrille::NewValues::existing;
    const double range = largest_range(channel.values);
    const double part = channel.kind == AttributeKind::name ? part_of_names : 1;
    if (channel.name == skin || is_length(channel))
      options.weights.assign(channel.values.components, 1);
    else if (const double weight = 0.02 * part * length / range;
             weight > 0 && std::isfinite(weight))
      options.weights.assign(channel.values.components, weight);
    return options;
  }

  /// But for the value that stands first.
  static double largest_range(const quadrille::SoupChannel& channel) {
    double largest = 0;
    for (std::size_t c = 0; c < channel.components; ++c) {
      double least = std::numeric_limits<double>::max(), greatest = -least;
      for (std::size_t i = channel.components + c; i < channel.values.size();
           i += channel.components) {
        least = std::min(least, channel.values[i]);
        greatest = std::max(greatest, channel.values[i]);
      }
      largest = std::max(largest, greatest - least);
    }
    return largest;
  }

  std::vector<GltfChannel> channels_;
  std::vector<std::vector<std::size_t>> numbers_; // of the channels of each surface
};

} // namespace quadrille_examples

#endif
