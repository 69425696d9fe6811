#ifndef QUADRILLE_EXAMPLES_MESH_ATTRIBUTES_H
#define QUADRILLE_EXAMPLES_MESH_ATTRIBUTES_H

#include "../mesh/indexed_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The attributes of a vertex as `simplify` gets and changes them, and which vertex it was: a value
/// of a property map for `quadrille::parameters::vertex_attribute_map`.
template <std::size_t N>
struct CarriedAttributes {
  std::array<double, N> values;
  std::uint32_t origin;

  double& operator[](std::size_t i) { return values[i]; }
  double operator[](std::size_t i) const { return values[i]; }
};

/// How much attributes count: a step across their whole range as much as one of this part of the
/// model's size. See quadrille::AttributeQuadric.
struct Importance {
  double of_colors, of_textures;
};

/// The colours and texture coordinates of a mesh as lengths of space: each that varies, times a
/// power of two by which it counts as its importance says, up to a factor of √2. So a number goes
/// to the engine and back with all its bits.
class MeshAttributes {
public:
  MeshAttributes(const IndexedMesh& mesh, const Importance& importance)
      : colors_(mesh.colors), textures_(mesh.texture_coordinates), color_type_(mesh.color_type),
        is_used_(used_points(mesh)) {
    const double size = diagonal(mesh);
    if (!colors_.empty())
      add_channels(0, color_type_.has_alpha ? 4 : 3, importance.of_colors * size);
    if (!textures_.empty())
      add_channels(4, 6, importance.of_textures * size);
  }

  /// How many vary.
  std::size_t size() const { return channels_.size(); }

  /// A number of each vertex that varies, and the exponent of the power of two that it is times.
  struct Number {
    std::size_t index; ///< 0 to 3 of its colour, 4 and 5 its texture coordinate
    int exponent;
  };
  std::vector<Number> numbers() const {
    std::vector<Number> numbers;
    for (const Channel& channel : channels_)
      numbers.push_back({channel.index, channel.exponent});
    return numbers;
  }

  /// One for each point. N is size() or more; the rest is 0.
  template <std::size_t N>
  std::vector<CarriedAttributes<N>> carried() const {
    std::vector<CarriedAttributes<N>> result(is_used_.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
      result[v].origin = static_cast<std::uint32_t>(v);
      for (std::size_t i = 0; i < size(); ++i)
        result[v][i] = std::ldexp(number(channels_[i].index, v), channels_[i].exponent);
    }
    return result;
  }

  /// Gives the mesh, of which the points are those that are left, the attributes that `simplify`
  /// has made.
  template <std::size_t N>
  void restore(IndexedMesh& mesh, const std::vector<CarriedAttributes<N>>& carried) const {
    resize(mesh);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const std::size_t origin = carried[v].origin;
      if (!colors_.empty())
        mesh.colors[v] = colors_[origin];
      if (!textures_.empty())
        mesh.texture_coordinates[v] = textures_[origin];
      for (std::size_t i = 0; i < size(); ++i)
        number(mesh, channels_[i].index, v) =
            restored(channels_[i], carried[v][i], number(channels_[i].index, origin));
    }
  }

  /// The same where none varies.
  void restore(IndexedMesh& mesh) const {
    resize(mesh);
    const auto used = std::find(is_used_.begin(), is_used_.end(), true) - is_used_.begin();
    if (mesh.points.empty())
      return;
    if (!colors_.empty())
      std::fill(mesh.colors.begin(), mesh.colors.end(), colors_[static_cast<std::size_t>(used)]);
    if (!textures_.empty())
      std::fill(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end(),
                textures_[static_cast<std::size_t>(used)]);
  }

private:
  /// A number of each vertex: 0 to 3 of its colour, 4 and 5 its texture coordinate.
  struct Channel {
    std::size_t index;
    double low, high; // of the vertices that faces use
    int exponent = 0; // of the power of two

    double half_range() const { return high / 2 - low / 2; } // lest it overflow
    bool is_color() const { return index < 4; }
  };

  double number(std::size_t channel, std::size_t v) const {
    return channel < 4 ? colors_[v][channel] : textures_[v][channel - 4];
  }
  static double& number(IndexedMesh& mesh, std::size_t channel, std::size_t v) {
    return channel < 4 ? mesh.colors[v][channel] : mesh.texture_coordinates[v][channel - 4];
  }

  static std::vector<bool> used_points(const IndexedMesh& mesh) {
    std::vector<bool> is_used(mesh.points.size());
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle)
        is_used[corner] = true;
    return is_used;
  }

  /// The least and the greatest of number_of(v) over the points that faces use.
  template <class NumberOf>
  std::pair<double, double> range(NumberOf number_of) const {
    std::pair<double, double> range(std::numeric_limits<double>::max(),
                                    std::numeric_limits<double>::lowest());
    for (std::size_t v = 0; v < is_used_.size(); ++v)
      if (is_used_[v]) {
        range.first = std::min(range.first, number_of(v));
        range.second = std::max(range.second, number_of(v));
      }
    return range;
  }

  /// Of the box of the points; 1 if it is a point.
  double diagonal(const IndexedMesh& mesh) const {
    std::array<double, 3> extent{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = range([&](std::size_t v) { return mesh.points[v][axis]; });
      extent[static_cast<std::size_t>(axis)] = high > low ? high / 2 - low / 2 : 0;
    }
    const double half = std::hypot(extent[0], extent[1], extent[2]);
    return half > 0 ? 2 * std::min(half, std::numeric_limits<double>::max() / 2) : 1;
  }

  /// The channels of a kind that vary, so that the largest range of all becomes `length`.
  void add_channels(std::size_t begin, std::size_t end, double length) {
    const std::size_t before = channels_.size();
    double widest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const auto [low, high] = range([&](std::size_t v) { return number(i, v); });
      if (!(low < high))
        continue;
      channels_.push_back({i, low, high});
      widest = std::max(widest, channels_.back().half_range());
    }
    const double exponent = std::log2(length) - std::log2(widest) - 1;
    for (std::size_t i = before; i < channels_.size(); ++i)
      channels_[i].exponent = static_cast<int>(std::lround(exponent));
  }

  /// What a vertex had if it still has it, up to rounding; else as its type asks for it. A colour
  /// stays within the range that there was.
  double restored(const Channel& channel, double carried, double before) const {
    const double after = std::ldexp(carried, -channel.exponent);
    if (std::abs(after / 2 - before / 2) <= 1e-12 * channel.half_range())
      return before;
    if (!channel.is_color())
      return after;
    const double inside = std::clamp(after, channel.low, channel.high);
    if (color_type_.is_whole)
      return std::round(inside);
    return color_type_.is_single ? static_cast<double>(static_cast<float>(inside)) : inside;
  }

  /// Parts of faces and named numbers are all the same: what differs needs channels.
  void resize(IndexedMesh& mesh) const {
    mesh.parts.of_faces.resize(std::min(mesh.parts.of_faces.size(), mesh.triangles.size()));
    for (NamedNumbers& numbers : mesh.vertex_numbers)
      numbers.values.resize(mesh.points.size());
    for (NamedNumbers& numbers : mesh.face_numbers)
      numbers.values.resize(mesh.triangles.size());
    if (!colors_.empty())
      mesh.colors.resize(mesh.points.size());
    if (!textures_.empty())
      mesh.texture_coordinates.resize(mesh.points.size());
  }

  std::vector<Color> colors_;
  std::vector<std::array<double, 2>> textures_;
  ColorType color_type_;
  std::vector<bool> is_used_;
  std::vector<Channel> channels_;
};

} // namespace quadrille_examples

#endif
