#ifndef QUADRILLE_INTERNAL_FILE_TEXT_LINES_H
#define QUADRILLE_INTERNAL_FILE_TEXT_LINES_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

/// \file
/// Lines, words and numbers of a text, and errors that name their position. A number is read the
/// same way in every locale, and must take up its whole word: `1.5` is not an index and `12abc` is
/// not a coordinate.

namespace quadrille::internal {

/// A file and its content, or the beginning of its content.
struct Source {
  std::filesystem::path path;
  std::string content;
};

/// Throws "FILE: message" or, for a `line` counted from 1, "FILE:LINE: message".
[[noreturn]] inline void fail_line(const std::filesystem::path& file, std::size_t line,
                                   const std::string& message) {
  const std::string place = line == 0 ? std::string() : ":" + std::to_string(line);
  throw std::runtime_error(file.string() + place + ": " + message);
}

/// `word` between quotes, fit for a message of one line: short and printable.
inline std::string in_quotes(std::string_view word, std::size_t longest = 24) {
  std::string shown(word.substr(0, longest));
  const auto unprintable = [](char c) { return c < ' ' || c > '~'; };
  std::replace_if(shown.begin(), shown.end(), unprintable, '?');
  return "'" + shown + (word.size() > longest ? "..." : "") + "'";
}

inline bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Returns the number that `word` spells, including signed numbers, `nan` and `inf`. Beyond the
/// range of `double` it is zero or infinite, as IEEE 754 rounds. If the standard library does not
/// read such numbers by `std::from_chars`, a stream does, which accepts neither `nan` nor `inf`.
template <class Number = double>
std::optional<Number> parse_number(std::string_view word) {
  if (word.starts_with('+'))
    word.remove_prefix(1);
  Number value = 0;
  if constexpr (requires(const char* text) { std::from_chars(text, text, value); }) {
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument)
      return std::nullopt;
    if (error == std::errc::result_out_of_range) // from_chars does not say on which side
      value = std::strtod(std::string(word).c_str(), nullptr);
  } else {
    std::istringstream text{std::string(word)};
    text.imbue(std::locale::classic());
    if (!(text >> value) || text.peek() != std::istringstream::traits_type::eof())
      return std::nullopt;
  }
  return value;
}

inline std::optional<std::int64_t> parse_integer(std::string_view word) {
  if (word.starts_with('+'))
    word.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc())
    return std::nullopt;
  return value;
}

/// Does a `#` begin a comment, up to the end of the line?
enum class Comments { absent, hash };

/// Iterates over the lines of a text that contain a word, without their comments. Lines end in LF,
/// CR LF or CR.
class LineReader {
public:
  explicit LineReader(const Source& source, Comments comments = Comments::hash)
      : source_(&source), comments_(comments) {
    if (text().starts_with("\xEF\xBB\xBF")) // the byte order mark of some editors
      next_ = 3;
  }

  /// Steps to the next line that contains a word; false at the end of the text.
  bool next_line() {
    do {
      if (next_ >= text().size())
        return false;
      take_line();
      skip_blanks();
    } while (at_line_end());
    return true;
  }

  /// Returns the next word of the line; it is empty if there is none left.
  std::string_view next_word() {
    const std::size_t start = position_;
    while (position_ < line_end_ && !is_blank(text()[position_]))
      ++position_;
    const std::string_view word = text().substr(start, position_ - start);
    skip_blanks();
    return word;
  }

  /// Makes `tail`, an end of the last word that was read, the next word.
  void go_back_to(std::string_view tail) {
    position_ = static_cast<std::size_t>(tail.data() - text().data());
  }

  /// Returns the rest of the line.
  std::string_view rest_of_line() const { return text().substr(position_, line_end_ - position_); }

  /// Returns the rest of the line as a name, which may contain blanks, and a # unless that stands
  /// alone.
  std::string_view rest_as_name() const {
    std::string_view name = text().substr(position_, newline_ - position_);
    for (std::size_t i = 0; i < name.size(); ++i)
      if (name[i] == '#' && (i == 0 || is_blank(name[i - 1])) &&
          (i + 1 == name.size() || is_blank(name[i + 1])))
        name = name.substr(0, i);
    while (!name.empty() && is_blank(name.back()))
      name.remove_suffix(1);
    return name;
  }

  double next_number(const char* what) {
    const std::string_view word = next_word();
    const std::optional<double> value = parse_number(word);
    if (!value)
      fail_at_word(word, what, "a number");
    return *value;
  }

  std::int64_t next_integer(const char* what) {
    const std::string_view word = next_word();
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value)
      fail_at_word(word, what, "an integer");
    return *value;
  }

  /// Reads an integer, which may be written as 255.0, as some programs do.
  double next_whole_number(const char* what) {
    const std::string_view word = next_word();
    if (const std::optional<std::int64_t> value = parse_integer(word))
      return static_cast<double>(*value);
    const std::optional<double> value = parse_number(word);
    if (!value || *value != std::trunc(*value) || !std::isfinite(*value))
      fail_at_word(word, what, "an integer");
    return *value;
  }

  std::string_view peek_word() const { return LineReader(*this).next_word(); }
  bool at_line_end() const { return position_ == line_end_; }

  std::size_t words_left() const {
    LineReader ahead = *this;
    std::size_t count = 0;
    while (!ahead.next_word().empty())
      ++count;
    return count;
  }

  std::size_t line_number() const { return line_number_; }
  /// The number of bytes in the lines after this one.
  std::size_t bytes_left() const { return text().size() - next_; }

  [[noreturn]] void fail(const std::string& message) const { fail_at(line_number_, message); }

  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const {
    fail_line(source_->path, line, message);
  }

private:
  std::string_view text() const { return source_->content; }

  void take_line() {
    const auto is_newline = [](char c) { return c == '\n' || c == '\r'; };
    position_ = next_;
    const auto begin = source_->content.begin() + static_cast<std::ptrdiff_t>(position_);
    const auto end = std::find_if(begin, source_->content.end(), is_newline);
    const auto text_end = comments_ == Comments::hash ? std::find(begin, end, '#') : end;
    line_end_ = position_ + static_cast<std::size_t>(text_end - begin);
    newline_ = next_ = position_ + static_cast<std::size_t>(end - begin);
    next_ += text().substr(next_, 2) == "\r\n" ? 2 : 1;
    next_ = (std::min)(next_, text().size());
    ++line_number_;
  }

  void skip_blanks() {
    while (position_ < line_end_ && is_blank(text()[position_]))
      ++position_;
  }

  [[noreturn]] void fail_at_word(std::string_view word, const char* what,
                                 const char* wanted) const {
    if (word.empty())
      fail(std::string("the line ends before the next ") + what);
    fail(std::string(what) + " " + in_quotes(word) + " is not " + wanted);
  }

  const Source* source_;
  Comments comments_;
  std::size_t position_ = 0; // of the next word in the line
  std::size_t line_end_ = 0;
  std::size_t newline_ = 0; // after the line and its comment
  std::size_t next_ = 0;    // start of the next line
  std::size_t line_number_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_TEXT_LINES_H
