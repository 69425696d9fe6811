#ifndef QUADRILLE_EXAMPLES_MESH_IO_OBJ_H
#define QUADRILLE_EXAMPLES_MESH_IO_OBJ_H

/// \file
/// Wavefront OBJ: vertices, faces, the texture coordinates and normals of their corners, materials,
/// groups and objects. Vertex colours, with or without alpha, are behind the coordinates, as
/// MeshLab has them. All else (lines, curves) is passed over, and told.

#include "../mesh/face_parts.h"
#include "../mesh/indexed_mesh.h"
#include "../mesh/polygon_soup.h"
#include "../text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Vertices, texture coordinates or normals: counted from 1, or from the newest backwards. They may
/// be used before they are defined, so the largest index is kept until the file ends.
class ObjIndices {
public:
  explicit ObjIndices(const char* kind) : kind_(kind) {}

  /// The index, counted from 0, that `word` means where `defined` things are defined.
  std::uint32_t resolve(std::string_view word, std::size_t defined, const LineReader& lines) {
    const std::int64_t index = integer(word, lines);
    if (is_wrong(index, defined))
      lines.fail(out_of_range(kind_, index, defined));
    return number(index, defined, lines);
  }

  /// The same of what a face may do without: `nothing` for what can never be defined.
  static constexpr std::uint32_t nothing = static_cast<std::uint32_t>(most_points);
  std::uint32_t resolve_if_any(std::string_view word, std::size_t defined,
                               const LineReader& lines) {
    const std::int64_t index = integer(word, lines);
    return is_wrong(index, defined) ? nothing : number(index, defined, lines);
  }

  void require_defined(std::size_t defined, const LineReader& lines) const {
    if (largest_ > static_cast<std::int64_t>(defined))
      lines.fail_at(line_of_largest_, out_of_range(kind_, largest_, defined));
  }

private:
  std::int64_t integer(std::string_view word, const LineReader& lines) const {
    const std::optional<std::int64_t> index = parse_integer(word);
    if (!index)
      lines.fail(kind_ + " index " + in_quotes(word) + " is not an integer");
    return *index;
  }

  static bool is_wrong(std::int64_t index, std::size_t defined) {
    return index == 0 || index < -static_cast<std::int64_t>(defined) ||
           index > static_cast<std::int64_t>(most_points);
  }

  std::uint32_t number(std::int64_t index, std::size_t defined, const LineReader& lines) {
    const auto count = static_cast<std::int64_t>(defined);
    if (index > largest_) {
      largest_ = index;
      line_of_largest_ = lines.line_number();
    }
    return static_cast<std::uint32_t>(index < 0 ? count + index : index - 1);
  }

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
    if (!soup_.colors.empty())
      soup_.colors.resize(soup_.points.size(), unset);
    soup_.parts = parts_.take();
    lose_missing(soup_.corner_textures, soup_.texture_table.size(), &FacePart::has_textures,
                 "texture coordinate");
    lose_missing(soup_.corner_normals, soup_.normal_table.size(), &FacePart::has_normals, "normal");
    return std::move(soup_);
  }

private:
  static constexpr Color unset = {opaque, opaque, opaque, opaque};

  /// Faces that name values that are not there do without.
  void lose_missing(const std::vector<std::uint32_t>& indices, std::size_t defined,
                    bool FacePart::*has, const std::string& what) {
    std::map<std::uint32_t, std::uint32_t> without; // by parts
    std::size_t faces = 0;
    for (std::size_t face = 0; face < soup_.polygon_ends.size(); ++face) {
      const auto begin = indices.begin() + static_cast<std::ptrdiff_t>(soup_.begin_of(face));
      const auto end = indices.begin() + static_cast<std::ptrdiff_t>(soup_.polygon_ends[face]);
      const std::uint32_t part = soup_.parts.of_faces[face];
      if (!(soup_.parts.parts[part].*has) ||
          std::all_of(begin, end, [&](std::uint32_t index) { return index < defined; }))
        continue;
      ++faces;
      const auto next = static_cast<std::uint32_t>(soup_.parts.parts.size());
      const auto [place, is_new] = without.try_emplace(part, next);
      if (is_new) {
        soup_.parts.parts.push_back(soup_.parts.parts[part]);
        soup_.parts.parts.back().*has = false;
      }
      soup_.parts.of_faces[face] = place->second;
    }
    if (faces > 0)
      soup_.remarks.push_back("faces with " + what + " indices that are out of range, read " +
                              "without them: " + std::to_string(faces));
  }

  void read_line(std::string_view keyword) {
    if (keyword == "v")
      read_vertex();
    else if (keyword == "vt")
      read_texture();
    else if (keyword == "vn")
      read_normal();
    else if (keyword == "f")
      read_face();
    else if (keyword == "mtllib")
      parts_.add_library(lines_.rest_as_name());
    else if (!read_part(keyword))
      pass_over(keyword);
  }

  /// What the faces from here on belong to; false if that is not what the line says.
  bool read_part(std::string_view keyword) {
    if (keyword == "o")
      part_.object = next_name();
    else if (keyword == "g")
      part_.group = next_name();
    else if (keyword == "usemtl")
      part_.material = next_name();
    else if (keyword == "s")
      part_.smoothing = next_smoothing();
    else
      return false;
    return true;
  }

  std::uint32_t next_name() { return parts_.name(lines_.rest_as_name()); }

  std::uint32_t next_smoothing() {
    const std::string_view value = lines_.peek_word();
    return parts_.name(value == "off" || value == "0" ? "" : value);
  }

  void pass_over(std::string_view keyword) {
    soup_.losses.add(keyword == "l"   ? "lines"
                     : keyword == "p" ? "points"
                                      : "lines that begin with " + in_quotes(keyword));
  }

  void read_vertex() {
    const double x = lines_.next_number("coordinate");
    const double y = lines_.next_number("coordinate");
    soup_.points.emplace_back(x, y, lines_.next_number("coordinate"));
    const std::size_t more = lines_.words_left();
    if (more > 4 || more == 2 || (more == 1 && parse_number(lines_.peek_word()) != 1))
      soup_.losses.add("extra numbers of vertices"); // as weights of curves
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

  void read_normal() {
    const double x = lines_.next_number("normal");
    const double y = lines_.next_number("normal");
    soup_.normal_table.push_back({x, y, lines_.next_number("normal")});
  }

  void read_face() {
    const std::size_t begin = soup_.corners.size();
    for (std::string_view word = next_corner(); !word.empty(); word = next_corner())
      read_corner(word);
    soup_.end_polygon();
    part_.has_textures = all_have(soup_.corner_textures, begin, "texture coordinates");
    part_.has_normals = all_have(soup_.corner_normals, begin, "normals");
    parts_.add_face(part_);
  }

  /// Has each corner of the face that begins there an index? If only some have, these are lost.
  bool all_have(const std::vector<std::uint32_t>& indices, std::size_t begin, const char* what) {
    const auto first = indices.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto without = std::count(first, indices.end(), PolygonSoup::no_value);
    if (without > 0 && without < indices.end() - first)
      soup_.losses.add(std::string(what) + " of faces that have them only at some corners");
    return without == 0;
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
        texture.empty() ? PolygonSoup::no_value
                        : textures_.resolve_if_any(texture, soup_.texture_table.size(), lines_));
    soup_.corner_normals.push_back(
        normal.empty() ? PolygonSoup::no_value
                       : normals_.resolve_if_any(normal, soup_.normal_table.size(), lines_));
  }

  LineReader lines_;
  ObjIndices vertices_{"vertex"};
  ObjIndices textures_{"texture coordinate"};
  ObjIndices normals_{"normal"};
  FacePart part_;
  PartNumbers parts_;
  PolygonSoup soup_;
};

} // namespace quadrille_examples

#endif
