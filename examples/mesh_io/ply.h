#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_H

/// \file
/// Stanford's polygon file format, as text or bytes of either order. Of the vertices it reads the
/// coordinates, colours of any type and texture coordinates; of the faces the vertex indices and
/// MeshLab's texture coordinates of the corners; of triangle strips the triangles. All else is
/// passed over, and told.

#include "indexed_mesh.h"
#include "ply_header.h"
#include "ply_values.h"
#include "polygon_soup.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille_examples {

template <class Values>
class PlyReader {
public:
  PlyReader(const Source& source, const LineReader& end_of_header, const PlyHeader& header)
      : source_(source), header_(header), values_(source, end_of_header, header.byte_order) {}

  PolygonSoup read() {
    require_vertices();
    for (const std::string& comment : header_.comments)
      if (names_a_texture(comment))
        soup_.losses.add("comment " + in_quotes(comment, 100));
    for (const PlyElement& element : header_.elements)
      if (element.count > 0)
        read_element(element);
    values_.require_end();
    return std::move(soup_);
  }

private:
  enum Column { x, y, z, red, green, blue, alpha, u, v, ignored, column_count };

  void require_vertices() {
    for (const PlyElement& element : header_.elements)
      if (is_vertex(element))
        vertex_count_ = element.count;
    if (!vertex_count_)
      fail(source_.path, "the header declares no element 'vertex'");
    if (*vertex_count_ > most_points)
      fail(source_.path, std::to_string(*vertex_count_) + " vertices do not fit 32-bit indices");
  }

  /// In the manner of "comment TextureFile a.png".
  static bool names_a_texture(std::string comment) {
    std::transform(comment.begin(), comment.end(), comment.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const char* sign : {"texturefile", ".png", ".jpg", ".jpeg", ".tga", ".tif", ".bmp", ".dds",
                             ".webp", ".exr", ".mtl"})
      if (comment.find(sign) != std::string::npos)
        return true;
    return false;
  }

  /// Tells of the properties of which is_read(its place) does not hold.
  template <class IsRead>
  void tell_losses(const PlyElement& element, const char* kind, IsRead is_read) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const std::string& name = element.properties[i].name;
      if (is_read(i))
        continue;
      if (name == "nx" || name == "ny" || name == "nz")
        soup_.tell_normals();
      else
        soup_.losses.add(std::string(kind) + " property " + in_quotes(name));
    }
  }

  static bool is_vertex(const PlyElement& element) {
    return element.name == "vertex" || element.name == "vertices";
  }

  void read_element(const PlyElement& element) {
    require_room(element);
    if (is_vertex(element))
      read_vertices(element);
    else if (element.name == "face" || element.name == "faces")
      read_faces(element);
    else if (element.name == "tristrips")
      read_strips(element);
    else if (!element.properties.empty())
      skip_element(element);
  }

  /// Before anything is allocated.
  void require_room(const PlyElement& element) {
    std::size_t item_size = 0;
    for (const PlyProperty& property : element.properties)
      item_size += Values::least_size(property.count_type.value_or(property.type));
    if (item_size > 0 && element.count > values_.bytes_left() / item_size)
      fail(source_.path, "the file is too short for " + std::to_string(element.count) +
                             " items of element " + in_quotes(element.name));
  }

  void read_vertices(const PlyElement& element) {
    const std::vector<Column> columns = vertex_columns(element);
    const auto has = [&](Column column) {
      return std::find(columns.begin(), columns.end(), column) != columns.end();
    };
    if (!has(x) || !has(y) || !has(z))
      fail(source_.path, "the vertices have no x, y and z");
    const bool has_colors = has(red) && has(green) && has(blue);
    const bool has_textures = has(u) && has(v);
    tell_losses(element, "vertex", [&](std::size_t i) {
      return columns[i] <= z || (has_colors && columns[i] >= red && columns[i] <= alpha) ||
             (has_textures && (columns[i] == u || columns[i] == v));
    });
    soup_.color_type.has_alpha = has_colors && has(alpha);
    soup_.points.reserve(element.count);
    std::array<double, column_count> row = {};
    row[alpha] = opaque;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_row(element, i, columns, row);
      soup_.points.emplace_back(row[x], row[y], row[z]);
      if (has_colors)
        soup_.colors.push_back({row[red], row[green], row[blue], row[alpha]});
      if (has_textures)
        soup_.texture_coordinates.push_back({row[u], row[v]});
    }
  }

  /// What each property of the vertices holds.
  std::vector<Column> vertex_columns(const PlyElement& element) {
    std::vector<Column> columns(element.properties.size(), ignored);
    const auto assign = [&](Column column, std::initializer_list<std::string_view> names) {
      const std::optional<std::size_t> place = element.find(names);
      if (!place || element.properties[*place].is_list())
        return;
      columns[*place] = column;
      if (column == red)
        set_color_type(element.properties[*place].type);
    };
    assign(x, {"x"});
    assign(y, {"y"});
    assign(z, {"z"});
    assign(red, {"red", "r", "diffuse_red"});
    assign(green, {"green", "g", "diffuse_green"});
    assign(blue, {"blue", "b", "diffuse_blue"});
    assign(alpha, {"alpha", "a", "diffuse_alpha"});
    assign(u, {"u", "s", "texture_u", "texture_s"});
    assign(v, {"v", "t", "texture_v", "texture_t"});
    return columns;
  }

  void set_color_type(const PlyScalar& type) {
    soup_.color_type.full = type.size == 2 ? 65535 : 255;
    soup_.color_type.is_whole = soup_.is_color_unit_certain = type.is_integer;
    soup_.color_type.is_single = !type.is_integer && type.size == 4;
  }

  void read_row(const PlyElement& element, std::uint64_t index, const std::vector<Column>& columns,
                std::array<double, column_count>& row) {
    values_.begin_item(element, index);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.is_list())
        read_list(property);
      else
        row[columns[i]] = values_.next(property.type);
    }
    values_.end_item();
  }

  void read_faces(const PlyElement& element) {
    const std::size_t indices = find_indices(element);
    const std::optional<std::size_t> textures = find_textures(element);
    tell_losses(element, "face", [&](std::size_t i) { return i == indices || i == textures; });
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_item(element, i, indices, textures);
      for (const double index : indices_)
        soup_.corners.push_back(checked_index(index));
      if (textures)
        append_corner_textures();
      soup_.end_polygon();
    }
    if (soup_.texture_table.empty())
      soup_.corner_textures.clear();
  }

  static std::optional<std::size_t> find_textures(const PlyElement& element) {
    const std::optional<std::size_t> place = element.find({"texcoord"});
    return place && element.properties[*place].is_list() ? place : std::nullopt;
  }

  std::size_t find_indices(const PlyElement& element) {
    const std::optional<std::size_t> place = element.find({"vertex_indices", "vertex_index"});
    if (!place || !element.properties[*place].is_list() ||
        !element.properties[*place].type.is_integer)
      fail(source_.path,
           "element " + in_quotes(element.name) + " has no list of integers 'vertex_indices'");
    return *place;
  }

  void read_item(const PlyElement& element, std::uint64_t item, std::size_t indices,
                 std::optional<std::size_t> textures) {
    values_.begin_item(element, item);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (!property.is_list())
        values_.next(property.type);
      else if (i == indices)
        read_list(property).swap(indices_);
      else if (i == textures)
        read_list(property).swap(corner_textures_);
      else
        read_list(property);
    }
    values_.end_item();
  }

  void skip_element(const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i)
      read_item(element, i, element.properties.size(), std::nullopt);
    soup_.losses.add("element " + in_quotes(element.name));
  }

  /// Grows with the values that are there, not by the count that is claimed.
  std::vector<double>& read_list(const PlyProperty& property) {
    const double count = values_.next(*property.count_type);
    if (count < 0)
      values_.fail("a list of " + std::to_string(static_cast<std::int64_t>(count)) + " values");
    list_.clear();
    while (static_cast<double>(list_.size()) < count)
      list_.push_back(values_.next(property.type));
    return list_;
  }

  std::uint32_t checked_index(double index) {
    if (index < 0 || index >= static_cast<double>(*vertex_count_))
      values_.fail(out_of_range("vertex", static_cast<std::int64_t>(index), *vertex_count_));
    return static_cast<std::uint32_t>(index);
  }

  void append_corner_textures() {
    const std::size_t earlier = soup_.corners.size() - indices_.size();
    soup_.corner_textures.resize(earlier, PolygonSoup::no_value); // of faces that have none
    const bool is_complete = corner_textures_.size() == 2 * indices_.size();
    for (std::size_t i = 0; i < indices_.size(); ++i) {
      soup_.corner_textures.push_back(is_complete
                                          ? static_cast<std::uint32_t>(soup_.texture_table.size())
                                          : PolygonSoup::no_value);
      if (is_complete)
        soup_.texture_table.push_back({corner_textures_[2 * i], corner_textures_[2 * i + 1]});
    }
  }

  void read_strips(const PlyElement& element) {
    const std::size_t indices = find_indices(element);
    tell_losses(element, "strip", [&](std::size_t i) { return i == indices; });
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_item(element, i, indices, std::nullopt);
      append_strip();
    }
  }

  /// Every three neighbours are a triangle, turned over at every other place; -1 starts a new
  /// strip, and a repeated index only leads on.
  void append_strip() {
    std::array<std::uint32_t, 3> last = {};
    std::size_t length = 0;
    for (const double index : indices_) {
      if (index == -1) {
        length = 0;
        continue;
      }
      last = {last[1], last[2], checked_index(index)};
      if (++length < 3 || last[0] == last[1] || last[1] == last[2] || last[2] == last[0])
        continue;
      const bool is_turned = length % 2 == 0;
      soup_.corners.insert(soup_.corners.end(),
                           {last[is_turned ? 1U : 0U], last[is_turned ? 0U : 1U], last[2]});
      soup_.end_polygon();
    }
  }

  const Source& source_;
  const PlyHeader& header_;
  Values values_;
  std::optional<std::uint64_t> vertex_count_;
  std::vector<double> list_;
  std::vector<double> indices_;         // of the item read last
  std::vector<double> corner_textures_; // of the item read last
  PolygonSoup soup_;
};

inline PolygonSoup read_ply(const Source& source) {
  LineReader lines(source);
  const PlyHeader header = PlyHeaderReader::read(lines);
  if (header.is_text)
    return PlyReader<PlyTextValues>(source, lines, header).read();
  return PlyReader<PlyBinaryValues>(source, lines, header).read();
}

} // namespace quadrille_examples

#endif
