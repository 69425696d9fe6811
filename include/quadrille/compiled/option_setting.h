#ifndef QUADRILLE_COMPILED_OPTION_SETTING_H
#define QUADRILLE_COMPILED_OPTION_SETTING_H

#include <quadrille/compiled/option_table.h>
#include <quadrille/internal/core/base/text.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Options are set by name, and checked against the table: a message names the option, the value
/// and the range.

namespace quadrille::internal {

/// Returns whether a number is in a range as "(0, 180]"; an empty range has all numbers.
inline bool is_in_range(double value, const char* range) {
  if (*range == '\0')
    return true;
  char* end = nullptr;
  const double low = std::strtod(range + 1, &end);
  const double high = std::strtod(end + 1, &end);
  return (*range == '(' ? value > low : value >= low) &&
         (*end == ')' ? value < high : value <= high);
}

[[noreturn]] inline void reject_value(const std::string& name, const std::string& value,
                                      const std::string& what) {
  throw std::invalid_argument(name + " is " + value + ", not " + what);
}

/// Throws std::invalid_argument for a number that is out of range, or of the wrong kind.
inline void check_number(const Option& option, double value, const std::string& place = {}) {
  if (!is_in_range(value, option.range))
    reject_value(option.name + place, text_of(value), "in " + std::string(option.range));
  if (option.kind == OptionKind::count && value != std::floor(value))
    reject_value(option.name + place, text_of(value), "an integer");
}

inline const char* description(OptionKind kind) {
  constexpr const char* names[] = {"an integer",
                                   "a number",
                                   "true or false",
                                   "a word",
                                   "an array of numbers",
                                   "an array of numbers, one for each point",
                                   "an array of flags, one for each point",
                                   "an array of flags, one for each triangle"};
  return names[static_cast<std::size_t>(kind)];
}

[[noreturn]] inline void reject_kind(const Option& option, const char* given) {
  reject_value(option.name, given, description(option.kind));
}

[[noreturn]] inline void reject_option(std::string_view name) {
  throw std::invalid_argument("there is no option " + std::string(name));
}

/// Returns the words of an option as "quadric, memoryless_quadric, …".
inline std::string words_of(std::span<const OptionWord> words, std::string_view option) {
  std::string names;
  for (const OptionWord& word : words)
    if (word.option == option)
      names += (names.empty() ? "" : ", ") + std::string(word.word);
  return names;
}

/// Sets a number, an integer or a flag.
template <class Options>
void set_number(Options& options, std::string_view name, double value) {
  const bool is_known = with_option(options, name, [&](const Option& option, auto& field) {
    using Value = OptionValue<std::remove_reference_t<decltype(field)>>;
    if constexpr (std::is_same_v<Value, bool>) {
      if (value != 0 && value != 1)
        reject_value(option.name, text_of(value), description(option.kind));
      field = value == 1;
    } else if constexpr (std::is_arithmetic_v<Value>) {
      check_number(option, value);
      field = static_cast<Value>(value);
    } else {
      reject_kind(option, "a number");
    }
  });
  if (!is_known)
    reject_option(name);
}

/// Sets a choice by its word.
template <class Options>
void set_word(Options& options, std::string_view name, std::string_view word) {
  const bool is_known = with_option(options, name, [&](const Option& option, auto& field) {
    using Value = OptionValue<std::remove_reference_t<decltype(field)>>;
    if constexpr (std::is_enum_v<Value>) {
      for (const OptionWord& known : words_of<Options>())
        if (known.option == name && known.word == word) {
          field = static_cast<Value>(known.value);
          return;
        }
      reject_value(option.name, '"' + std::string(word) + '"',
                   "one of " + words_of(words_of<Options>(), name));
    } else {
      reject_kind(option, "a word");
    }
  });
  if (!is_known)
    reject_option(name);
}

/// Sets an array: read(T{}) returns its values as a std::vector<T>, where T is double or bool.
template <class Options, class Read>
void set_array(Options& options, std::string_view name, const Read& read) {
  const bool is_known = with_option(options, name, [&](const Option& option, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, std::vector<double>>) {
      std::vector<double> values = read(double{});
      for (std::size_t i = 0; i < values.size(); ++i)
        if (!is_in_range(values[i], option.range))
          check_number(option, values[i], '[' + std::to_string(i) + ']');
      field = std::move(values);
    } else if constexpr (std::is_same_v<Field, std::vector<bool>>) {
      field = read(bool{});
    } else {
      reject_kind(option, "an array");
    }
  });
  if (!is_known)
    reject_option(name);
}

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_OPTION_SETTING_H
