#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_H

/// \file
/// Stanford's polygon file format, as text or bytes of either order. Of the vertices it reads the
/// coordinates, normals, colours of any type and texture coordinates; of the faces the vertex
/// indices and MeshLab's texture coordinates of the corners; of both all other scalars, as numbers
/// of their names; of triangle strips the triangles; and comments that name a texture. All else is
/// passed over, and told.

#include "../mesh/face_parts.h"
#include "../mesh/indexed_mesh.h"
#include "../mesh/named_numbers.h"
#include "../mesh/polygon_soup.h"
#include "../text.h"
#include "ply_columns.h"
#include "ply_items.h"
#include "ply_values.h"

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

using quadrille::internal::PlyHeader;

template <class Values>
class PlyReader {
public:
  PlyReader(const Source& source, const LineReader& end_of_header, const PlyHeader& header)
      : source_(source), header_(header), values_(source, end_of_header, header.byte_order),
        items_(values_) {}

  PolygonSoup read() {
    require_vertices();
    soup_.texture_comments = header_.texture_comments();
    for (const PlyElement& element : header_.elements)
      if (element.count > 0)
        read_element(element);
    values_.require_end();
    finish();
    return std::move(soup_);
  }

private:
  /// Columns that are known, in a row of the numbers of a vertex.
  enum Column { x, y, z, nx, ny, nz, red, green, blue, alpha, u, v, column_count };

  static bool is_of_vertices(const PlyElement& element) {
    return element.name == "vertex" || element.name == "vertices";
  }
  static bool is_of_faces(const PlyElement& element) {
    return element.name == "face" || element.name == "faces";
  }
  /// The list of MeshLab's texture coordinates of corners.
  static std::optional<std::size_t> find_corner_textures(const PlyElement& element) {
    const std::optional<std::size_t> place = element.find({"texcoord"});
    return place && element.properties[*place].is_list() ? place : std::nullopt;
  }

  void require_vertices() {
    const std::size_t vertices = require_at_most_one(is_of_vertices, "vertices");
    require_at_most_one(is_of_faces, "faces");
    if (vertices == header_.elements.size())
      fail(source_.path, "the header declares no element 'vertex'");
    vertex_count_ = header_.elements[vertices].count;
    if (vertex_count_ > most_points)
      fail(source_.path,
           std::to_string(vertex_count_) + " vertices do not fit into 32-bit indices");
  }

  /// The place of the element of a kind, or behind all of them.
  std::size_t require_at_most_one(bool (*is_of_kind)(const PlyElement&), const char* kind) const {
    const auto& elements = header_.elements;
    if (std::count_if(elements.begin(), elements.end(), is_of_kind) > 1)
      fail(source_.path, std::string("the header declares ") + kind + " under two names");
    return static_cast<std::size_t>(std::find_if(elements.begin(), elements.end(), is_of_kind) -
                                    elements.begin());
  }

  void read_element(const PlyElement& element) {
    require_room(element);
    if (is_of_vertices(element))
      read_vertices(element);
    else if (is_of_faces(element))
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
    PlyColumns columns(element, column_count);
    if (!columns.assign(x, {{"x"}, {"y"}, {"z"}}))
      fail(source_.path, "the vertices have no x, y and z");
    const bool has_normals = assign_normals(element, columns);
    const bool has_colors = assign_colors(element, columns);
    const bool has_textures = assign_textures(columns);
    soup_.vertex_numbers = columns.assign_others([&](const std::string& name) {
      return (has_colors && PlyColumns::is_one_of(name, {"red", "green", "blue", "alpha"})) ||
             (has_textures && PlyColumns::is_one_of(name, {"s", "t"}));
    });
    note_losses(element, "vertex", columns);
    items_.begin(element, column_count + soup_.vertex_numbers.size());
    std::vector<double>& row = items_.row();
    row[alpha] = opaque;
    soup_.points.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      items_.read(element, i, columns);
      soup_.points.emplace_back(row[x], row[y], row[z]);
      if (has_normals)
        soup_.normal_table.push_back({row[nx], row[ny], row[nz]});
      if (has_colors)
        soup_.colors.push_back({row[red], row[green], row[blue], row[alpha]});
      if (has_textures)
        soup_.texture_coordinates.push_back({row[u], row[v]});
      items_.append_to(soup_.vertex_numbers, column_count);
    }
  }

  bool assign_normals(const PlyElement& element, PlyColumns& columns) {
    if (!columns.assign(nx, {{"nx"}, {"ny"}, {"nz"}}))
      return false;
    soup_.are_normals_double = element.properties[*element.find({"nx"})].type.size == 8;
    return true;
  }

  bool assign_colors(const PlyElement& element, PlyColumns& columns) {
    if (!columns.assign(red, {{"red", "r", "diffuse_red"},
                              {"green", "g", "diffuse_green"},
                              {"blue", "b", "diffuse_blue"}}))
      return false;
    soup_.color_type.has_alpha = columns.assign(alpha, {{"alpha", "a", "diffuse_alpha"}});
    set_color_type(element.properties[*element.find({"red", "r", "diffuse_red"})].type);
    return true;
  }

  /// Beside texture coordinates at corners those of vertices are numbers like any other.
  bool assign_textures(PlyColumns& columns) {
    const auto has_corner_textures = [](const PlyElement& element) {
      return is_of_faces(element) && find_corner_textures(element);
    };
    return std::none_of(header_.elements.begin(), header_.elements.end(), has_corner_textures) &&
           columns.assign(
               u, {{"u", "s", "texture_u", "texture_s"}, {"v", "t", "texture_v", "texture_t"}});
  }

  void set_color_type(const NumberType& type) {
    soup_.color_type.full = type.size == 2 ? 65535 : 255;
    soup_.color_type.is_whole = soup_.is_color_unit_certain = type.is_integer;
    soup_.color_type.is_single = !type.is_integer && type.size == 4;
  }

  /// Tells of the scalars without a column and of the lists but for those that are read.
  void note_losses(const PlyElement& element, const char* kind, const PlyColumns& columns,
                   std::initializer_list<std::optional<std::size_t>> read_lists = {}) {
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (!columns.of(i) && std::find(read_lists.begin(), read_lists.end(), i) == read_lists.end())
        soup_.losses.add(kind + (" property " + in_quotes(element.properties[i].name)));
  }

  void read_faces(const PlyElement& element) {
    const std::size_t indices = find_indices(element);
    const std::optional<std::size_t> textures = find_corner_textures(element);
    PlyColumns columns(element, 0);
    soup_.face_numbers =
        columns.assign_others([](const std::string& name) { return name == "vertex_indices"; });
    note_losses(element, "face", columns, {indices, textures});
    items_.begin(element, soup_.face_numbers.size());
    if (textures)
      soup_.are_textures_double = element.properties[*textures].type.size == 8;
    fill_face_numbers();
    const std::vector<double> none;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      items_.read(element, i, columns);
      for (const double index : items_.list(indices))
        soup_.corners.push_back(checked_index(index));
      end_face(textures ? items_.list(*textures) : none);
      items_.append_to(soup_.face_numbers, 0);
    }
  }

  /// Triangles of strips have zeros.
  void fill_face_numbers() {
    for (NamedNumbers& column : soup_.face_numbers)
      column.values.resize(soup_.polygon_ends.size());
  }

  std::size_t find_indices(const PlyElement& element) {
    const std::optional<std::size_t> place = element.find({"vertex_indices", "vertex_index"});
    if (!place || !element.properties[*place].is_list() ||
        !element.properties[*place].type.is_integer)
      fail(source_.path,
           "element " + in_quotes(element.name) + " has no list of integers 'vertex_indices'");
    return *place;
  }

  void skip_element(const PlyElement& element) {
    const PlyColumns columns(element, 0);
    items_.begin(element, 0);
    for (std::uint64_t i = 0; i < element.count; ++i)
      items_.read(element, i, columns);
    soup_.losses.add("element " + in_quotes(element.name));
  }

  std::uint32_t checked_index(double index) {
    if (index < 0 || index >= static_cast<double>(vertex_count_))
      values_.fail(out_of_range("vertex", static_cast<std::int64_t>(index), vertex_count_));
    return static_cast<std::uint32_t>(index);
  }

  /// Ends the face of the corners that have been appended since the last one: two texture
  /// coordinates for each of them, or none at all.
  void end_face(const std::vector<double>& textures) {
    const std::size_t begin = soup_.begin_of(soup_.polygon_ends.size());
    const std::size_t count = soup_.corners.size() - begin;
    if (!textures.empty() && textures.size() != 2 * count)
      values_.fail("a list of " + std::to_string(textures.size()) + " texture coordinates for " +
                   std::to_string(count) + " corners");
    if (!textures.empty())
      soup_.corner_textures.resize(begin, PolygonSoup::no_value); // of faces that have none
    for (std::size_t i = 0; i < textures.size(); i += 2) {
      soup_.corner_textures.push_back(static_cast<std::uint32_t>(soup_.texture_table.size()));
      soup_.texture_table.push_back({textures[i], textures[i + 1]});
    }
    parts_.add_face({.has_textures = !textures.empty()});
    soup_.end_polygon();
  }

  /// Every three neighbours are a triangle, turned over at every other place; -1 starts a new
  /// strip, and a repeated index only leads on.
  void append_strip(const std::vector<double>& indices) {
    std::array<std::uint32_t, 3> last = {};
    std::size_t length = 0;
    for (const double index : indices) {
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
      end_face({});
    }
  }

  void read_strips(const PlyElement& element) {
    const std::size_t indices = find_indices(element);
    const PlyColumns columns(element, 0);
    note_losses(element, "strip", columns, {indices});
    items_.begin(element, 0);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      items_.read(element, i, columns);
      append_strip(items_.list(indices));
    }
  }

  /// Vertices may come behind the faces that have their normals.
  void finish() {
    soup_.parts = parts_.take();
    if (!soup_.normal_table.empty()) {
      soup_.corner_normals = soup_.corners;
      for (FacePart& part : soup_.parts.parts)
        part.has_normals = true;
    }
    fill_face_numbers();
  }

  const Source& source_;
  const PlyHeader& header_;
  Values values_;
  std::uint64_t vertex_count_ = 0;
  PlyItems<Values> items_;
  PartNumbers parts_;
  PolygonSoup soup_;
};

inline PolygonSoup read_ply(const Source& source) {
  LineReader lines(source);
  const PlyHeader header = quadrille::internal::PlyHeaderReader::read(lines);
  if (header.is_text)
    return PlyReader<PlyTextValues>(source, lines, header).read();
  return PlyReader<PlyBinaryValues>(source, lines, header).read();
}

} // namespace quadrille_examples

#endif
