#ifndef QUADRILLE_EXAMPLES_MESH_CHANNELS_H
#define QUADRILLE_EXAMPLES_MESH_CHANNELS_H

#include "../mesh/face_parts.h"
#include "../mesh/indexed_mesh.h"
#include "../mesh/named_numbers.h"
#include "face_labels.h"
#include "soup_arrays.h"
#include "value_seams.h"
#include "vertex_values.h"

#include <quadrille/channels.h>
#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// By how much less counts what shall hardly count.
inline constexpr double hardly = 1. / 64;

/// How much attributes count, and what becomes of the seams of textures, as
/// quadrille::ChannelOptions has it.
struct ChannelChoices {
  double of_colors = 1, of_textures = 1, of_normals = 1, of_numbers = 1;
  std::optional<quadrille::Seams> texture_seams = {};
};

/// Returns whether a mesh has anything in addition to positions that differs from place to place.
inline bool needs_channels(const IndexedMesh& mesh) {
  const auto differ = [](const NamedNumbers& numbers) { return numbers.differ(); };
  return !mesh.colors.empty() || !mesh.texture_coordinates.empty() ||
         !mesh.corner_textures.empty() || !mesh.corner_normals.empty() ||
         !mesh.value_triangles.empty() || mesh.parts.differ() ||
         std::any_of(mesh.vertex_numbers.begin(), mesh.vertex_numbers.end(), differ) ||
         std::any_of(mesh.face_numbers.begin(), mesh.face_numbers.end(), differ);
}

/// Fits the numbers of a mesh that needs no channels to the vertices and faces that are left.
inline void resize_constants(IndexedMesh& mesh) {
  const auto resize = [](auto& values, std::size_t count) {
    if (!values.empty())
      values.assign(count, std::remove_cvref_t<decltype(values.front())>(values.front()));
  };
  resize(mesh.parts.of_faces, mesh.triangles.size());
  for (NamedNumbers& numbers : mesh.vertex_numbers)
    resize(numbers.values, mesh.points.size());
  for (NamedNumbers& numbers : mesh.face_numbers)
    resize(numbers.values, mesh.triangles.size());
}

/// A mesh on its way through `quadrille::simplified_soup`, with what its vertices, its corners and
/// its faces have.
class MeshChannels {
public:
  explicit MeshChannels(IndexedMesh& mesh)
      : mesh_(mesh), colors_(std::move(mesh.colors), mesh),
        textures_(std::move(mesh.texture_coordinates), mesh), numbers_(mesh),
        labels_(FaceRegions(mesh).labels()) {
    if (!mesh.value_triangles.empty())
      patches_.emplace(mesh);
  }

  /// The channels are textures, normals, colours, numbers and the charts of seams of vertices, in
  /// this order, as far as there are any. `begun`, if there is one, becomes what
  /// begun_surface() is.
  quadrille::Report simplify(const quadrille::SoupOptions& options, const ChannelChoices& choices,
                             quadrille::PreparedSurface* begun = nullptr) {
    const quadrille::SoupPoints points = soup_points(mesh_.points);
    const std::vector<Channel> channels = this->channels(choices);
    quadrille::SoupView soup{points, mesh_.triangles, labels_, {}};
    for (const Channel& channel : channels)
      soup.channels.push_back(channel.view);
    quadrille::SoupResult result = quadrille::simplified_soup(soup, options);
    const bool are_inputs = options.placement == quadrille::SoupOptions::Placement::endpoint;
    const std::vector<std::uint32_t> nearest = quadrille_examples::nearest_inputs(points, result);
    if (are_inputs && !patches_) // each point that is left is the nearest of those that became it
      take_inputs(nearest);
    for (std::size_t i = 0; i < channels.size(); ++i)
      channels[i].take(std::move(result.channels[i]));
    mesh_.points = mesh_points(result.points);
    mesh_.triangles = std::move(result.triangles);
    if (patches_) {
      restore_seams(patches_->nearest(mesh_, result.vertex_map, result.input_faces));
    } else {
      if (!are_inputs) {
        mesh_.colors = colors_.of_points(mesh_);
        mesh_.texture_coordinates = textures_.of_points(mesh_);
      }
      numbers_.restore(mesh_, nearest);
    }
    take_faces(mesh_, result.input_faces);
    if (begun)
      *begun = begun_surface(result);
    return result.report;
  }

private:
  struct Channel {
    quadrille::SoupChannelView view;
    std::function<void(quadrille::SoupChannel)> take;
  };

  /// Takes the colours and texture coordinates of these points of the input.
  void take_inputs(const std::vector<std::uint32_t>& points) {
    mesh_.colors = colors_.of_inputs(points);
    mesh_.texture_coordinates = textures_.of_inputs(points);
  }

  /// Of each corner the values of its side; `nearest` names an old one of these.
  void restore_seams(const std::vector<std::array<std::uint32_t, 3>>& nearest) {
    ValueNumbers numbers(mesh_.points.size());
    mesh_.value_triangles.clear();
    for (std::size_t face = 0; face < mesh_.triangles.size(); ++face) {
      mesh_.value_triangles.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double> row;
        colors_.append_corner(face, i, row);
        textures_.append_corner(face, i, row);
        numbers_.append_corner(face, i, nearest[face][i], row);
        mesh_.value_triangles.back()[i] = numbers.number(mesh_.triangles[face][i], row);
      }
    }
    if (numbers.rows().size() == mesh_.points.size())
      mesh_.value_triangles.clear();
    std::size_t first = 0; // of the columns
    take_columns(numbers.rows(), first, colors_.empty(), mesh_.colors);
    take_columns(numbers.rows(), first, textures_.empty(), mesh_.texture_coordinates);
    for (NamedNumbers& column : mesh_.vertex_numbers) {
      column.values.clear();
      for (const std::vector<double>& row : numbers.rows())
        column.values.push_back(row.empty() ? 0 : row[first]);
      ++first;
    }
  }

  template <std::size_t N>
  static void take_columns(const std::vector<std::vector<double>>& rows, std::size_t& first,
                           bool is_absent, std::vector<std::array<double, N>>& values) {
    values.assign(is_absent ? 0 : rows.size(), {});
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t k = 0; k < N && !rows[i].empty(); ++k)
        values[i][k] = rows[i][first + k];
    first += is_absent ? 0 : N;
  }

  std::vector<Channel> channels(const ChannelChoices& choices) {
    using Kind = quadrille::SoupChannelView::Kind;
    std::vector<Channel> channels;
    const auto add = [&](auto& corners, Kind kind, const quadrille::ChannelOptions& options) {
      if (!corners.empty())
        channels.push_back(
            {view_of(corners, kind, options), [&corners](quadrille::SoupChannel channel) {
               quadrille_examples::take(corners, std::move(channel));
             }});
    };
    add(textures_.empty() ? mesh_.corner_textures : textures_.corners, Kind::texture,
        {.importance = choices.of_textures, .seams = choices.texture_seams});
    add(mesh_.corner_normals, Kind::normals, {.importance = choices.of_normals});
    add(colors_.corners, Kind::colors, {.importance = choices.of_colors});
    for (VertexValues<1>& numbers : numbers_.channels())
      add(numbers.corners, Kind::attributes, {.importance = choices.of_numbers});
    if (patches_)
      add(patches_->charts(), Kind::texture, {});
    return channels;
  }

  IndexedMesh& mesh_;
  VertexValues<4> colors_;
  VertexValues<2> textures_;
  VertexNumbers numbers_;
  std::vector<std::uint32_t> labels_;
  std::optional<SeamPatches> patches_; // where values have seams
};

} // namespace quadrille_examples

#endif
