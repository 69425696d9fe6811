#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_HEADER_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_HEADER_H

/// \file
/// The header of Stanford's polygon file format: which elements follow, with which properties.

#include "../mesh/named_numbers.h"
#include "../text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille_examples {

struct PlyTypeNames {
  std::array<std::string_view, 2> names; ///< the first is the older
  NumberType type;
};

inline constexpr PlyTypeNames ply_types[] = {
    {{"char", "int8"}, {1, true, true}},      {{"uchar", "uint8"}, {1, true, false}},
    {{"short", "int16"}, {2, true, true}},    {{"ushort", "uint16"}, {2, true, false}},
    {{"int", "int32"}, {4, true, true}},      {{"uint", "uint32"}, {4, true, false}},
    {{"float", "float32"}, {4, false, true}}, {{"double", "float64"}, {8, false, true}}};

struct PlyProperty {
  std::string name;
  NumberType type;
  std::optional<NumberType> count_type; // of a list

  bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The place of the first property that has one of the names.
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const {
    const auto is_named = [&](const PlyProperty& property) {
      return std::find(names.begin(), names.end(), property.name) != names.end();
    };
    const auto found = std::find_if(properties.begin(), properties.end(), is_named);
    if (found == properties.end())
      return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
  }

  bool is_of_vertices() const { return name == "vertex" || name == "vertices"; }
  bool is_of_faces() const { return name == "face" || name == "faces"; }
  /// The list of MeshLab's texture coordinates of corners.
  std::optional<std::size_t> find_corner_textures() const {
    const std::optional<std::size_t> place = find({"texcoord"});
    return place && properties[*place].is_list() ? place : std::nullopt;
  }
};

/// Does a comment name a texture, in the manner of "comment TextureFile a.png"?
inline bool names_a_texture(std::string comment) {
  std::transform(comment.begin(), comment.end(), comment.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  for (const char* sign : {"texturefile", ".png", ".jpg", ".jpeg", ".tga", ".tif", ".bmp", ".dds",
                           ".webp", ".exr", ".mtl"})
    if (comment.find(sign) != std::string::npos)
      return true;
  return false;
}

struct PlyHeader {
  bool is_text = false;
  std::endian byte_order = std::endian::little;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;

  /// Those that name a texture.
  std::vector<std::string> texture_comments() const {
    std::vector<std::string> found;
    std::copy_if(comments.begin(), comments.end(), std::back_inserter(found), names_a_texture);
    return found;
  }
};

class PlyHeaderReader {
public:
  /// Leaves `lines` at the last line of the header.
  static PlyHeader read(LineReader& lines) {
    PlyHeaderReader reader(lines);
    reader.read_magic();
    while (reader.read_line()) {
    }
    return std::move(reader.header_);
  }

private:
  /// Beyond what any program writes, lest a file of nothing but names take forever.
  static constexpr std::size_t most_names = 1000;

  explicit PlyHeaderReader(LineReader& lines) : lines_(lines) {}

  void read_magic() {
    if (!lines_.next_line() || lines_.next_word() != "ply")
      lines_.fail("not a PLY file: its first line is not 'ply'");
    if (!lines_.next_line() || lines_.next_word() != "format")
      lines_.fail("the line that names the format is missing");
    const std::string_view format = lines_.next_word();
    header_.is_text = format == "ascii";
    if (format == "binary_big_endian")
      header_.byte_order = std::endian::big;
    else if (format != "binary_little_endian" && !header_.is_text)
      lines_.fail("unknown format " + in_quotes(format));
  }

  /// False after the last line.
  bool read_line() {
    if (!lines_.next_line())
      lines_.fail("the file ends inside the header");
    const std::string_view keyword = lines_.next_word();
    if (keyword == "element")
      read_element();
    else if (keyword == "property")
      read_property();
    else if (keyword == "comment" || keyword == "obj_info")
      read_comment();
    else if (keyword != "end_header")
      lines_.fail("unknown keyword " + in_quotes(keyword) + " in the header");
    return keyword != "end_header";
  }

  void read_comment() {
    if (header_.comments.size() < most_names)
      header_.comments.emplace_back(lines_.rest_as_name());
  }

  void read_element() {
    PlyElement element;
    element.name = lines_.next_word();
    const std::int64_t count = lines_.next_integer("element count");
    if (count < 0)
      lines_.fail("element count " + std::to_string(count) + " is negative");
    for (const PlyElement& earlier : header_.elements)
      if (earlier.name == element.name)
        lines_.fail("element " + in_quotes(element.name) + " is declared twice");
    if (header_.elements.size() == most_names)
      lines_.fail("more than " + std::to_string(most_names) + " elements");
    element.count = static_cast<std::uint64_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty())
      lines_.fail("a property without an element");
    PlyProperty property;
    if (lines_.peek_word() == "list") {
      lines_.next_word();
      property.count_type = read_type();
      if (!property.count_type->is_integer)
        lines_.fail("the count of a list is no integer type");
    }
    property.type = read_type();
    property.name = lines_.next_word();
    PlyElement& element = header_.elements.back();
    if (property.name.empty())
      lines_.fail("a property without a name");
    if (element.find({property.name}))
      lines_.fail("property " + in_quotes(property.name) + " is declared twice");
    if (element.properties.size() == most_names)
      lines_.fail("more than " + std::to_string(most_names) + " properties");
    element.properties.push_back(std::move(property));
  }

  NumberType read_type() {
    const std::string_view name = lines_.next_word();
    for (const auto& [names, type] : ply_types)
      if (names[0] == name || names[1] == name)
        return type;
    lines_.fail("unknown type " + in_quotes(name));
  }

  LineReader& lines_;
  PlyHeader header_;
};

} // namespace quadrille_examples

#endif
