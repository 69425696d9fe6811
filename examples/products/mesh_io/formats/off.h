#ifndef QUADRILLE_EXAMPLES_MESH_IO_OFF_H
#define QUADRILLE_EXAMPLES_MESH_IO_OFF_H

/// \file
/// The text form of Geomview's Object File Format: a keyword `[ST][C][N][4]OFF`, the counts, a line
/// for each vertex and a line for each face. http://www.geomview.org/docs/html/OFF.html
/// Whatever the order of the letters, a line holds the coordinates, the normal, the colour and the
/// texture coordinates. Normals and face colours are passed over.

#include "../mesh/indexed_mesh.h"
#include "../mesh/polygon_soup.h"
#include "../number_text.h"
#include "../text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace quadrille_examples {

class OffReader {
public:
  explicit OffReader(const Source& source) : source_(&source), lines_(source) {}

  PolygonSoup read() {
    read_header();
    soup_.points.reserve(vertex_count_);
    for (std::uint64_t i = 0; i < vertex_count_; ++i)
      read_vertex();
    soup_.color_type.is_whole = !fractional_colors_;
    soup_.is_color_unit_certain = false;
    soup_.polygon_ends.reserve(face_count_);
    for (std::uint64_t i = 0; i < face_count_; ++i)
      read_face();
    if (lines_.next_line()) // faces would be lost in silence
      lines_.fail("the file goes on after the last of " + std::to_string(face_count_) + " faces");
    return std::move(soup_);
  }

private:
  void read_header() {
    if (!lines_.next_line())
      lines_.fail("not an OFF file: it contains only comments");
    const std::string_view word = lines_.next_word();
    const std::size_t length = word.find_last_not_of("+-0123456789") + 1;
    if (length < word.size()) // a count, without a blank or without a keyword before it
      lines_.go_back_to(word.substr(length));
    if (length > 0)
      read_keyword(word.substr(0, length));
    if (lines_.at_line_end() && !lines_.next_line())
      lines_.fail("the file ends before the counts");
    require_text(*source_);
    vertex_count_ = read_count("vertex count");
    face_count_ = read_count("face count"); // the edge count may be missing, and nothing needs it
    require_room();
  }

  /// The letters before `OFF` come in any order, each once; all may be small. A small `n` among
  /// capitals is another thing: any number of dimensions.
  void read_keyword(std::string_view word) {
    std::string keyword(word);
    if (std::none_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'Z'; }))
      std::transform(word.begin(), word.end(), keyword.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    std::string_view rest = keyword;
    const auto take = [&rest](std::string_view letters, bool& is_there) {
      if (is_there || !rest.starts_with(letters))
        return false;
      rest.remove_prefix(letters.size());
      return is_there = true;
    };
    while (take("ST", has_textures_) || take("C", has_colors_) || take("N", has_normals_) ||
           take("4", is_homogeneous_)) {
    }
    if (rest != "OFF")
      lines_.fail("not a three-dimensional OFF file: it starts with " + in_quotes(word));
    if (lines_.peek_word() == "BINARY")
      lines_.fail("binary OFF is not supported");
    if (has_normals_)
      soup_.losses.add("normals");
  }

  std::uint64_t read_count(const char* what) {
    const std::int64_t count = lines_.next_integer(what);
    if (count < 0)
      lines_.fail(std::string(what) + " " + std::to_string(count) + " is negative");
    return static_cast<std::uint64_t>(count);
  }

  /// Before anything is allocated: a line takes up two bytes at least.
  void require_room() {
    const std::size_t most_lines = lines_.bytes_left() / 2 + 1;
    if (vertex_count_ > std::min<std::uint64_t>(most_lines, most_points))
      lines_.fail(std::to_string(vertex_count_) + " vertices do not fit into the file");
    if (face_count_ > most_lines - vertex_count_)
      lines_.fail(std::to_string(face_count_) + " faces do not fit into the file");
  }

  void read_vertex() {
    if (!lines_.next_line())
      lines_.fail(ends_before("vertex", soup_.points.size(), vertex_count_));
    const double x = lines_.next_number("coordinate");
    const double y = lines_.next_number("coordinate");
    const double z = lines_.next_number("coordinate");
    const double w = is_homogeneous_ ? lines_.next_number("coordinate") : 1;
    soup_.points.push_back(w == 1 ? Point(x, y, z) : Point(x / w, y / w, z / w));
    for (int i = 0; has_normals_ && i < 3; ++i)
      lines_.next_number("normal");
    if (has_colors_)
      read_color();
    if (has_textures_) {
      const double s = lines_.next_number("texture coordinate");
      soup_.texture_coordinates.push_back({s, lines_.next_number("texture coordinate")});
    }
    if (!lines_.at_line_end())
      soup_.losses.add("extra numbers of vertices");
  }

  /// Three or four values: the fourth, opacity, is often left out.
  void read_color() {
    const bool has_alpha = lines_.words_left() >= (has_textures_ ? 6U : 4U);
    soup_.color_type.has_alpha |= has_alpha;
    Color color = {0, 0, 0, opaque};
    for (std::size_t i = 0; i < (has_alpha ? 4U : 3U); ++i) {
      fractional_colors_ = fractional_colors_ || !parse_integer(lines_.peek_word());
      color[i] = lines_.next_number("colour");
    }
    soup_.colors.push_back(color);
  }

  void read_face() {
    if (!lines_.next_line())
      lines_.fail(ends_before("face", soup_.polygon_ends.size(), face_count_));
    const std::uint64_t corners = read_count("corner count");
    for (std::uint64_t i = 0; i < corners; ++i) // ends with the line, if the count is wild
      soup_.corners.push_back(read_index());
    if (!lines_.at_line_end())
      soup_.losses.add("face colours");
    soup_.end_polygon();
  }

  std::uint32_t read_index() {
    const std::int64_t index = lines_.next_integer("vertex index");
    if (static_cast<std::uint64_t>(index) >= vertex_count_) // or negative
      lines_.fail(out_of_range("vertex", index, vertex_count_));
    return static_cast<std::uint32_t>(index);
  }

  const Source* source_;
  LineReader lines_;
  bool has_textures_ = false;
  bool has_colors_ = false;
  bool has_normals_ = false;
  bool is_homogeneous_ = false;
  bool fractional_colors_ = false;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t face_count_ = 0;
  PolygonSoup soup_;
};

/// Integers from 0 to 255, or fractions, each with a decimal point or an exponent.
inline void append_off_color(std::string& text, const Color& color, const ColorType& type) {
  for (std::size_t i = 0; i < (type.has_alpha ? 4U : 3U); ++i) {
    if (type.is_whole && type.full == 255) {
      append_numbers(text, std::lround(color[i]));
      continue;
    }
    const std::size_t begin = (text += ' ').size();
    append_fraction(text, color[i], type);
    if (text.find_first_of(".e", begin) == std::string::npos)
      text += ".0";
  }
}

inline std::string encode_off(const IndexedMesh& mesh) {
  const bool has_colors = !mesh.colors.empty();
  const bool has_textures = !mesh.texture_coordinates.empty();
  std::string text = std::string(has_textures ? "ST" : "") + (has_colors ? "C" : "") + "OFF\n";
  append_number(text, mesh.points.size());
  append_numbers(text, mesh.triangles.size(), 0);
  text += '\n';
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point& p = mesh.points[i];
    append_number(text, p.x());
    append_numbers(text, p.y(), p.z());
    if (has_colors)
      append_off_color(text, mesh.colors[i], mesh.color_type);
    if (has_textures)
      append_numbers(text, mesh.texture_coordinates[i][0], mesh.texture_coordinates[i][1]);
    text += '\n';
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    text += '3';
    append_numbers(text, a, b, c);
    text += '\n';
  }
  return text;
}

} // namespace quadrille_examples

#endif
