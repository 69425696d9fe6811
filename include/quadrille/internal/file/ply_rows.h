#ifndef QUADRILLE_INTERNAL_FILE_PLY_ROWS_H
#define QUADRILLE_INTERNAL_FILE_PLY_ROWS_H

#include <quadrille/internal/file/byte_stream.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/ply_header.h>
#include <quadrille/internal/file/text_lines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::internal {

/// The header of a PLY file on the disk, and the offset at which its values begin.
struct PlyFileHeader : PlyHeader {
  explicit PlyFileHeader(const InputFile& file) {
    Source source{file.path(), std::string(most_bytes, '\0')};
    source.content.resize(file.read_some(0, source.content.data(), most_bytes));
    LineReader text(source);
    static_cast<PlyHeader&>(*this) = PlyHeaderReader::read(text);
    size = source.content.size() - text.bytes_left();
    lines = text.line_number();
    made = MadeCounts::of(comments);
  }

  std::uint64_t size = 0, lines = 0;
  MadeCounts made;

private:
  static constexpr std::size_t most_bytes = std::size_t{1} << 20;
};

/// The values of a text PLY file, one item per line. Messages name the line.
class PlyTextValues {
public:
  PlyTextValues(const InputFile& file, const PlyFileHeader& header)
      : file_(file), offset_(header.size), line_number_(header.lines) {}

  void begin_item(const PlyElement& element, std::uint64_t item) {
    if (!next_line())
      fail_file(file_.path(), "ends before " + element.name + " " + std::to_string(item) + " of " +
                                  std::to_string(element.count));
  }
  double next(const PlyType& type) {
    const std::string_view word = next_word();
    const std::optional<double> value = parse_number(word);
    if (!value)
      fail(word.empty() ? "has fewer values than the header declares"
                        : in_quotes(word) + " is not a number");
    if (type.is_integer && !(std::trunc(*value) == *value && fits(type, *value)))
      fail(in_quotes(word) + " is not a number of the type " + type.name());
    return *value;
  }
  void end_item() {
    if (!next_word().empty())
      fail("has more values than the header declares");
  }
  void skip(const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i)
      begin_item(element, i);
  }
  void require_end() {
    if (next_line())
      fail("goes on after the last element");
  }
  [[noreturn]] void fail(const std::string& what) const {
    fail_line(file_.path(), line_number_, what);
  }

private:
  static bool fits(const PlyType& type, double value) {
    const double values = std::ldexp(1, static_cast<int>(8 * type.size));
    return type.is_signed ? value >= -values / 2 && value < values / 2
                          : value >= 0 && value < values;
  }

  // Steps to the next line that is not empty; false if there is none.
  bool next_line() {
    do {
      if (!read_line())
        return false;
      ++line_number_;
    } while (line_.find_first_not_of(blanks) == std::string_view::npos);
    return true;
  }
  bool read_line() {
    std::size_t end = std::string::npos;
    while ((end = text_.find('\n', begin_)) == std::string::npos && read_more()) {
    }
    if (begin_ == text_.size())
      return false;
    end = (std::min)(end, text_.size());
    line_ = std::string_view(text_).substr(begin_, end - begin_);
    begin_ = (std::min)(end + 1, text_.size());
    return true;
  }
  bool read_more() {
    text_.erase(0, begin_);
    begin_ = 0;
    const std::size_t before = text_.size();
    text_.resize(before + block);
    const std::size_t got = file_.read_some(offset_, text_.data() + before, block);
    text_.resize(before + got);
    offset_ += got;
    return got > 0;
  }
  std::string_view next_word() {
    line_.remove_prefix((std::min)(line_.find_first_not_of(blanks), line_.size()));
    const std::string_view word = line_.substr(0, line_.find_first_of(blanks));
    line_.remove_prefix(word.size());
    return word;
  }

  static constexpr std::string_view blanks = " \t\r\v\f";
  static constexpr std::size_t block = std::size_t{1} << 20;

  const InputFile& file_;
  std::uint64_t offset_, line_number_;
  std::string text_;
  std::size_t begin_ = 0; // of the next line
  std::string_view line_; // the rest of the present one
};

/// The values of a binary PLY file. Messages name the item.
template <bool is_swapped>
class PlyBinaryValues {
public:
  PlyBinaryValues(const InputFile& file, const PlyFileHeader& header)
      : file_(file), stream_(file, header.size) {}

  void begin_item(const PlyElement& element, std::uint64_t item) {
    element_ = &element;
    item_ = item;
  }
  double next(const PlyType& type) {
    const char* const bytes = stream_.next(type.size);
    if (!bytes)
      fail_file(file_.path(), "ends at byte " + std::to_string(file_.size()) + ", within " +
                                  element_->name + " " + std::to_string(item_) + " of " +
                                  std::to_string(element_->count));
    return ply_number<is_swapped>(type, bytes);
  }
  void end_item() {}
  void skip(const PlyElement& element) {
    const auto row = element.row_size();
    if (row && stream_.offset() + element.count * *row <= file_.size()) {
      stream_ = ByteStream(file_, stream_.offset() + element.count * *row);
      return;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      begin_item(element, i);
      for (const PlyProperty& p : element.properties)
        for (double n = p.is_list() ? next(*p.count_type) : 1; n > 0; --n)
          next(p.type);
    }
  }
  void require_end() const {
    if (stream_.offset() != file_.size())
      fail_file(file_.path(), "goes on after the last element, from byte " +
                                  std::to_string(stream_.offset()) + " on");
  }
  [[noreturn]] void fail(const std::string& what) const {
    fail_file(file_.path(), element_->name + " " + std::to_string(item_) + " " + what);
  }

private:
  const InputFile& file_;
  ByteStream stream_;
  const PlyElement* element_ = nullptr;
  std::uint64_t item_ = 0;
};

/// The items of an element of a PLY file, text or binary, one after another, whatever lists they
/// and others have.
class PlyRows {
public:
  /// The values of each property: one value, or the values of a list.
  using Row = std::vector<std::vector<double>>;

  PlyRows(const InputFile& file, const PlyFileHeader& header) : file_(file), header_(header) {}

  /// Calls take(number, row, fail) for each item; fail(text) throws std::runtime_error with the
  /// position in the file. It ends when take returns false; otherwise the file must be at its end
  /// after the last item.
  template <class Take>
  void for_items(const PlyElement& wanted, Take take) const {
    if (header_.is_text)
      read(PlyTextValues(file_, header_), wanted, take);
    else if (header_.is_swapped())
      read(PlyBinaryValues<true>(file_, header_), wanted, take);
    else
      read(PlyBinaryValues<false>(file_, header_), wanted, take);
  }

private:
  template <class Values, class Take>
  void read(Values values, const PlyElement& wanted, Take& take) const {
    Row row(wanted.properties.size());
    const auto fail = [&](const std::string& what) { values.fail(what); };
    for (const PlyElement& element : header_.elements) {
      if (&element != &wanted)
        values.skip(element);
      for (std::uint64_t i = 0; &element == &wanted && i < element.count; ++i) {
        read_row(values, element, i, row);
        if (!take(i, row, fail))
          return;
      }
    }
    values.require_end();
  }

  template <class Values>
  static void read_row(Values& values, const PlyElement& element, std::uint64_t item, Row& row) {
    values.begin_item(element, item);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const PlyProperty& p = element.properties[i];
      row[i].clear();
      double count = p.is_list() ? values.next(*p.count_type) : 1;
      if (count < 0)
        values.fail("has a list of " + std::to_string(static_cast<std::int64_t>(count)) +
                    " values");
      for (; count > 0; --count)
        row[i].push_back(values.next(p.type));
    }
    values.end_item();
  }

  const InputFile& file_;
  const PlyFileHeader& header_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PLY_ROWS_H
