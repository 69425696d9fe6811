#ifndef QUADRILLE_INTERNAL_FILE_PLY_HEADER_H
#define QUADRILLE_INTERNAL_FILE_PLY_HEADER_H

#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::internal {

/// A type of numbers in a PLY file.
struct PlyType {
  std::size_t size = 0;
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

/// The number at `bytes`, in which every number of every type fits.
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
  std::optional<PlyType> count_type; ///< of a list

  bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  const PlyProperty* find(std::string_view property) const {
    for (const PlyProperty& p : properties)
      if (p.name == property)
        return &p;
    return nullptr;
  }
  /// Of an item, in bytes; nothing if there are lists.
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

/// What was done while a surface was made of files that were something else, as a comment of the
/// file that has been made tells.
struct MadeCounts {
  std::uint64_t welded = 0;      ///< vertices that have become one with another at the same place
  std::uint64_t fans = 0;        ///< polygons that were flat or crossed themselves
  std::uint64_t short_faces = 0; ///< left out for having fewer than three different corners

  static constexpr std::string_view keyword = "quadrille_made";

  MadeCounts& operator+=(const MadeCounts& other) {
    welded += other.welded, fans += other.fans, short_faces += other.short_faces;
    return *this;
  }

  /// A line of a header, of the same length whatever there is.
  std::string comment() const {
    std::ostringstream text;
    text << "comment " << keyword << std::setfill('0');
    for (const std::uint64_t count : {welded, fans, short_faces})
      text << ' ' << std::setw(12) << count;
    return text.str() + "\n";
  }
};

/// What the header of a PLY file tells.
struct PlyHeader {
  bool is_big_endian = false, is_text = false;
  std::vector<PlyElement> elements;
  std::vector<std::string> textures; ///< comments that name one: "TextureFile wall.png"
  std::uint64_t size = 0;            ///< of the header, in bytes
  std::uint64_t lines = 0;           ///< of the header
  MadeCounts made;

  bool is_swapped() const { return is_big_endian != (std::endian::native == std::endian::big); }
};

/// Reads the header of a PLY file. Throws std::runtime_error, naming the line.
class PlyHeaderReader {
public:
  static PlyHeader read(const InputFile& file) { return PlyHeaderReader(file).header(); }

private:
  explicit PlyHeaderReader(const InputFile& file) : file_(file), text_(std::size_t{1} << 20, '\0') {
    text_.resize(file.read_some(0, text_.data(), text_.size()));
  }

  PlyHeader header() {
    if (next_line() != "ply")
      fail("not a PLY file: its first line is not 'ply'");
    while (read_line(next_line())) {
    }
    header_.size = position_;
    header_.lines = line_;
    return std::move(header_);
  }

  // Lines end in \n, or in \r\n.
  std::string next_line() {
    const std::size_t end = text_.find('\n', position_);
    if (end == std::string::npos)
      fail("the header of a PLY file does not end");
    std::string line = text_.substr(position_, end - position_);
    position_ = end + 1;
    ++line_;
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    return line;
  }

  bool read_line(const std::string& line) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "format")
      read_format(words);
    else if (keyword == "element")
      read_element(words);
    else if (keyword == "property")
      read_property(words);
    else if (keyword == "comment")
      read_comment(line.substr(line.find(keyword) + keyword.size()));
    else if (keyword != "obj_info" && keyword != "end_header")
      fail("unknown keyword '" + keyword + "' in the header");
    return keyword != "end_header";
  }

  void read_comment(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin != std::string::npos && text.compare(begin, 12, "TextureFile ") == 0)
      header_.textures.push_back(text.substr(begin));
    std::istringstream words(text);
    std::string keyword;
    words >> keyword;
    if (keyword == MadeCounts::keyword)
      words >> header_.made.welded >> header_.made.fans >> header_.made.short_faces;
  }

  void read_format(std::istream& words) {
    std::string format;
    words >> format;
    header_.is_text = format == "ascii";
    header_.is_big_endian = format == "binary_big_endian";
    if (format != "binary_little_endian" && !header_.is_big_endian && !header_.is_text)
      fail("unknown format '" + format + "'");
  }

  void read_element(std::istream& words) {
    PlyElement element;
    std::string count;
    words >> element.name >> count;
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (count.empty() || error != std::errc() || end != count.data() + count.size())
      fail("'" + count + "' is no number of elements");
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::istream& words) {
    if (header_.elements.empty())
      fail("a property without an element");
    PlyProperty property;
    std::string type;
    words >> type;
    if (type == "list") {
      words >> type;
      property.count_type = type_named(type);
      if (!property.count_type->is_integer)
        fail("the count of a list is no integer type");
      words >> type;
    }
    property.type = type_named(type);
    words >> property.name;
    if (property.name.empty() || header_.elements.back().find(property.name))
      fail("a property without a name of its own");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType type_named(const std::string& name) const {
    const std::optional<PlyType> type = PlyType::named(name);
    if (!type)
      fail("unknown type '" + name + "'");
    return *type;
  }

  [[noreturn]] void fail(const std::string& what) const {
    fail_file(file_.path(), "line " + std::to_string(line_) + ": " + what);
  }

  const InputFile& file_;
  std::string text_;
  std::size_t position_ = 0, line_ = 0;
  PlyHeader header_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PLY_HEADER_H
