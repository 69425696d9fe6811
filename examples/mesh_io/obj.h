#ifndef QUADRILLE_EXAMPLES_MESH_IO_OBJ_H
#define QUADRILLE_EXAMPLES_MESH_IO_OBJ_H

/// \file
/// Wavefront OBJ: vertices, faces and texture coordinates. Vertex colours, with or without alpha,
/// are read and written behind the coordinates, as MeshLab does. All else (normals, materials,
/// groups, lines, curves) is passed over, and told.

#include "indexed_mesh.h"
#include "number_text.h"
#include "polygon_soup.h"
#include "text.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace quadrille_examples {

/// Vertices, texture coordinates or normals: counted from 1, or from the newest backwards. They may
/// be used before they are defined, so the largest index is kept until the file ends.
class ObjIndices {
public:
  explicit ObjIndices(const char* kind) : kind_(kind) {}

  /// The index, counted from 0, that `word` means where `defined` things are defined.
  std::uint32_t resolve(std::string_view word, std::size_t defined, const LineReader& lines) {
    const std::optional<std::int64_t> index = parse_integer(word);
    if (!index)
      lines.fail(kind_ + " index " + in_quotes(word) + " is not an integer");
    const auto count = static_cast<std::int64_t>(defined);
    if (*index == 0 || *index < -count || *index > static_cast<std::int64_t>(most_points))
      lines.fail(out_of_range(kind_, *index, defined));
    if (*index > largest_) {
      largest_ = *index;
      line_of_largest_ = lines.line_number();
    }
    return static_cast<std::uint32_t>(*index < 0 ? count + *index : *index - 1);
  }

  void require_defined(std::size_t defined, const LineReader& lines) const {
    if (largest_ > static_cast<std::int64_t>(defined))
      lines.fail_at(line_of_largest_, out_of_range(kind_, largest_, defined));
  }

private:
  std::string kind_;
  std::int64_t largest_ = 0;
  std::size_t line_of_largest_ = 0;
};

class ObjReader {
public:
  explicit ObjReader(const Source& source) : lines_(source) { require_text(source); }

  PolygonSoup read() {
    while (lines_.next_line())
      read_line(lines_.next_word());
    vertices_.require_defined(soup_.points.size(), lines_);
    textures_.require_defined(soup_.texture_table.size(), lines_);
    normals_.require_defined(normal_count_, lines_);
    if (!soup_.colors.empty())
      soup_.colors.resize(soup_.points.size(), unset);
    if (soup_.texture_table.empty())
      soup_.corner_textures.clear();
    return std::move(soup_);
  }

private:
  static constexpr Color unset = {opaque, opaque, opaque, opaque};

  void read_line(std::string_view keyword) {
    if (keyword == "v")
      read_vertex();
    else if (keyword == "vt")
      read_texture();
    else if (keyword == "vn")
      read_normal();
    else if (keyword == "f")
      read_face();
    else
      pass_over(keyword);
  }

  void read_normal() {
    ++normal_count_;
    soup_.tell_normals();
  }

  void pass_over(std::string_view keyword) {
    struct Kind {
      std::string_view keyword;
      const char* name;
    };
    static constexpr Kind kinds[] = {{"mtllib", "material libraries (mtllib)"},
                                     {"usemtl", "materials (usemtl)"},
                                     {"g", "groups"},
                                     {"o", "objects"},
                                     {"s", "smoothing groups"},
                                     {"l", "lines"},
                                     {"p", "points"}};
    const std::string_view value = lines_.peek_word();
    if (keyword == "s" && (value == "off" || value == "0"))
      return; // none
    for (const Kind& kind : kinds)
      if (keyword == kind.keyword)
        return soup_.losses.add(kind.name);
    soup_.losses.add("lines that begin with " + in_quotes(keyword));
  }

  void read_vertex() {
    const double x = lines_.next_number("coordinate");
    const double y = lines_.next_number("coordinate");
    soup_.points.emplace_back(x, y, lines_.next_number("coordinate"));
    const std::size_t more = lines_.words_left();
    if (more > 4 || more == 2 || (more == 1 && parse_number(lines_.peek_word()) != 1))
      soup_.losses.add("numbers of vertices behind their coordinates"); // as weights of curves
    if (more == 3 || more == 4)
      read_color(more);
  }

  void read_color(std::size_t channels) {
    soup_.color_type.is_whole = soup_.is_color_unit_certain = false;
    soup_.color_type.has_alpha |= channels == 4;
    soup_.colors.resize(soup_.points.size(), unset);
    for (std::size_t i = 0; i < channels; ++i)
      soup_.colors.back()[i] = lines_.next_number("colour");
  }

  void read_texture() {
    const double u = lines_.next_number("texture coordinate");
    const double v = lines_.at_line_end() ? 0 : lines_.next_number("texture coordinate");
    if (!lines_.at_line_end() && parse_number(lines_.peek_word()) != 0)
      soup_.losses.add("third texture coordinates");
    soup_.texture_table.push_back({u, v});
  }

  void read_face() {
    for (std::string_view word = next_corner(); !word.empty(); word = next_corner())
      read_corner(word);
    soup_.end_polygon();
  }

  /// A backslash at the end of a line continues it on the next.
  std::string_view next_corner() {
    std::string_view word = lines_.next_word();
    while (word.ends_with('\\') && lines_.at_line_end()) {
      word.remove_suffix(1);
      const bool goes_on = lines_.next_line();
      if (!word.empty() || !goes_on)
        break;
      word = lines_.next_word();
    }
    return word;
  }

  /// `vertex`, `vertex/texture`, `vertex//normal` or `vertex/texture/normal`.
  void read_corner(std::string_view corner) {
    const auto next_part = [&corner] {
      const std::string_view part = corner.substr(0, corner.find('/'));
      corner.remove_prefix(std::min(part.size() + 1, corner.size()));
      return part;
    };
    const std::string_view whole = corner;
    const std::string_view vertex = next_part();
    const std::string_view texture = next_part();
    const std::string_view normal = next_part();
    if (!corner.empty())
      lines_.fail("face corner " + in_quotes(whole) + " has more than three parts");

    soup_.corners.push_back(vertices_.resolve(vertex, soup_.points.size(), lines_));
    soup_.corner_textures.push_back(
        texture.empty() ? PolygonSoup::no_texture
                        : textures_.resolve(texture, soup_.texture_table.size(), lines_));
    if (!normal.empty())
      normals_.resolve(normal, normal_count_, lines_);
  }

  LineReader lines_;
  ObjIndices vertices_{"vertex"};
  ObjIndices textures_{"texture coordinate"};
  ObjIndices normals_{"normal"};
  std::size_t normal_count_ = 0;
  PolygonSoup soup_;
};

inline std::string encode_obj(const IndexedMesh& mesh) {
  const bool has_textures = !mesh.texture_coordinates.empty();
  std::string text = "# " + std::to_string(mesh.points.size()) + " vertices, " +
                     std::to_string(mesh.triangles.size()) + " faces\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point& p = mesh.points[i];
    text += 'v';
    append_numbers(text, p.x(), p.y(), p.z());
    const std::size_t channels = mesh.colors.empty() ? 0 : mesh.color_type.has_alpha ? 4 : 3;
    for (std::size_t channel = 0; channel < channels; ++channel)
      append_fraction(text += ' ', mesh.colors[i][channel], mesh.color_type);
    text += '\n';
  }
  for (const auto& [u, v] : mesh.texture_coordinates) {
    text += "vt";
    append_numbers(text, u, v);
    text += '\n';
  }
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    for (const std::uint32_t index : triangle) {
      append_numbers(text, index + 1);
      if (has_textures)
        append_number(text += '/', index + 1);
    }
    text += '\n';
  }
  return text;
}

} // namespace quadrille_examples

#endif
