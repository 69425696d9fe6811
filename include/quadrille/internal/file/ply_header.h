#ifndef QUADRILLE_INTERNAL_FILE_PLY_HEADER_H
#define QUADRILLE_INTERNAL_FILE_PLY_HEADER_H

#include <quadrille/internal/file/text_lines.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iomanip>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A type of numbers in a PLY file.
struct PlyType {
  std::size_t size = 0; ///< in bytes: 1, 2 or 4 for integers, 4 or 8 for others
  bool is_integer = true, is_signed = true;

  friend bool operator==(const PlyType&, const PlyType&) = default;

  std::string name() const {
    if (!is_integer)
      return size == 8 ? "double" : "float";
    return std::string(is_signed ? "" : "u") + (size == 1 ? "char" : size == 2 ? "short" : "int");
  }

  static std::optional<PlyType> named(std::string_view name) {
    struct Named {
      std::string_view old_name, name;
      PlyType type;
    };
    static constexpr std::array<Named, 8> types{{{"char", "int8", {1, true, true}},
                                                 {"uchar", "uint8", {1, true, false}},
                                                 {"short", "int16", {2, true, true}},
                                                 {"ushort", "uint16", {2, true, false}},
                                                 {"int", "int32", {4, true, true}},
                                                 {"uint", "uint32", {4, true, false}},
                                                 {"float", "float32", {4, false, true}},
                                                 {"double", "float64", {8, false, true}}}};
    for (const Named& t : types)
      if (t.old_name == name || t.name == name)
        return t.type;
    return std::nullopt;
  }
};

/// Returns the number at `bytes` as a double, which represents every number of every type exactly.
template <bool is_swapped>
double ply_number(const PlyType& type, const char* bytes) {
  std::array<char, 8> raw{};
  std::copy_n(bytes, type.size, raw.begin());
  if constexpr (is_swapped)
    std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(type.size));
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, raw.data(), sizeof(T));
    return static_cast<double>(value);
  };
  if (!type.is_integer)
    return type.size == 8 ? as(0.0) : as(0.0F);
  switch (type.size) {
  case 1:
    return type.is_signed ? as(std::int8_t{}) : as(std::uint8_t{});
  case 2:
    return type.is_signed ? as(std::int16_t{}) : as(std::uint16_t{});
  default:
    return type.is_signed ? as(std::int32_t{}) : as(std::uint32_t{});
  }
}

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type; ///< the count type of a list

  bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Returns the index of the first property that has one of the names.
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (std::find(names.begin(), names.end(), properties[i].name) != names.end())
        return i;
    return std::nullopt;
  }
  /// The size of an item in bytes; nothing if there are lists.
  std::optional<std::size_t> row_size() const {
    std::size_t size = 0;
    for (const PlyProperty& p : properties) {
      if (p.is_list())
        return std::nullopt;
      size += p.type.size;
    }
    return size;
  }
};

/// Counts of the changes when a surface was made from files of another kind. A comment of the file
/// that has been made contains them.
struct MadeCounts {
  std::uint64_t welded = 0;      ///< vertices that were merged with another one at the same
                                 ///< position
  std::uint64_t fans = 0;        ///< polygons that were flat or crossed themselves
  std::uint64_t short_faces = 0; ///< faces left out because they have fewer than three different
                                 ///< corners

  static constexpr std::string_view keyword = "quadrille_made";

  MadeCounts& operator+=(const MadeCounts& other) {
    welded += other.welded, fans += other.fans, short_faces += other.short_faces;
    return *this;
  }

  /// Reads the counts from the comments of a header.
  static MadeCounts of(const std::vector<std::string>& comments) {
    MadeCounts made;
    for (const std::string& comment : comments) {
      std::istringstream words(comment);
      std::string first;
      if (words >> first && first == keyword)
        words >> made.welded >> made.fans >> made.short_faces;
    }
    return made;
  }
  /// Returns a line of a header, which has the same length for all counts.
  std::string comment() const {
    std::ostringstream text;
    text << "comment " << keyword << std::setfill('0');
    for (const std::uint64_t count : {welded, fans, short_faces})
      text << ' ' << std::setw(12) << count;
    return text.str() + "\n";
  }
};

/// The header of a PLY file: which elements follow, with which properties.
struct PlyHeader {
  bool is_text = false;
  std::endian byte_order = std::endian::little;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;

  bool is_swapped() const { return byte_order != std::endian::native; }

  /// The comments that name a texture, such as "comment TextureFile a.png".
  std::vector<std::string> texture_comments() const {
    std::vector<std::string> found;
    std::copy_if(comments.begin(), comments.end(), std::back_inserter(found), names_a_texture);
    return found;
  }

private:
  static bool names_a_texture(std::string comment) {
    std::transform(comment.begin(), comment.end(), comment.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const char* sign : {"texturefile", ".png", ".jpg", ".jpeg", ".tga", ".tif", ".bmp", ".dds",
                             ".webp", ".exr", ".mtl"})
      if (comment.find(sign) != std::string::npos)
        return true;
    return false;
  }
};

/// Reads the header of a PLY file. Throws std::runtime_error, naming the line.
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
  /// The limit is above what any program writes, so that a file of nothing but names does not take
  /// forever.
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

  /// Returns false after the last line.
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
        lines_.fail("the count of a list does not have an integer type");
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

  PlyType read_type() {
    const std::string_view name = lines_.next_word();
    const std::optional<PlyType> type = PlyType::named(name);
    if (!type)
      lines_.fail("unknown type " + in_quotes(name));
    return *type;
  }

  LineReader& lines_;
  PlyHeader header_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PLY_HEADER_H
