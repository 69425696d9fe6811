#ifndef QUADRILLE_EXAMPLES_PROGRAM_SUGGESTION_H
#define QUADRILLE_EXAMPLES_PROGRAM_SUGGESTION_H

/// \file
/// What to say of words of the command line that no option takes.

#include "../mesh_io/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille_examples {

/// How many letters have to be put in, taken out or changed to make one word the other.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// The option whose name is at most two letters off, as "--name"; empty if there is none.
inline std::string closest_option(const CLI::App& app, std::string_view word) {
  std::size_t least = 3;
  std::string closest;
  for (const CLI::Option* const option : app.get_options())
    for (const std::string& name : option->get_lnames())
      if (const std::size_t distance = edit_distance("--" + name, word); distance < least) {
        least = distance;
        closest = "--" + name;
      }
  return closest;
}

/// Of the first of the words that is written like an option, else of the first.
inline std::string complaint_of_unknown(const CLI::App& app,
                                        const std::vector<std::string>& words) {
  const auto is_option = [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  };
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  if (option == words.end())
    return in_quotes(words.front()) + ": one word too many; between the items of a list stand "
                                      "commas";
  const std::string name = option->substr(0, option->find('='));
  const std::string closest = closest_option(app, name);
  return "there is no option " + name +
         (closest.empty() ? "; --help lists all" : "; did you mean " + closest + "?");
}

} // namespace quadrille_examples

#endif
