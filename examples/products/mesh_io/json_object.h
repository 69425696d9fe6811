#ifndef QUADRILLE_EXAMPLES_MESH_IO_JSON_OBJECT_H
#define QUADRILLE_EXAMPLES_MESH_IO_JSON_OBJECT_H

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace quadrille_examples {

/// An object of JSON, written member by member. It may stand within an element of HTML, whatever is
/// in its texts, which are UTF-8.
class JsonObject {
public:
  /// A member of which the value is JSON already.
  void add_raw(std::string_view name, std::string_view json) {
    text_ += (text_.empty() ? '{' : ',') + json_of(name) + ':';
    text_ += json;
  }
  template <class Value>
  void add(std::string_view name, const Value& value) {
    add_raw(name, json_of(value));
  }

  std::string text() const { return text_.empty() ? "{}" : text_ + '}'; }

  static std::string json_of(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) {
      constexpr std::string_view digits = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x20 || byte == 0x7f ||
          std::string_view("\"\\<>&").find(c) != std::string_view::npos)
        json.append("\\u00").append({digits[byte >> 4U], digits[byte & 15U]});
      else
        json += c;
    }
    return json + '"';
  }
  static std::string json_of(const std::string& text) { return json_of(std::string_view(text)); }
  static std::string json_of(const char* text) { return json_of(std::string_view(text)); }
  static std::string json_of(bool value) { return value ? "true" : "false"; }
  static std::string json_of(std::size_t count) { return std::to_string(count); }
  /// What is beyond all doubles, as 1e999, is read as Infinity.
  static std::string json_of(double number) {
    if (!std::isfinite(number))
      return number > 0 ? "1e999" : "null";
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
  }
  static std::string json_of(const JsonObject& object) { return object.text(); }
  /// An array of what each value becomes.
  template <class Values>
  requires requires(const Values& values) {
    values.begin() != values.end();
    values.front();
  }
  static std::string json_of(const Values& values) {
    std::string json;
    for (const auto& value : values)
      json.append(json.empty() ? "" : ",").append(json_of(value));
    return '[' + json + ']';
  }

private:
  std::string text_;
};

} // namespace quadrille_examples

#endif
