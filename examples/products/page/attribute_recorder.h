#ifndef QUADRILLE_EXAMPLES_PAGE_ATTRIBUTE_RECORDER_H
#define QUADRILLE_EXAMPLES_PAGE_ATTRIBUTE_RECORDER_H

#include "../program/position_recorder.h"
#include "shown_mesh.h"
#include "track.h"

#include <quadrille/levels.h>
#include <quadrille/record.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The colours and texture coordinates of a recording that a page shows, by input indices. Colours
/// are linear, from 0 to 1; the second texture coordinate goes down, as that of images does.
struct RecordedAttributes {
  bool has_colors = false, has_textures = false; ///< at vertices
  std::vector<float> values;                     ///< of each vertex: colour, texture coordinates
  std::vector<float> changed_values; ///< of the vertex that each contraction leaves, if it does
  Track textures;                    ///< instead, where these have seams; of the faces of the input

  std::size_t width() const { return (has_colors ? 3U : 0U) + (has_textures ? 2U : 0U); }
};

/// Records positions as levels, and beside them what a page shows.
class AttributeRecorder {
public:
  /// Of a run that begins with `shown`.
  AttributeRecorder(const ShownMesh& shown, quadrille::Levels& levels)
      : positions_(levels), has_corner_textures_(!shown.mesh.corner_textures.empty()),
        has_normals_(!shown.mesh.corner_normals.empty()),
        full_color_(shown.has_linear_colors ? 0 : shown.mesh.color_type.full) {
    const IndexedMesh& mesh = shown.mesh;
    const std::size_t any = mesh.triangles.empty() ? 0 : mesh.triangles[0][0];
    has_vertex_textures_ = !mesh.texture_coordinates.empty();
    recorded_.has_colors = !mesh.colors.empty();
    recorded_.has_textures = has_vertex_textures_ && shown.looks.has_images();
    shows_corner_textures_ = has_corner_textures_ && shown.looks.has_images();
    for (std::size_t i = 0; i < 4 && recorded_.has_colors; ++i)
      numbers_[i].constant = mesh.colors[any][i];
    for (std::size_t i = 0; i < 2 && recorded_.has_textures; ++i)
      numbers_[4 + i].constant = mesh.texture_coordinates[any][i];
  }

  void begin(quadrille::RecordedSurface surface) {
    find_channels(surface);
    for (std::size_t v = 0; v < surface.values.size(); v += surface.width)
      append(std::span(surface.values).subspan(v, surface.width), recorded_.values);
    positions_.begin(std::move(surface));
  }

  void record(const quadrille::RecordedContraction& contraction) {
    if (contraction.kept != quadrille::not_recorded)
      append(contraction.values, recorded_.changed_values);
    for (const quadrille::RecordedWedge& wedge : contraction.wedges)
      if (wedge.channel == seamed_channel_)
        record(wedge);
    recorded_.textures.end_contraction();
    ++contractions_;
    positions_.record(contraction);
  }

  void end() { positions_.end(); }

  RecordedAttributes take() { return std::move(recorded_); }

private:
  /// The place of one of the numbers of a vertex, or the value that it always has.
  struct Number {
    std::optional<std::size_t> place;
    double constant = 0;
  };

  /// Of the channels that there are, textures come first, then normals, then colours: see
  /// MeshChannels.
  void find_channels(quadrille::RecordedSurface& surface) {
    const bool has_textures = has_vertex_textures_ || has_corner_textures_;
    const std::size_t of_colors = (has_textures ? 1U : 0U) + (has_normals_ ? 1U : 0U);
    std::size_t place = surface.dimension;
    for (std::size_t c = 0; c < surface.channels.size(); ++c) {
      quadrille::RecordedChannel& channel = surface.channels[c];
      const bool is_texture = c == 0 && (recorded_.has_textures || shows_corner_textures_);
      if (!channel.corners.empty()) {
        if (is_texture)
          begin_textures(c, channel);
        continue;
      }
      if (is_texture)
        recorded_.has_textures = true;
      const bool is_color = recorded_.has_colors && c == of_colors;
      for (std::size_t i = 0; i < channel.components && (is_texture || is_color); ++i)
        numbers_[(is_texture ? 4 : 0) + i].place = place + i;
      place += channel.components;
    }
  }

  void begin_textures(std::size_t number, const quadrille::RecordedChannel& channel) {
    seamed_channel_ = number;
    recorded_.has_textures = false;
    Track& textures = recorded_.textures;
    textures.width = 2;
    textures.corners = channel.corners;
    textures.add_items(channel.values.size() / 2);
    append_textures(channel.values, textures.values);
  }

  void record(const quadrille::RecordedWedge& wedge) {
    Track& textures = recorded_.textures;
    for (const quadrille::RecordedIndex joined : wedge.joined)
      textures.end_item(joined, contractions_, wedge.wedge);
    if (wedge.values.empty())
      return;
    textures.changed.push_back(wedge.wedge);
    append_textures(wedge.values, textures.changed_values);
  }

  static void append_textures(std::span<const double> numbers, std::vector<float>& values) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      values.push_back(static_cast<float>(i % 2 == 0 ? numbers[i] : 1 - numbers[i]));
  }

  /// What a page shows of the numbers of a vertex.
  void append(std::span<const double> vertex, std::vector<float>& values) const {
    const auto number = [&](std::size_t i) {
      const Number& n = numbers_[i];
      return n.place ? vertex[*n.place] : n.constant;
    };
    for (std::size_t i = 0; i < 3 && recorded_.has_colors; ++i)
      values.push_back(static_cast<float>(light(number(i))));
    if (recorded_.has_textures)
      append_textures(std::array{number(4), number(5)}, values);
  }

  double light(double color) const {
    if (full_color_ == 0)
      return std::clamp(color, 0., 1.);
    return linear_light(std::clamp(color / full_color_, 0., 1.));
  }

  PositionRecorder positions_;
  bool has_corner_textures_, has_normals_, has_vertex_textures_, shows_corner_textures_;
  double full_color_;               // 0: linear
  std::array<Number, 6> numbers_{}; // red, green, blue, alpha; texture coordinates
  std::optional<std::size_t> seamed_channel_;
  std::size_t contractions_ = 0;
  RecordedAttributes recorded_;
};

} // namespace quadrille_examples

#endif
