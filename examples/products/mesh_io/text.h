#ifndef QUADRILLE_EXAMPLES_MESH_IO_TEXT_H
#define QUADRILLE_EXAMPLES_MESH_IO_TEXT_H

/// \file
/// What the readers share: a whole file in memory, and what the library has for lines, words and
/// numbers of a text.

#include <quadrille/internal/core/base/little_endian.h>
#include <quadrille/internal/file/text_lines.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>

namespace quadrille_examples {

using quadrille::internal::append_little_endian;
using quadrille::internal::Comments;
using quadrille::internal::in_quotes;
using quadrille::internal::is_blank;
using quadrille::internal::LineReader;
using quadrille::internal::little_endian_at;
using quadrille::internal::parse_integer;
using quadrille::internal::parse_number;
using quadrille::internal::Source;

[[noreturn]] inline void fail(const std::filesystem::path& file, const std::string& message) {
  quadrille::internal::fail_line(file, 0, message);
}

inline bool is_standard_input(const std::filesystem::path& path) {
  return path == "-" || path == "/dev/stdin" || path == "/dev/fd/0" || path == "/proc/self/fd/0";
}

inline bool is_standard_output(const std::filesystem::path& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

/// All that is left in a stream.
inline std::string content_of(std::istream& stream, const std::filesystem::path& path) {
  constexpr std::size_t step = std::size_t{1} << 20;
  std::string content;
  while (stream) {
    const std::size_t size = content.size();
    content.resize(size + step);
    stream.read(content.data() + size, static_cast<std::streamsize>(step));
    content.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad())
    fail(path, "cannot be read");
  return content;
}

/// Standard input, a pipe or a regular file. A device may never end.
inline std::string read_content(const std::filesystem::path& path) {
  if (is_standard_input(path))
    return content_of(std::cin, path);
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    fail(path, "no such file");
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
    fail(path, "not a regular file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    fail(path, "cannot be opened");
  return content_of(stream, path);
}

/// Reads the file at `path`, "-" for standard input, which must not be empty: no format has an
/// empty file.
inline Source read_source(const std::filesystem::path& path) {
  Source source{path, read_content(path)};
  if (source.content.empty())
    fail(path, "the file is empty");
  return source;
}

/// The complaint about an index into `count` things of a kind.
inline std::string out_of_range(const std::string& kind, std::int64_t index, std::uint64_t count) {
  return kind + " index " + std::to_string(index) + " is out of range: there are " +
         std::to_string(count);
}

/// The complaint about a file that is shorter than it says.
inline std::string ends_before(const std::string& what, std::uint64_t index, std::uint64_t count) {
  return "the file ends before " + what + " " + std::to_string(index) + " of " +
         std::to_string(count) + " (counted from 0)";
}

inline void require_text(const Source& source) {
  if (source.content.find('\0') != std::string::npos)
    fail(source.path, "not a text file");
}

inline bool equal_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

} // namespace quadrille_examples

#endif
