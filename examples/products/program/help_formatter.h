#ifndef QUADRILLE_EXAMPLES_PROGRAM_HELP_FORMATTER_H
#define QUADRILLE_EXAMPLES_PROGRAM_HELP_FORMATTER_H

#include <CLI/CLI.hpp>

#include <cstddef>
#include <sstream>
#include <string>

namespace quadrille_examples {

/// Writes --help in lines of at most 80 characters: of each option its name, what it takes, and
/// what it does.
class HelpFormatter : public CLI::Formatter {
public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string name = "  " + option->get_name(is_positional, true);
    if (!option->get_type_name().empty() && !is_positional)
      name += " " + option->get_type_name();
    const std::string text = wrapped(option->get_description());
    if (name.size() + 2 > indent)
      return name + "\n" + std::string(indent, ' ') + text + "\n";
    return name + std::string(indent - name.size(), ' ') + text + "\n";
  }

private:
  static constexpr std::size_t indent = 24, width = 80;

  /// All lines but the first are indented.
  static std::string wrapped(const std::string& text) {
    std::istringstream words(text);
    std::string result, word;
    std::size_t column = indent;
    while (words >> word) {
      if (column > indent && column + 1 + word.size() > width) {
        result += "\n" + std::string(indent, ' ');
        column = indent;
      } else if (column > indent) {
        result += ' ';
        ++column;
      }
      result += word;
      column += word.size();
    }
    return result;
  }
};

} // namespace quadrille_examples

#endif
