#ifndef QUADRILLE_EXAMPLES_PROGRAM_OPTION_NAMES_H
#define QUADRILLE_EXAMPLES_PROGRAM_OPTION_NAMES_H

/// \file
/// The names that options and words of the table (options.def) have in the command line.

#include <quadrille/compiled/option_table.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace quadrille_examples {

using quadrille::internal::Option;
using quadrille::internal::OptionWord;

constexpr bool is_in_program(const Option& row) {
  return std::string_view(row.places).find("program") != std::string_view::npos;
}

inline std::string with_dashes(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// Returns the name of an option in help and messages, which is the short form if there is one.
inline std::string name_of(const Option& row) {
  return "--" + with_dashes(*row.short_form == '\0' ? row.name : row.short_form);
}
inline std::string name_of(const OptionWord& word) {
  return with_dashes(*word.short_form == '\0' ? word.word : word.short_form);
}

/// Returns all names of an option, separated by commas.
inline std::string names_of(const Option& row) {
  const std::string name = "--" + with_dashes(row.name);
  return name_of(row) == name ? name : name_of(row) + "," + name;
}

/// Returns an option or a word of the table as the command line spells it.
inline std::string spelled(std::string_view name) {
  namespace table = quadrille::internal;
  for (const Option& row : table::call_options)
    if (row.name == name)
      return name_of(row);
  for (const OptionWord& word : table::call_words)
    if (word.word == name)
      return name_of(word);
  return std::string(name);
}

/// Returns a sentence of the table with its names as the command line spells them.
inline std::string in_words_of_command_line(std::string_view sentence) {
  std::string text;
  while (!sentence.empty()) {
    const std::size_t begin = std::min(sentence.find('`'), sentence.size());
    const std::size_t end = std::min(sentence.find('`', begin + 1), sentence.size());
    text += sentence.substr(0, begin);
    if (begin < end)
      text += spelled(sentence.substr(begin + 1, end - begin - 1));
    sentence.remove_prefix(std::min(end + 1, sentence.size()));
  }
  return text;
}

} // namespace quadrille_examples

#endif
