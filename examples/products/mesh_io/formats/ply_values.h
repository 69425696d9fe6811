#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_VALUES_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_VALUES_H

/// \file
/// The two ways in which PLY holds values: as text, with a line for each item, and as bytes. All
/// are handed on as `double`, which holds every value of every type of the format.

#include "../text.h"
#include "ply_columns.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace quadrille_examples {

/// Values as text. A message names the line.
class PlyTextValues {
public:
  PlyTextValues(const Source& source, const LineReader& header, std::endian) : lines_(header) {
    require_text(source);
  }

  void begin_item(const PlyElement& element, std::uint64_t index) {
    if (!lines_.next_line())
      lines_.fail(ends_before(element.name, index, element.count));
  }

  double next(const NumberType& type) {
    return type.is_integer ? lines_.next_whole_number("value") : lines_.next_number("value");
  }

  void end_item() {
    if (!lines_.at_line_end())
      lines_.fail("the line has more values than the header declares");
  }

  void require_end() {
    if (lines_.next_line())
      lines_.fail("the file goes on after the last element");
  }

  static constexpr std::size_t least_size(const NumberType&) { return 2; } // a digit and a blank
  /// One more than there are: the last line may do without its newline.
  std::size_t bytes_left() const { return lines_.bytes_left() + 1; }

  [[noreturn]] void fail(const std::string& message) const { lines_.fail(message); }

private:
  LineReader lines_;
};

/// Values as bytes. A message names the item.
class PlyBinaryValues {
public:
  PlyBinaryValues(const Source& source, const LineReader& header, std::endian byte_order)
      : source_(&source), position_(source.content.size() - header.bytes_left()),
        is_swapped_(byte_order != std::endian::native) {}

  void begin_item(const PlyElement& element, std::uint64_t index) {
    element_ = &element;
    index_ = index;
  }

  double next(const NumberType& type) {
    using quadrille::internal::ply_number;
    if (bytes_left() < type.size)
      quadrille_examples::fail(source_->path, ends_before(element_->name, index_, element_->count));
    const char* const bytes = source_->content.data() + position_;
    position_ += type.size;
    return is_swapped_ ? ply_number<true>(type, bytes) : ply_number<false>(type, bytes);
  }

  void end_item() {}

  void require_end() const {
    const auto rest = source_->content.begin() + static_cast<std::ptrdiff_t>(position_);
    if (!std::all_of(rest, source_->content.end(), is_blank))
      quadrille_examples::fail(source_->path, "the file goes on after the last element");
  }

  static constexpr std::size_t least_size(const NumberType& type) { return type.size; }
  std::size_t bytes_left() const { return source_->content.size() - position_; }

  [[noreturn]] void fail(const std::string& message) const {
    const std::string item = element_->name + " " + std::to_string(index_);
    quadrille_examples::fail(source_->path, item + ": " + message);
  }

private:
  const Source* source_;
  std::size_t position_;
  bool is_swapped_;
  const PlyElement* element_ = nullptr;
  std::uint64_t index_ = 0;
};

} // namespace quadrille_examples

#endif
