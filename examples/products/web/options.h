#ifndef QUADRILLE_EXAMPLES_WEB_OPTIONS_H
#define QUADRILLE_EXAMPLES_WEB_OPTIONS_H

/// \file
/// Options by their names in the table (options.def). Sentences and ranges of the table are not
/// here, so that they are not in the WebAssembly: the engine checks the ranges.

#include <quadrille/compiled.h>
#include <quadrille/compiled/option_field.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace quadrille_examples {

/// A value of an enumeration by its name.
template <class Enum>
struct Named {
  std::string_view name;
  Enum value;
};

using Options = quadrille::SoupOptions;

inline constexpr std::array<Named<quadrille::SoupChannelView::Kind>, 4> kinds{
    {{"texture", quadrille::SoupChannelView::Kind::texture},
     {"normals", quadrille::SoupChannelView::Kind::normals},
     {"colors", quadrille::SoupChannelView::Kind::colors},
     {"attributes", quadrille::SoupChannelView::Kind::attributes}}};

[[noreturn]] inline void reject_word(std::string_view option, std::string_view word,
                                     const std::string& words) {
  throw std::invalid_argument(std::string(option) + " is \"" + std::string(word) +
                              "\", which is not one of " + words);
}

/// The value of that name. Throws std::invalid_argument, which tells all names, if there is none.
template <class Enum, std::size_t n>
Enum chosen(const std::array<Named<Enum>, n>& choices, std::string_view option,
            std::string_view name) {
  std::string names;
  for (const Named<Enum>& choice : choices) {
    if (choice.name == name)
      return choice.value;
    names += (names.empty() ? "" : ", ") + std::string(choice.name);
  }
  reject_word(option, name, names);
}

[[noreturn]] inline void reject_option(std::string_view name) {
  throw std::invalid_argument("there is no option " + std::string(name));
}

/// Sets a field that is or holds a number or a boolean. Numbers of an array are set one by one.
/// Returns false for other fields.
template <class Field>
bool set_field(Field& field, double value) {
  if constexpr (requires { field.emplace(); })
    return set_field(field.emplace(), value);
  else if constexpr (std::is_same_v<Field, std::vector<double>>)
    field.push_back(value);
  else if constexpr (std::is_same_v<Field, bool>)
    field = value != 0;
  else if constexpr (std::is_arithmetic_v<Field>)
    field = static_cast<Field>(value);
  else
    return false;
  return true;
}

#define QUADRILLE_SET_NUMBER(field)                                                                \
  if (name == #field && set_field(options.field, value))                                           \
    return;
#define QUADRILLE_SET_WORD(option, word)                                                           \
  if (name == #option) {                                                                           \
    using Field = decltype(options.option);                                                        \
    if (value == #word) {                                                                          \
      options.option = quadrille::internal::OptionValue<Field>::word;                              \
      return;                                                                                      \
    }                                                                                              \
    words += (words.empty() ? "" : ", ") + std::string(#word);                                     \
  }

/// A number or a boolean of the options, by the name of its field.
inline void set_number(Options& options, std::string_view name, double value) {
#define QUADRILLE_OPTION(kind, field, ...) QUADRILLE_SET_NUMBER(field)
#include <quadrille/compiled/options.def>
  reject_option(name);
}

/// A choice by name.
inline void set_choice(Options& options, std::string_view name, std::string_view value) {
  std::string words;
#define QUADRILLE_WORD(option, word, ...) QUADRILLE_SET_WORD(option, word)
#include <quadrille/compiled/options.def>
  words.empty() ? reject_option(name) : reject_word(name, value, words);
}

/// The same of a channel.
inline void set_number(quadrille::ChannelOptions& options, std::string_view name, double value) {
#define QUADRILLE_CHANNEL_OPTION(kind, field, ...) QUADRILLE_SET_NUMBER(field)
#include <quadrille/compiled/options.def>
  reject_option(name);
}
inline void set_choice(quadrille::ChannelOptions& options, std::string_view name,
                       std::string_view value) {
  std::string words;
#define QUADRILLE_CHANNEL_WORD(option, word, ...) QUADRILLE_SET_WORD(option, word)
#include <quadrille/compiled/options.def>
  words.empty() ? reject_option(name) : reject_word(name, value, words);
}

#undef QUADRILLE_SET_NUMBER
#undef QUADRILLE_SET_WORD

} // namespace quadrille_examples

#endif
